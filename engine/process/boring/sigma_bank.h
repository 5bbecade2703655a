// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/process/boring/kalman_estimator.h"

/// The gauge's σ, learnt from how well the bores are predicted: one Kalman estimator for each σ it might be, weighted
/// by the evidence of all parts so far.
///
///   candidates  σ·{½, 1/√2, 1, √2, 2},  prior weights {.02, .08, .8, .08, .02}
///   weight      ∏ p(bores of part k | bores before, σ candidate)
///   in force    the candidate with the largest weight; its estimate is the lot's
///
/// A change of the process counts with the probability .02 per part, so that a gauge that scatters is not taken for a
/// tool that breaks, part after part. Pure functions of their input; no allocation.
namespace kerf::boring {

inline constexpr std::array<double, 5> kSigmaFactors{0.5, 0.70710678118654752, 1.0, 1.4142135623730951, 2.0};

struct SigmaBank {
    std::array<KalmanState, kSigmaFactors.size()> states{};
    std::array<double, kSigmaFactors.size()> lnWeight{};
    [[nodiscard]] static SigmaBank from(const KalmanState& state) noexcept;
    [[nodiscard]] std::size_t inForce() const noexcept;
    [[nodiscard]] double factor() const noexcept { return kSigmaFactors[inForce()]; }
    [[nodiscard]] const KalmanState& state() const noexcept { return states[inForce()]; }
};

/// Takes one part. `outcome`, of the candidate in force afterwards, may be null.
[[nodiscard]] SigmaBank update(const SigmaBank& before, const KalmanParams& params, const PartVisit& visit,
                               RowOutcome* outcome) noexcept;

}  // namespace kerf::boring
