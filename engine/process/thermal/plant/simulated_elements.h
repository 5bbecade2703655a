// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/process/thermal/volumetric.h"

namespace kerf::thermal {

/// Error elements of the simulated machine (760 × 430 × 500 mm) as a laser would have found them: links of ordinary
/// size, joint errors linear in the position of their axis. Our own choice, of the size the paper reports.
[[nodiscard]] inline ErrorElements simulatedElements() {
    constexpr double kMicron = 1e-3;
    constexpr double kMicroRad = 1e-6;
    using V = Eigen::Vector3d;
    ErrorElements e;
    e.shape_mm = {V(0, 0, -180), V(0, 420, 650), V(60, -300, 90), V(-40, 0, 70)};
    e.shapeError[0] = {V(1, -2, 3) * kMicron, V(4, -3, 2) * kMicroRad};
    e.shapeError[1] = {V(-2, 4, 5) * kMicron, V(-6, 5, 3) * kMicroRad};
    e.shapeError[2] = {V(2, 1, -2) * kMicron, V(3, 2, -5) * kMicroRad};
    e.shapeError[3] = {V(-1, 2, 1) * kMicron, V(-2, 3, 4) * kMicroRad};
    e.jointErrorPer_mm[0] = {V(0.004, -0.006, 0.012) * kMicron, V(0.02, -0.012, 0.006) * kMicroRad};
    e.jointErrorPer_mm[1] = {V(-0.005, 0.014, 0.004) * kMicron, V(-0.016, 0.01, 0.02) * kMicroRad};
    e.jointErrorPer_mm[2] = {V(0.010, 0.005, -0.007) * kMicron, V(0.008, 0.022, -0.014) * kMicroRad};
    return e;
}
inline constexpr double kTravelX_mm = 760.0;
inline constexpr double kTravelY_mm = 430.0;
inline constexpr double kTravelZ_mm = 500.0;

}  // namespace kerf::thermal
