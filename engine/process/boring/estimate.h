// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "engine/process/boring/boring_types.h"
#include "engine/process/boring/model.h"

/// What both estimators share: θ, its covariance as plain values, and what one measurement did.
namespace kerf::boring {

/// Symmetric 3×3 as [00, 01, 02, 11, 12, 22]: stored, compared and printed in this order.
using Covariance = std::array<double, 6>;

[[nodiscard]] inline Eigen::Matrix3d matrixOf(const Covariance& p) noexcept {
    Eigen::Matrix3d m;
    m << p[0], p[1], p[2], p[1], p[3], p[4], p[2], p[4], p[5];
    return m;
}
/// The symmetric part of `m`.
[[nodiscard]] inline Covariance covarianceOf(const Eigen::Matrix3d& m) noexcept {
    return {m(0, 0), 0.5 * (m(0, 1) + m(1, 0)), 0.5 * (m(0, 2) + m(2, 0)), m(1, 1), 0.5 * (m(1, 2) + m(2, 1)), m(2, 2)};
}
[[nodiscard]] inline Eigen::Vector3d vectorOf(const LawConstants& law) noexcept {
    return {law.lnC, law.alpha, law.beta};
}
[[nodiscard]] inline LawConstants lawOf(const Eigen::Vector3d& theta) noexcept {
    return {theta(0), theta(1), theta(2)};
}

/// θ̂ and its covariance. Not ready: the first part has not been measured far enough to begin.
struct Estimate {
    bool ready{false};
    LawConstants law{};
    Covariance covariance{};
    friend bool operator==(const Estimate&, const Estimate&) = default;
};

/// Measurements of one part that belong together, in the order they were taken.
struct PartVisit {
    std::uint32_t part{0};  ///< ≥ 1, number within the lot
    std::uint8_t count{0};
    std::array<Measurement, kMaxBoreDepths> rows{};

    [[nodiscard]] std::span<const Measurement> measurements() const noexcept { return {rows.data(), count}; }
    friend bool operator==(const PartVisit&, const PartVisit&) = default;
};

/// What one measurement did to the estimate.
struct RowOutcome {
    Estimate after{};
    bool perturbed{false};  ///< a process change was noticed with this measurement
    double statistic{0.0};  ///< perturbation: measurements in a row outside the band; kalman: T² of the part so far
    friend bool operator==(const RowOutcome&, const RowOutcome&) = default;
};

}  // namespace kerf::boring
