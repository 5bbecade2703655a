// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <span>
#include <string_view>

#include "engine/process/turning/broadband_predictor.h"
#include "engine/process/turning/depth_path.h"
#include "engine/process/turning/pi_law.h"

namespace kerf::turning {

/// L(e^{jω}) of an open loop whose negative feedback 1 + g·L = 0 is to stay stable; ω in rad per sample, (0, π].
using LoopResponse = std::function<std::complex<double>(double omega_radPerSample)>;

/// Smallest factor g > 0 on the loop gain at which the closed loop reaches the unit circle.
///
/// Scans 20,000 frequencies for Im L = 0 with Re L < 0, refines each by bisection, adds ω = π. The loop has to be
/// stable for small g. Not in the cycle. Infinity when no such frequency exists.
[[nodiscard]] double gainLimit(const LoopResponse& loop);

struct Margins {
    double gain{0.0};       ///< factor by which the loop gain may grow
    double gainLow{0.0};    ///< factor to which it may fall; 0: no limit
    double phase_deg{0.0};  ///< smallest over all crossings of |L| = 1
    double delay_samples{0.0};
    double modulus{0.0};  ///< smallest |1 + L|
};
[[nodiscard]] Margins margins(const LoopResponse& loop);

/// One loop of the paper with one sample of delay, and its gain limit.
struct NamedLimit {
    std::string_view name{};
    std::string_view loop{};
    double limit{0.0};
};
/// PC, C, PC/.24 with unit gain; R0 as a factor on (1 − µ) = .02; R1 as a factor on g = .3, times one over g.
[[nodiscard]] std::array<NamedLimit, 5> paperLimits(const ProcessParams& process);

/// Margins of a PI law on the way the plant gives it (DepthPath, delay included), when `truth` cuts and the law is
/// tuned to `process`. On B2 the law rebuilds x_i by F/P: the loop gets the factor truth/process.
[[nodiscard]] Margins lawMargins(PlantKind plant, const PiGains& gains, const ProcessParams& process,
                                 const ProcessParams& truth);
[[nodiscard]] inline Margins lawMargins(PlantKind plant, const PiGains& gains, const ProcessParams& process) {
    return lawMargins(plant, gains, process, process);
}

/// One tone that the default law follows: its frequency and κ, the Kalman gain of its amplitude per sample.
struct FollowedTone {
    double frequency_Hz{0.0};
    double share{0.0};
};
/// The default law as it stands: its tones, how far they are trusted (β), and the weights of both predictions.
struct StandingLaw {
    std::span<const FollowedTone> tones{};
    double toneShare{1.0};
    std::array<double, BroadbandPredictor::kFilters> plain{};
    std::array<double, BroadbandPredictor::kFilters> underTones{};
};
/// Margins of the whole default law on B2, tones and prediction together, tuned to `process`, while `truth` cuts.
///
/// With gains, weights and β constant and the frequencies held the law is linear and time-invariant:
///   B_j(z) = κ_j/(1 − e^{jω_j} z⁻¹)·e, e = m − Σ Re{e^{jω_j} z⁻¹ B_j} (tones), m = x_i − path·w
///   −path·w = T·m, T = −β·G·path/(1 + G_p) + z⁻¹[(1 − β) H + β H_u/(1 + G_p)], H = V/R of each prediction
/// so L = r·T/(1 − T), r = truth/process. gainLow may be above 0: the law knows its own path. Nothing that acts: no
/// loop, nothing to lose (infinite margins). Not in the cycle.
[[nodiscard]] Margins defaultMargins(const StandingLaw& standing, const ProcessParams& process,
                                     const ProcessParams& truth, double sampleRate_Hz);
/// The same with tones alone, all trusted.
[[nodiscard]] inline Margins toneMargins(std::span<const FollowedTone> tones, const ProcessParams& process,
                                         const ProcessParams& truth, double sampleRate_Hz) {
    return defaultMargins({tones, 1.0, {}, {}}, process, truth, sampleRate_Hz);
}

/// The worst of what `ofTruth` gives over the 95 % box of an identified process: guaranteed margins.
[[nodiscard]] Margins guaranteedMargins(const ProcessParams& identified, const std::array<double, 3>& half95,
                                        const std::function<Margins(const ProcessParams&)>& ofTruth);

/// What the default law guarantees at every tone when tones are far apart against the filter's bandwidth: in the tone's
/// frame the loop is a real integrator with the ratio of true to modelled path as its gain.
/// Stable while the path's phase error stays below 90°; so a further delay of a quarter period of the highest tone.
[[nodiscard]] Margins cancellerMargins(double highestTone_Hz, double sampleRate_Hz) noexcept;

}  // namespace kerf::turning
