// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/tapping/tuning_verdict.h"

namespace kerf::tapping {

/// What a simulated machine adds to the clean drive.
struct TrialScatter {
    double noise_um{0.0};               ///< white, on the recorded Z
    double encoderSpindle_counts{0.0};  ///< counts per revolution; 0: exact
    double encoderZ_um{0.0};            ///< resolution of the recorded Z; 0: exact
    double loadSpread{0.0};             ///< each tap's load is scaled by 1 ± this, uniform
    double frictionSpread{0.0};         ///< each tap's Coulomb and viscous friction of Z likewise
};

/// A drive that taps and records as a real machine would.
class TrialMachine {
 public:
    TrialMachine(const DriveParams& drive, const TrialScatter& scatter, std::uint64_t seed);
    /// One tap; the spans stay valid until the next.
    [[nodiscard]] TapSignals tap(const TapSettings& settings);
    /// The same without work: no load. Its noise and friction come from streams of their own.
    [[nodiscard]] TapSignals airTap(const TapSettings& settings);

 private:
    TapSignals record(const DriveParams& drive, const TapSettings& settings, Random& noise);

    DriveParams m_drive;
    TrialScatter m_scatter;
    Random m_loads;
    Random m_noise;
    Random m_airFriction;
    Random m_airNoise;
    std::vector<double> m_spindle_rev;
    std::vector<double> m_z_mm;
};

/// The clean drive's figures with these settings: no noise, nominal load.
[[nodiscard]] ContourFigures cleanFigures(const DriveParams& drive, const TapSettings& settings);

/// Settings of a drive as they stand.
[[nodiscard]] TapSettings settingsOf(const DriveParams& drive);

/// What a tuner may know of a drive: its programmed cycle and set gains from `drive`, servo constants from `assumed`.
[[nodiscard]] DriveParams knownTo(const DriveParams& drive, const DriveParams& assumed);

/// One of the random machines of the tests and tables: every servo constant within ±25 % of the reference, spindle gain
/// 30-55 1/s, Z gain 85-135 % of it, torque limit 520-1000 rev/s², 1500-6000 rpm, 12-30 revolutions, load 40-160.
[[nodiscard]] DriveParams randomDrive(Random& random);

/// A machine that bites, drawn from a seed; seed 0 is the reference drive, digit for digit.
///
///   servos     every servo constant as in randomDrive(), friction and thrust ±25 %
///   lag        dead time of Z uniform 0-3 ms, torque lag .5-2 ms (log-uniform)
///   resonance  30-200 Hz, damping .02-.1, share .02-.3, each log-uniform
///   play       backlash uniform 2-20 µm, stiction uniform 0-1
///   spindle    torque limit 300-1200 rev/s² (log-uniform); gear 1 or 2, ratio uniform 1.5-3, motor's share .3-.6
///   job        1500-6000 rpm, 12-30 revolutions, load 40-160 rev/s², ramp 500 rev/s²
///   gains      spindle 30-55 1/s, Z 85-135 % of it; both scaled down where Z would exceed a third of its critical
///   gain:
///              a machine is commissioned stable
[[nodiscard]] DriveParams hardDrive(std::uint64_t seed);

/// Z oscillates with these settings: at or beyond the true critical gain, or still moving by more than 25 µm in the
/// last 100 ms of two seconds at rest behind the tap.
[[nodiscard]] bool oscillates(const DriveParams& drive, const TapSettings& settings);

/// One trial of a tuning.
struct Trial {
    TapSettings settings{};
    ContourFigures measured{};
    TunerStep step{};
};
struct Tuning {
    std::vector<Trial> trials{};
    TapSettings final{};
    ContourFigures before{};  ///< clean, initial settings
    ContourFigures after{};   ///< clean, final settings
    TunerSetup setup{};       ///< with what the probe measured
    RampReach reach{};        ///< of the air tap before the first trial and of that trial, the lesser
    double noise_um{0.0};     ///< white part of the last record's error
    bool tapsUsed{false};     ///< ended because no tap was left
    [[nodiscard]] double reduction() const { return 1.0 - after.saec_mm / before.saec_mm; }
};
/// Three taps in the air (two of them the stability probe), then tap, observe, until the tuner is finished.
[[nodiscard]] Tuning runTuning(const TunerSetup& setup, const DriveParams& drive, const TrialScatter& scatter,
                               std::uint64_t seed);
/// Whether the clean drive holds `allowedPp_um` with the final settings, and if not, why.
[[nodiscard]] TuningVerdict judgeTuning(const Tuning& tuning, double allowedPp_um);

}  // namespace kerf::tapping
