// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_boring.h"

#include <algorithm>
#include <cmath>

namespace kerf {

double BoredHole::deflectionAt_mm(double wantedOverhang_mm) const noexcept {
    const auto wanted = static_cast<float>(wantedOverhang_mm);
    std::size_t upper = 0;
    while (upper < count && overhang_mm[upper] < wanted) {
        ++upper;
    }
    if (upper == 0) {
        return static_cast<double>(deflection_mm[0]);
    }
    if (upper == count) {
        return static_cast<double>(deflection_mm[count - 1U]);
    }
    const double low_mm = static_cast<double>(overhang_mm[upper - 1]);
    const double share = (wantedOverhang_mm - low_mm) / (static_cast<double>(overhang_mm[upper]) - low_mm);
    return std::lerp(static_cast<double>(deflection_mm[upper - 1]), static_cast<double>(deflection_mm[upper]), share);
}

const BoringTruth& truthOf(const std::vector<BoringTruth>& truths, std::uint32_t bored) noexcept {
    const BoringTruth* now = &truths.front();
    for (const BoringTruth& truth : truths) {
        if (truth.fromPart <= bored) {
            now = &truth;
        }
    }
    return *now;
}

double trueDeflection_mm(const BoringTruth& truth, double feed_mmPerRev, double overhang_mm) noexcept {
    return truth.c_mm * std::pow(std::max(feed_mmPerRev, 1e-6), truth.alpha) * std::pow(overhang_mm, truth.beta);
}

SimulatedBoring::SimulatedBoring(const Params& params) : m_params(params), m_bored(params.boredSoFar) {}

void SimulatedBoring::fit(Capabilities& capabilities) const {
    capabilities.gauge.fitted = true;
    capabilities.gauge.why = Sentence{};
}

Result<void> SimulatedBoring::begin(const StartProgram& program, std::uint32_t partSequence) noexcept {
    const bool sound = program.programmedFeed_mmPerRev > 0.0 && program.spindleSpeed_rpm > 0.0 &&
                       program.from_mm > 0.0 && program.to_mm > program.from_mm &&
                       std::isfinite(program.to_mm * program.programmedFeed_mmPerRev);
    if (!sound) {
        return fail(
            KERF_TEXT("The boring program needs feed, speed and overhangs above zero, the end deeper than the start."));
    }
    m_program = program;
    m_truth = truthOf(m_params.truths, ++m_bored);
    m_hole = BoredHole{};
    m_hole.partSequence = partSequence;
    m_overhang_mm = program.from_mm;
    m_feed_mmPerS =
        program.programmedFeed_mmPerRev * program.spindleSpeed_rpm / 60.0;  // steady before it meets the work
    m_running = true;
    return {};
}

void SimulatedBoring::recordStation() noexcept {
    const double spacing_mm = (m_program.to_mm - m_program.from_mm) / static_cast<double>(BoredHole::kStations - 1);
    while (m_hole.count < BoredHole::kStations &&
           m_overhang_mm >= m_program.from_mm + spacing_mm * m_hole.count - 1e-9) {
        const double feed_mmPerRev = m_feed_mmPerS * 60.0 / m_program.spindleSpeed_rpm;
        const double station_mm = m_program.from_mm + spacing_mm * m_hole.count;
        m_hole.overhang_mm[m_hole.count] = static_cast<float>(station_mm);
        m_hole.deflection_mm[m_hole.count] = static_cast<float>(trueDeflection_mm(m_truth, feed_mmPerRev, station_mm));
        ++m_hole.count;
    }
}

bool SimulatedBoring::advance(const SimulationStep& step, MachineInputs& inputs) noexcept {
    const double programmed_mmPerS = m_program.programmedFeed_mmPerRev * m_program.spindleSpeed_rpm / 60.0;
    if (m_running) {
        const double wanted_mmPerS = programmed_mmPerS * step.feedFactor * step.spindleFactor;
        m_feed_mmPerS += (wanted_mmPerS - m_feed_mmPerS) * m_driveLag.of(step.dt_s, m_params.driveLag_s);
        if (m_hole.count > 0) {  // the first station is cut with the feed of the entry, before the spindle moves on
            m_overhang_mm += m_feed_mmPerS * step.dt_s;
        }
        if (m_feed_mmPerS > 0.0) {
            recordStation();
        }
        if (m_overhang_mm >= m_program.to_mm) {
            m_overhang_mm = m_program.to_mm;
            recordStation();
            m_running = false;
            (void)m_holes.tryPush(m_hole);  // nobody gauges: the ring fills and further holes stay unmeasured
        }
    }
    const bool boringProgram = m_running || inputs.programProcess == ProcessId::Boring;
    if (!boringProgram) {
        return m_running;
    }
    const InjectedFaults& faults = *step.faults;
    const double speed_rpm = m_running ? m_program.spindleSpeed_rpm * step.spindleFactor : 0.0;
    const double feed_mmPerS = m_running ? m_feed_mmPerS : 0.0;
    inputs.overhang_mm = simulatedReading(m_overhang_mm, step.now_ns, faults.overhang, m_lastOverhang_mm);
    inputs.spindleSpeed_rpm = simulatedReading(speed_rpm, step.now_ns, faults.spindleSpeed, m_lastSpeed_rpm);
    inputs.actualFeed_mmPerS = {feed_mmPerS, step.now_ns, Quality::Good};
    inputs.programmedFeed_mmPerS = {m_running ? programmed_mmPerS : 0.0, step.now_ns, Quality::Good};
    inputs.position_mm[2] = {-(m_overhang_mm - m_program.from_mm), step.now_ns, Quality::Good};
    m_lastOverhang_mm = inputs.overhang_mm;
    m_lastSpeed_rpm = inputs.spindleSpeed_rpm;
    return m_running;
}

}  // namespace kerf
