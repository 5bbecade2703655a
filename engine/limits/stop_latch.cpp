// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/limits/stop_latch.h"

namespace kerf {
namespace {

constexpr std::size_t indexOf(ProcessId id) {
    return static_cast<std::size_t>(id);
}

}  // namespace

void StopLatch::set(ProcessId process, const StopWish& wish, std::int64_t now_ns) noexcept {
    const std::size_t index = indexOf(process);
    if (latch(m_slots[index], wish.kind, wish.cause)) {
        m_reasons[index] = wish.reason;
        m_since_ns[index] = now_ns;
    }
}

void StopLatch::join(const StopSlots& kept, std::int64_t now_ns) noexcept {
    for (std::size_t i = 0; i < kProcessPlaces; ++i) {
        const StopSlot before = m_slots[i];
        m_slots[i] = joined(before, kept[i]);
        if (m_slots[i].number != before.number) {
            m_reasons[i] = Sentence{};
            m_since_ns[i] = now_ns;
        }
    }
}

Sentence StopLatch::release(ProcessId process, std::uint32_t number, std::string_view person) noexcept {
    StopSlot& slot = m_slots[indexOf(process)];
    if (person.empty()) {
        return Sentence(KERF_TEXT("Sign on first: a stop is released by a person."));
    }
    if (!slot.active()) {
        return Sentence(KERF_TEXT("No stop stands here."));
    }
    if (number != slot.number) {
        return Sentence(KERF_TEXT("Stopped again since the release was asked: look once more."));
    }
    slot.released = number;
    return {};
}

void StopLatch::turnedOut(ProcessId process) noexcept {
    StopSlot& slot = m_slots[indexOf(process)];
    if (slot.active() && slot.kind == StopKind::InWork) {
        slot.released = slot.number;
    }
}

StopStatus StopLatch::status(ProcessId process) const noexcept {
    const std::size_t index = indexOf(process);
    return {m_slots[index], m_reasons[index], m_since_ns[index]};
}

Sentence StopLatch::whyNoStart() const noexcept {
    if (anyStopOf(m_slots, StopKind::InWork)) {
        return Sentence(KERF_TEXT("A tap stands in the hole: turn it out first, or say that it is gone."));
    }
    if (anyStop(m_slots)) {
        return Sentence(KERF_TEXT("A stop stands: look at the machine, then release the stop."));
    }
    return {};
}

}  // namespace kerf
