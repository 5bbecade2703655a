// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "engine/api/boring_types.h"
#include "engine/api/tapping_types.h"
#include "engine/api/turning_types.h"
#include "engine/core/process.h"
#include "engine/core/sentence.h"

/// Commands from a page to the engine: numbered, plain values, whole parameter sets. The status echoes number and
/// result.
namespace kerf {

struct SetLoopMode {
    ProcessId process{ProcessId::Boring};
    LoopMode mode{LoopMode::Off};
};
/// Leave "held" or "faulted" after a person has looked; loops come back in the mode they had.
struct ReleaseHold {
    std::uint32_t holdsSeen{0};  ///< set by EngineApi::send: a hold pressed later than the release wins
};
/// Factor between machine time and wall time; simulated machines only. 0 = as fast as it can.
struct SetSimulationSpeed {
    double factor{1.0};
};
/// Start the next part's program (simulator, or a control that allows it).
struct StartPart {
    ProcessId process{ProcessId::Boring};
};
/// Boring: the schedule for the next part. A part being cut keeps the one it began with.
struct LoadBoringSchedule {
    BoringSchedule schedule{};
};

/// Turning: the cut of the next part. A part being cut keeps the one it began with.
struct LoadTurningSetup {
    TurningSetup setup{};
};
/// Tapping: what is tapped. Between taps only; its first tap is made in the air.
struct LoadTappingJob {
    TappingJob job{};
};
/// Tapping: gains and trim for the next taps.
struct LoadTapGains {
    TapGains gains{};
    bool accept{false};      ///< an abort returns to these
    bool production{false};  ///< taps with them are parts, watched for drift; else trials
};
/// Tapping: end the running tap in sync, restore the accepted gains.
struct AbortTap {};
/// Tapping: turn a tap that stands in the hole out in sync.
struct RecoverTap {};

struct Command {
    std::uint32_t number{0};  ///< set by the sender's EngineApi
    std::variant<std::monostate, SetLoopMode, ReleaseHold, SetSimulationSpeed, StartPart, LoadBoringSchedule,
                 LoadTurningSetup, LoadTappingJob, LoadTapGains, AbortTap, RecoverTap>
        action{};
};
static_assert(std::is_trivially_copyable_v<Command>);

/// The loop a process command belongs to.
[[nodiscard]] inline ProcessId processOf(const Command& command) noexcept {
    if (const auto* mode = std::get_if<SetLoopMode>(&command.action)) {
        return mode->process;
    }
    if (const auto* start = std::get_if<StartPart>(&command.action)) {
        return start->process;
    }
    if (std::holds_alternative<LoadTurningSetup>(command.action)) {
        return ProcessId::Turning;
    }
    if (std::holds_alternative<LoadTappingJob>(command.action) ||
        std::holds_alternative<LoadTapGains>(command.action) || std::holds_alternative<AbortTap>(command.action) ||
        std::holds_alternative<RecoverTap>(command.action)) {
        return ProcessId::Tapping;
    }
    return ProcessId::Boring;  // LoadBoringSchedule; later processes add theirs here
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
