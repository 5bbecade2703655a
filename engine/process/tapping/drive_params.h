// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace kerf::tapping {

/// Every constant of the simulated tapping drive and its cycle; defaults are the reference drive BASE.
///
/// Spindle: position P, velocity PI behind a filter, acceleration limit. Z servo: position P, velocity PI, torque lag.
struct DriveParams {
    double pitch_mm{1.25};                ///< thread lead, > 0
    double depth_rev{22.0};               ///< revolutions in, > 0
    double speed_rpm{3000.0};             ///< > 0
    double ramp_revPerS2{500.0};          ///< spindle acceleration of the command, > 0
    double tick_s{0.001};                 ///< period of the position loops
    double substeps{5.0};                 ///< velocity-loop steps per tick, a whole number
    double tail_s{0.1};                   ///< record after the command has come back
    double spindleKp_perS{40.0};          ///< K_ps
    double spindleVelocityFf{0.0};        ///< share of the command's speed added to the speed command
    double spindleBandwidth_perS{150.0};  ///< w_s, velocity P
    double spindleIntegral_perS{18.75};   ///< velocity I is w_s times this
    double spindleFilter_s{0.002};        ///< filter on the speed command
    double spindleAccelMax_revPerS2{900.0};
    double spindleViscous_perS{0.5};
    double zKp_perS{48.0};          ///< K_pz
    double zVelocityFf{0.0};        ///< ff_z: share of the commanded Z speed
    double zAccelFf{0.0};           ///< fa_z: share of the commanded Z acceleration
    double zBandwidth_perS{400.0};  ///< w_z
    double zIntegral_perS{50.0};
    double zTorqueLag_s{0.0008};
    double zAccelMax_mmPerS2{6000.0};
    double zViscous_perS{2.0};
    double zCoulomb_mmPerS2{60.0};
    double reversalSpeed{0.5};      ///< softness of the friction's sign: mm/s for Z, rev/s for the spindle
    double load_revPerS2{80.0};     ///< tap torque going in, as spindle acceleration
    double loadOut_revPerS2{16.0};  ///< coming out
    double engage_rev{3.0};         ///< revolutions until the tap touches
    double chamfer_rev{3.0};        ///< revolutions until all its teeth cut
    double thrust_mmPerS2{30.0};    ///< axial force of the tap, as Z acceleration
    double slaved{0.0};             ///< 1: Z follows the measured spindle, 0: both follow one command
    double zDelay_s{0.0};           ///< dead time of the Z speed command, 0…0.01
    double zResonance_Hz{0.0};      ///< structural resonance of Z, 0: none
    double zResonanceDamping{0.05};
    double zResonanceShare{0.2};  ///< of the structure's swing that the measured position sees
    double zBacklash_um{0.0};     ///< play between motor and table; the position is measured at the table
    double zStiction{0.0};        ///< friction at rest over Coulomb's, as a share of it; gone above some mm/s
    double spindleGear{1.0};      ///< 1: direct; 2: low gear, gearRatio motor turns per spindle turn
    double gearRatio{2.5};
    double motorInertiaShare{0.6};  ///< of the spindle's inertia in gear 1
    double referenceDelay_s{0.0};  ///< model of a slaved Z: the spindle's angle reaches it this much later, whole ticks
    double referenceAccel{0.0};    ///< model of a slaved Z: 1: fa_z acts on the reference's second difference
};

/// One constant with its name in files and on the command line, and the range it must keep.
struct DriveKey {
    const char* key;  ///< as in DRIVE.json
    double DriveParams::*member;
    double min;
    double max;
};
[[nodiscard]] std::span<const DriveKey> driveKeys();
/// Null when there is no such key.
[[nodiscard]] const DriveKey* findDriveKey(std::string_view key);

/// The drive with its spindle in the gear it stands in, gear 1 afterwards. In gear 2 the motor's torque counts by the
/// ratio i and its inertia by i²: with r the motor's share, J = 1 − r + i² r; a_max·i/J, w_s·i²/J, load/J, vis_s/J.
[[nodiscard]] DriveParams inGear(const DriveParams& drive);

/// A middling servo: what a tuner assumes before it has seen the machine. Not the simulator's own constants.
[[nodiscard]] DriveParams middlingDrive();

}  // namespace kerf::tapping
