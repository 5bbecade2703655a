// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/process/tapping/z_servo_model.h"

namespace kerf::tapping {

/// Z's position loop as two taps in the air show it, one with a sweep added to the Z command, one with it taken away.
struct MeasuredLoop {
    double critical_perS{0.0};  ///< gain at which the measured loop would just oscillate
    double highest_perS{0.0};   ///< with 8 dB to it, and the open loop half a unit from −1 at every smaller gain
    double resonance_Hz{0.0};   ///< 0: none found
    DriveParams fitted{};       ///< the assumed servo moved to what was measured, with its resonance
};

/// The sweep: 60 µm, 4 Hz to 220 Hz or .3 of the sampling rate, linear in time, low first so that it can ring out; over
/// by .25 s before the end. Slewing stays below 85 mm/s. Nothing in a tap shorter than .55 s.
[[nodiscard]] std::vector<double> probeTrim_mm(std::size_t ticks, double tick_s);

/// T = Δz/Δz_c by Fourier transform at any frequency (half the difference of the two taps begins and ends at rest),
/// open loop L = T/(1 − T), and with it the margins. Noise counts against them: two standard deviations are added to
/// |L|; above 80 Hz three neighbours 1.2 % apart are averaged. Not from the assumed servo; that is only moved to the
/// measurement for the learning.
/// Nothing when Z did not answer the sweep (a loop that takes no trim, a lost signal): at 4 to 8 Hz |T| must be .5
/// to 2.
/// @pre both taps were made with `settings`, without load, on the cycle of `assumed`, with +`probe_mm` and −`probe_mm`
[[nodiscard]] std::optional<MeasuredLoop> measureLoop(const DriveParams& assumed, const TapSettings& settings,
                                                      std::span<const double> probe_mm, const TapSignals& plus,
                                                      const TapSignals& minus);

}  // namespace kerf::tapping
