// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/supervisor.h"

namespace kerf {
namespace {

/// What stops every loop at this moment; empty when nothing does.
Sentence machineObstacle(const MachineInputs& inputs) {
    if (inputs.link != LinkState::Up) {
        return Sentence(
            KERF_TEXT("No connection to the machine: the last offset stays, the control runs at its own feed."));
    }
    if (inputs.emergencyStop) {
        return Sentence(KERF_TEXT("Emergency stop: the control has stopped the machine."));
    }
    if (!inputs.machineOn) {
        return Sentence(KERF_TEXT("The machine is switched off."));
    }
    return {};
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

void Supervisor::release() noexcept {
    m_held = false;
    for (Loop& loop : m_loops) {
        loop.faulted = false;
    }
}

void Supervisor::fault(ProcessId id, const Sentence& why) noexcept {
    Loop& loop = m_loops[static_cast<std::size_t>(id)];
    if (!loop.faulted) {
        loop.faultReason = why;
    }
    loop.faulted = true;
}

LoopMode Supervisor::effectiveMode(ProcessId id, const MachineInputs& inputs,
                                   const Capabilities& capabilities) const noexcept {
    const auto index = static_cast<std::size_t>(id);
    const Loop& loop = m_loops[index];
    if (m_held || loop.faulted || !capabilities.process[index].fitted || !machineObstacle(inputs).empty()) {
        return LoopMode::Off;
    }
    return loop.mode;
}

LoopStatus Supervisor::describe(ProcessId id, bool present, const LoopVerdict& verdict, const MachineInputs& inputs,
                                const Capabilities& capabilities) const noexcept {
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
    if (loop.faulted) {
        status.state = LoopState::Faulted;
        status.reason = loop.faultReason;
    } else if (loop.mode == LoopMode::Off) {
        status.reason = Sentence(KERF_TEXT("Switched off."));
    } else if (m_held) {
        status.state = LoopState::Held;
        status.reason = m_holdReason;
    } else if (const Sentence obstacle = machineObstacle(inputs); !obstacle.empty()) {
        status.state = LoopState::Held;
        status.reason = obstacle;
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
