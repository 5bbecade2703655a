// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/api/status.h"
#include "engine/cycle/process_loop.h"

namespace kerf {

/// Decides for every loop whether it may act, and says why in one sentence.
///
/// mode (operator) ∧ fitted (machine) ∧ ¬held ∧ link up ∧ machine on ∧ ¬emergency stop ∧ ¬faulted → the loop's own
/// verdict. Hold wins over everything, needs nobody's consent and lasts until released by a command.
class Supervisor {
 public:
    /// Operator's wish for one loop; refused with the reason when the machine cannot host it.
    [[nodiscard]] CommandResult setMode(ProcessId id, LoopMode mode, const Capabilities& capabilities) noexcept;
    void hold(const Sentence& why) noexcept;
    void release() noexcept;
    void fault(ProcessId id, const Sentence& why) noexcept;

    /// The mode the loop runs with in this cycle; Off whenever something forbids it to act.
    [[nodiscard]] LoopMode effectiveMode(ProcessId id, const MachineInputs& inputs,
                                         const Capabilities& capabilities) const noexcept;
    /// The state shown for the loop, given its own verdict.
    [[nodiscard]] LoopStatus describe(ProcessId id, bool present, const LoopVerdict& verdict,
                                      const MachineInputs& inputs, const Capabilities& capabilities) const noexcept;
    [[nodiscard]] bool held() const noexcept { return m_held; }
    [[nodiscard]] LoopMode mode(ProcessId id) const noexcept { return m_loops[static_cast<std::size_t>(id)].mode; }

 private:
    struct Loop {
        LoopMode mode{LoopMode::Off};
        bool faulted{false};
        Sentence faultReason{};
    };
    std::array<Loop, kProcessCount> m_loops{};
    bool m_held{false};
    Sentence m_holdReason{};
};

}  // namespace kerf
