// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/files/dfq.h"
#include "app/files/dfq_line.h"
#include "app/files/text_encoding.h"

namespace kerf::dfq {
namespace {

/// Windows-1252 from 0x80 to 0x9F; bytes it leaves open stand for themselves, so that they survive a copy.
constexpr std::array<char32_t, 32> kUpper{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                          0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                          0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                          0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

void append(std::string& text, char32_t letter) {
    const auto byte = [&](char32_t value) { text += static_cast<char>(static_cast<unsigned char>(value)); };
    if (letter < 0x80) {
        byte(letter);
    } else if (letter < 0x800) {
        byte(0xC0 | (letter >> 6U));
        byte(0x80 | (letter & 0x3FU));
    } else if (letter < 0x10000) {
        byte(0xE0 | (letter >> 12U));
        byte(0x80 | ((letter >> 6U) & 0x3FU));
        byte(0x80 | (letter & 0x3FU));
    } else {
        byte(0xF0 | (letter >> 18U));
        byte(0x80 | ((letter >> 12U) & 0x3FU));
        byte(0x80 | ((letter >> 6U) & 0x3FU));
        byte(0x80 | (letter & 0x3FU));
    }
}

/// The next letter of UTF-8, moving `at` on; empty when the bytes are none.
std::optional<char32_t> nextLetter(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(at);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
    if (length == 0 || at + length > text.size()) {
        return std::nullopt;
    }
    char32_t letter = length == 1 ? lead : lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0U) != 0x80U) {
            return std::nullopt;
        }
        letter = (letter << 6U) | (byte(at + i) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    if (letter < kLeast[length] || letter > 0x10FFFF || (letter >= 0xD800 && letter < 0xE000)) {
        return std::nullopt;
    }
    at += length;
    return letter;
}

/// Valid UTF-8 with at least one letter beyond ASCII.
bool looksLikeUtf8(std::string_view bytes) {
    bool beyond = false;
    for (std::size_t at = 0; at < bytes.size();) {
        const auto letter = nextLetter(bytes, at);
        if (!letter) {
            return false;
        }
        beyond = beyond || *letter >= 0x80;
    }
    return beyond;
}

std::string fromUtf16(std::string_view bytes, bool littleEndian) {
    std::string text;
    const auto unit = [&](std::size_t i) {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        return static_cast<char32_t>(littleEndian ? first | second << 8 : second | first << 8);
    };
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        char32_t letter = unit(i);
        if (letter >= 0xD800 && letter < 0xDC00 && i + 3 < bytes.size() && (unit(i + 2) & 0xFC00U) == 0xDC00U) {
            letter = 0x10000 + ((letter - 0xD800) << 10U) + (unit(i + 2) - 0xDC00);
            i += 2;
        } else if (letter >= 0xD800 && letter < 0xE000) {
            letter = 0xFFFD;
        }
        append(text, letter);
    }
    return text;
}

constexpr double kFinestSecond = 1e9;  // parts of a second that are told apart

/// A whole number of one to four digits at the front of `text`, taken off it.
std::optional<int> takeNumber(std::string_view& text) {
    std::size_t digits = 0;
    int value = 0;
    while (digits < text.size() && digits < 4 && isDigit(text[digits])) {
        value = value * 10 + (text[digits] - '0');
        ++digits;
    }
    if (digits == 0) {
        return std::nullopt;
    }
    text.remove_prefix(digits);
    return value;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) {
        return false;
    }
    text.remove_prefix(1);
    return true;
}

int daysIn(int year, int month) {
    constexpr std::array<int, 12> kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return month == 2 && leap ? 29 : kDays[static_cast<std::size_t>(month - 1)];
}

/// hh:mm, hh:mm:ss, with a fraction, AM or PM; all of `text`.
bool takeClock(std::string_view text, Time& time) {
    const auto hour = takeNumber(text);
    if (!hour || !take(text, ':')) {
        return false;
    }
    const auto minute = takeNumber(text);
    if (!minute) {
        return false;
    }
    time.hour = *hour;
    time.minute = *minute;
    if (take(text, ':')) {
        const auto second = takeNumber(text);
        if (!second) {
            return false;
        }
        time.second = *second;
        if (!text.empty() && (text.front() == '.' || text.front() == ',')) {
            double fraction = 0.0;
            double scale = 1.0;
            text.remove_prefix(1);
            for (; !text.empty() && isDigit(text.front()); text.remove_prefix(1)) {
                if (scale < kFinestSecond) {
                    fraction = 10.0 * fraction + (text.front() - '0');
                    scale *= 10.0;
                }
            }
            time.second += fraction / scale;
        }
    }
    while (take(text, ' ')) {
    }
    if (text == "AM" || text == "am" || text == "PM" || text == "pm") {
        const bool afternoon = text[0] == 'P' || text[0] == 'p';
        if (time.hour < 1 || time.hour > 12) {
            return false;
        }
        time.hour = time.hour % 12 + (afternoon ? 12 : 0);
        text = {};
    }
    return text.empty() && time.hour < 24 && time.minute < 60 && time.second < 61.0;
}

}  // namespace

const char* encodingName(Encoding encoding) {
    constexpr std::array<const char*, 4> kNames{"windows-1252", "utf-8", "utf-16", "cp949"};
    return kNames[static_cast<std::size_t>(encoding)];
}

