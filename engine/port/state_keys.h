// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/process.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// Keys of states in files, on standard output and on the gateway. Never translated, never changed.
[[nodiscard]] constexpr const char* stateKey(LoopState state) noexcept {
    switch (state) {
        case LoopState::Advising:
            return "advising";
        case LoopState::Controlling:
            return "controlling";
        case LoopState::Limited:
            return "limited";
        case LoopState::Held:
            return "held";
        case LoopState::Faulted:
            return "faulted";
        case LoopState::Off:
            break;
    }
    return "off";
}

[[nodiscard]] constexpr const char* stateKey(ProgramState state) noexcept {
    switch (state) {
        case ProgramState::Running:
            return "running";
        case ProgramState::Paused:
            return "paused";
        case ProgramState::Finished:
            return "finished";
        case ProgramState::Aborted:
            return "aborted";
        case ProgramState::Idle:
            break;
    }
    return "idle";
}

}  // namespace kerf
