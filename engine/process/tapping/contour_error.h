// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kerf::tapping {

/// Figures of one tap. Contour error E_r = pitch·θ − z, positive when Z is behind the spindle.
struct ContourFigures {
    double saec_mm{0.0};  ///< Σ|E_r| over the samples
    double peak_um{0.0};  ///< max |E_r|
    double rms_um{0.0};
    double engagedPp_um{0.0};  ///< max − min of E_r while the tap is in the work
    std::size_t samples{0};
    std::size_t missing{0};
};

/// Samples with `valid` 0 are left out; SAEC is then scaled to the whole tap. `valid` may be empty: all count.
/// @pre spindle_rev.size() == z_mm.size()
[[nodiscard]] ContourFigures contourFigures(std::span<const double> spindle_rev, std::span<const double> z_mm,
                                            std::span<const std::uint8_t> valid, double pitch_mm, double engage_rev);

}  // namespace kerf::tapping
