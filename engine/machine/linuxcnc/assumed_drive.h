// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/machine/linuxcnc/tap_follower.h"
#include "engine/process/tapping/drive_params.h"

namespace kerf::linuxcnc {

/// What a tuner assumes of a Z closed by LinuxCNC's pid: it follows the measured spindle, two servo periods late, its
/// feed-forward acts on the command's first and second difference; the drive is a velocity loop of `bandwidth_perS`
/// without integrator. The tuner fits the constants to what it records.
[[nodiscard]] inline tapping::DriveParams assumedDrive(double bandwidth_perS) {
    tapping::DriveParams drive;
    drive.slaved = 1.0;
    drive.referenceDelay_s = static_cast<double>(TapFollower::kDelay) * drive.tick_s;
    drive.referenceAccel = 1.0;
    drive.zBandwidth_perS = bandwidth_perS;
    drive.zIntegral_perS = 1.0;
    drive.zCoulomb_mmPerS2 = 0.0;
    drive.zViscous_perS = 0.0;
    drive.thrust_mmPerS2 = 0.0;
    return drive;
}

/// The simulator's drive (kerf-sim.hal), and kerf.z-bandwidth when nothing else is set.
inline constexpr double kAssumedBandwidth_perS = 400.0;

}  // namespace kerf::linuxcnc
