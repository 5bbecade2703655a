// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/clock.h"

#include <algorithm>
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

constexpr int kShortYears = 100;

/// Days since 1970 of a date's numbers in this order; empty when they are none.
std::optional<double> calendarDay(const std::array<std::int16_t, 3>& n, DateOrder order) noexcept {
    const int year = order == DateOrder::YearFirst ? n[0] : n[2];
    const int month = order == DateOrder::MonthFirst ? n[0] : n[1];
    const int day = order == DateOrder::DayFirst ? n[0] : order == DateOrder::MonthFirst ? n[1] : n[2];
    if (month < 1 || day < 1) {
        return std::nullopt;
    }
    const std::chrono::year_month_day all{std::chrono::year(year < kShortYears ? 2000 + year : year),
                                          std::chrono::month(static_cast<unsigned>(month)),
                                          std::chrono::day(static_cast<unsigned>(day))};
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

void ClockColumn::add(const ClockTime& time) {
    Time out{time.second_s, {}, 0, !time.date.empty(), time.date != m_date};
    std::string_view date = time.date;
    if (date.size() == 8 && date.find_first_not_of("0123456789") == std::string_view::npos) {  // 20261127
        auto year = date.substr(0, 4), month = date.substr(4, 2), day = date.substr(6);
        out.numbers = {static_cast<std::int16_t>(*takeNumber(year, 4)),
                       static_cast<std::int16_t>(*takeNumber(month, 2)),
                       static_cast<std::int16_t>(*takeNumber(day, 2))};
        out.mark = '-';
    } else if (const auto first = takeNumber(date, 4); first && !date.empty()) {
        out.mark = date.front();
        date.remove_prefix(1);
        const auto second = takeNumber(date, 2);
        const auto third = second && take(date, out.mark) ? takeNumber(date, 4) : std::nullopt;
        if (third && date.empty()) {
            out.numbers = {static_cast<std::int16_t>(*first), static_cast<std::int16_t>(*second),
                           static_cast<std::int16_t>(*third)};
        }
    }
    m_date = time.date;
    m_times.push_back(out);
}

std::vector<double> ClockColumn::secondsIn(DateOrder order) const {
    std::vector<double> out;
    for (const Time& time : m_times) {
        const bool yearFirst = time.numbers[0] >= kShortYears;
        const bool dayFirst = time.mark == '.' && !yearFirst;
        const DateOrder own = yearFirst ? DateOrder::YearFirst : dayFirst ? DateOrder::DayFirst : order;
        const auto day = calendarDay(time.numbers, own);
        if (!day) {
            return {};
        }
        out.push_back(*day * kDay_s + time.second_s);
    }
    return out;
}

std::vector<double> ClockColumn::secondsWithoutCalendar() const {
    std::vector<double> out;
    double day = 0.0;
    for (std::size_t k = 0; k < m_times.size(); ++k) {
        const Time& time = m_times[k];
        if (k > 0 && (time.dated ? time.another : time.second_s < m_times[k - 1].second_s - kDay_s / 2.0)) {
            day += 1.0;
        }
        out.push_back(day * kDay_s + time.second_s);
    }
    return out;
}

ClockColumn::Counted ClockColumn::counted(std::optional<DateOrder> said) const {
    std::vector<std::vector<double>> readings;
    for (const DateOrder order : {DateOrder::DayFirst, DateOrder::MonthFirst, DateOrder::YearFirst}) {
        if (said && *said != order) {
            continue;
        }
        std::vector<double> seconds = secondsIn(order);
        if (seconds.empty()) {
            continue;
        }
        const double first_s = seconds.front();
        for (double& second : seconds) {
            second -= first_s;
        }
        readings.push_back(std::move(seconds));
    }
    const auto forward = [](const std::vector<double>& seconds) { return std::ranges::is_sorted(seconds); };
    if (std::ranges::any_of(readings, forward)) {
        std::erase_if(readings, [&](const auto& seconds) { return !forward(seconds); });
    }
    Counted out;
    if (readings.empty()) {
        out.seconds = secondsWithoutCalendar();
        for (double& second : out.seconds) {
            second -= m_times.front().second_s;
        }
        return out;
    }
    for (const auto& other : readings) {
        const auto [own, differs] = std::ranges::mismatch(readings.front(), other);
        if (own != readings.front().end()) {
            out.doubt =
                std::min(out.doubt.value_or(m_times.size()), static_cast<std::size_t>(own - readings.front().begin()));
        }
    }
    out.seconds = std::move(readings.front());
    return out;
}

}  // namespace kerf::files
