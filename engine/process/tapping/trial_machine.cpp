// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/trial_machine.h"

#include <cmath>
#include <utility>

#include "engine/process/tapping/tap_drive.h"
#include "engine/process/tapping/trim_learning.h"

namespace kerf::tapping {

TrialMachine::TrialMachine(const DriveParams& drive, const TrialScatter& scatter, std::uint64_t seed)
    : m_drive(drive),
      m_scatter(scatter),
      m_loads(Random(seed).stream(1)),
      m_noise(Random(seed).stream(2)),
      m_airFriction(Random(seed).stream(3)),
      m_airNoise(Random(seed).stream(4)),
      m_spindle_rev(tapTicks(drive)),
      m_z_mm(m_spindle_rev.size()) {}

TapSignals TrialMachine::tap(const TapSettings& settings) {
    DriveParams drive = withSettings(m_drive, settings);
    const double load = 1.0 + m_scatter.loadSpread * m_loads.uniform(-1.0, 1.0);
    const double friction = 1.0 + m_scatter.frictionSpread * m_loads.uniform(-1.0, 1.0);
    drive.load_revPerS2 *= load;
    drive.loadOut_revPerS2 *= load;
    drive.thrust_mmPerS2 *= load;
    drive.zCoulomb_mmPerS2 *= friction;
    drive.zViscous_perS *= friction;
    return record(drive, settings, m_noise);
}

TapSignals TrialMachine::airTap(const TapSettings& settings) {
    DriveParams drive = withSettings(m_drive, settings);
    const double friction = 1.0 + m_scatter.frictionSpread * m_airFriction.uniform(-1.0, 1.0);
    drive.load_revPerS2 = 0.0;
    drive.loadOut_revPerS2 = 0.0;
    drive.thrust_mmPerS2 = 0.0;
    drive.zCoulomb_mmPerS2 *= friction;
    drive.zViscous_perS *= friction;
    return record(drive, settings, m_airNoise);
}

TapSignals TrialMachine::record(const DriveParams& drive, const TapSettings& settings, Random& noise) {
    simulateTap(drive, settings.zTrim_mm, m_spindle_rev, m_z_mm);
    const double counts = m_scatter.encoderSpindle_counts;
    const double step_mm = m_scatter.encoderZ_um / 1000.0;
    for (std::size_t k = 0; k < m_z_mm.size(); ++k) {
        if (m_scatter.noise_um > 0.0) m_z_mm[k] += m_scatter.noise_um / 1000.0 * noise.gauss();
        if (counts > 0.0) m_spindle_rev[k] = std::round(m_spindle_rev[k] * counts) / counts;
        if (step_mm > 0.0) m_z_mm[k] = std::round(m_z_mm[k] / step_mm) * step_mm;
    }
    return {m_spindle_rev, m_z_mm, {}};
}

ContourFigures cleanFigures(const DriveParams& drive, const TapSettings& settings) {
    TrialMachine machine(drive, {}, 0);
    const TapSignals tap = machine.tap(settings);
    return contourFigures(tap.spindle_rev, tap.z_mm, {}, drive.pitch_mm, drive.engage_rev);
}

TapSettings settingsOf(const DriveParams& drive) {
    return {drive.spindleKp_perS, drive.zKp_perS, drive.zVelocityFf, drive.zAccelFf, {}};
}

DriveParams knownTo(const DriveParams& drive, const DriveParams& assumed) {
    DriveParams known = withSettings(assumed, settingsOf(drive));
    known.pitch_mm = drive.pitch_mm;
    known.depth_rev = drive.depth_rev;
    known.speed_rpm = drive.speed_rpm;
    known.ramp_revPerS2 = drive.ramp_revPerS2;
    known.tick_s = drive.tick_s;
    known.substeps = drive.substeps;
    known.tail_s = drive.tail_s;
    known.engage_rev = drive.engage_rev;
    known.slaved = drive.slaved;
    return known;
}

DriveParams randomDrive(Random& random) {
    DriveParams drive;
    const auto about = [&](double nominal) { return nominal * random.uniform(0.75, 1.25); };
    drive.spindleBandwidth_perS = about(drive.spindleBandwidth_perS);
    drive.spindleIntegral_perS = about(drive.spindleIntegral_perS);
    drive.spindleFilter_s = about(drive.spindleFilter_s);
    drive.spindleViscous_perS = about(drive.spindleViscous_perS);
    drive.zBandwidth_perS = about(drive.zBandwidth_perS);
    drive.zIntegral_perS = about(drive.zIntegral_perS);
    drive.zTorqueLag_s = about(drive.zTorqueLag_s);
    drive.zViscous_perS = about(drive.zViscous_perS);
    drive.zCoulomb_mmPerS2 = about(drive.zCoulomb_mmPerS2);
    drive.thrust_mmPerS2 = about(drive.thrust_mmPerS2);
    drive.spindleKp_perS = random.uniform(30.0, 55.0);
    drive.zKp_perS = drive.spindleKp_perS * random.uniform(0.85, 1.35);
    drive.spindleAccelMax_revPerS2 = random.uniform(520.0, 1000.0);
    drive.speed_rpm = random.uniform(1500.0, 6000.0);
    drive.depth_rev = random.uniform(12.0, 30.0);
    drive.load_revPerS2 = random.uniform(40.0, 160.0);
    drive.loadOut_revPerS2 = 0.2 * drive.load_revPerS2;
    return drive;
}

Tuning runTuning(const TunerSetup& setup, const DriveParams& drive, const TrialScatter& scatter, std::uint64_t seed) {
    Tuning tuning;
    const std::unique_ptr<Tuner> tuner = makeTuner(setup);
    TrialMachine machine(drive, scatter, seed);
    tuning.before = cleanFigures(drive, setup.initial);
    tuning.reach = rampReach(setup.assumed, setup.initial, machine.airTap(setup.initial));
    for (bool finished = false; !finished;) {
        Trial trial;
        trial.settings = tuner->settings();
        const TapSignals tap = machine.tap(trial.settings);
        trial.measured = contourFigures(tap.spindle_rev, tap.z_mm, tap.valid, drive.pitch_mm, drive.engage_rev);
        if (tuning.trials.empty()) tuning.reach = tuning.reach.lesser(rampReach(setup.assumed, trial.settings, tap));
        trial.step = tuner->observe(tap);
        finished = trial.step.finished;
        tuning.noise_um = 1000.0 * errorNoise_mm(contourError(tap, drive.pitch_mm));
        tuning.final = trial.step.next;
        tuning.trials.push_back(std::move(trial));
    }
    tuning.after = cleanFigures(drive, tuning.final);
    tuning.tapsUsed = static_cast<int>(tuning.trials.size()) >= setup.maxTaps;
    return tuning;
}

TuningVerdict judgeTuning(const TunerSetup& setup, const Tuning& tuning, double allowedPp_um) {
    return judgeTuning({setup, tuning.reach, tuning.final, tuning.trials.back().step.safe, tuning.after.engagedPp_um,
                        allowedPp_um, tuning.noise_um, tuning.tapsUsed});
}

}  // namespace kerf::tapping
