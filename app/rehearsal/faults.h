// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "app/rehearsal/scenario.h"
#include "engine/machine/simulated/injected_faults.h"

namespace kerf::rehearsal {

/// What a fault of this name needs beside its time.
enum class FaultNeeds : std::uint8_t { Nothing, Value, Channel, Seconds };

/// One fault by its name in the file. `apply` is empty for those of the console, not of the machine.
struct FaultSpec {
    const char* name;
    FaultNeeds needs;
    void (*apply)(InjectedFaults& faults, const Event& event);
};

inline constexpr const char* kCycleStall = "cycle_stall";
inline constexpr const char* kConsoleRestart = "console_restart";

[[nodiscard]] std::span<const FaultSpec> faultSpecs() noexcept;
/// A signal that this process needs fails.
[[nodiscard]] bool failsFor(ProcessId process, const InjectedFaults& faults) noexcept;
/// Whether a loop of this process, or its program, notices this fault at all.
[[nodiscard]] bool concerns(std::string_view fault, ProcessId process) noexcept;
/// Null: there is none of that name.
[[nodiscard]] const FaultSpec* findFault(std::string_view name) noexcept;

}  // namespace kerf::rehearsal
