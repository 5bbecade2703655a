// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_machine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"

namespace kerf {
namespace {

constexpr std::int64_t kDeadConsole_ns = 100'000'000;
constexpr double kWorkOffsetRate_umPerS = 1000.0;  // the control's own ramp for external offsets

void copyName(std::array<char, 32>& to, const char* from) {
    for (std::size_t i = 0; from[i] != '\0' && i + 1 < to.size(); ++i) {
        to[i] = from[i];
    }
}

}  // namespace

Reading simulatedReading(double value, std::int64_t now_ns, SignalFault fault, Reading previous) noexcept {
    switch (fault) {
        case SignalFault::Unplugged:
            return {0.0, now_ns, Quality::Missing};
        case SignalFault::Stale:
            return {previous.value, previous.stamp_ns, Quality::Stale};
        case SignalFault::NotANumber:
            return {std::numeric_limits<double>::quiet_NaN(), now_ns, Quality::Bad};
        case SignalFault::Saturated:
            return {value, now_ns, Quality::Saturated};
        case SignalFault::Stuck:
            return {previous.value, now_ns, Quality::Good};
        case SignalFault::None:
            break;
    }
    return {value, now_ns, Quality::Good};
}

SimulatedMachine::SimulatedMachine(const Params& params, std::vector<std::unique_ptr<SimulatedProcess>> processes)
    : m_processes(std::move(processes)), m_partSequence(params.partsSoFar) {
    copyName(m_capabilities.machineName, params.name);
    m_capabilities.cycle_ns = params.cycle_ns;
    m_capabilities.maxFeedScale = params.maxFeedScale;
    m_capabilities.simulated = true;
    m_capabilities.feedScale.fitted = true;
    m_capabilities.workOffset.fitted = true;
    m_capabilities.cycleStart.fitted = true;
    for (const ProcessId id : kAllProcesses) {
        Capability& host = m_capabilities.process[static_cast<std::size_t>(id)];
        host.fitted = find(id) != nullptr;
        if (!host.fitted) {
            host.why = params.absentProcess;
        }
    }
    const Sentence notFitted(KERF_TEXT("This simulated machine does not have it."));
    for (Capability* capability : {&m_capabilities.forceSensor, &m_capabilities.temperatures,
                                   &m_capabilities.gapSensors, &m_capabilities.toolMotion, &m_capabilities.servoGains,
                                   &m_capabilities.zTrim, &m_capabilities.toolTrim, &m_capabilities.gauge}) {
        capability->why = notFitted;
    }
    for (const auto& process : m_processes) {
        process->fit(m_capabilities);
    }
}

SimulatedProcess* SimulatedMachine::find(ProcessId id) const noexcept {
    const auto found = std::ranges::find_if(m_processes, [id](const auto& process) { return process->id() == id; });
    return found == m_processes.end() ? nullptr : found->get();
}

Result<void> SimulatedMachine::connect() {
    m_connected = true;
    return {};
}

void SimulatedMachine::disconnect() noexcept {
    m_connected = false;
}

void SimulatedMachine::read(std::int64_t now_ns, MachineInputs& inputs) noexcept {
    (void)m_injected.refresh();
    const InjectedFaults& faults = m_injected.value();
    const double dt_s =
        m_last_ns < 0 ? 0.0 : std::max(0.0, static_cast<double>(now_ns - m_last_ns) / kNanosecondPerSecond);
    if (m_last_ns < 0) {
        m_lastWrite_ns = now_ns;
        for (const auto& process : m_processes) {
            if (const auto kept = process->keptWorkOffset_um()) {
                m_workOffset_um = *kept;
                m_outputs.workOffset_um = *kept;
            }
        }
    }
    m_last_ns = now_ns;

    const bool stopped = faults.emergencyStop || faults.machineOff;
    if (stopped && m_program == ProgramState::Running) {
        if (SimulatedProcess* process = find(m_programProcess)) {
            process->abort();
        }
        m_program = ProgramState::Aborted;
    }

    const bool consoleDead = now_ns - m_lastWrite_ns > kDeadConsole_ns;
    const double scale = consoleDead ? std::min(m_outputs.feedScale, 1.0) : m_outputs.feedScale;
    const bool feedHold = faults.operatorFeedHold || (m_outputs.feedHold && !consoleDead) || faults.spindleStopped;
    SimulationStep step;
    step.dt_s = dt_s;
    step.now_ns = now_ns;
    step.feedFactor = feedHold ? 0.0 : scale * faults.operatorOverride;
    step.spindleFactor = faults.spindleStopped || stopped ? 0.0 : faults.spindleOverride;
    step.spindleAngle_rev = m_spindleAngle_rev;
    step.outputs = &m_outputs;
    step.faults = &faults;

    inputs.time_ns = now_ns;
    inputs.link = m_connected && !faults.linkDown ? LinkState::Up : LinkState::Down;
    inputs.emergencyStop = faults.emergencyStop;
    inputs.machineOn = !faults.machineOff;
    inputs.feedHold = feedHold;
    inputs.operatorOverride = faults.operatorOverride;
    inputs.appliedFeedScale = {scale, now_ns, Quality::Good};
    inputs.fastCount = 0;
    inputs.spindleSpeed_rpm = {0.0, now_ns, Quality::Good};
    inputs.spindleAngle_rev = {m_spindleAngle_rev, now_ns, Quality::Missing};
    inputs.programmedFeed_mmPerS = {0.0, now_ns, Quality::Good};
    inputs.actualFeed_mmPerS = {0.0, now_ns, Quality::Good};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double ramp = faults.workOffsetIgnored ? 0.0 : kWorkOffsetRate_umPerS * dt_s;
        m_workOffset_um[axis] =
            std::clamp(m_outputs.workOffset_um[axis], m_workOffset_um[axis] - ramp, m_workOffset_um[axis] + ramp);
        inputs.workOffset_um[axis] = {m_workOffset_um[axis], now_ns, Quality::Good};
        inputs.position_mm[axis] = {0.0, now_ns, Quality::Good};
    }

