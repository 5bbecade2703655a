// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/core/process.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// What a cycle brings for the part of one process. At most one of begins and ends is true; both may follow a cut-off.
struct ProgramTurn {
    bool running{false};  ///< a program of this process runs or pauses, and the machine can be seen
    bool cutOff{
        false};  ///< another program of this process has taken the place of the part's: the part is not complete
    bool begins{false};    ///< a part begins with this cycle
    bool ends{false};      ///< the part has ended …
    bool finished{false};  ///< … and its program had come to its end
};

/// Follows the programs of one process at the machine: which are its own, where a part begins and ends, and the
/// numbers of what it asks for, so that an answer never counts for another process or another request.
///
/// A part is one run of a program (partSequence). A lost link ends nothing: the control goes on by itself, and what
/// runs when it is back tells whether it is still the same part.
class ProgramFollower {
 public:
    explicit constexpr ProgramFollower(ProcessId process) noexcept : m_process(process) {}

    /// A program of this process runs or pauses.
    [[nodiscard]] bool runs(const MachineInputs& inputs) const noexcept {
        return sees(inputs) && (inputs.program == ProgramState::Running || inputs.program == ProgramState::Paused);
    }
    /// Once in a cycle.
    [[nodiscard]] ProgramTurn follow(const MachineInputs& inputs) noexcept {
        ProgramTurn turn;
        turn.running = runs(inputs);
        turn.begins = turn.running && (!m_inPart || inputs.partSequence != m_sequence);
        turn.cutOff = turn.begins && m_inPart;
        turn.ends = m_inPart && sees(inputs) && !turn.running;
        turn.finished = turn.ends && inputs.program == ProgramState::Finished;
        if (turn.begins) {
            m_sequence = inputs.partSequence;
        }
        m_inPart = (m_inPart || turn.begins) && !turn.ends;
        return turn;
    }
    [[nodiscard]] bool inPart() const noexcept { return m_inPart; }
    /// Number for a request to the machine: the process in its highest byte, counting from 1.
    [[nodiscard]] std::uint32_t nextRequest() noexcept {
        return ((static_cast<std::uint32_t>(m_process) + 1U) << 24U) + ++m_requests;
    }

 private:
    [[nodiscard]] bool sees(const MachineInputs& inputs) const noexcept {
        return inputs.programProcess == m_process && inputs.link == LinkState::Up;
    }

    ProcessId m_process;
    bool m_inPart{false};
    std::uint32_t m_sequence{0};
    std::uint32_t m_requests{0};
};

}  // namespace kerf
