// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/one_step_error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace kerf::boring {
namespace {

constexpr int kMaxDepths = static_cast<int>(kMaxBoreDepths);
constexpr double kLargestLnD = 5.0;  // keeps the expectation of a wild law finite
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxDepths, 1>;
using Design = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, kMaxDepths, 3>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxDepths, kMaxDepths>;

Estimate believed(const EstimatorState& before, const EstimatorParams& params, const PartVisit& visit) noexcept {
    const auto* kalman = std::get_if<KalmanState>(&before);
    return kalman != nullptr ? predictedFor(*kalman, params.kalman, visit) : estimateOf(before);
}

}  // namespace

OneStepError oneStepError(const EstimatorState& before, const EstimatorParams& params,
                          const PartVisit& visit) noexcept {
    OneStepError result;
    const Estimate estimate = believed(before, params, visit);
    if (!estimate.ready || visit.count == 0) {
        return result;
    }
    Design h(visit.count, 3);
    Vector expected_mm(visit.count);
    Vector innovation_mm(visit.count);
    for (Eigen::Index i = 0; i < visit.count; ++i) {
        const Measurement& bore = visit.rows[static_cast<std::size_t>(i)];
        h.row(i) << 1.0, std::log(bore.feed_mmPerRev), std::log(bore.overhang_mm);
        expected_mm(i) = std::exp(std::min(h.row(i).dot(vectorOf(estimate.law)), kLargestLnD));
        h.row(i) *= expected_mm(i);
        innovation_mm(i) = bore.deflection_mm - expected_mm(i);
    }
    const double sigma_mm = params.sigma_mm();
    Square s = h * matrixOf(estimate.covariance) * h.transpose();
    s.diagonal().array() += sigma_mm * sigma_mm;
    const Eigen::LLT<Square> factor(s);
    const Vector solved = factor.solve(innovation_mm);
    const double information = expected_mm.dot(factor.solve(expected_mm));
    result.count = visit.count;
    result.tSquared = innovation_mm.dot(solved);
    result.level = expected_mm.dot(solved) / std::sqrt(information);
    for (Eigen::Index i = 0; i < visit.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        result.error[at] = innovation_mm(i) / std::sqrt(s(i, i));
        result.expected_mm[at] = expected_mm(i);
    }
    return result;
}

}  // namespace kerf::boring
