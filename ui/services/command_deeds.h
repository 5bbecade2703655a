// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>

#include "engine/api/command.h"
#include "ui/services/permissions.h"

namespace kerf {

/// One line per command. A command of a process that has none is a change of its set-up, which is a setter's; one of
/// the whole engine does not compile before it has its place here.
struct DeedOf {
    using DeedOrNone = std::optional<Deed>;
    template <class Command>
    requires requires { Command::kProcess; }
    DeedOrNone operator()(const Command&) const { return Deed::ProcessSetup; }
    DeedOrNone operator()(std::monostate) const { return std::nullopt; }
    DeedOrNone operator()(const ReleaseHold&) const { return std::nullopt; }
    DeedOrNone operator()(const SetSimulationSpeed&) const { return std::nullopt; }
    DeedOrNone operator()(const NameOrder& name) const {
        return name.process == ProcessId::Boring ? Deed::BoringLot : Deed::ProcessSetup;
    }
    DeedOrNone operator()(const StartPart&) const { return std::nullopt; }
    DeedOrNone operator()(const AbortTap&) const { return std::nullopt; }
    DeedOrNone operator()(const RecoverTap&) const { return std::nullopt; }
    DeedOrNone operator()(const StopWarmUp&) const { return std::nullopt; }
    DeedOrNone operator()(const SetLoopMode&) const { return Deed::SwitchLoop; }
    DeedOrNone operator()(const ReleaseStop&) const { return Deed::ReleaseStop; }
    DeedOrNone operator()(const RestoreStops&) const { return Deed::ReleaseStop; }
    DeedOrNone operator()(const LoadBoringSchedule&) const { return Deed::BoringSchedule; }
    DeedOrNone operator()(const LoadTurningSetup&) const { return Deed::TurningLimits; }
    DeedOrNone operator()(const SetTurningController&) const { return Deed::TurningLaw; }
    DeedOrNone operator()(const LoadTappingJob&) const { return Deed::TappingJob; }
    DeedOrNone operator()(const LoadTapGains&) const { return Deed::TappingTuning; }
    DeedOrNone operator()(const LoadMillingSetup&) const { return Deed::MillingLimits; }
    DeedOrNone operator()(const LoadMillingBlank&) const { return Deed::MillingBlank; }
    DeedOrNone operator()(const SetMillingLaw&) const { return Deed::MillingLaw; }
    DeedOrNone operator()(const SetMillingReference&) const { return Deed::MillingLaw; }
    DeedOrNone operator()(const TeachMillingReference&) const { return Deed::MillingLaw; }
    DeedOrNone operator()(const RestoreMillingTool&) const { return Deed::MillingTool; }
    DeedOrNone operator()(const NewMillingTool&) const { return Deed::MillingTool; }
    DeedOrNone operator()(const LoadThermalSetup&) const { return Deed::ThermalLimits; }
    DeedOrNone operator()(const TakeThermalReference&) const { return Deed::ThermalReference; }
    DeedOrNone operator()(const LoadGapZero&) const { return Deed::ThermalReference; }
    DeedOrNone operator()(const MeasureOrigin&) const { return Deed::ThermalReference; }
    DeedOrNone operator()(const MeasureByPart&) const { return Deed::ThermalReference; }
    DeedOrNone operator()(const AdoptMeasurement&) const { return Deed::ThermalReference; }
    DeedOrNone operator()(const RecordGaps&) const { return Deed::ThermalSession; }
};

/// What a command does, in the words of the table; empty: anybody may (starting a part, ending a hold or a tap, the
/// simulator's speed).
[[nodiscard]] inline std::optional<Deed> deedOf(const Command& command) noexcept {
    return std::visit(DeedOf{}, command.action);
}

}  // namespace kerf
