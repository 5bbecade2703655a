// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/port/machine_port.h"
#include "engine/process/thermal/day_layer.h"

namespace kerf {

/// What the thermal loop believed and the control had shifted when a part was finished. The part carries the rest of
/// the drift of that moment, so a part that is measured later is a measurement of the origin made then.
struct FinishedPart {
    std::array<double, kAxisCount> predicted_um{};
    std::array<double, kAxisCount> half_um{};
    std::array<double, kAxisCount> shift_um{};  ///< reported by the control
    thermal::DayInstant at{};                   ///< of a model that learns
    std::uint32_t model{0};
    std::uint32_t reference{0};
    std::size_t minute{0};  ///< of the log
};

/// Whether a part is being cut: any program that is not the warm-up, paused or not.
class PartWatch {
 public:
    enum class Edge : std::uint8_t { None, Begun, Finished };
    [[nodiscard]] Edge watch(const MachineInputs& inputs) noexcept {
        const bool runs = (inputs.program == ProgramState::Running || inputs.program == ProgramState::Paused) &&
                          inputs.programProcess != ProcessId::Thermal;
        const bool before = m_runs;
        m_runs = runs;
        if (runs == before) return Edge::None;
        if (runs) return Edge::Begun;
        return inputs.program == ProgramState::Aborted ? Edge::None : Edge::Finished;
    }
    [[nodiscard]] bool runs() const noexcept { return m_runs; }

 private:
    bool m_runs{false};
};

}  // namespace kerf
