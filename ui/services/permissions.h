// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/core/sentence.h"

/// Who may do what, for all processes alike: one table, asked by every service before it changes anything, by the gate
/// in front of the engine, and by the pages for what their buttons say.
namespace kerf {

/// What somebody is trusted with; each may do what the ones before may.
enum class Trust : std::uint8_t {
    Operator,  ///< enter and correct measurements, a new tool, acknowledge
    Setter,    ///< part types, setups, tunings and models that are cut with, lots, modes of the loops
    Engineer,  ///< recipes and limits
};

/// Everything a person can change. Whatever is not here changes nothing that is kept (starting a part, the simulator's
/// speed, ending a hold or a tap: safety never waits for a name).
enum class Deed : std::uint8_t {
    SwitchLoop,
    ReleaseStop,
    BoringDiameter,
    BoringCorrection,
    BoringSchedule,
    BoringChange,
    BoringLot,
    BoringLotEnd,
    BoringRecipe,
    BoringPartType,
    MillingSetup,
    MillingLimits,
    MillingBlank,
    MillingPartType,
    MillingTool,
    MillingLaw,
    MillingMemory,
    TurningSetup,
    TurningLimits,
    TurningLaw,
    TurningMemory,
    ThermalModel,
    ThermalLimits,
    ThermalSession,
    ThermalReference,
    ThermalMemory,
    TappingJob,
    TappingTuning,
    TappingMemory,
    SensorPlace,
    ShiftWords,
    ToolChange,
    ToolLife,
    DataRestore,
    PersonRemove,
    LimitFar,
    QualityDecision,
    QualityLimits,
    QualityGauge,
    QualityStudy,
    QualityFiles,
    ProcessSetup,
    Count,
};
inline constexpr std::size_t kDeedCount = static_cast<std::size_t>(Deed::Count);

struct Permission {
    Deed deed{Deed::Count};
    Trust least{Trust::Engineer};
    bool reason{false};   ///< a person must say why
    const char* key{""};  ///< in the audit log
    const char* name{""};
};

/// In the order of Deed.
inline constexpr std::array<Permission, kDeedCount> kPermissions{{
    {Deed::SwitchLoop, Trust::Setter, false, "loop.mode", KERF_TEXT("Switch a loop")},
    {Deed::ReleaseStop, Trust::Operator, false, "stop.release", KERF_TEXT("Release a stop")},
    {Deed::BoringDiameter, Trust::Operator, false, "boring.diameter", KERF_TEXT("Enter a diameter")},
    {Deed::BoringCorrection, Trust::Operator, true, "boring.correction", KERF_TEXT("Correct or void a diameter")},
    {Deed::BoringSchedule, Trust::Operator, false, "boring.schedule", KERF_TEXT("Accept a feed schedule")},
    {Deed::BoringChange, Trust::Operator, false, "boring.change", KERF_TEXT("Announce a change of tool or material")},
    {Deed::BoringLot, Trust::Setter, false, "boring.lot", KERF_TEXT("Open or choose a lot")},
    {Deed::BoringLotEnd, Trust::Setter, true, "boring.lot_end", KERF_TEXT("Close a lot or leave it out of memory")},
    {Deed::BoringRecipe, Trust::Engineer, true, "boring.recipe", KERF_TEXT("Change a boring recipe")},
    {Deed::BoringPartType, Trust::Engineer, false, "boring.part_type", KERF_TEXT("Add a part type for boring")},
    {Deed::MillingSetup, Trust::Setter, false, "milling.setup", KERF_TEXT("Change the milling setup")},
    {Deed::MillingLimits, Trust::Engineer, true, "milling.limits", KERF_TEXT("Raise a limit of milling")},
    {Deed::MillingBlank, Trust::Setter, false, "milling.blank", KERF_TEXT("Change the blank profile")},
    {Deed::MillingPartType, Trust::Setter, false, "milling.part_type", KERF_TEXT("Choose a milled part type")},
    {Deed::MillingTool, Trust::Operator, false, "milling.tool", KERF_TEXT("Say that a new milling tool is in")},
    {Deed::MillingLaw, Trust::Setter, false, "milling.law", KERF_TEXT("Change law or reference of milling")},
    {Deed::MillingMemory, Trust::Setter, true, "milling.memory", KERF_TEXT("Leave a milling tool out of memory")},
    {Deed::TurningSetup, Trust::Setter, false, "turning.setup", KERF_TEXT("Change the turning setup")},
    {Deed::TurningLimits, Trust::Engineer, true, "turning.limits", KERF_TEXT("Raise a limit of turning")},
    {Deed::TurningLaw, Trust::Setter, false, "turning.law", KERF_TEXT("Change the law of turning")},
    {Deed::TurningMemory, Trust::Setter, true, "turning.memory", KERF_TEXT("Leave a turned part out of memory")},
    {Deed::ThermalModel, Trust::Setter, false, "thermal.model", KERF_TEXT("Put a thermal model live or back")},
    {Deed::ThermalLimits, Trust::Engineer, true, "thermal.limits", KERF_TEXT("Change the limits of the thermal shift")},
    {Deed::ThermalSession, Trust::Setter, false, "thermal.session", KERF_TEXT("Record a gap-sensor session")},
    {Deed::ThermalReference, Trust::Operator, false, "thermal.reference",
     KERF_TEXT("Take a reference or a measurement of the origin over")},
    {Deed::ThermalMemory, Trust::Setter, true, "thermal.memory", KERF_TEXT("Leave a day out of thermal training")},
    {Deed::TappingJob, Trust::Setter, false, "tapping.job", KERF_TEXT("Load a tapping job")},
    {Deed::TappingTuning, Trust::Setter, false, "tapping.tuning", KERF_TEXT("Tune, accept a tuning or roll it back")},
    {Deed::TappingMemory, Trust::Setter, true, "tapping.memory", KERF_TEXT("Leave a stored tuning out")},
    {Deed::SensorPlace, Trust::Engineer, false, "sensor.place", KERF_TEXT("Place a sensor on the picture")},
    {Deed::ShiftWords, Trust::Operator, false, "shift.words",
     KERF_TEXT("Reason of a stop, note or handover of a shift")},
    {Deed::ToolChange, Trust::Operator, false, "tool.change", KERF_TEXT("Say that a new tool is in")},
    {Deed::ToolLife, Trust::Setter, false, "tool.life", KERF_TEXT("Set the life of a tool")},
    {Deed::DataRestore, Trust::Engineer, true, "data.restore", KERF_TEXT("Put a backup in the place of the data")},
    {Deed::PersonRemove, Trust::Engineer, false, "person.remove", KERF_TEXT("Take somebody off the list of people")},
    {Deed::LimitFar, Trust::Engineer, true, "limit.far",
     KERF_TEXT("Raise a limit by more than half, with a second person")},
    {Deed::QualityDecision, Trust::Operator, false, "quality.decision",
     KERF_TEXT("Say what was done with a part out of tolerance")},
    {Deed::QualityLimits, Trust::Setter, true, "quality.limits", KERF_TEXT("Set the limits of figures")},
    {Deed::QualityGauge, Trust::Setter, false, "quality.gauge", KERF_TEXT("Change the register of gauges")},
    {Deed::QualityStudy, Trust::Setter, false, "quality.study", KERF_TEXT("Keep the study of a gauge")},
    {Deed::QualityFiles, Trust::Setter, false, "quality.files", KERF_TEXT("Set where Q-DAS files appear")},
    {Deed::ProcessSetup, Trust::Setter, false, "process.setup", KERF_TEXT("Change the set-up of a process")},
}};
static_assert([] {
    for (std::size_t i = 0; i < kDeedCount; ++i) {
        if (static_cast<std::size_t>(kPermissions[i].deed) != i) return false;
    }
    return true;
}());

/// A limit raised by more than half wants a second person beside the one who raises it (Deed::LimitFar).
[[nodiscard]] constexpr bool raisedFar(double from, double to) noexcept {
    return from > 0.0 && to > 1.5 * from;
}

[[nodiscard]] constexpr const Permission& permissionOf(Deed deed) noexcept {
    return kPermissions[static_cast<std::size_t>(deed)];
}

/// The sentence for whoever is not trusted enough.
[[nodiscard]] inline Sentence onlyWho(Trust least) {
    return least == Trust::Engineer ? Sentence(KERF_TEXT("Only a process engineer may do this."))
                                    : Sentence(KERF_TEXT("Only a setter or a process engineer may do this."));
}

}  // namespace kerf
