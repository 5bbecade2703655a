// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/cell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace kerf::files {
namespace {

/// Scopes and meters write 9.9E+37 for "beyond the range".
constexpr double kOverRangeFrom = 9.8e37;
constexpr std::size_t kLongestNumber = 64;

constexpr std::array<std::string_view, 35> kMissing{"nan",       "na",
                                                    "n/a",       "#n/a",
                                                    "#nv",       "null",
                                                    "none",      "nil",
                                                    "nul",       "missing",
                                                    "no data",   "nodata",
                                                    "#value!",   "#div/0!",
                                                    "#wert!",    "#ref!",
                                                    "#bezug!",   "#num!",
                                                    "#zahl!",    "#null!",
                                                    "err",       "error",
                                                    "bad",       "invalid",
                                                    "fault",     "-nan",
                                                    "+nan",      "nan(ind)",
                                                    "-nan(ind)", "1.#qnan",
                                                    "1.#ind",    "-1.#ind",
                                                    "1.#snan",   "\xEC\x97\x86\xEC\x9D\x8C",
                                                    "missed"};
/// What stations and people here write: not measurable, not measured, missing, fault, error.
constexpr std::array<std::string_view, 6> kMissingKorean{"\xEC\xB8\xA1\xEC\xA0\x95\xEB\xB6\x88\xEA\xB0\x80",
                                                         "\xEC\xB8\xA1\xEC\xA0\x95\x20\xEB\xB6\x88\xEA\xB0\x80",
                                                         "\xEB\xAF\xB8\xEC\xB8\xA1\xEC\xA0\x95",
                                                         "\xEA\xB2\xB0\xEC\xB8\xA1",
                                                         "\xEC\x98\xA4\xEB\xA5\x98",
                                                         "\xEC\x97\x90\xEB\x9F\xAC"};
constexpr std::array<std::string_view, 25> kOverRange{
    "ol",          "-ol",  "+ol",  "o.l",  "o.l.",   "over",     "overload", "over range",
    "overrange",   "ovld", "ovrl", "ovr",  "ovf",    "overflow", "open",     "opn",
    "burnout",     "inf",  "+inf", "-inf", "1.#inf", "-1.#inf",  "under",    "\xEB\x8B\xA8\xEC\x84\xA0",
    "\xE2\x88\x9E"};

/// Words that say the same, whatever stands around and between their letters: n.a., <NULL>, TC OPEN, S.br, burn-out.
constexpr std::array<std::string_view, 25> kMissingLetters{
    "na",        "notavailable", "nodata",    "keine",       "keinwert",   "leer",        "null",
    "badinput",  "timeout",      "iotimeout", "commfail",    "commerror",  "sensorfault", "name",
    "sensorerr", "sensorerror",  "readerror", "invaliddata", "badquality", "notmeasured", "unknown",
    "disabled",  "nv",           "fehlt",     "fehler"};
constexpr std::array<std::string_view, 16> kOverRangeLetters{
    "ol",          "over",    "overrange", "underrange", "under", "infinity",    "tcopen",    "opentc",
    "opencircuit", "opencct", "burnout",   "break",      "sbr",   "sensorbreak", "wirebreak", "sensoropen"};
constexpr std::size_t kLongestMark = 24;

/// Dashes, dots, stars or question marks alone: how displays and reports show "nothing".
bool isRule(std::string_view text) noexcept {
    return text.find_first_not_of("-_.*?# ") == std::string_view::npos || text == "\xE2\x80\x93" ||
           text == "\xE2\x80\x94";
}

/// Digits in threes behind a first group of one to three: 1,234,567.
bool grouped(std::string_view digits, char mark) noexcept {
    const auto first = digits.find(mark);
    if (first == std::string_view::npos || first == 0 || first > 3 || digits[0] == '0') {
        return false;
    }
    for (std::size_t at = first; at < digits.size(); at += 4) {
        if (digits[at] != mark || digits.size() - at < 4 ||
            !std::all_of(digits.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                         digits.begin() + static_cast<std::ptrdiff_t>(at) + 4, isDigit)) {
            return false;
        }
    }
    return true;
}

struct Number {
    bool ok{false};
    double value{0.0};
    Marks marks{Marks::None};
};

Number readNumber(std::string_view text, char decimal) noexcept {
    std::array<char, kLongestNumber> buffer{};
    std::size_t length = 0;
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    } else if (text.starts_with("\xE2\x88\x92")) {  // the minus of typesetters
        buffer[length++] = '-';
        text.remove_prefix(3);
    } else if (text.starts_with('-')) {
        buffer[length++] = '-';
        text.remove_prefix(1);
    }
    if (text.empty() || text.size() > kLongestNumber - 2 || (!isDigit(text[0]) && text[0] != '.' && text[0] != ',')) {
        return {};
    }
    const auto exponentAt = text.find_first_of("eEdD");
    const std::string_view mantissa = text.substr(0, exponentAt);
    const auto points = std::ranges::count(mantissa, '.');
    const auto commas = std::ranges::count(mantissa, ',');
    char mark = 0;
    char thousands = 0;
    Number out;
    if (points > 0 && commas > 0) {
        mark = mantissa.rfind('.') > mantissa.rfind(',') ? '.' : ',';
        thousands = mark == '.' ? ',' : '.';
        if (decimal != 0 && mark != decimal) return {};
        if (std::ranges::count(mantissa, mark) != 1) return {};
        out.marks = mark == '.' ? Marks::PointThousands : Marks::CommaThousands;
    } else if (points > 1 || commas > 1) {  // 1.234.567
        thousands = points > 1 ? '.' : ',';
        if (decimal == thousands) return {};
        out.marks = thousands == ',' ? Marks::PointThousands : Marks::CommaThousands;
    } else if (points + commas == 1) {
        mark = points == 1 ? '.' : ',';
        const bool maybe = grouped(mantissa, mark) && exponentAt == std::string_view::npos;
        if (decimal != 0 && mark != decimal) {
            if (!maybe) return {};
            thousands = mark;
            mark = 0;
        }
        out.marks = mark == '.'   ? (maybe ? Marks::PointMaybe : Marks::Point)
                    : mark == ',' ? (maybe ? Marks::CommaMaybe : Marks::Comma)
                                  : Marks::None;
        if (mark == ',' && mantissa.ends_with(',')) return {};  // "1," is a list
    }
    if (thousands != 0) {
        const std::string_view whole = mark != 0 ? mantissa.substr(0, mantissa.rfind(mark)) : mantissa;
        if (!grouped(whole, thousands)) return {};
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (i < mantissa.size()) {
            if (c == thousands && thousands != 0) continue;
            if (c == mark && mark != 0) c = '.';
        } else if (c == 'd' || c == 'D') {
            c = 'e';  // Fortran
        }
        if (i == mantissa.size() + 1 && c == '+') continue;
        buffer[length++] = c;
    }
    const auto [stop, error] = std::from_chars(buffer.data(), buffer.data() + length, out.value);
    if (stop != buffer.data() + length) return {};
    if (error == std::errc::result_out_of_range) {
        const bool large = exponentAt == std::string_view::npos || text.find('-', exponentAt) == std::string_view::npos;
        out.value = large ? HUGE_VAL : 0.0;
        out.ok = true;
        return out;
    }
    out.ok = error == std::errc{};
    return out;
}

