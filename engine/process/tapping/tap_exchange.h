// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/core/latest_value.h"
#include "engine/process/tapping/tapping_types.h"

namespace kerf {

/// One tap as recorded in the cycle, from the first tick of the command; both axes count from there.
struct TapRecord {
    std::uint32_t number{0};  ///< TappingStatus::taps after it
    std::uint32_t job{0};
    std::uint32_t gains{0};
    TapKind kind{TapKind::Air};
    TapOutcome outcome{TapOutcome::None};
    TapFigures figures{};
    std::uint32_t count{0};
    std::array<float, kMaxTapTicks> spindle_rev{};
    std::array<float, kMaxTapTicks> z_mm{};
    std::array<std::uint8_t, kMaxTapTicks> valid{};
};

/// Learned addition to the Z command, one value per tick of the command.
struct TrimTable {
    std::uint32_t revision{0};  ///< 0: none
    std::uint32_t count{0};
    std::array<float, kMaxTapTicks> trim_um{};
};

/// What passes between the loop (engine thread) and the tuner's side (one other thread) beside commands and status.
/// Large, so it is made once, on the heap, before the engine starts.
struct TapExchange {
    LatestValue<TapRecord> records{};  ///< written by the loop when a tap has ended
    LatestValue<TrimTable> trims{};    ///< written by the tuner's side before the gains that name it
};

}  // namespace kerf
