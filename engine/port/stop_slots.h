// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "engine/core/alarm.h"
#include "engine/core/process.h"
#include "engine/core/sentence.h"

/// Stops as console and machine both keep them, so that neither's restart loses one.
namespace kerf {

/// What a stop forbids; a stronger one takes the place of a weaker one. Each forbids all that the ones before it do.
enum class StopKind : std::uint8_t {
    None,
    NoStart,   ///< Kerf starts nothing: seen while the loop did not control, so the feed is not Kerf's to hold
    LoopOut,   ///< and the loop has no influence any more; the feed goes on
    FeedHold,  ///< and the feed is held, in every mode, whatever program runs
    InWork,    ///< something stands in the work: no start and no axis move of Kerf's but the way out of it
};

/// The newest stop of one process. `released` only ever rises, and only by a person's release (or, in the work, by
/// having been turned out): two keepers join by taking the larger numbers, in any order and as often as they like.
struct StopSlot {
    std::uint32_t number{0};    ///< of the newest stop; 0: there was none
    std::uint32_t released{0};  ///< number of the newest stop that was released
    StopKind kind{StopKind::None};
    AlarmCode cause{0};  ///< alarm that tells about it; 0: none of its own

    [[nodiscard]] constexpr bool active() const noexcept { return number > released; }
    friend constexpr bool operator==(const StopSlot&, const StopSlot&) = default;
};
using StopSlots = std::array<StopSlot, kProcessPlaces>;
static_assert(std::is_trivially_copyable_v<StopSlots>);

/// A stop as the screen shows it.
struct StopStatus {
    StopSlot slot{};
    Sentence reason{};         ///< empty: kept from before a restart; the alarm of slot.cause tells
    std::int64_t since_ns{0};  ///< machine time; of a kept one: when it was read back
};

/// A new stop, unless one as strong stands already. True: it is new.
constexpr bool latch(StopSlot& slot, StopKind kind, AlarmCode cause) noexcept {
    if (kind == StopKind::None || (slot.active() && slot.kind >= kind)) {
        return false;
    }
    slot.number = std::max(slot.number, slot.released) + 1;
    slot.kind = kind;
    slot.cause = cause;
    return true;
}

/// What either of both knows.
[[nodiscard]] constexpr StopSlot joined(const StopSlot& a, const StopSlot& b) noexcept {
    StopSlot slot = a.number != b.number ? (a.number > b.number ? a : b) : (a.kind >= b.kind ? a : b);
    slot.released = std::max(a.released, b.released);
    return slot;
}

[[nodiscard]] constexpr bool anyStop(const StopSlots& stops, StopKind atLeast = StopKind::NoStart) noexcept {
    return std::ranges::any_of(stops,
                               [atLeast](const StopSlot& slot) { return slot.active() && slot.kind >= atLeast; });
}

[[nodiscard]] constexpr bool anyStopOf(const StopSlots& stops, StopKind kind) noexcept {
    return std::ranges::any_of(stops, [kind](const StopSlot& slot) { return slot.active() && slot.kind == kind; });
}

}  // namespace kerf
