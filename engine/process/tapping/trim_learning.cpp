// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/trim_learning.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "engine/process/tapping/tap_drive.h"

namespace kerf::tapping {
namespace {

constexpr std::size_t kKnot_ticks = 6;
constexpr double kBend_mm = 0.03;  ///< prior spread of the splines' second differences
constexpr double kSize_mm = 1.0;   ///< prior spread of the coefficients
constexpr double kLeastNoise_mm = 0.0003;
constexpr double kMadToSigma = 0.6745;
constexpr double kSecondDifferenceGain = 2.449489742783178;  // √6

/// Cubic B-spline over 4 knots, starting at tick 0.
std::vector<double> splineShape() {
    std::vector<double> shape(4 * kKnot_ticks);
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const double x = std::abs(static_cast<double>(i) / static_cast<double>(kKnot_ticks) - 2.0);
        const double outer = 2.0 - x;
        const double inner = 1.0 - x;
        shape[i] = outer > 0.0 ? outer * outer * outer / 6.0 : 0.0;
        if (inner > 0.0) shape[i] -= 4.0 * inner * inner * inner / 6.0;
    }
    return shape;
}

}  // namespace

std::vector<double> contourError(const TapSignals& tap, double pitch_mm) {
    const std::size_t n = tap.z_mm.size();
    std::vector<double> error_mm(n, 0.0);
    std::size_t lastValid = n;
    for (std::size_t k = 0; k < n; ++k) {
        if (!tap.valid.empty() && tap.valid[k] == 0) {
            error_mm[k] = lastValid < n ? error_mm[lastValid] : 0.0;
            continue;
        }
        error_mm[k] = pitch_mm * tap.spindle_rev[k] - tap.z_mm[k];
        if (lastValid < n && lastValid + 1 < k) {
            for (std::size_t gap = lastValid + 1; gap < k; ++gap) {
                const double share = static_cast<double>(gap - lastValid) / static_cast<double>(k - lastValid);
                error_mm[gap] = error_mm[lastValid] + share * (error_mm[k] - error_mm[lastValid]);
            }
        }
        lastValid = k;
    }
    return error_mm;
}

double errorNoise_mm(std::span<const double> error_mm) {
    if (error_mm.size() < 3) return 0.0;
    std::vector<double> bends(error_mm.size() - 2);
    for (std::size_t k = 0; k < bends.size(); ++k) {
        bends[k] = std::abs(error_mm[k] - 2.0 * error_mm[k + 1] + error_mm[k + 2]);
    }
    const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
    std::nth_element(bends.begin(), middle, bends.end());
    return *middle / kMadToSigma / kSecondDifferenceGain;
}

double sumAbs_mm(std::span<const double> error_mm) {
    double sum_mm = 0.0;
    for (const double e_mm : error_mm)
        sum_mm += std::abs(e_mm);
    return sum_mm;
}

FeedForward feedForwardFor(const DriveParams& model, const TapSettings& settings, std::span<const double> spindle_rev,
                           std::span<const double> error_mm) {
    constexpr double kStep = 0.02;
    const std::vector<double> base = predictZ(model, settings, spindle_rev);
    TapSettings moved = settings;
    moved.zVelocityFf += kStep;
    const std::vector<double> byVelocity = predictZ(model, moved, spindle_rev);
    moved = settings;
    moved.zAccelFf += kStep;
    const std::vector<double> byAccel = predictZ(model, moved, spindle_rev);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-6;
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < base.size(); ++k) {
        const Eigen::Vector2d slope((byVelocity[k] - base[k]) / kStep, (byAccel[k] - base[k]) / kStep);
        normal += slope * slope.transpose();
        right += slope * error_mm[k];
    }
    const Eigen::Vector2d found = normal.ldlt().solve(right);
    return {found(0), found(1)};
}

TrimUpdate trimFor(const DriveParams& model, std::span<const double> error_mm, double noise_mm) {
    const std::size_t n = error_mm.size();
    const std::vector<double> shape = splineShape();
    std::vector<double> pulse(std::min(n, shape.size() + static_cast<std::size_t>(0.25 / model.tick_s)), 0.0);
    std::copy_n(shape.begin(), std::min(shape.size(), pulse.size()), pulse.begin());
    const std::vector<double> response = trimResponse(model, pulse);
    const std::size_t count = (n + kKnot_ticks - 1) / kKnot_ticks;
    const std::size_t reach = (response.size() + kKnot_ticks - 1) / kKnot_ticks;

    const double noise2_mm2 = std::pow(std::max(noise_mm, kLeastNoise_mm), 2);
    const double bend = noise2_mm2 / (kBend_mm * kBend_mm);
    const double size = noise2_mm2 / (kSize_mm * kSize_mm);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(count * (reach + 5));
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
    for (std::size_t j = 0; j < count; ++j) {
        const std::size_t begin = j * kKnot_ticks;
        const std::size_t length = std::min(response.size(), n - begin);
        for (std::size_t i = 0; i < length; ++i)
            right(static_cast<Eigen::Index>(j)) += response[i] * error_mm[begin + i];
        for (std::size_t d = 0; d < reach && j + d < count; ++d) {
            const std::size_t shift = d * kKnot_ticks;
            double sum = d == 0 ? size : 0.0;
            for (std::size_t i = shift; i < length; ++i)
                sum += response[i] * response[i - shift];
            // Lower triangle only.
            entries.emplace_back(static_cast<int>(j + d), static_cast<int>(j), sum);
        }
        constexpr std::array<double, 3> kDifference{1.0, -2.0, 1.0};
        for (std::size_t a = 0; a < 3 && j + 2 < count; ++a) {
            for (std::size_t b = 0; b <= a; ++b) {
                entries.emplace_back(static_cast<int>(j + a), static_cast<int>(j + b),
                                     bend * kDifference[a] * kDifference[b]);
            }
        }
    }
    Eigen::SparseMatrix<double> normal(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
    normal.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd weights =
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>(normal).solve(right);

    TrimUpdate update;
    update.trim_mm.assign(n, 0.0);
    for (std::size_t j = 0; j < count; ++j) {
        const std::size_t begin = j * kKnot_ticks;
        for (std::size_t i = 0; i < shape.size() && begin + i < n; ++i) {
            update.trim_mm[begin + i] += weights(static_cast<Eigen::Index>(j)) * shape[i];
        }
    }
    update.explained_mm = trimResponse(model, update.trim_mm);
    return update;
}

}  // namespace kerf::tapping
