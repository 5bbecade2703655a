// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/process/boring/estimator.h"

/// How far a part's bores are from what the law predicted for the feed it was really cut with: what quality charts show
/// of a process that is steered. The controller moves the bores, but not these errors.
///
///   ν = d − d̂                     innovation, mm, one per bore
///   S = H P Hᵀ + σ² I, H = d̂·x    its covariance, with P as believed before the part was seen
///   e_i = ν_i/√S_ii                the standardised one-step error of a bore
///   T² = νᵀ S⁻¹ ν                  all bores together, χ² with as many degrees of freedom when the law is right
///   e = hᵀS⁻¹ν/√(hᵀS⁻¹h), h = d̂    the component of a change of level (ln C), N(0, 1) when the law is right
///
/// Sign: + is a larger deflection than predicted, a bore that came out smaller.
namespace kerf::boring {

struct OneStepError {
    std::size_t count{0};                              ///< bores; 0: the law is not known yet, nothing is charted
    std::array<double, kMaxBoreDepths> error{};        ///< e_i, in the order of the visit
    std::array<double, kMaxBoreDepths> expected_mm{};  ///< d̂
    double level{0.0};                                 ///< e
    double tSquared{0.0};
};

/// @pre `before` was made with the same params.kind
[[nodiscard]] OneStepError oneStepError(const EstimatorState& before, const EstimatorParams& params,
                                        const PartVisit& visit) noexcept;

}  // namespace kerf::boring
