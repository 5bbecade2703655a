// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "engine/cycle/event_sink.h"

namespace kerf {

bool EventSink::active(AlarmCode code) const noexcept {
    return std::find(m_active.begin(), m_active.begin() + static_cast<std::ptrdiff_t>(m_activeCount), code) !=
           m_active.begin() + static_cast<std::ptrdiff_t>(m_activeCount);
}

void EventSink::raise(AlarmCode code, const Sentence& detail) noexcept {
    if (active(code) || m_activeCount == kMaxActiveAlarms) {
        return;
    }
    // A refused push leaves the alarm inactive, so that the next cycle tries again: an alarm is late, never lost.
    if (alarms.tryPush({code, true, now_ns, detail})) {
        m_active[m_activeCount++] = code;
    }
}

void EventSink::clear(AlarmCode code) noexcept {
    if (std::ranges::any_of(stops, [code](const StopSlot& slot) { return slot.active() && slot.cause == code; })) {
        return;
    }
    const auto end = m_active.begin() + static_cast<std::ptrdiff_t>(m_activeCount);
    const auto found = std::find(m_active.begin(), end, code);
    if (found == end || !alarms.tryPush({code, false, now_ns, Sentence{}})) {
        return;
    }
    *found = m_active[--m_activeCount];
}

void EventSink::finishPart(const PartRecord& record) noexcept {
    flush();
    m_unrecordedNow = false;
    if (m_pendingCount == 0 && parts.tryPush(record)) {
        return;
    }
    if (m_pendingCount < m_pending.size()) {
        m_pending[m_pendingCount++] = record;
        return;
    }
    m_unrecordedNow = true;
    ++m_unrecorded;
}

void EventSink::flush() noexcept {
    std::size_t sent = 0;
    while (sent < m_pendingCount && parts.tryPush(m_pending[sent])) {
        ++sent;
    }
    std::move(m_pending.begin() + static_cast<std::ptrdiff_t>(sent),
              m_pending.begin() + static_cast<std::ptrdiff_t>(m_pendingCount), m_pending.begin());
    m_pendingCount -= sent;
}

}  // namespace kerf
