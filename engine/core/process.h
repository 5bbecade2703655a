// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/core/sentence.h"

/// What engine, services and screens need to know of any process, so that none of them has to name one.
namespace kerf {

struct PartRecord;  // engine/api/status.h

/// A process's number: its place in all that is kept per process (stops, status, the bridge's memory). Never changed; a
/// new one comes at the end, and its descriptor into processes() (docs/architecture.md, "Add a process").
enum class ProcessId : std::uint8_t { Boring, Milling, Turning, Thermal, Tapping };

/// Places for processes; more than there are, so that one more changes no layout of shared memory.
inline constexpr std::size_t kProcessPlaces = 8;

/// One figure of a finished part beside its measurements; `key` ends in the stored unit ("waviness_um").
struct PartResultSpec {
    const char* key{""};
    const char* label{""};  ///< KERF_TEXT
    const char* unit{""};   ///< stored unit, "" for a ratio or count
    int decimals{1};
};
/// A figure with the place it comes from; empty: this part has none.
struct PartResultRow {
    PartResultSpec spec{};
    std::optional<double> (*read)(const PartRecord& part){nullptr};
};

/// Outputs that a process may wish for; a wish for any other does not exist (engine/limits).
struct ProcessAuthority {
    bool feedScale{false};   ///< of its own program
    bool workOffset{false};  ///< at any time
    bool toolTrim{false};
    bool servo{false};  ///< servo gains, synchronous retract, and the Z trim while its own program runs
};

/// One process. What is not said here lives in its own folders.
struct ProcessDescriptor {
    ProcessId id{ProcessId::Boring};
    const char* key{""};   ///< in files, the database and logs; never translated, never changed
    const char* name{""};  ///< KERF_TEXT
    ProcessAuthority may{};
    bool makesParts{true};  ///< its programs end with a part that is counted and judged
    std::span<const PartResultRow>
        partResults{};  ///< in the order a page shows them; the first is the one that matters
};

// Defined in the processes' own folders.
extern const ProcessDescriptor kBoringProcess;
extern const ProcessDescriptor kMillingProcess;
extern const ProcessDescriptor kTurningProcess;
extern const ProcessDescriptor kThermalProcess;
extern const ProcessDescriptor kTappingProcess;
/// In the order of their numbers.
inline constexpr std::array kOwnProcesses{&kBoringProcess, &kMillingProcess, &kTurningProcess, &kThermalProcess,
                                          &kTappingProcess};

/// All processes of this program, in the order the navigation shows them.
[[nodiscard]] std::span<const ProcessDescriptor* const> processes() noexcept;
[[nodiscard]] std::span<const ProcessId> allProcesses() noexcept;
/// One more, before an engine or a screen is made; `process` outlives them. False: its place is taken or there is none.
bool fitProcess(const ProcessDescriptor& process) noexcept;

/// Null: no process of this program (a file or a machine of a later version).
[[nodiscard]] const ProcessDescriptor* findProcess(ProcessId id) noexcept;
[[nodiscard]] const ProcessDescriptor* findProcess(std::string_view key) noexcept;
/// What it may wish for; an unknown one nothing.
[[nodiscard]] ProcessAuthority authorityOf(ProcessId id) noexcept;
/// "" when unknown.
[[nodiscard]] const char* processKey(ProcessId id) noexcept;

/// What one loop is doing. One sentence beside it always says why.
enum class LoopState : std::uint8_t {
    Off,          ///< no influence on the machine
    Advising,     ///< computes and shows, does not act
    Controlling,  ///< its output reaches the machine
    Limited,      ///< controlling, but the output sits at a limit
    Held,         ///< stopped by hold-all or a lost link; the last offset stays, feed at or below the programmed one
    Faulted,      ///< stopped by a fault that a person must clear
};

/// What the operator asks of one loop.
enum class LoopMode : std::uint8_t { Off, Advise, Control };

}  // namespace kerf
