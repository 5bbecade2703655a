// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/core/sentence.h"

namespace kerf {

/// The five loops, in the order the navigation shows them.
enum class ProcessId : std::uint8_t { Boring, Milling, Turning, Thermal, Tapping };
inline constexpr std::size_t kProcessCount = 5;
inline constexpr std::array<ProcessId, kProcessCount> kAllProcesses{
    ProcessId::Boring, ProcessId::Milling, ProcessId::Turning, ProcessId::Thermal, ProcessId::Tapping};

/// Key used in files, the database and logs. Never translated, never changed.
[[nodiscard]] constexpr const char* processKey(ProcessId id) noexcept {
    constexpr std::array<const char*, kProcessCount> keys{"boring", "milling", "turning", "thermal", "tapping"};
    return keys[static_cast<std::size_t>(id)];
}

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
