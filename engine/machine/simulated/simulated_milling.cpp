// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_milling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace kerf {

SimulatedMilling::SimulatedMilling(const Params& params)
    : m_params(params), m_noise(params.seed), m_zero_N(params.zero_N) {
    assert(!m_params.blanks.empty());
    for (milling::BlankProfile& blank : m_params.blanks) {
        blank = blank.inAir(true, true);
    }
}

void SimulatedMilling::fit(Capabilities& capabilities) const {
    capabilities.forceSensor.fitted = true;
    capabilities.forceSensor.why = Sentence{};
    capabilities.force.rate_Hz = m_params.sampleRate_Hz;
    capabilities.force.bandwidth_Hz = m_params.corner_Hz > 0.0
                                          ? std::min(0.5 * m_params.sampleRate_Hz, m_params.corner_Hz)
                                          : 0.5 * m_params.sampleRate_Hz;
    capabilities.force.zeroInAir = m_params.piezo;
    capabilities.force.drift_NPerS = m_params.statedDrift_NPerS;
    capabilities.force.reset_s = 0.1;
    capabilities.forceReset.fitted = m_params.resetLine;
}

Result<void> SimulatedMilling::begin(const StartProgram& program, std::uint32_t /*partSequence*/) noexcept {
    const bool sound = program.programmedFeed_mmPerRev > 0.0 && program.spindleSpeed_rpm > 0.0 &&
                       program.to_mm > program.from_mm && std::isfinite(program.to_mm - program.from_mm) &&
                       std::isfinite(program.programmedFeed_mmPerRev * program.spindleSpeed_rpm);
    if (!sound) {
        return fail(KERF_TEXT("The milling program needs feed and speed above zero and an end beyond its start."));
    }
    m_program = program;
    const double wear = m_params.wearPerPart * m_partsWithTool.fetch_add(1, std::memory_order_relaxed);
    m_cut.begin(m_params.plant, m_params.blanks[m_partsBegun % m_params.blanks.size()],
                m_params.plant.cuttingCoefficient * std::exp(wear), program.from_mm);
    ++m_partsBegun;
    m_feed_mmPerS = 0.0;
    m_chatter_N = 0.0;
    m_time_s = 0.0;
    m_zero_N = m_params.piezo ? m_zero_N : 0.0;  // the amplifier is reset before each cut
    m_toldForce_N = 0.0;
    m_pastCount = 0;
    m_running = true;
    return {};
}

void SimulatedMilling::cut(const SimulationStep& step, double speed_rpm) noexcept {
    const double programmed_mmPerS = m_program.programmedFeed_mmPerRev * m_program.spindleSpeed_rpm / 60.0;
    const double wanted_mmPerS = programmed_mmPerS * step.feedFactor;
    m_feed_mmPerS += (wanted_mmPerS - m_feed_mmPerS) * m_driveLag.of(step.dt_s, m_params.driveLag_s);
    m_cut.step(m_feed_mmPerS * step.dt_s, speed_rpm / 60.0 * step.dt_s, step.faults->toolBroken ? 0.02 : 1.0);
}

void SimulatedMilling::sampleForce(const SimulationStep& step, double speed_rpm, double forceBefore_N,
                                   MachineInputs& inputs) noexcept {
    m_samplesOwed += step.dt_s * m_params.sampleRate_Hz;
    if (m_params.resetLine && step.outputs->forceReset) {  // what pulls at the sensor now is its zero
        m_zero_N = -m_cut.force_N();
    }
    const double owed = std::floor(m_samplesOwed);
    m_samplesOwed -= owed;
    const auto count = static_cast<std::size_t>(std::min(owed, static_cast<double>(kMaxFastSamples)));
    milling::ForceShape shape = m_params.shape;
    shape.missing = shape.missing || step.faults->fluteChipped;
    const double sample_s = step.dt_s / static_cast<double>(std::max<std::size_t>(count, 1));
    const double passes =
        m_params.corner_Hz > 0.0 ? 1.0 - std::exp(-2.0 * std::numbers::pi * m_params.corner_Hz * sample_s) : 1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(count);
        const double ago_s = (1.0 - share) * step.dt_s;
        FastSample& sample = inputs.fast[i];
        sample.spindleAngle_rev = step.spindleAngle_rev + speed_rpm / 60.0 * step.dt_s * share;
        if (m_params.revolutionNoise_N > 0.0 && std::floor(sample.spindleAngle_rev) > m_revolution) {
            m_revolution = std::floor(sample.spindleAngle_rev);
            m_offset_N = m_params.revolutionNoise_N * m_noise.gauss();
        }
        const double mean_N = std::lerp(forceBefore_N, m_toldForce_N, share);
        const double time_s = m_time_s - ago_s;
        double force_N = milling::sampledForce_N(shape, mean_N, sample.spindleAngle_rev) + swing_N(time_s) +
                         m_offset_N + m_zero_N + m_params.sampleNoise_N * m_noise.gauss();
        if (m_params.corner_Hz > 0.0) {
            m_passed_N += (force_N - m_passed_N) * passes;
            force_N = m_passed_N;
        }
        SignalFault fault = step.faults->force;
        if (fault == SignalFault::None && std::abs(force_N) > m_params.sensorRange_N) {
            force_N = std::copysign(m_params.sensorRange_N, force_N);
            fault = SignalFault::Saturated;
        }
        const auto stamp_ns = step.now_ns - static_cast<std::int64_t>(ago_s * kNanosecondPerSecond);
        const Reading reading = simulatedReading(force_N, stamp_ns, fault, m_lastSample_N);
        sample.stamp_ns = reading.stamp_ns;
        sample.force_N = reading.value;
        sample.quality = reading.quality;
        m_lastSample_N = reading;
    }
    inputs.fastCount = static_cast<std::uint16_t>(count);
}