/// A mark by its letters alone.
Cell readLetters(std::string_view key) noexcept {
    std::array<char, kLongestMark> kept{};
    std::size_t length = 0;
    for (const char c : key) {
        const bool letter = c >= 'a' && c <= 'z';
        if (!letter && std::string_view(" ._-/+<>()[]{}'\"#!?*:").find(c) == std::string_view::npos) {
            return {};
        }
        if (letter) {
            kept[length++] = c;
        }
    }
    const std::string_view letters(kept.data(), length);
    if (std::ranges::find(kMissingLetters, letters) != kMissingLetters.end()) {
        return {CellKind::Missing, 0.0, Marks::None};
    }
    if (std::ranges::find(kOverRangeLetters, letters) != kOverRangeLetters.end()) {
        return {CellKind::OverRange, 0.0, Marks::None};
    }
    return {};
}

struct Unit {
    std::string_view spelling;
    std::string_view quantity;
    double factor;
    double offset;
};
// In mm, s, rev, N, mm/rev, mm/s, degC, rpm.
constexpr std::array kUnits{
    Unit{"mm", "length", 1.0, 0.0},
    Unit{"um", "length", 1e-3, 0.0},
    Unit{"micron", "length", 1e-3, 0.0},
    Unit{"nm", "length", 1e-6, 0.0},
    Unit{"cm", "length", 10.0, 0.0},
    Unit{"m", "length", 1000.0, 0.0},
    Unit{"in", "length", 25.4, 0.0},
    Unit{"inch", "length", 25.4, 0.0},
    Unit{"inches", "length", 25.4, 0.0},
    Unit{"zoll", "length", 25.4, 0.0},
    Unit{"\"", "length", 25.4, 0.0},
    Unit{"s", "time", 1.0, 0.0},
    Unit{"sec", "time", 1.0, 0.0},
    Unit{"second", "time", 1.0, 0.0},
    Unit{"seconds", "time", 1.0, 0.0},
    Unit{"\xEC\xB4\x88", "time", 1.0, 0.0},
    Unit{"ms", "time", 1e-3, 0.0},
    Unit{"us", "time", 1e-6, 0.0},
    Unit{"ns", "time", 1e-9, 0.0},
    Unit{"min", "time", 60.0, 0.0},
    Unit{"minute", "time", 60.0, 0.0},
    Unit{"minutes", "time", 60.0, 0.0},
    Unit{"minuten", "time", 60.0, 0.0},
    Unit{"\xEB\xB6\x84", "time", 60.0, 0.0},
    Unit{"h", "time", 3600.0, 0.0},
    Unit{"hr", "time", 3600.0, 0.0},
    Unit{"hour", "time", 3600.0, 0.0},
    Unit{"hours", "time", 3600.0, 0.0},
    Unit{"rev", "angle", 1.0, 0.0},
    Unit{"revs", "angle", 1.0, 0.0},
    Unit{"turn", "angle", 1.0, 0.0},
    Unit{"turns", "angle", 1.0, 0.0},
    Unit{"u", "angle", 1.0, 0.0},
    Unit{"deg", "angle", 1.0 / 360.0, 0.0},
    Unit{"degree", "angle", 1.0 / 360.0, 0.0},
    Unit{"degrees", "angle", 1.0 / 360.0, 0.0},
    Unit{"rad", "angle", 0.15915494309189535, 0.0},
    Unit{"n", "force", 1.0, 0.0},
    Unit{"newton", "force", 1.0, 0.0},
    Unit{"kn", "force", 1000.0, 0.0},
    Unit{"mn", "force", 1e-3, 0.0},
    Unit{"dan", "force", 10.0, 0.0},
    Unit{"kgf", "force", 9.80665, 0.0},
    Unit{"lbf", "force", 4.4482216152605, 0.0},
    Unit{"mm per rev", "feed", 1.0, 0.0},
    Unit{"mm per r", "feed", 1.0, 0.0},
    Unit{"mm per u", "feed", 1.0, 0.0},
    Unit{"um per rev", "feed", 1e-3, 0.0},
    Unit{"in per rev", "feed", 25.4, 0.0},
    Unit{"inch per rev", "feed", 25.4, 0.0},
    Unit{"ipr", "feed", 25.4, 0.0},
    Unit{"mm s", "speed", 1.0, 0.0},
    Unit{"mm per s", "speed", 1.0, 0.0},
    Unit{"mm per sec", "speed", 1.0, 0.0},
    Unit{"mm min", "speed", 1.0 / 60.0, 0.0},
    Unit{"mm per min", "speed", 1.0 / 60.0, 0.0},
    Unit{"m per min", "speed", 1000.0 / 60.0, 0.0},
    Unit{"in per min", "speed", 25.4 / 60.0, 0.0},
    Unit{"ipm", "speed", 25.4 / 60.0, 0.0},
    Unit{"degc", "temperature", 1.0, 0.0},
    Unit{"c", "temperature", 1.0, 0.0},
    Unit{"celsius", "temperature", 1.0, 0.0},
    Unit{"deg c", "temperature", 1.0, 0.0},
    Unit{"degf", "temperature", 5.0 / 9.0, -160.0 / 9.0},
    Unit{"f", "temperature", 5.0 / 9.0, -160.0 / 9.0},
    Unit{"deg f", "temperature", 5.0 / 9.0, -160.0 / 9.0},
    Unit{"fahrenheit", "temperature", 5.0 / 9.0, -160.0 / 9.0},
    Unit{"k", "temperature", 1.0, -273.15},
    Unit{"kelvin", "temperature", 1.0, -273.15},
    Unit{"rpm", "rotation", 1.0, 0.0},
    Unit{"r per min", "rotation", 1.0, 0.0},
    Unit{"rev per min", "rotation", 1.0, 0.0},
    Unit{"u per min", "rotation", 1.0, 0.0},
    Unit{"1 per min", "rotation", 1.0, 0.0},
    Unit{"min-1", "rotation", 1.0, 0.0},
    Unit{"rps", "rotation", 60.0, 0.0},
    Unit{"rev per s", "rotation", 60.0, 0.0},
    Unit{"%", "share", 1.0, 0.0},
    Unit{"percent", "share", 1.0, 0.0},
    Unit{"pct", "share", 1.0, 0.0},
    Unit{"v", "voltage", 1.0, 0.0},
    Unit{"mv", "voltage", 1e-3, 0.0},
    Unit{"a", "current", 1.0, 0.0},
    Unit{"w", "power", 1.0, 0.0},
    Unit{"kw", "power", 1000.0, 0.0},
    Unit{"hz", "frequency", 1.0, 0.0},
    Unit{"bar", "pressure", 1.0, 0.0},
};

