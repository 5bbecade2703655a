// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/process/boring/estimate.h"

namespace kerf::boring {

/// The paper's estimator: recursive least squares in ln d whose covariance is thrown back to I when the process has
/// changed.
///
///   gain        θ += P·x·(y − xᵀθ) / (A + xᵀPx)             (5)
///   covariance  P −= P·x·xᵀ·P / (B + xᵀPx)                  (6)
///   noise       A = B = (σ/d0)², the consistent reading; print: eq. 5 has Σ_k, eq. 6 has 1
///   change      the last three consecutive measurements, or the last three at one overhang, all outside d0 ± 3σ:
///               P := I before this measurement's update; counters start again. From part 2 on.
///
/// Source: Lee (1983); readings in docs/boring.md. Deviation: a measurement cut with the feed at a limit is not counted
/// (d0 was out of reach), else P would be thrown back for ever.
/// Pure functions of their input: same state and measurements, same digits.
struct PerturbationParams {
    enum class Noise : std::uint8_t { Consistent, Unit, LiteralPrint };  ///< A, B: R, R | 1, 1 | R, 1
    enum class Trigger : std::uint8_t { Either, Consecutive, SameOverhang };
    enum class Timing : std::uint8_t { BeforeUpdate, AfterUpdate };

    double sigma_mm{kTableSigma_mm};                        ///< > 0
    double targetDeflection_mm{kTableTargetDeflection_mm};  ///< d0 > 0
    double alpha0{0.5};                                     ///< (0, 1], by experience
    Noise noise{Noise::Consistent};
    Trigger trigger{Trigger::Either};
    Timing timing{Timing::BeforeUpdate};
    bool firstPartUpdates{true};  ///< part 1 also updates θ and P
};

struct PerturbationState {
    bool ready{false};
    std::uint32_t firstPart{0};  ///< part whose measurement began the estimate
    LawConstants law{};
    Covariance covariance{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    std::uint8_t inARow{0};
    std::uint8_t overhangCount{0};
    std::array<double, kMaxBoreDepths> overhang_mm{};     ///< depths seen
    std::array<std::uint8_t, kMaxBoreDepths> inARowAt{};  ///< per depth
    std::uint8_t waitingCount{0};                         ///< measurements before eqs. 9-10 could be solved
    std::array<Measurement, kMaxBoreDepths> waiting{};
    friend bool operator==(const PerturbationState&, const PerturbationState&) = default;
};

/// One step of eqs. 5-6. @return the innovation y − xᵀθ
double recursiveLeastSquaresStep(Eigen::Vector3d& theta, Eigen::Matrix3d& p, const Eigen::Vector3d& x, double y,
                                 double a, double b) noexcept;

/// Counts measurements outside the band; true when this one completes three in a row.
[[nodiscard]] bool noticeOutside(PerturbationState& state, const PerturbationParams& params,
                                 const Measurement& measurement) noexcept;

/// Takes the visit's measurements one by one. `rows` is empty or has visit.count places; rows before the estimate could
/// begin get the estimate it then began with.
[[nodiscard]] PerturbationState update(const PerturbationState& before, const PerturbationParams& params,
                                       const PartVisit& visit, std::span<RowOutcome> rows) noexcept;

}  // namespace kerf::boring
