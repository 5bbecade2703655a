// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/api/status.h"
#include "engine/cycle/process_loop.h"

namespace kerf {

/// Decides for every loop whether it may act, and says why in one sentence.
///
/// mode (operator) ∧ fitted (machine) ∧ ¬held ∧ link up ∧ machine on ∧ ¬emergency stop ∧ ¬stopped out → the loop's own
/// verdict. Hold wins over everything, needs nobody's consent and lasts until released by a command. An emergency stop,
/// a machine that is switched off and a lost link are a hold as well, alike for all loops: what they end begins again
/// only when a person has looked. Stops are not kept here but in engine/limits; no hold and no release touches them.
class Supervisor {
 public:
    /// Operator's wish for one loop; refused with the reason when the machine cannot host it.
    [[nodiscard]] CommandResult setMode(ProcessId id, LoopMode mode, const Capabilities& capabilities) noexcept;
    void hold(const Sentence& why) noexcept;
    /// Once per cycle, before all else is asked. True: the machine has just been lost.
    [[nodiscard]] bool watch(const MachineInputs& inputs) noexcept;
    /// Why not; empty: done. Refused while what held the loops has not been put right.
    [[nodiscard]] Sentence release(const MachineInputs& inputs) noexcept;

    /// The mode the loop runs with in this cycle; Off whenever something forbids it to act.
    [[nodiscard]] LoopMode effectiveMode(ProcessId id, const MachineInputs& inputs,
                                         const Capabilities& capabilities) const noexcept;
    /// The state shown for the loop, given its own verdict.
    [[nodiscard]] LoopStatus describe(ProcessId id, bool present, const LoopVerdict& verdict,
                                      const MachineInputs& inputs, const Capabilities& capabilities,
                                      const StopStatus& stop) const noexcept;
    [[nodiscard]] bool held() const noexcept { return m_held || m_lost; }
    [[nodiscard]] LoopMode mode(ProcessId id) const noexcept { return m_loops[static_cast<std::size_t>(id)].mode; }

 private:
    struct Loop {
        LoopMode mode{LoopMode::Off};
    };
    std::array<Loop, kProcessPlaces> m_loops{};
    bool m_held{false};
    bool m_lost{false};   ///< the machine has stopped or was lost, and nobody has looked since
    bool m_ready{false};  ///< in the last cycle
    bool m_seen{false};   ///< the machine has been reached once
    Sentence m_holdReason{};
    Sentence m_lostReason{};
};

}  // namespace kerf
