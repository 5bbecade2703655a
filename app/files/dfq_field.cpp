// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dfq_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/files/cell.h"
#include "app/files/dfq_line.h"
#include "app/files/dfq_loose.h"
#include "engine/core/utf8.h"

namespace kerf::dfq {
namespace {

constexpr std::size_t kQuoted = 32;  // letters of a field in a sentence
constexpr double kMostAttribute = 1e6;

bool isZeroTime(std::string_view text) {
    return text.find_first_not_of("0./:- T") == std::string_view::npos;
}

}  // namespace

std::string eitherOrder(std::string_view text) {
    return fmt::format(
        "'{}' may have its day or its month first, and no date of the file tells; say which with --dates day-first or "
        "--dates month-first",
        beginOf(text, kQuoted));
}

std::string keyName(int key) {
    return key < 0 ? fmt::format("place {}", -key) : fmt::format("K{:04}", key);
}

bool FieldReader::take(Value& value, int key, std::string& text) {
    switch (key) {
        case 1:
        case 20:
        case 21:
            return takeNumber(value, key, text);
        case 2:
            return takeAttribute(value, text);
        case 4:
            return takeTime(value, text);
        case 5:
            takeEvents(value, text);
            return true;
        default:
            return true;
    }
}

/// A mark for "no value" leaves `text` empty.
bool FieldReader::takeNumber(Value& value, int key, std::string& text) {
    std::optional<double> number = numberOf(text);
    if (!number && !text.empty()) {
        const std::string* unit = m_file.find(2142, value.characteristic);
        number = looseNumberOf(withoutUnit(text, unit != nullptr ? std::string_view(*unit) : std::string_view()));
        if (number) {
            m_findings.oddOfFile(fmt::format("numbers in another form ('{}')", beginOf(text, kQuoted)));
            text = fmt::format("{}", *number);
        } else if (key == 1 && files::readCell(text).kind == files::CellKind::Missing) {
            m_findings.oddOnce(fmt::format("'{}' stands for no value", beginOf(text, kQuoted)));
            text.clear();
        } else {
            m_findings.bad(keyName(key), fmt::format("'{}' is no number", text));
            return false;
        }
    }
    if (text.find(',') != std::string::npos) {
        m_findings.oddOfFile("decimal commas");
        std::ranges::replace(text, ',', '.');
    }
    if (key == 1) {
        value.value = number;
    }
    return true;
}

bool FieldReader::takeAttribute(Value& value, std::string& text) {
    if (text.empty()) {
        return true;
    }
    int attribute = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), attribute);
    if (error != std::errc{} || stop != text.data() + text.size()) {
        const auto whole = numberOf(text);  // "0.0"
        if (!whole || *whole != std::floor(*whole) || std::abs(*whole) > kMostAttribute) {
            m_findings.bad(keyName(2), fmt::format("'{}' is no attribute; expected 0, 255, 256 …", text));
            return false;
        }
        m_findings.oddOfFile(fmt::format("attributes in another form ('{}')", beginOf(text, kQuoted)));
        attribute = static_cast<int>(*whole);
        text = std::to_string(attribute);
    }
    value.attribute = attribute;
    return true;
}

/// What the date of `text` says about the order of day and month.
void FieldReader::judgeOrder(const Time& time, std::string_view local, const std::string& text) {
    if (m_slashes != SlashDates::MonthFirst || text.find('/') == std::string::npos) {
        return;
    }
    auto other = timeOf(local, SlashDates::DayFirst);
    if (!other) other = looseTimeOf(text, SlashDates::DayFirst);
    const bool own = std::ranges::count(text, '/') == 3 || text.find_first_of("Mm") != std::string::npos;
    m_monthFirst = m_monthFirst || !other || (own && *other != time);
    m_either = m_either || (other && *other != time && !own);
}

bool FieldReader::takeTime(Value& value, std::string& text) {
    if (text.empty()) {
        return true;
    }
    // An offset of ISO 8601 is kept as it stands; the clock in front of it is what counts here.
    std::string_view local = text;
    const auto t = local.find('T');
    bool offset = false;
    if (t != std::string_view::npos) {
        const auto zone = local.find_first_of("+-Z", t);
        offset = zone != std::string_view::npos;
        local = local.substr(0, zone);
    }
    value.time = timeOf(local, m_slashes);
    if (!value.time && isZeroTime(text)) {
        m_findings.oddHere("a time of zeros, taken as none");
        return true;
    }
    if (!value.time && files::readCell(text).kind == files::CellKind::Missing) {
        m_findings.oddOnce(fmt::format("'{}' stands for no time", text.substr(0, kQuoted)));
        return true;
    }
    if (!value.time) {
        value.time = looseTimeOf(text, m_slashes);
        offset = offset && !value.time;
    }
    if (!value.time) {
        m_dayFirst = m_slashes == SlashDates::MonthFirst && (timeOf(local, SlashDates::DayFirst).has_value() ||
                                                             looseTimeOf(text, SlashDates::DayFirst).has_value());
        m_findings.bad(keyName(4), fmt::format("'{}' is no time; expected dd.MM.yyyy/HH:mm:ss", text));
        return false;
    }
    judgeOrder(*value.time, local, text);
    if (!offset) {
        const std::string canonical = timeText(*value.time);
        if (canonical != text) {
            m_findings.oddOfFile(
                fmt::format("times in another form than dd.MM.yyyy/HH:mm:ss ('{}')", beginOf(text, kQuoted)));
            text = canonical;
        }
    }
    return true;
}

void FieldReader::takeEvents(Value& value, std::string& text) {
    value.events.clear();
    if (text.find_first_not_of("0123456789 ,;") == std::string::npos && text.find_first_of(" ;") != std::string::npos) {
        m_findings.oddOfFile("events apart by blanks or semicolons instead of commas");
        std::string numbers;
        for (std::size_t at = text.find_first_of("0123456789"); at != std::string::npos;) {
            const std::size_t end = std::min(text.find_first_of(" ,;", at), text.size());
            numbers.append(numbers.empty() ? 0 : 1, ',').append(text, at, end - at);
            at = text.find_first_of("0123456789", end);
        }
        text = numbers;
    }
    for (const std::string_view piece : split(text, ',')) {
        const std::string_view number = trimmed(piece);
        std::uint32_t event = 0;
        const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), event);
        if (!number.empty() && error == std::errc{} && stop == number.data() + number.size()) {
            value.events.push_back(event);
        } else if (!number.empty()) {
            m_findings.oddHere(fmt::format("'{}' is no event's number, kept as text", beginOf(number, kQuoted)));
        }
    }
}

}  // namespace kerf::dfq
