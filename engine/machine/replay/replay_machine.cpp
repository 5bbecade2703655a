// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/replay/replay_machine.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace kerf {
namespace {

constexpr double kMinute_ns = 60e9;
constexpr double kAfterTheLast_min = 2.0;  ///< a row stands so long at the most

}  // namespace

ReplayMachine::ReplayMachine(std::vector<ReplayRow> rows, std::uint16_t count) : m_rows(std::move(rows)) {
    constexpr std::string_view kName = "Recorded day";
    std::ranges::copy(kName, m_capabilities.machineName.begin());
    m_capabilities.simulated = true;  // it runs at any speed
    const Sentence recorded(KERF_TEXT("A recorded day is played: nothing can be commanded."));
    for (Capability* capability : {&m_capabilities.feedScale, &m_capabilities.forceSensor, &m_capabilities.forceReset,
                                   &m_capabilities.toolMotion, &m_capabilities.servoGains, &m_capabilities.zTrim,
                                   &m_capabilities.toolTrim, &m_capabilities.gauge, &m_capabilities.cycleStart}) {
        *capability = {false, recorded};
    }
    m_capabilities.temperatures = {true, {}};
    m_capabilities.temperatureCount = count;
    m_capabilities.workOffset = {true, {}};
    const bool gaps = std::ranges::any_of(m_rows, &ReplayRow::measured);
    m_capabilities.gapSensors = {gaps, gaps ? Sentence{} : Sentence(KERF_TEXT("No drift was measured on that day."))};
    m_capabilities.process.fill({false, recorded});
    m_capabilities.process[static_cast<std::size_t>(ProcessId::Thermal)] = {true, {}};
    m_frame.count = count;
}

void ReplayMachine::read(std::int64_t now_ns, MachineInputs& inputs) noexcept {
    if (!m_start_ns) {
        m_start_ns = now_ns;
    }
    const double time_min = m_rows.front().time_min + static_cast<double>(now_ns - *m_start_ns) / kMinute_ns;
    while (m_next < m_rows.size() && m_rows[m_next].time_min <= time_min + 1e-9) {
        const ReplayRow& row = m_rows[m_next++];
        ++m_frame.revision;
        for (std::size_t k = 0; k < m_frame.count; ++k) {
            const bool there = (row.present >> k & 1U) != 0U;
            m_frame.temp_degC[k] = {static_cast<double>(row.temp_degC[k]), now_ns,
                                    there ? Quality::Good : Quality::Missing};
        }
    }
    m_ended = m_next == m_rows.size() && time_min > m_rows.back().time_min + kAfterTheLast_min;
    const ReplayRow& row = m_rows[m_next == 0 ? 0 : m_next - 1];
    const Quality quality = m_ended ? Quality::Stale : Quality::Good;
    inputs.time_ns = now_ns;
    inputs.link = LinkState::Up;
    inputs.machineOn = true;
    inputs.emergencyStop = false;
    inputs.feedHold = false;
    inputs.operatorOverride = 1.0;
    inputs.program = ProgramState::Idle;
    inputs.fastCount = 0;
    inputs.servoCount = 0;
    inputs.servoRecord = false;
    inputs.spindleSpeed_rpm = {row.speed_rpm.value_or(0.0), now_ns, row.speed_rpm ? quality : Quality::Missing};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        inputs.workOffset_um[axis] = {m_workOffset_um[axis], now_ns, Quality::Good};
        inputs.gap_um[axis] = {kGapAtRest_um + row.drift_um[axis], now_ns, row.measured ? quality : Quality::Missing};
    }
    inputs.temperatures = m_ended ? nullptr : &m_frame;
    inputs.reply = m_reply;
}

void ReplayMachine::write(const MachineOutputs& outputs) noexcept {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (std::isfinite(outputs.workOffset_um[axis])) {
            m_workOffset_um[axis] = std::round(outputs.workOffset_um[axis]);
        }
    }
    if (outputs.request.number != 0 && outputs.request.number != m_reply.number) {
        m_reply = {outputs.request.number, RequestState::Refused, m_capabilities.cycleStart.why};
    }
}

}  // namespace kerf
