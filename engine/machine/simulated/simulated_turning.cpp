// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf {
namespace {

constexpr double kSample_s = 0.0002;
constexpr double kAirBefore_s = 0.3;
constexpr double kAirAfter_s = 0.2;
constexpr double kBrokenEdge = 1.6;  // the same depth takes this much more force
constexpr double kPlunge_s = 0.001;  // the slide goes to depth at the touch

turning::PlantParams plantParams(const SimulatedTurning::Params& params) {
    turning::PlantParams out;
    out.kind = turning::PlantKind::B2;
    out.process = params.process;
    return out;
}

}  // namespace

SimulatedTurning::SimulatedTurning(const Params& params) noexcept
    : m_params(params), m_random(params.seed), m_plant(plantParams(params)) {}

void SimulatedTurning::fit(Capabilities& capabilities) const {
    capabilities.forceSensor = {true, Sentence{}};
    capabilities.force.rate_Hz = 1.0 / kSample_s;
    capabilities.force.bandwidth_Hz = 0.5 / kSample_s;
    capabilities.force.zeroInAir = true;
    capabilities.force.drift_NPerS = std::abs(m_params.drift_NPerS);
    capabilities.toolTrim = {true, Sentence{}};
    if (m_params.motionSensorNoise_um > 0.0) {
        capabilities.toolMotion = {true, Sentence{}};
    }
}

Result<void> SimulatedTurning::begin(const StartProgram& program, std::uint32_t) noexcept {
    const bool sound = program.programmedFeed_mmPerRev > 0.0 && program.spindleSpeed_rpm >= 150.0 &&
                       program.spindleSpeed_rpm <= 30000.0 && program.to_mm > program.from_mm &&
                       program.depth_um > 0.0 && program.depth_um <= 50.0 &&
                       std::isfinite(program.to_mm * program.programmedFeed_mmPerRev);
    if (!sound) {
        return fail(
            KERF_TEXT("The turning program needs feed and depth above zero, 150 to 30000 rev/min, and an end "
                      "beyond its start."));
    }
    m_program = program;
    m_position_mm = program.from_mm;
    m_programTime_s = m_depth_um = m_air_s = 0.0;
    m_cutDone = false;
    turning::PlantParams params = plantParams(m_params);
    params.revolutionSamples = turning::samplesPerRevolution(program.spindleSpeed_rpm / 60.0, 1.0 / kSample_s);
    m_plant = turning::Plant(params);
    m_running = true;
    return {};
}

double SimulatedTurning::disturbance_um() noexcept {
    double sum_um = m_params.white_um * m_random.gauss();
    for (const turning::ToneSpec& tone : turning::kPaperTones) {
        sum_um += m_shake * tone.amplitude_um * std::sin(2.0 * std::numbers::pi * tone.frequency_Hz * m_time_s);
    }
    return sum_um;
}

bool SimulatedTurning::advance(const SimulationStep& step, MachineInputs& inputs) noexcept {
    const bool ours = m_running || inputs.programProcess == ProcessId::Turning;
    m_drift_N += m_params.drift_NPerS * step.dt_s;
    const InjectedFaults& faults = *step.faults;
    const double programmed_mmPerS = m_program.programmedFeed_mmPerRev * m_program.spindleSpeed_rpm / 60.0;
    const double feed_mmPerS = m_running ? programmed_mmPerS * step.feedFactor * step.spindleFactor : 0.0;
    m_owed_s += step.dt_s;
    if (!ours) {
        m_owed_s = 0.0;
        return m_running;
    }
    inputs.fastCount = 0;
    for (; m_owed_s >= kSample_s - 1e-9 && inputs.fastCount < kMaxFastSamples; m_owed_s -= kSample_s) {
        m_time_s += kSample_s;
        bool contact = false;
        if (m_running) {
            m_programTime_s += kSample_s;
            if (m_programTime_s >= kAirBefore_s && !m_cutDone) {
                contact = true;
                m_depth_um = std::min(m_program.depth_um, m_depth_um + m_program.depth_um * kSample_s / kPlunge_s);
                m_position_mm += feed_mmPerS * kSample_s;
                m_cutDone = m_position_mm >= m_program.to_mm;
            } else if (m_cutDone) {
                m_air_s += kSample_s;
                m_running = m_air_s < kAirAfter_s;
            }
        }
        const double disturbance = disturbance_um();
        double force_N = 0.0;
        m_trim_um = step.outputs->toolTrim_um;
        if (contact) {
            turning::ProcessParams process = m_params.process;
            const double chip = m_chip * (faults.toolBroken ? kBrokenEdge : 1.0);
            process.b0 *= chip;
            process.b1 *= chip;
            m_plant.setProcess(process);
            m_plant.setDepth(m_depth_um);
            const turning::PlantSample sample = m_plant.step(disturbance, m_trim_um);
            force_N = sample.force_N;
            m_inner_um = sample.inner_um;
        } else {
            m_inner_um = disturbance - m_trim_um;
        }
        force_N += m_params.residualForce_N + m_drift_N + m_params.forceNoise_N * m_random.gauss();
        const bool outOfRange = std::abs(force_N) > m_params.forceRange_N;
        const Reading reading = simulatedReading(std::clamp(force_N, -m_params.forceRange_N, m_params.forceRange_N),
                                                 step.now_ns, faults.force, m_lastForce_N);
        m_lastForce_N = reading;
        const auto ago_ns = static_cast<std::int64_t>(std::llround(std::max(m_owed_s - kSample_s, 0.0) * 1e9));
        FastSample& fast = inputs.fast[inputs.fastCount++];
        fast = {step.now_ns - ago_ns, 0.0, reading.value,
                outOfRange && reading.good() ? Quality::Saturated : reading.quality};
    }
    if (m_params.motionSensorNoise_um > 0.0) {
        inputs.toolMotion_um = {m_inner_um + m_params.motionSensorNoise_um * m_random.gauss(), step.now_ns,
                                Quality::Good};
    }
    inputs.toolTrim_um = {m_trim_um, step.now_ns, Quality::Good};
    inputs.spindleSpeed_rpm = simulatedReading(m_running ? m_program.spindleSpeed_rpm * step.spindleFactor : 0.0,
                                               step.now_ns, faults.spindleSpeed, inputs.spindleSpeed_rpm);
    inputs.actualFeed_mmPerS = {m_running ? feed_mmPerS : 0.0, step.now_ns, Quality::Good};
    inputs.programmedFeed_mmPerS = {m_running ? programmed_mmPerS : 0.0, step.now_ns, Quality::Good};
    inputs.position_mm[0] = {m_position_mm, step.now_ns, Quality::Good};
    return m_running;
}

}  // namespace kerf
