// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/core/sentence.h"
#include "engine/limits/loop_outputs.h"
#include "engine/port/stop_slots.h"

namespace kerf {

/// The stops of all five processes. Any loop sets one; a person's numbered release ends it and nothing else does: no
/// mode, hold, link state or restart. Runs in the cycle: no allocation, lock, throw or I/O.
class StopLatch {
 public:
    /// A stop that is as strong as the one that stands changes nothing.
    void set(ProcessId process, const StopWish& wish, std::int64_t now_ns) noexcept;
    /// What the machine or the store has kept; can add stops, and releases that a person has already made.
    void join(const StopSlots& kept, std::int64_t now_ns) noexcept;
    /// Why it is refused; empty: done. `number` is the stop the person has looked at; a newer one stays.
    [[nodiscard]] Sentence release(ProcessId process, std::uint32_t number, std::string_view person) noexcept;
    /// What stood in the work is out of it, as its loop has seen. Other stops stay.
    void turnedOut(ProcessId process) noexcept;

    [[nodiscard]] const StopSlots& all() const noexcept { return m_slots; }
    [[nodiscard]] StopStatus status(ProcessId process) const noexcept;
    /// Why Kerf may start nothing; empty: it may.
    [[nodiscard]] Sentence whyNoStart() const noexcept;

 private:
    StopSlots m_slots{};
    std::array<Sentence, kProcessPlaces> m_reasons{};
    std::array<std::int64_t, kProcessPlaces> m_since_ns{};
};

/// What a loop remembers of its own stop: tells it once when it has been released.
class StopWatch {
 public:
    [[nodiscard]] bool released(const StopSlot& slot) noexcept {
        const bool was = m_active;
        m_active = slot.active();
        return was && !m_active;
    }

 private:
    bool m_active{false};
};

}  // namespace kerf
