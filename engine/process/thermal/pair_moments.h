// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Sums over one row set from which the normal equations of every pair of inputs are read (see gmdh.h).
namespace kerf::thermal {

struct PairMoments {
    double rows{0.0};
    Eigen::VectorXd x;     ///< Σ xi
    Eigen::MatrixXd xx;    ///< Σ xi xj
    Eigen::MatrixXd xxx;   ///< (i,j): Σ xi² xj
    Eigen::MatrixXd xxxT;  ///< its transpose, for walking down columns
    Eigen::MatrixXd x2x2;  ///< Σ xi² xj²
    Eigen::MatrixXd x3x;   ///< (i,j): Σ xi³ xj; empty for the bilinear basis
    Eigen::MatrixXd x3xT;
    Eigen::RowVectorXd y;              ///< Σ y, per output
    Eigen::RowVectorXd yy;             ///< Σ y²
    Eigen::MatrixXd xy;                ///< Σ xi y, inputs × outputs
    Eigen::MatrixXd x2y;               ///< Σ xi² y
    std::vector<Eigen::MatrixXd> xxy;  ///< per output: Σ xi xj y

    PairMoments() = default;
    PairMoments(const Eigen::MatrixXd& inputs, const Eigen::MatrixXd& outputs, bool withCubes);
    PairMoments& operator+=(const PairMoments& other);
};

/// K = 6: basis 1, xi, xj, xi², xj², xi·xj. K = 4: 1, xi, xj, xi·xj.
template <int K>
struct PairBasis {
    static_assert(K == 4 || K == 6);
    using Gram = std::array<double, static_cast<std::size_t>(K* K)>;  ///< lower triangle used
    using Vector = std::array<double, static_cast<std::size_t>(K)>;

    static void gram(const PairMoments& m, Eigen::Index i, Eigen::Index j, Gram& g) noexcept {
        const auto at = [&g](int row, int col) -> double& { return g[static_cast<std::size_t>(row * K + col)]; };
        const double iij = m.xxx(i, j);
        const double ijj = m.xxxT(i, j);  // Σ xj² xi
        at(0, 0) = m.rows;
        at(1, 0) = m.x[i];
        at(2, 0) = m.x[j];
        at(1, 1) = m.xx(i, i);
        at(2, 1) = m.xx(i, j);
        at(2, 2) = m.xx(j, j);
        at(K - 1, 0) = m.xx(i, j);
        at(K - 1, 1) = iij;
        at(K - 1, 2) = ijj;
        at(K - 1, K - 1) = m.x2x2(i, j);
        if constexpr (K == 6) {
            at(3, 0) = m.xx(i, i);
            at(3, 1) = m.xxx(i, i);
            at(3, 2) = iij;
            at(3, 3) = m.x2x2(i, i);
            at(4, 0) = m.xx(j, j);
            at(4, 1) = ijj;
            at(4, 2) = m.xxx(j, j);
            at(4, 3) = m.x2x2(i, j);
            at(4, 4) = m.x2x2(j, j);
            at(5, 3) = m.x3x(i, j);
            at(5, 4) = m.x3xT(i, j);  // Σ xj³ xi
        }
    }
    static void rhs(const PairMoments& m, Eigen::Index i, Eigen::Index j, Eigen::Index output, Vector& b) noexcept {
        b[0] = m.y[output];
        b[1] = m.xy(i, output);
        b[2] = m.xy(j, output);
        b[static_cast<std::size_t>(K - 1)] = m.xxy[static_cast<std::size_t>(output)](i, j);
        if constexpr (K == 6) {
            b[3] = m.x2y(i, output);
            b[4] = m.x2y(j, output);
        }
    }
    /// In-place L·D·Lᵀ of the lower triangle. A pivot that vanishes against its diagonal drops its term (coefficient
    /// 0).
    static void factor(Gram& g, double ridgeTimesRows) noexcept {
        const auto at = [&g](int row, int col) -> double& { return g[static_cast<std::size_t>(row * K + col)]; };
        std::array<double, static_cast<std::size_t>(K)> diagonal{};
        for (int k = 0; k < K; ++k) {
            if (k > 0) {
                at(k, k) += ridgeTimesRows;
            }
            diagonal[static_cast<std::size_t>(k)] = at(k, k);
        }
        for (int k = 0; k < K; ++k) {
            const double pivot = at(k, k);
            const bool vanished = pivot <= 1e-14 * diagonal[static_cast<std::size_t>(k)];
            at(k, k) = vanished ? 0.0 : 1.0 / pivot;  // inverse kept
            for (int row = k + 1; row < K; ++row) {
                const double factor = at(row, k) * at(k, k);
                for (int col = k + 1; col <= row; ++col) {
                    at(row, col) -= factor * at(col, k);
                }
            }
            for (int row = k + 1; row < K; ++row) {
                at(row, k) *= at(k, k);
            }
        }
    }
    static void solve(const Gram& factored, Vector& b) noexcept {
        const auto at = [&factored](int row, int col) { return factored[static_cast<std::size_t>(row * K + col)]; };
        for (int row = 1; row < K; ++row) {
            for (int col = 0; col < row; ++col) {
                b[static_cast<std::size_t>(row)] -= at(row, col) * b[static_cast<std::size_t>(col)];
            }
        }
        for (int row = 0; row < K; ++row) {
            b[static_cast<std::size_t>(row)] *= at(row, row);
        }
        for (int row = K - 2; row >= 0; --row) {
            for (int col = row + 1; col < K; ++col) {
                b[static_cast<std::size_t>(row)] -= at(col, row) * b[static_cast<std::size_t>(col)];
            }
        }
    }
    /// vᵀ·G·v from the lower triangle.
    [[nodiscard]] static double quadraticForm(const Gram& g, const Vector& v) noexcept {
        double sum = 0.0;
        for (int row = 0; row < K; ++row) {
            double inner = 0.0;
            for (int col = 0; col < row; ++col) {
                inner += g[static_cast<std::size_t>(row * K + col)] * v[static_cast<std::size_t>(col)];
            }
            const double own = v[static_cast<std::size_t>(row)];
            sum += own * (2.0 * inner + g[static_cast<std::size_t>(row * K + row)] * own);
        }
        return sum;
    }
};

}  // namespace kerf::thermal
