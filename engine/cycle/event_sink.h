// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/api/status.h"
#include "engine/core/alarm.h"
#include "engine/core/spsc_ring.h"

namespace kerf {

/// Where a loop puts what leaves the cycle: alarms and finished parts. Called in the cycle only.
struct EventSink {
    static constexpr std::size_t kMaxActiveAlarms = 64;

    EventSink(SpscRing<AlarmEvent>& alarmRing, SpscRing<PartRecord>& partRing) noexcept
        : alarms(alarmRing), parts(partRing) {}

    /// Raise an alarm; repeated calls while it is active change nothing.
    void raise(AlarmCode code, const Sentence& detail = Sentence{}) noexcept;
    /// The condition has gone; nothing happens if it was not active, or tells of a stop that stands.
    void clear(AlarmCode code) noexcept;
    [[nodiscard]] bool active(AlarmCode code) const noexcept;
    /// raise() or clear().
    void set(AlarmCode code, bool condition, const Sentence& detail = Sentence{}) noexcept {
        condition ? raise(code, detail) : clear(code);
    }
    /// Hand a part record to the database. When the ring is full the record is kept here, `partsBlocked` latches and
    /// no part of Kerf's may begin until flush() has got rid of it. Parts that a person begins at the control all the
    /// same may find no place at last: those are counted, and said to be unrecorded.
    void finishPart(const PartRecord& record) noexcept;
    void flush() noexcept;
    [[nodiscard]] bool partsBlocked() const noexcept { return m_pendingCount > 0; }
    /// Finished parts that nobody keeps, since the engine started.
    [[nodiscard]] std::uint32_t partsUnrecorded() const noexcept { return m_unrecorded; }
    /// The newest finished part was one of them.
    [[nodiscard]] bool unrecordedNow() const noexcept { return m_unrecordedNow; }

    std::int64_t now_ns{0};  ///< set by the cycle
    StopSlots stops{};       ///< set by the cycle: the alarm of a stop stands as long as the stop

 private:
    SpscRing<AlarmEvent>& alarms;
    SpscRing<PartRecord>& parts;
    std::array<AlarmCode, kMaxActiveAlarms> m_active{};
    std::size_t m_activeCount{0};
    std::array<PartRecord, 4> m_pending{};
    std::size_t m_pendingCount{0};
    std::uint32_t m_unrecorded{0};
    bool m_unrecordedNow{false};
};

}  // namespace kerf
