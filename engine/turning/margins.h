// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <string_view>

#include "engine/turning/depth_path.h"
#include "engine/turning/pi_law.h"

namespace kerf::turning {

/// L(e^{jω}) of an open loop whose negative feedback 1 + g·L = 0 is to stay stable; ω in rad per sample, (0, π].
using LoopResponse = std::function<std::complex<double>(double omega_radPerSample)>;

/// Smallest factor g > 0 on the loop gain at which the closed loop reaches the unit circle.
///
/// Scans 20,000 frequencies for Im L = 0 with Re L < 0, refines each by bisection, adds ω = π. The loop has to be
/// stable for small g. Not in the cycle. Infinity when no such frequency exists.
[[nodiscard]] double gainLimit(const LoopResponse& loop);

struct Margins {
    double gain{0.0};       ///< factor
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

/// Margins of a PI law on the way the plant gives it (DepthPath, delay included).
[[nodiscard]] Margins lawMargins(PlantKind plant, const PiGains& gains, const ProcessParams& process);

/// What the default law guarantees at every tone when tones are far apart against the filter's bandwidth: in the tone's
/// frame the loop is a real integrator with the ratio of true to modelled path as its gain.
/// Stable while the path's phase error stays below 90°; so a further delay of a quarter period of the highest tone.
[[nodiscard]] Margins cancellerMargins(double highestTone_Hz, double sampleRate_Hz) noexcept;

}  // namespace kerf::turning