const Unit* findUnit(std::string_view spelling) noexcept {
    const auto found = std::ranges::find(kUnits, spelling, &Unit::spelling);
    return found == kUnits.end() ? nullptr : &*found;
}

}  // namespace

std::string_view trimmedCell(std::string_view text) noexcept {
    const auto blankLength = [](std::string_view t, bool front) -> std::size_t {
        if (t.empty()) return 0;
        const char c = front ? t.front() : t.back();
        if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0' || c == '\v' || c == '\f') return 1;
        for (const std::string_view wide : {"\xC2\xA0", "\xE2\x80\xAF", "\xE3\x80\x80", "\xEF\xBB\xBF"}) {
            if (front ? t.starts_with(wide) : t.ends_with(wide)) return wide.size();
        }
        return 0;
    };
    while (const std::size_t n = blankLength(text, true)) {
        text.remove_prefix(n);
    }
    while (const std::size_t n = blankLength(text, false)) {
        text.remove_suffix(n);
    }
    return text;
}

Cell readCell(std::string_view text, char decimal) noexcept {
    text = trimmedCell(text);
    if (text.empty()) {
        return {CellKind::Missing, 0.0, Marks::None};
    }
    if (const Number number = readNumber(text, decimal); number.ok) {
        const bool beyond = std::abs(number.value) >= kOverRangeFrom;
        return {beyond ? CellKind::OverRange : CellKind::Number, number.value, number.marks};
    }
    if (isRule(text)) {
        return {CellKind::Missing, 0.0, Marks::None};
    }
    if (text.size() > kLongestMark) {
        return {};
    }
    std::array<char, kLongestMark> lower{};
    std::ranges::transform(text, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const std::string_view key(lower.data(), text.size());
    if (std::ranges::find(kMissing, key) != kMissing.end() ||
        std::ranges::find(kMissingKorean, key) != kMissingKorean.end() || key.starts_with("nan(") ||
        key.starts_with("-nan(")) {
        return {CellKind::Missing, 0.0, Marks::None};
    }
    if (std::ranges::find(kOverRange, key) != kOverRange.end()) {
        return {CellKind::OverRange, 0.0, Marks::None};
    }
    if ((key.front() == '>' || key.front() == '<') && readNumber(trimmedCell(key.substr(1)), decimal).ok) {
        return {CellKind::OverRange, 0.0, Marks::None};  // ">1372": beyond what the instrument shows
    }
    return readLetters(key);
}

std::optional<UnitChange> unitChange(std::string_view found, std::string_view wanted) noexcept {
    const Unit* from = findUnit(found);
    const Unit* to = findUnit(wanted);
    if (from == nullptr || to == nullptr || from->quantity != to->quantity) {
        return std::nullopt;
    }
    return UnitChange{from->factor / to->factor, (from->offset - to->offset) / to->factor};
}

bool isUnit(std::string_view normalised) noexcept {
    return findUnit(normalised) != nullptr;
}

bool isTemperatureUnit(std::string_view normalised) noexcept {
    const Unit* unit = findUnit(normalised);
    return unit != nullptr && unit->quantity == "temperature";
}

}  // namespace kerf::files
