// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <variant>

#include "engine/core/process.h"
#include "engine/core/sentence.h"
#include "engine/port/machine_port.h"
#include "engine/process/boring/boring_types.h"
#include "engine/process/milling/milling_types.h"
#include "engine/process/tapping/tapping_types.h"
#include "engine/process/thermal/thermal_types.h"
#include "engine/process/turning/turning_types.h"

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
/// Start the next part's program (simulator, or a control that allows it).
struct StartPart {
    ProcessId process{ProcessId::Boring};
};
/// Boring: the schedule for the next part. A part being cut keeps the one it began with.
struct LoadBoringSchedule {
    static constexpr ProcessId kProcess = ProcessId::Boring;
    BoringSchedule schedule{};
};

/// Boring: whose parts the next ones are, when a lot has been chosen and no schedule of it accepted yet.
struct NameBoringLot {
    static constexpr ProcessId kProcess = ProcessId::Boring;
    std::int64_t lot{0};
};

/// Turning: the cut of the next part. A part being cut keeps the one it began with.
struct LoadTurningSetup {
    static constexpr ProcessId kProcess = ProcessId::Turning;
    TurningSetup setup{};
};
/// Turning: another law, bumpless, also while cutting.
struct SetTurningController {
    static constexpr ProcessId kProcess = ProcessId::Turning;
    TurningController controller{TurningController::Tones};
};
/// Tapping: what is tapped. Between taps only; its first tap is made in the air.
struct LoadTappingJob {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
    TappingJob job{};
};
/// Tapping: gains and trim for the next taps.
struct LoadTapGains {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
    TapGains gains{};
    bool accept{false};      ///< an abort returns to these
    bool production{false};  ///< taps with them are parts, watched for drift; else trials
};
/// Tapping: end the running tap in sync, restore the accepted gains.
struct AbortTap {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
};
/// Tapping: turn a tap that stands in the hole out in sync.
struct RecoverTap {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
};
/// Milling: everything for the next parts; refused while one is being cut.
struct LoadMillingSetup {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingSetup setup{};
};
/// Milling: blank profile for the preview law; refused while a part is being cut. An empty one takes it away.
struct LoadMillingBlank {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingBlank blank{};
};
/// Milling: change of law, bumpless, also while cutting.
struct SetMillingLaw {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingLaw law{MillingLaw::Model};
};
/// Milling: reference force, also while cutting.
struct SetMillingReference {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    double reference_N{0.0};
};
/// Milling: take the mean force of this cut (or of the last one) as the reference.
struct TeachMillingReference {
    static constexpr ProcessId kProcess = ProcessId::Milling;
};
/// Milling: what was learnt of the tool before a restart; refused while a part is being cut.
struct RestoreMillingTool {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingToolState tool{};
};
/// Milling: a new tool; wear and tool stiffness are learnt anew.
struct NewMillingTool {
    static constexpr ProcessId kProcess = ProcessId::Milling;
};

/// Thermal: limits, period and warm-up.
struct LoadThermalSetup {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    ThermalSetup setup{};
};
/// Thermal: count temperatures and drift from now on. The shift stays unless `clearShift` says the origin has been set
/// anew without it.
struct TakeThermalReference {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    bool clearShift{false};
};
/// Thermal: gap readings that mean no drift, kept from before a restart.
struct LoadGapZero {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    std::array<double, kAxisCount> zero_um{};
};
/// Thermal: measure the origin with the gap sensors.
struct MeasureOrigin {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
};
/// Thermal: the part finished last has been measured; what it is off by is a measurement of the origin made when it was
/// finished.
struct MeasureByPart {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    static constexpr double kMost_um = 200.0;  ///< |deviation|; beyond it is no drift
    static constexpr double kNoise_um = 1.0;   ///< σ of a part and its gauge beyond that of the gap sensors
    /// Where the surface lies against where it should, > 0 along +axis; a diameter's deviation counts half.
    std::array<double, kAxisCount> deviation_um{};
    std::array<bool, kAxisCount> known{};
};
/// Thermal: count on from the last measurement instead of the prediction.
struct AdoptMeasurement {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
};
/// Thermal: put the gap sensors' readings into every minute, as training data.
struct RecordGaps {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    bool on{false};
};
/// Thermal: end the warm-up program.
struct StopWarmUp {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
};

struct Command {
    std::uint32_t number{0};  ///< set by the sender's EngineApi
    std::variant<std::monostate, SetLoopMode, ReleaseHold, ReleaseStop, RestoreStops, SetSimulationSpeed, StartPart,
                 LoadBoringSchedule, NameBoringLot, LoadTurningSetup, SetTurningController, LoadTappingJob,
                 LoadTapGains, AbortTap, RecoverTap, LoadMillingSetup, LoadMillingBlank, SetMillingLaw,
                 SetMillingReference, TeachMillingReference, RestoreMillingTool, NewMillingTool, LoadThermalSetup,
                 TakeThermalReference, LoadGapZero, MeasureOrigin, MeasureByPart, AdoptMeasurement, RecordGaps,
                 StopWarmUp>
        action{};
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
