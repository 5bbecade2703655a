// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/sampled_force.h"

#include <cmath>
#include <numbers>

namespace kerf::milling {

double sampledForce_N(const ForceShape& shape, double meanForce_N, double angle_rev) noexcept {
    if (meanForce_N == 0.0) {  // in air
        return 0.0;
    }
    const double flute_rev = angle_rev + shape.markAt_rev;
    const double turn = 2.0 * std::numbers::pi * (flute_rev - std::floor(flute_rev));
    const double tooth = static_cast<double>(shape.flutes) * turn;
    const double teeth = 1.0 + shape.toothRipple * (std::cos(tooth) + 0.25 * std::cos(2.0 * tooth));
    const double pitch = std::floor(tooth / (2.0 * std::numbers::pi));
    const double flute = !shape.missing || pitch > 1.0 ? 1.0 : 2.0 * pitch;
    return meanForce_N * (teeth * flute + shape.runOut * std::cos(turn));
}

}  // namespace kerf::milling