std::string decoded(std::string_view bytes, Encoding& encoding) {
    if (bytes.starts_with("\xEF\xBB\xBF")) {
        encoding = Encoding::Utf8;
        bytes.remove_prefix(3);
        if (std::string_view probe = bytes; !looksLikeUtf8(probe)) {  // ASCII, or a mark that lies
            Encoding other{};
            return decoded(bytes, other);
        }
        return std::string(bytes);
    }
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        encoding = Encoding::Utf16;
        return fromUtf16(bytes.substr(2), bytes.front() == '\xFF');
    }
    // Without a mark: a K line of two-byte letters has a zero beside every letter.
    const bool wide = bytes.size() >= 4 && bytes.size() % 2 == 0;
    if (wide && bytes[0] != '\0' && bytes[1] == '\0' && bytes[2] != '\0' && bytes[3] == '\0') {
        encoding = Encoding::Utf16;
        return fromUtf16(bytes, true);
    }
    if (wide && bytes[0] == '\0' && bytes[1] != '\0' && bytes[2] == '\0' && bytes[3] != '\0') {
        encoding = Encoding::Utf16;
        return fromUtf16(bytes, false);
    }
    if (looksLikeUtf8(bytes)) {
        encoding = Encoding::Utf8;
        return std::string(bytes);
    }
    if (const auto guess = files::decodeText(bytes); guess.encoding == files::Encoding::Cp949 && !guess.damaged) {
        encoding = Encoding::Cp949;
        return guess.utf8;
    }
    encoding = Encoding::Windows1252;
    std::string text;
    text.reserve(bytes.size());
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        append(text, byte >= 0x80 && byte < 0xA0 ? kUpper[byte - 0x80U] : byte);
    }
    return text;
}

std::string windows1252(std::string_view utf8, bool& lossless) {
    std::string bytes;
    bytes.reserve(utf8.size());
    for (std::size_t at = 0; at < utf8.size();) {
        const auto letter = nextLetter(utf8, at);
        if (!letter) {
            lossless = false;
            bytes += '?';
            ++at;
            continue;
        }
        const auto upper = std::ranges::find(kUpper, *letter);
        if (*letter < 0x80 || (*letter >= 0xA0 && *letter < 0x100)) {
            bytes += static_cast<char>(static_cast<unsigned char>(*letter));
        } else if (upper != kUpper.end()) {
            bytes += static_cast<char>(static_cast<unsigned char>(0x80 + (upper - kUpper.begin())));
        } else {
            lossless = false;
            bytes += '?';
        }
    }
    return bytes;
}

std::optional<double> numberOf(std::string_view text) {
    std::string clean(text);
    std::ranges::replace(clean, ',', '.');
    std::string_view rest = clean;
    if (rest.starts_with('+')) {
        rest.remove_prefix(1);
        if (rest.starts_with('-') || rest.starts_with('+')) {
            return std::nullopt;
        }
    }
    double value = 0.0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    const bool whole = stop == rest.data() + rest.size();
    if (error == std::errc::result_out_of_range && whole) {  // 1E-999 is 0; 1E+999 is none
        return rest.find("E-") != std::string_view::npos || rest.find("e-") != std::string_view::npos
                   ? std::optional(0.0)
                   : std::nullopt;
    }
    return error == std::errc{} && whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Time> timeOf(std::string_view text, SlashDates slashes) {
    Time time;
    const auto first = takeNumber(text);
    if (!first || text.empty()) {
        return std::nullopt;
    }
    const char between = text.front();
    if (between != '.' && between != '/' && between != '-') {
        return std::nullopt;
    }
    text.remove_prefix(1);
    const auto second = takeNumber(text);
    if (!second || !take(text, between)) {
        return std::nullopt;
    }
    const auto third = takeNumber(text);
    if (!third) {
        return std::nullopt;
    }
    switch (between) {
        case '.':  // d.M.y
            time.day = *first, time.month = *second, time.year = *third;
            break;
        case '/':  // M/d/y or d/M/y
            time.month = slashes == SlashDates::MonthFirst ? *first : *second;
            time.day = slashes == SlashDates::MonthFirst ? *second : *first;
            time.year = *third;
            break;
        default:  // y-M-d
            time.year = *first, time.month = *second, time.day = *third;
            break;
    }
    if (time.year < 100) {
        time.year += time.year < 70 ? 2000 : 1900;
    }
    if (time.year < 1000 || time.month < 1 || time.month > 12 || time.day < 1 ||
        time.day > daysIn(time.year, time.month)) {
        return std::nullopt;
    }
    if (text.empty()) {
        return time;
    }
    if (text.front() != '/' && text.front() != ' ' && text.front() != '.' && text.front() != 'T') {
        return std::nullopt;
    }
    text.remove_prefix(1);
    return takeClock(text, time) ? std::optional(time) : std::nullopt;
}

std::string timeText(const Time& time) {
    std::string seconds = fmt::format("{:012.9f}", time.second);
    constexpr std::size_t kMilliseconds = 6;  // "12.500"
    while (seconds.size() > kMilliseconds && seconds.back() == '0') {
        seconds.pop_back();
    }
    if (seconds.ends_with(".000")) {
        seconds.resize(2);
    }
    return fmt::format("{:02}.{:02}.{:04}/{:02}:{:02}:{}", time.day, time.month, time.year, time.hour, time.minute,
                       seconds);
}

}  // namespace kerf::dfq
