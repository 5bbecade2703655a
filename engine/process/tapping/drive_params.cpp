// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/drive_params.h"

#include <array>

namespace kerf::tapping {

std::span<const DriveKey> driveKeys() {
    using P = DriveParams;
    static constexpr std::array keys{
        DriveKey{"pitch", &P::pitch_mm, 0.1, 10.0},
        DriveKey{"revs", &P::depth_rev, 1.0, 200.0},
        DriveKey{"rpm", &P::speed_rpm, 10.0, 20000.0},
        DriveKey{"acc", &P::ramp_revPerS2, 1.0, 1e5},
        DriveKey{"Tp", &P::tick_s, 1e-4, 0.01},
        DriveKey{"sub", &P::substeps, 1.0, 100.0},
        DriveKey{"dwell", &P::tail_s, 0.0, 5.0},
        DriveKey{"Kps", &P::spindleKp_perS, 0.1, 5000.0},
        DriveKey{"ffs", &P::spindleVelocityFf, -2.0, 2.0},
        DriveKey{"ws", &P::spindleBandwidth_perS, 1.0, 5000.0},
        DriveKey{"wis", &P::spindleIntegral_perS, 0.0, 1000.0},
        DriveKey{"tf", &P::spindleFilter_s, 1e-4, 0.1},
        DriveKey{"amax_s", &P::spindleAccelMax_revPerS2, 1.0, 1e6},
        DriveKey{"vis_s", &P::spindleViscous_perS, 0.0, 100.0},
        DriveKey{"Kpz", &P::zKp_perS, 0.1, 5000.0},
        DriveKey{"ffz", &P::zVelocityFf, -2.0, 2.0},
        DriveKey{"faz", &P::zAccelFf, -100.0, 100.0},
        DriveKey{"wz", &P::zBandwidth_perS, 1.0, 5000.0},
        DriveKey{"wiz", &P::zIntegral_perS, 0.0, 1000.0},
        DriveKey{"ta", &P::zTorqueLag_s, 1e-4, 0.1},
        DriveKey{"amax_z", &P::zAccelMax_mmPerS2, 1.0, 1e7},
        DriveKey{"vis_z", &P::zViscous_perS, 0.0, 100.0},
        DriveKey{"coul_z", &P::zCoulomb_mmPerS2, 0.0, 1e5},
        DriveKey{"vc", &P::reversalSpeed, 0.01, 100.0},
        DriveKey{"load", &P::load_revPerS2, 0.0, 1e4},
        DriveKey{"load_out", &P::loadOut_revPerS2, 0.0, 1e4},
        DriveKey{"engage", &P::engage_rev, 0.0, 100.0},
        DriveKey{"chamfer", &P::chamfer_rev, 0.01, 100.0},
        DriveKey{"thrust", &P::thrust_mmPerS2, 0.0, 1e5},
        DriveKey{"slave", &P::slaved, 0.0, 1.0},
        DriveKey{"delay", &P::zDelay_s, 0.0, 0.01},
        DriveKey{"res_hz", &P::zResonance_Hz, 0.0, 500.0},
        DriveKey{"res_damping", &P::zResonanceDamping, 0.001, 0.9},
        DriveKey{"res_share", &P::zResonanceShare, 0.0, 2.0},
        DriveKey{"backlash_um", &P::zBacklash_um, 0.0, 200.0},
        DriveKey{"stiction", &P::zStiction, 0.0, 5.0},
        DriveKey{"gear", &P::spindleGear, 1.0, 2.0},
        DriveKey{"gear_ratio", &P::gearRatio, 1.0, 10.0},
        DriveKey{"motor_share", &P::motorInertiaShare, 0.0, 1.0},
    };
    return keys;
}

const DriveKey* findDriveKey(std::string_view key) {
    for (const DriveKey& entry : driveKeys()) {
        if (key == entry.key) return &entry;
    }
    return nullptr;
}

DriveParams inGear(const DriveParams& drive) {
    if (drive.spindleGear < 1.5) return drive;
    DriveParams out = drive;
    const double ratio = drive.gearRatio;
    const double inertia = 1.0 - drive.motorInertiaShare + ratio * ratio * drive.motorInertiaShare;
    out.spindleAccelMax_revPerS2 *= ratio / inertia;
    out.spindleBandwidth_perS *= ratio * ratio / inertia;
    out.load_revPerS2 /= inertia;
    out.loadOut_revPerS2 /= inertia;
    out.spindleViscous_perS /= inertia;
    out.spindleGear = 1.0;
    return out;
}

DriveParams middlingDrive() {
    DriveParams drive;
    drive.spindleBandwidth_perS = 120.0;
    drive.spindleIntegral_perS = 15.0;
    drive.spindleFilter_s = 0.0015;
    drive.spindleViscous_perS = 0.3;
    drive.zBandwidth_perS = 300.0;
    drive.zIntegral_perS = 35.0;
    drive.zTorqueLag_s = 0.0012;
    drive.zViscous_perS = 1.0;
    drive.zCoulomb_mmPerS2 = 40.0;
    drive.thrust_mmPerS2 = 20.0;
    return drive;
}

}  // namespace kerf::tapping
