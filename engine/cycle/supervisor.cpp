// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/supervisor.h"

namespace kerf {
namespace {

/// The machine hears and may move: asked for every loop in every cycle, so without the words.
bool machineReady(const MachineInputs& inputs) noexcept {
    return inputs.link == LinkState::Up && !inputs.emergencyStop && inputs.machineOn;
}

/// What stops every loop at this moment; empty when nothing does.
Sentence machineObstacle(const MachineInputs& inputs) {
    if (machineReady(inputs)) {
        return {};
    }
    if (inputs.link != LinkState::Up) {
        return Sentence(KERF_TEXT(
            "No connection to the machine: the last offset stays, the feed is at most the planned one, or held."));
    }
    if (inputs.emergencyStop) {
        return Sentence(KERF_TEXT("Emergency stop: the control has stopped the machine."));
    }
    return Sentence(KERF_TEXT("The machine is switched off."));
}

}  // namespace

CommandResult Supervisor::setMode(ProcessId id, LoopMode mode, const Capabilities& capabilities) noexcept {
    const auto index = static_cast<std::size_t>(id);
    const Capability& host = capabilities.process[index];
    if (mode != LoopMode::Off && !host.fitted) {
        return CommandResult::refused(host.why.empty() ? Sentence(KERF_TEXT("This machine cannot host this loop."))
                                                       : host.why);
    }
    m_loops[index].mode = mode;
    return CommandResult::ok();
}

void Supervisor::hold(const Sentence& why) noexcept {
    if (!m_held) {
        m_holdReason = why;
    }
    m_held = true;
}

bool Supervisor::watch(const MachineInputs& inputs) noexcept {
    const bool linked = inputs.link == LinkState::Up;
    const bool ready = machineReady(inputs);
    const bool lost = m_ready && !ready;
    const bool running = inputs.program == ProgramState::Running || inputs.program == ProgramState::Paused;
    const bool amidst = linked && !m_seen && running;  // a console that comes back while a program runs
    if (lost || amidst) {
        m_lost = true;
        m_lostReason =
            amidst
                ? Sentence(KERF_TEXT("Kerf has come while a program runs: look at the machine, then release the hold."))
            : !linked ? Sentence(KERF_TEXT("The connection was lost: look at the machine, then release the hold."))
            : inputs.emergencyStop
                ? Sentence(KERF_TEXT("There was an emergency stop: look at the machine, then release the hold."))
                : Sentence(KERF_TEXT("The machine was switched off: look at it, then release the hold."));
    }
    m_seen = m_seen || linked;
    m_ready = ready;
    return lost;
}

Sentence Supervisor::release(const MachineInputs& inputs) noexcept {
    if (m_lost) {
        if (const Sentence obstacle = machineObstacle(inputs); !obstacle.empty()) {
            return obstacle;
        }
    }
    m_held = false;
    m_lost = false;
    return {};
}

LoopMode Supervisor::effectiveMode(ProcessId id, const MachineInputs& inputs,
                                   const Capabilities& capabilities) const noexcept {
    const auto index = static_cast<std::size_t>(id);
    const Loop& loop = m_loops[index];
    const StopSlot& stop = inputs.stops[index];
    const bool out = stop.active() && stop.kind == StopKind::LoopOut;
    if (held() || out || !capabilities.process[index].fitted || !machineReady(inputs)) {
        return LoopMode::Off;
    }
    return loop.mode;
}

LoopStatus Supervisor::describe(ProcessId id, bool present, const LoopVerdict& verdict, const MachineInputs& inputs,
                                const Capabilities& capabilities, const StopStatus& stop) const noexcept {
    const auto index = static_cast<std::size_t>(id);
    const Loop& loop = m_loops[index];
    const Capability& host = capabilities.process[index];
    LoopStatus status;
    status.mode = loop.mode;
    status.fitted = present && host.fitted;
    if (!status.fitted) {
        status.reason = host.fitted         ? Sentence(KERF_TEXT("Not fitted yet."))
                        : !host.why.empty() ? host.why
                                            : Sentence(KERF_TEXT("This machine cannot host this loop."));
        return status;
    }
    if (stop.slot.active() && stop.slot.kind == StopKind::LoopOut) {
        status.state = LoopState::Faulted;
        status.reason =
            stop.reason.empty() ? Sentence(KERF_TEXT("A stop stands from before: see the alarm.")) : stop.reason;
    } else if (stop.slot.active() && stop.slot.kind == StopKind::FeedHold) {
        status.state = LoopState::Held;
        status.reason = Sentence(KERF_TEXT("The feed is held: see the alarm, then release the stop."));
    } else if (loop.mode == LoopMode::Off) {
        status.reason = Sentence(KERF_TEXT("Switched off."));
    } else if (m_held) {
        status.state = LoopState::Held;
        status.reason = m_holdReason;
    } else if (const Sentence obstacle = machineObstacle(inputs); !obstacle.empty()) {
        status.state = LoopState::Held;
        status.reason = obstacle;
    } else if (m_lost) {
        status.state = LoopState::Held;
        status.reason = m_lostReason;
    } else {
        status.state = verdict.state;
        status.reason = verdict.reason;
        const bool acts = verdict.state == LoopState::Controlling || verdict.state == LoopState::Limited;
        if (loop.mode == LoopMode::Advise && acts) {
            status.state = LoopState::Advising;
        }
    }
    return status;
}

}  // namespace kerf
