// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/contour_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kerf::tapping {

ContourFigures contourFigures(std::span<const double> spindle_rev, std::span<const double> z_mm,
                              std::span<const std::uint8_t> valid, double pitch_mm, double engage_rev) {
    assert(spindle_rev.size() == z_mm.size());
    ContourFigures figures;
    double sum_mm = 0.0;
    double squares_mm2 = 0.0;
    double low_mm = 0.0;
    double high_mm = 0.0;
    bool engaged = false;
    for (std::size_t k = 0; k < z_mm.size(); ++k) {
        if (!valid.empty() && valid[k] == 0) {
            ++figures.missing;
            continue;
        }
        const double error_mm = pitch_mm * spindle_rev[k] - z_mm[k];
        ++figures.samples;
        sum_mm += std::abs(error_mm);
        squares_mm2 += error_mm * error_mm;
        figures.peak_um = std::max(figures.peak_um, 1000.0 * std::abs(error_mm));
        if (spindle_rev[k] >= engage_rev) {
            low_mm = engaged ? std::min(low_mm, error_mm) : error_mm;
            high_mm = engaged ? std::max(high_mm, error_mm) : error_mm;
            engaged = true;
        }
    }
    if (figures.samples > 0) {
        const auto counted = static_cast<double>(figures.samples);
        figures.saec_mm = sum_mm;
        if (figures.missing > 0) figures.saec_mm *= static_cast<double>(z_mm.size()) / counted;
        figures.rms_um = 1000.0 * std::sqrt(squares_mm2 / counted);
    }
    figures.engagedPp_um = 1000.0 * (high_mm - low_mm);
    return figures;
}

}  // namespace kerf::tapping
