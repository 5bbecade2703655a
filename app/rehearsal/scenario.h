// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/process.h"
#include "engine/port/output_limits.h"
#include "engine/process/boring/boring_types.h"
#include "engine/process/milling/milling_types.h"
#include "engine/process/tapping/tapping_types.h"
#include "engine/process/thermal/thermal_types.h"
#include "engine/process/turning/turning_types.h"

/// What a rehearsal does to the engine and its machine, read from a file. See docs/reliability.md.
namespace kerf::rehearsal {

/// A person at the console.
enum class Deed : std::uint8_t { Start, HoldAll, ReleaseHold, SetMode, ReleaseStop, AbortTap, RecoverTap };

/// One thing at a given time: a deed of a person, or a fault (see faults.h for their names).
struct Event {
    double at_s{0.0};
    std::size_t index{0};  ///< in the file's list
    std::optional<Deed> deed{};
    std::string fault{};  ///< empty: a deed
    ProcessId process{ProcessId::Boring};
    LoopMode mode{LoopMode::Off};
    double value{0.0};
    double seconds{0.0};
    std::uint16_t channel{0};
};

/// Setups of all five processes: those of the others are the defaults, so that a person may press their start too.
struct Setups {
    BoringSchedule boring{};
    MillingSetup milling{};
    TurningSetup turning{};
    ThermalSetup thermal{};
    TappingJob tapping{};
    TapGains tapGains{};
};

/// Key of a deed in the file.
[[nodiscard]] const char* deedKey(Deed deed) noexcept;

enum class MachineKind : std::uint8_t { Simulator, DiamondLathe, LinuxCnc };
[[nodiscard]] const char* machineKey(MachineKind kind) noexcept;

struct Scenario {
    ProcessId process{ProcessId::Milling};
    MachineKind machine{MachineKind::Simulator};
    double duration_s{0.0};
    LoopMode mode{LoopMode::Control};
    std::uint64_t seed{1};
    Setups setups{};
    OutputLimits limits{};  ///< of the machine; the built-in ones unless a machine file says others
    std::vector<Event> events{};
    std::vector<std::string> remarks{};  ///< events that can change nothing, in sentences  ///< by time, those of one
                                         ///< time in the file's order
};

/// Reads a scenario. `machine` empty: the one that has the process. `where` heads complaints (the file's name).
/// @throws headless::BadInput naming the key, what stands there and what was expected.
[[nodiscard]] Scenario readScenario(const std::string& text, const std::string& where, const std::string& machine);

}  // namespace kerf::rehearsal
