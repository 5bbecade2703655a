// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Times of day as loggers write them.
namespace kerf::files {

/// One cell: the second of its day, and the date as it stands before it (empty without one).
struct ClockTime {
    double second_s{0.0};  ///< 0 … 86400
    std::string_view date{};
};

/// "08:15", "8:15:03,250", "2026-11-27T08:15:03.5Z", "27.11.2026 08:15:03", "11/27/2026 8:15:03 PM".
[[nodiscard]] std::optional<ClockTime> readClock(std::string_view text) noexcept;

/// What comes first in a date of three numbers. Between points the day does, before a year of four digits the year.
enum class DateOrder : std::uint8_t { DayFirst, MonthFirst, YearFirst };

/// A column's times of day.
class ClockColumn {
 public:
    struct Counted {
        std::vector<double> seconds{};       ///< since the first, one per time
        std::optional<std::size_t> doubt{};  ///< the first date that may be two days, and no other date tells
    };

    void add(const ClockTime& time);
    [[nodiscard]] std::size_t size() const noexcept { return m_times.size(); }
    /// By the calendar, in the one order in which every date is one and none goes back. A date of another form that
    /// changes, or a time without one that falls by hours, is the next day.
    [[nodiscard]] Counted counted(std::optional<DateOrder> said) const;

 private:
    struct Time {
        double second_s{0.0};
        std::array<std::int16_t, 3> numbers{};  ///< of its date; {0, 0, 0}: of another form, or none
        char mark{0};                           ///< between them
        bool dated{false};
        bool another{false};  ///< date than the one before
    };
    [[nodiscard]] std::vector<double> secondsIn(DateOrder order) const;
    [[nodiscard]] std::vector<double> secondsWithoutCalendar() const;

    std::vector<Time> m_times{};
    std::string m_date{};
};

}  // namespace kerf::files