double SimulatedMilling::swing_N(double time_s) const noexcept {
    return m_chatter_N == 0.0 ? 0.0 : m_chatter_N * std::sin(2.0 * std::numbers::pi * m_params.chatter_Hz * time_s);
}

/// A swing grows from next to nothing while the cut is too deep and dies away when it is not.
void SimulatedMilling::chatter(double dt_s) noexcept {
    constexpr double kGrowth_perS = 2.0;
    constexpr double kDecay_perS = 10.0;
    constexpr double kLeast = 0.002, kMost = 0.4;  // of the mean force
    const bool grows = m_params.chattersFrom_mm > 0.0 && m_cut.depth_mm() > m_params.chattersFrom_mm;
    if (!grows && m_chatter_N == 0.0) {
        return;
    }
    m_chatter_N = grows ? std::clamp(m_chatter_N * std::exp(kGrowth_perS * dt_s), kLeast * m_cut.force_N(),
                                     kMost * m_cut.force_N())
                        : m_chatter_N * std::exp(-kDecay_perS * dt_s);
}

SimulatedMilling::Told SimulatedMilling::tell(const Told& now, double dt_s, double speed_rpm) noexcept {
    m_past[m_pastCount % kLate] = now;
    ++m_pastCount;
    if (!m_params.late || speed_rpm <= 0.0) {
        return now;
    }
    const double steps = std::min(std::round(60.0 / speed_rpm / dt_s), static_cast<double>(kLate - 1));
    const auto ago = static_cast<std::size_t>(steps);
    return ago < m_pastCount ? m_past[(m_pastCount - 1 - ago) % kLate] : Told{};
}

bool SimulatedMilling::advance(const SimulationStep& step, MachineInputs& inputs) noexcept {
    const double speed_rpm = m_running ? m_program.spindleSpeed_rpm * step.spindleFactor : 0.0;
    const double forceBefore_N = m_toldForce_N;
    if (m_running) {
        cut(step, speed_rpm);
        chatter(step.dt_s);
        m_time_s += step.dt_s;
        m_zero_N += m_params.drift_NPerS * step.dt_s;
        if (m_cut.axis_mm() >= m_program.to_mm) {
            m_running = false;
        }
    }
    if (!m_running && inputs.programProcess != ProcessId::Milling) {
        return m_running;
    }
    if (!m_running) {  // the tool has left the work
        m_cut.leaveWork();
        m_feed_mmPerS = 0.0;
        m_chatter_N = 0.0;
    }
    const Told told = tell({m_cut.force_N(), m_feed_mmPerS}, step.dt_s, speed_rpm);
    m_toldForce_N = told.force_N;
    sampleForce(step, speed_rpm, forceBefore_N, inputs);
    const InjectedFaults& faults = *step.faults;
    const double programmed_mmPerS = m_program.programmedFeed_mmPerRev * m_program.spindleSpeed_rpm / 60.0;
    inputs.spindleSpeed_rpm = simulatedReading(speed_rpm, step.now_ns, faults.spindleSpeed, m_lastSpeed_rpm);
    inputs.actualFeed_mmPerS = {told.feed_mmPerS, step.now_ns, Quality::Good};
    inputs.programmedFeed_mmPerS = {m_running ? programmed_mmPerS : 0.0, step.now_ns, Quality::Good};
    inputs.position_mm[0] = {m_cut.axis_mm(), step.now_ns, Quality::Good};
    m_lastSpeed_rpm = inputs.spindleSpeed_rpm;
    return m_running;
}

}  // namespace kerf
