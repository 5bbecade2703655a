// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "engine/core/process.h"
#include "engine/core/sentence.h"

namespace kerf {

/// Codes are stable: 1-99 engine and machine, 100 boring, 200 milling, 300 turning, 400 thermal, 500 tapping.
using AlarmCode = std::uint16_t;

/// What an alarm says to a person. Each room declares its own rows; texts are marked with KERF_TEXT.
struct AlarmSpec {
    AlarmCode code{0};
    std::uint8_t priority{3};  ///< 1 act now, 2 act soon, 3 know
    const char* title{""};
    const char* cause{""};
    const char* consequence{""};
    const char* action{""};
};

/// An alarm raised or cleared by the engine, as it leaves the cycle.
struct AlarmEvent {
    AlarmCode code{0};
    bool raised{true};  ///< false: the condition has gone
    std::int64_t time_ns{0};
    Sentence detail{};  ///< numbers of this occurrence; may be empty
};
static_assert(std::is_trivially_copyable_v<AlarmEvent>);

}  // namespace kerf
