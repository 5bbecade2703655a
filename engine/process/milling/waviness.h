// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace kerf::milling {

/// How the finished wall is scanned: a gap sensor with a spot, between two points of the path.
struct WallScan {
    double grid_mm{0.4};        ///< the sensor's reading distance
    double spot_mm{2.0};        ///< width over which the sensor averages
    double from_mm{10.0};       ///< after entry
    double beforeExit_mm{0.5};  ///< left out before the end of the blank
    double length_mm{100.0};    ///< of the blank
};

struct Waviness {
    double spot_um{0.0};        ///< max − min of the wall as the sensor with its spot sees it
    double raw_um{0.0};         ///< the same without a spot, on the grid
    double meanOffset_um{0.0};  ///< mean height of the wall over the line the tool would leave without force
};

/// Waviness of a wall from the tool's position after each revolution and its deflection δ_y there (piecewise linear).
///
/// The raw figure is taken on the grid; the spot is a running mean of a profile four times finer, evaluated at every
/// point of the finer profile (a scan does not fall in step with the cut). Empty when the cut does not cover the scan.
/// Allocates: for summaries and pages, not for the cycle.
[[nodiscard]] std::optional<Waviness> wallWaviness(std::span<const double> x_mm, std::span<const double> deflectionY_mm,
                                                   const WallScan& scan);

}  // namespace kerf::milling
