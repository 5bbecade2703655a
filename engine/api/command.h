// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "engine/api/process_types.h"
#include "engine/core/process.h"
#include "engine/core/sentence.h"
#include "engine/core/work_order.h"
#include "engine/port/machine_port.h"

/// Commands from a page to the engine: numbered, plain values, whole parameter sets. The status echoes number and
/// result.
namespace kerf {

struct SetLoopMode {
    ProcessId process{ProcessId::Boring};
    LoopMode mode{LoopMode::Off};
};
/// Leave "held" after a person has looked; loops come back in the mode they had. Stops stay.
struct ReleaseHold {
    std::uint32_t holdsSeen{0};  ///< set by EngineApi::send: a hold pressed later than the release wins
};
/// Who has signed on, as a command carries it; cut at its length.
struct PersonName {
    std::array<char, 48> text{};
    void set(std::string_view name) noexcept {
        text = {};
        std::copy_n(name.begin(), std::min(name.size(), text.size() - 1), text.begin());
    }
    [[nodiscard]] std::string_view view() const noexcept { return text.data(); }
};
/// A person has looked: the stop of that number ends. A newer one stays; so does every one when nobody is signed on.
struct ReleaseStop {
    ProcessId process{ProcessId::Milling};
    std::uint32_t number{0};
    PersonName person{};
};
/// What the data file has kept of stops, before anything else is asked; joined with what the machine keeps.
struct RestoreStops {
    StopSlots stops{};
};
/// Factor between machine time and wall time; simulated machines only. 0 = as fast as it can.
struct SetSimulationSpeed {
    double factor{1.0};
};
/// Whose work the next part is, where nothing of what it is cut with changes. Otherwise the order goes with that: every
/// command with an `order` names it by being done.
struct NameOrder {
    ProcessId process{ProcessId::Boring};
    WorkOrder order{};
};
/// Start the next part's program (simulator, or a control that allows it).
struct StartPart {
    ProcessId process{ProcessId::Boring};
    /// What whoever starts it believes to start; refused when the engine has another one. Empty: whatever is loaded.
    std::optional<WorkOrder> order{};
};
struct Command {
    std::uint32_t number{0};  ///< set by the sender's EngineApi
    CommandList<std::monostate, SetLoopMode, ReleaseHold, ReleaseStop, RestoreStops, SetSimulationSpeed, NameOrder,
                StartPart>::And<ProcessCommands>::Variant action{};
};
static_assert(std::is_trivially_copyable_v<Command>);

/// The loop a process command belongs to: named by the command itself, or by its kProcess.
[[nodiscard]] inline ProcessId processOf(const Command& command) noexcept {
    return std::visit(
        [](const auto& action) {
            if constexpr (requires { action.process; }) {
                return action.process;
            } else if constexpr (requires { action.kProcess; }) {
                return action.kProcess;
            } else {
                return ProcessId::Boring;  // commands of the whole engine never get here
            }
        },
        command.action);
}

/// Echo of a command: done, or refused with the reason.
struct CommandResult {
    std::uint32_t number{0};
    bool done{true};
    Sentence reason{};

    [[nodiscard]] static CommandResult ok() noexcept { return {}; }
    [[nodiscard]] static CommandResult refused(const Sentence& why) noexcept { return {0, false, why}; }
};

}  // namespace kerf
