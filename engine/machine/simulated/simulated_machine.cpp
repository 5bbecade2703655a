// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/simulated/simulated_machine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"

namespace kerf {
namespace {

constexpr std::int64_t kDeadConsole_ns = 100'000'000;
constexpr double kCollapsed = 0.02;                // share of a signal that is left of it
constexpr double kWorkOffsetRate_umPerS = 1000.0;  // the control's own ramp for external offsets

/// What a lost link leaves of the inputs: the time, and values nobody knows to be true.
void markUnheard(std::int64_t now_ns, MachineInputs& inputs) {
    inputs.time_ns = now_ns;
    inputs.link = LinkState::Down;
    inputs.fastCount = 0;
    inputs.servoCount = 0;
    const auto stale = [](Reading& reading) {
        reading.quality = reading.quality == Quality::Good ? Quality::Stale : reading.quality;
    };
    for (Reading* reading : {&inputs.programmedFeed_mmPerS, &inputs.actualFeed_mmPerS, &inputs.spindleSpeed_rpm,
                             &inputs.spindleAngle_rev, &inputs.overhang_mm, &inputs.appliedFeedScale,
                             &inputs.plannedFeedScale, &inputs.toolTrim_um, &inputs.zTrim_um, &inputs.toolMotion_um}) {
        stale(*reading);
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        stale(inputs.position_mm[axis]);
        stale(inputs.workOffset_um[axis]);
        stale(inputs.gap_um[axis]);
    }
}

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
        case SignalFault::Collapsed:
            return {kCollapsed * value, now_ns, Quality::Good};
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
    m_capabilities.limits = params.limits;
    m_capabilities.limits.feedScaleMax = std::max(params.limits.feedScaleMax, params.maxFeedScale);
    m_capabilities.simulated = true;
    m_capabilities.feedScale.fitted = true;
    m_capabilities.workOffset.fitted = true;
    m_capabilities.cycleStart.fitted = true;
    for (std::size_t place = 0; place < kProcessPlaces; ++place) {
        Capability& host = m_capabilities.process[place];
        host.fitted = find(static_cast<ProcessId>(place)) != nullptr;
        if (!host.fitted) {
            host.why = params.absentProcess;
        }
    }
    const Sentence notFitted(KERF_TEXT("This simulated machine does not have it."));
    for (Capability* capability :
         {&m_capabilities.forceSensor, &m_capabilities.forceReset, &m_capabilities.temperatures,
          &m_capabilities.gapSensors, &m_capabilities.toolMotion, &m_capabilities.servoGains, &m_capabilities.zTrim,
          &m_capabilities.toolTrim, &m_capabilities.gauge}) {
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
    advance(now_ns, m_truth);
    const SignalFault fault = m_injected.value().actualFeed;
    m_toldFeed_mmPerS = fault == SignalFault::None
                            ? m_truth.actualFeed_mmPerS
                            : simulatedReading(m_truth.actualFeed_mmPerS.value, now_ns, fault, m_toldFeed_mmPerS);
    if (m_truth.link == LinkState::Up) {
        inputs = m_truth;
        inputs.actualFeed_mmPerS = m_toldFeed_mmPerS;
    } else {
        markUnheard(now_ns, inputs);
    }
}

void SimulatedMachine::keepStops() noexcept {
    for (const auto& process : m_processes) {
        StopSlot& slot = m_stops[static_cast<std::size_t>(process->id())];
        const bool stands = process->standsInWork();
        if (stands) {
            (void)latch(slot, StopKind::InWork, process->inWorkAlarm());
        } else if (slot.active() && slot.kind == StopKind::InWork && m_program != ProgramState::Running) {
            slot.released = slot.number;  // it has been turned out
        }
    }
}

void SimulatedMachine::advance(std::int64_t now_ns, MachineInputs& inputs) noexcept {
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
    const bool cutting = m_program == ProgramState::Running;
    const double lossScale = cutting ? std::min({m_outputs.feedScale, m_outputs.lossScale, m_plannedScale}) : 1.0;
    const double scale = consoleDead ? lossScale : m_outputs.feedScale;
    const bool feedHold = faults.operatorFeedHold || m_outputs.feedHold || anyStopOf(m_stops, StopKind::FeedHold) ||
                          (consoleDead && lossScale <= 0.0) || faults.spindleStopped;
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
    inputs.zTrim_um = {m_outputs.zTrim_um, now_ns, Quality::Good};
    inputs.toolTrim_um = {m_outputs.toolTrim_um, now_ns, Quality::Good};
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

    if (stopped && m_request.number != 0) {  // nothing begins by itself when the machine comes back
        m_reply = {m_request.number, RequestState::Refused, Sentence(KERF_TEXT("The machine is not ready."))};
        m_request = PortRequest{};
    }
    answerRequest(inputs);
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
    keepStops();
    inputs.stops = m_stops;
    inputs.program = m_program;
    inputs.programProcess = m_programProcess;
    inputs.plannedFeedScale = {m_plannedScale, now_ns, Quality::Good};
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
        if (anyStop(m_stops)) {
            return fail(KERF_TEXT("A stop stands: look at the machine, then release the stop."));
        }
        if (const Result<void> begun = process->begin(*start, m_partSequence + 1); !begun) {
            return begun;
        }
        ++m_partSequence;
        m_plannedScale = start->plannedFeedScale;
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
    for (std::size_t i = 0; i < kProcessPlaces; ++i) {
        const StopSlot before = m_stops[i];
        m_stops[i] = joined(before, outputs.stops[i]);
        SimulatedProcess* process = find(static_cast<ProcessId>(i));
        if (before.active() && before.kind == StopKind::InWork && !m_stops[i].active() && process != nullptr) {
            process->takenOut();
        }
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