    if (!stopped) {
        answerRequest(inputs);
    }
    inputs.programProcess = m_programProcess;  // a program begun in this step: only its plant moves the axes
    for (const auto& process : m_processes) {
        const bool running = process->advance(step, inputs);
        if (m_program == ProgramState::Running && process->id() == m_programProcess && !running) {
            m_program = ProgramState::Finished;
        }
    }
    if (inputs.spindleAngle_rev.good()) {
        m_spindleAngle_rev = inputs.spindleAngle_rev.value;
    } else if (inputs.spindleAngle_rev.stamp_ns == now_ns && inputs.spindleAngle_rev.quality == Quality::Missing &&
               faults.spindleAngle == SignalFault::None) {
        m_spindleAngle_rev +=
            (std::isfinite(inputs.spindleSpeed_rpm.value) ? inputs.spindleSpeed_rpm.value : 0.0) / 60.0 * dt_s;
        inputs.spindleAngle_rev = {m_spindleAngle_rev, now_ns, Quality::Good};
    }
    inputs.program = m_program;
    inputs.programProcess = m_programProcess;
    inputs.partSequence = m_partSequence;
    inputs.reply = m_reply;
}

void SimulatedMachine::answerRequest(MachineInputs& inputs) noexcept {
    if (m_request.number == 0) {
        return;
    }
    const Result<void> outcome = carryOut(m_request);
    m_reply = {m_request.number, outcome ? RequestState::Done : RequestState::Refused,
               outcome ? Sentence{} : outcome.error()};
    m_request = PortRequest{};
    inputs.reply = m_reply;
}

Result<void> SimulatedMachine::carryOut(const PortRequest& request) noexcept {
    if (const auto* start = std::get_if<StartProgram>(&request.action)) {
        SimulatedProcess* process = find(start->process);
        if (process == nullptr) {
            return fail(KERF_TEXT("This simulated machine does not have it."));
        }
        if (m_program == ProgramState::Running) {
            return fail(KERF_TEXT("A part is being cut."));
        }
        if (const Result<void> begun = process->begin(*start, m_partSequence + 1); !begun) {
            return begun;
        }
        ++m_partSequence;
        m_programProcess = start->process;
        m_program = ProgramState::Running;
        return {};
    }
    if (std::holds_alternative<AbortProgram>(request.action)) {
        if (SimulatedProcess* process = find(m_programProcess);
            process != nullptr && m_program == ProgramState::Running) {
            process->abort();
            m_program = ProgramState::Aborted;
        }
        return {};
    }
    SimulatedProcess* tapping = find(ProcessId::Tapping);
    if (const auto* gains = std::get_if<SetServoGains>(&request.action); gains != nullptr && tapping != nullptr) {
        return tapping->setGains(gains->gains);
    }
    if (std::holds_alternative<RetractInSync>(request.action) && tapping != nullptr) {
        if (m_program == ProgramState::Running && m_programProcess != ProcessId::Tapping) {
            return fail(KERF_TEXT("A part is being cut."));
        }
        const Result<void> retracting = tapping->retractInSync();
        if (retracting) {
            m_program = ProgramState::Running;
            m_programProcess = ProcessId::Tapping;
        }
        return retracting;
    }
    return fail(KERF_TEXT("This simulated machine does not have it."));
}

void SimulatedMachine::write(const MachineOutputs& outputs) noexcept {
    if (m_injected.value().linkDown) {
        return;  // the cable is cut: nothing arrives
    }
    m_lastWrite_ns = m_last_ns;
    const MachineOutputs previous = m_outputs;
    m_outputs = outputs;
    if (outputs.request.number == 0) {
        m_outputs.request = previous.request;
    } else if (outputs.request.number != m_reply.number) {
        m_request = outputs.request;
    }
}

}  // namespace kerf
