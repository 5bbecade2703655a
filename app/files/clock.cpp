// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/clock.h"

#include <array>
#include <charconv>
#include <chrono>

#include "app/files/cell.h"

namespace kerf::files {
namespace {

constexpr double kDay_s = 86400.0;
constexpr std::size_t kLongest = 40;

/// A number of one to `digits` digits at the front; taken off.
std::optional<int> takeNumber(std::string_view& text, std::size_t digits) noexcept {
    std::size_t length = 0;
    while (length < text.size() && length < digits && text[length] >= '0' && text[length] <= '9') {
        ++length;
    }
    int value = 0;
    if (length == 0 || std::from_chars(text.data(), text.data() + length, value).ec != std::errc{}) {
        return std::nullopt;
    }
    text.remove_prefix(length);
    return value;
}

bool take(std::string_view& text, char c) noexcept {
    const bool there = text.starts_with(c);
    text.remove_prefix(there ? 1 : 0);
    return there;
}

/// Days since 1970 of "2026-11-27", "2026/11/27"; empty for other spellings.
std::optional<double> calendarDay(std::string_view date) noexcept {
    const auto year = takeNumber(date, 4);
    const char mark = date.empty() ? '\0' : date.front();
    if (!year || *year < 1900 || (mark != '-' && mark != '/' && mark != '.') || !take(date, mark)) {
        return std::nullopt;
    }
    const auto month = takeNumber(date, 2);
    if (!month || !take(date, mark)) {
        return std::nullopt;
    }
    const auto day = takeNumber(date, 2);
    if (!day || !date.empty()) {
        return std::nullopt;
    }
    const std::chrono::year_month_day all{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                          std::chrono::day(static_cast<unsigned>(*day))};
    return all.ok() ? std::optional(static_cast<double>(std::chrono::sys_days(all).time_since_epoch().count()))
                    : std::nullopt;
}

}  // namespace

std::optional<ClockTime> readClock(std::string_view text) noexcept {
    text = trimmedCell(text);
    const auto colon = text.find(':');
    if (text.size() > kLongest || colon == std::string_view::npos || colon == 0) {
        return std::nullopt;
    }
    ClockTime out;
    std::size_t begin = colon;
    while (begin > 0 && text[begin - 1] >= '0' && text[begin - 1] <= '9') {
        --begin;
    }
    out.date = trimmedCell(text.substr(0, begin));
    if (out.date.ends_with('T')) {
        out.date.remove_suffix(1);
    }
    if (out.date.find_first_not_of("0123456789-/. ") != std::string_view::npos ||
        (!out.date.empty() && text[begin - 1] != ' ' && text[begin - 1] != 'T')) {
        return std::nullopt;
    }
    text.remove_prefix(begin);
    const auto hour = takeNumber(text, 2);
    if (!hour || *hour > 24 || !take(text, ':')) {
        return std::nullopt;
    }
    const auto minute = takeNumber(text, 2);
    if (!minute || *minute > 59) {
        return std::nullopt;
    }
    double second_s = 0.0;
    if (take(text, ':')) {
        const auto whole = takeNumber(text, 2);
        if (!whole || *whole > 60) {
            return std::nullopt;
        }
        second_s = *whole;
        if (take(text, '.') || take(text, ',')) {
            double place = 0.1;
            while (!text.empty() && text[0] >= '0' && text[0] <= '9') {
                second_s += place * (text[0] - '0');
                place /= 10.0;
                text.remove_prefix(1);
            }
        }
    }
    text = trimmedCell(text);
    const bool evening = text == "PM" || text == "pm";
    const bool half = evening || text == "AM" || text == "am";
    if (half && (*hour > 12 || *hour == 0)) {
        return std::nullopt;
    }
    if (!half && !text.empty() && text != "Z" && text[0] != '+' && text[0] != '-') {
        return std::nullopt;
    }
    const int hours = half ? *hour % 12 + (evening ? 12 : 0) : *hour;
    out.second_s = hours * 3600.0 + *minute * 60.0 + second_s;
    return out;
}

double ClockCounter::seconds(const ClockTime& time) {
    const auto day = calendarDay(time.date);
    if (!m_begun) {
        m_begun = true;
        m_day = day.value_or(0.0);
        m_first_s = m_day * kDay_s + time.second_s;
    } else if (day) {
        m_day = *day;
    } else if (time.date.empty() ? time.second_s < m_last_s - kDay_s / 2.0 : time.date != m_date) {
        m_day += 1.0;
    }
    m_date = time.date;
    m_last_s = time.second_s;
    return m_day * kDay_s + time.second_s - m_first_s;
}

}  // namespace kerf::files
