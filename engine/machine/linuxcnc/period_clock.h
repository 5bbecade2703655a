// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace kerf::linuxcnc {

/// When a servo period was, though it is read late: t(n) = t(n − 1) + period + lateness of n, periods that are missing
/// in the count included. The clock is laid so that no period lies in the future; what was read soonest fixes it.
class PeriodClock {
 public:
    /// @param period_s nominal period of the servo thread, > 0
    explicit PeriodClock(double period_s) : m_period_ns(std::llround(period_s * 1e9)) {}

    /// @param late_ns time since the period before, less the nominal one. @return ns on the clock of `now_ns`
    std::int64_t next(std::uint32_t number, std::int32_t late_ns, std::int64_t now_ns) noexcept {
        const std::uint32_t passed = m_any ? number - m_number : 0;  // the count may run over
        m_stamp_ns = m_any && passed > 0 && passed <= kMostMissing
                         ? std::min(m_stamp_ns + passed * m_period_ns + late_ns, now_ns)
                         : now_ns;
        m_number = number;
        m_any = true;
        return m_stamp_ns;
    }
    /// All has been read: the newest period is not long ago. If it seems so, time was lost, and the clock is laid anew.
    void drained(std::int64_t now_ns) noexcept { m_any = m_any && now_ns - m_stamp_ns < kLost_ns; }

 private:
    static constexpr std::uint32_t kMostMissing = 100'000;
    static constexpr std::int64_t kLost_ns = 20'000'000;

    std::int64_t m_period_ns;
    std::int64_t m_stamp_ns{0};
    std::uint32_t m_number{0};
    bool m_any{false};
};

}  // namespace kerf::linuxcnc
