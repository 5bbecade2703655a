// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "engine/core/result.h"

namespace kerf::turning {

/// Which tones the force can see at a spindle speed, and a speed near it where all are seen better.
///
/// The force sees x_o − x_i = −(1 − z⁻ᵈ)·x_i: a tone at a multiple of the revolution is invisible in steady state.
/// Visibility is |1 − exp(−jωd)|, 0 blind to 2; below .05 the tone is named blind. d is rounded to whole samples, as
/// the loop rounds it (eq. 5).
struct ToneVisibility {
    double frequency_Hz{0.0};
    double visibility{0.0};
    bool blind{false};
};
struct BlindReport {
    double spindle_rps{0.0};
    std::size_t revolutionSamples{0};
    std::vector<ToneVisibility> tones{};
    double worst{0.0};          ///< smallest visibility
    double suggested_rps{0.0};  ///< within ±`span` of the speed, the one whose worst tone is seen best
    std::size_t suggestedSamples{0};
    double suggestedWorst{0.0};
};

/// Not in the cycle. Errors: speed from sampleRate/2000 to sampleRate/10 rev/s, tones above 0 and below half the rate.
[[nodiscard]] Result<BlindReport> blindFrequencies(double spindle_rps, std::span<const double> tones_Hz,
                                                   double sampleRate_Hz, double span = 0.1);

}  // namespace kerf::turning
