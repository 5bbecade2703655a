// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/process/tapping/drive_params.h"

namespace kerf::tapping {

/// What may be set on the drive between two taps, in the machine's own units.
struct TapSettings {
    double spindleKp_perS{40.0};
    double zKp_perS{48.0};
    double zVelocityFf{0.0};         ///< share of the commanded Z speed
    double zAccelFf{0.0};            ///< share of the commanded Z acceleration
    std::vector<double> zTrim_mm{};  ///< learned addition to the Z position command, per tick; empty: none
};

/// One recorded tap, sampled at the position tick from the begin of the command. `valid` may be empty: all valid.
struct TapSignals {
    std::span<const double> spindle_rev{};
    std::span<const double> z_mm{};
    std::span<const std::uint8_t> valid{};
};

/// Drive parameters with the settings of a tap put in.
[[nodiscard]] DriveParams withSettings(const DriveParams& params, const TapSettings& settings);

/// Z as the assumed servo would follow the tap's reference (the command, or the recorded spindle when slaved), tick by
/// tick. The spindle of the record decides where thrust acts. Allocates; never in the cycle.
[[nodiscard]] std::vector<double> predictZ(const DriveParams& assumed, const TapSettings& settings,
                                           std::span<const double> spindle_rev);

/// Response of the servo, without friction and limits, to a trim of the Z command.
[[nodiscard]] std::vector<double> trimResponse(const DriveParams& assumed, std::span<const double> trim_mm);

/// The assumed constants w_z, w_iz and t_a moved so that the model reproduces the recorded Z; least squares with the
/// assumption as prior (standard deviations of the logarithms .5, .5 and 1). Levenberg-Marquardt, at most ten steps.
[[nodiscard]] DriveParams fitServo(const DriveParams& assumed, const TapSettings& settings, const TapSignals& tap);

/// Open position loop at gain 1, s = jω: velocity loop, lag, dead time, resonance, integration and the sample-and-hold
/// of the tick.
[[nodiscard]] std::complex<double> openLoop(const DriveParams& drive, double omega_perS);

/// Position gain at which the loop would just oscillate: the least where its phase crosses −180°, a resonance included.
[[nodiscard]] double criticalZKp_perS(const DriveParams& drive);

/// Gains a proposal may have: 50 to 160 % of the initial gain, and at most the critical gain over 2.5 (8 dB), where the
/// assumed and the fitted servo's smaller critical gain counts: a record tells the sum of the lags, not how they split.
struct SafeGains {
    double lowest_perS{0.0};
    double highest_perS{0.0};
    double critical_perS{0.0};  ///< estimated
    double highestTrim_mm{0.0};
};
[[nodiscard]] SafeGains safeGains(const DriveParams& assumed, const DriveParams& fitted, double initialZKp_perS);
/// The same with a highest gain that stability allows, and the critical gain it was taken from.
[[nodiscard]] SafeGains safeGains(double critical_perS, double stable_perS, double pitch_mm, double initialZKp_perS);

}  // namespace kerf::tapping
