// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/trial_machine.h"

#include <algorithm>
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

DriveParams hardDrive(std::uint64_t seed) {
    if (seed == 0) return {};
    Random random(seed);
    const auto logUniform = [&](double low, double high) { return low * std::pow(high / low, random.uniform()); };
    DriveParams drive = randomDrive(random);
    drive.zDelay_s = random.uniform(0.0, 0.003);
    drive.zTorqueLag_s = logUniform(0.0005, 0.002);
    drive.zResonance_Hz = logUniform(30.0, 200.0);
    drive.zResonanceDamping = logUniform(0.02, 0.1);
    drive.zResonanceShare = logUniform(0.02, 0.3);
    drive.zBacklash_um = random.uniform(2.0, 20.0);
    drive.zStiction = random.uniform();
    drive.spindleAccelMax_revPerS2 = logUniform(300.0, 1200.0);
    drive.spindleGear = random.uniform() < 0.5 ? 1.0 : 2.0;
    drive.gearRatio = random.uniform(1.5, 3.0);
    drive.motorInertiaShare = random.uniform(0.3, 0.6);
    constexpr double kCommissioned = 3.0;
    const double most_perS = criticalZKp_perS(drive) / kCommissioned;
    const double scale = std::min(1.0, most_perS / drive.zKp_perS);
    drive.zKp_perS *= scale;
    drive.spindleKp_perS *= scale;
    return drive;
}

bool oscillates(const DriveParams& drive, const TapSettings& settings) {
    if (!(settings.zKp_perS < criticalZKp_perS(drive))) return true;
    constexpr double kRest_s = 2.0;  // a trim that ends with the record decays with the gain: 10 1/s needs a second
    constexpr double kStill_mm = 0.025;
    DriveParams resting = withSettings(drive, settings);
    resting.tail_s = std::max(resting.tail_s, kRest_s);
    std::vector<double> spindle_rev(tapTicks(resting));
    std::vector<double> z_mm(spindle_rev.size());
    simulateTap(resting, settings.zTrim_mm, spindle_rev, z_mm);
    const auto last = static_cast<std::ptrdiff_t>(std::min(0.1 / drive.tick_s, static_cast<double>(z_mm.size())));
    const auto [low, high] = std::minmax_element(z_mm.end() - last, z_mm.end());
    return !(*high - *low < kStill_mm);
}

namespace {

/// Taps without work: one as programmed, one with the sweep and one with its opposite. A machine that takes no trim
/// makes the first alone; so does a tap too short for a sweep.
void probeInTheAir(TrialMachine& machine, Tuning& tuning) {
    TunerSetup& setup = tuning.setup;
    const TapSignals air = machine.airTap(setup.initial);
    tuning.reach = rampReach(setup.assumed, setup.initial, air);
    const std::vector<double> probe_mm = probeTrim_mm(air.z_mm.size(), setup.assumed.tick_s);
    if (!setup.trim || std::ranges::all_of(probe_mm, [](double p_mm) { return p_mm == 0.0; })) return;
    const auto probed = [&](double sign) {
        TapSettings settings = setup.initial;
        settings.zTrim_mm.resize(probe_mm.size(), 0.0);
        for (std::size_t k = 0; k < probe_mm.size(); ++k)
            settings.zTrim_mm[k] += sign * probe_mm[k];
        return machine.airTap(settings);
    };
    const TapSignals plus = probed(1.0);
    const std::vector<double> spindle_rev(plus.spindle_rev.begin(), plus.spindle_rev.end());
    const std::vector<double> z_mm(plus.z_mm.begin(), plus.z_mm.end());
    setup.measured = measureLoop(setup.assumed, setup.initial, probe_mm, {spindle_rev, z_mm, {}}, probed(-1.0));
}

}  // namespace

Tuning runTuning(const TunerSetup& setup, const DriveParams& drive, const TrialScatter& scatter, std::uint64_t seed) {
    Tuning tuning;
    TrialMachine machine(drive, scatter, seed);
    tuning.before = cleanFigures(drive, setup.initial);
    tuning.setup = setup;
    probeInTheAir(machine, tuning);
    const std::unique_ptr<Tuner> tuner = makeTuner(tuning.setup);
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

TuningVerdict judgeTuning(const Tuning& tuning, double allowedPp_um) {
    return judgeTuning({tuning.setup, tuning.reach, tuning.final, tuning.trials.back().step.safe,
                        tuning.after.engagedPp_um, allowedPp_um, tuning.noise_um, tuning.tapsUsed});
}

}  // namespace kerf::tapping
