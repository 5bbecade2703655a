// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Times of day as loggers write them.
namespace kerf::files {

/// One cell: the second of its day, and the date as it stands before it (empty without one).
struct ClockTime {
    double second_s{0.0};  ///< 0 … 86400
    std::string_view date{};
};

/// "08:15", "8:15:03,250", "2026-11-27T08:15:03.5Z", "27.11.2026 08:15:03", "11/27/2026 8:15:03 PM".
[[nodiscard]] std::optional<ClockTime> readClock(std::string_view text) noexcept;

/// Seconds since the first of a column's times. A date that changes, or a time without one that falls by hours, is the
/// next day; a date written year-month-day is counted by the calendar.
class ClockCounter {
 public:
    [[nodiscard]] double seconds(const ClockTime& time);

 private:
    bool m_begun{false};
    double m_first_s{0.0}, m_last_s{0.0}, m_day{0.0};
    std::string m_date{};
};

}  // namespace kerf::files
