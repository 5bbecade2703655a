// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dfq_loose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "app/files/dfq_line.h"

namespace kerf::dfq {
namespace {

constexpr int kFirstYear = 1950;
constexpr int kLastYear = 2100;

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

int number(std::string_view digits) {
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

std::string lower(std::string_view text) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
    std::string out;
    std::string_view rest = text;
    for (auto at = rest.find(what); at != std::string_view::npos; at = rest.find(what)) {
        out += rest.substr(0, at);
        out += with;
        rest.remove_prefix(at + what.size());
    }
    out += rest;
    text = std::move(out);
}

/// 1 to 12 by its first three letters in English or German; 0: none.
int monthOf(std::string_view word) {
    constexpr std::array<std::string_view, 12> kEnglish{"jan", "feb", "mar", "apr", "may", "jun",
                                                        "jul", "aug", "sep", "oct", "nov", "dec"};
    constexpr std::array<std::string_view, 12> kGerman{"jan", "feb", "m\xC3\xA4r", "apr", "mai", "jun",
                                                       "jul", "aug", "sep",        "okt", "nov", "dez"};
    const std::string letters = lower(word);
    for (std::size_t month = 0; month < kEnglish.size(); ++month) {
        if (letters.starts_with(kEnglish[month]) || letters.starts_with(kGerman[month])) {
            return static_cast<int>(month) + 1;
        }
    }
    return 0;
}

/// yyyyMMdd or ddMMyyyy as dd.MM.yyyy; never both. Empty: neither.
std::string dateOf(std::string_view eight) {
    const int year = number(eight.substr(0, 4));
    if (year >= kFirstYear && year <= kLastYear) {
        return fmt::format("{}.{}.{}", eight.substr(6, 2), eight.substr(4, 2), year);
    }
    const int last = number(eight.substr(4, 4));
    if (last >= kFirstYear && last <= kLastYear) {
        return fmt::format("{}.{}.{}", eight.substr(0, 2), eight.substr(2, 2), last);
    }
    return {};
}

/// HHmm or HHmmss as HH:mm:ss, a clock with dots or hyphens as one with colons.
std::string clockOf(std::string_view text) {
    const bool digits = std::ranges::all_of(text, isDigit);
    if (digits && (text.size() == 4 || text.size() == 6)) {
        return fmt::format("{}:{}:{}", text.substr(0, 2), text.substr(2, 2),
                           text.size() == 6 ? text.substr(4, 2) : std::string_view("00"));
    }
    std::string clock(text);
    if (text.find(':') == std::string_view::npos) {
        for (const char between : {'.', '-', 'h'}) {
            const auto parts = split(text, between);
            const bool times = parts.size() >= 2 && parts.size() <= 3 && std::ranges::all_of(parts, [](auto part) {
                                   return !part.empty() && part.size() <= 2 && std::ranges::all_of(part, isDigit);
                               });
            if (times) {
                std::ranges::replace(clock, between, ':');
                return clock;
            }
        }
    }
    return clock;
}

/// Words taken out: morning and afternoon go behind, months become numbers, weekdays and Uhr go.
std::string withoutWords(std::string_view given) {
    std::string text(trimmed(given));
    std::string half;
    for (const auto& [word, mark] : {std::pair("오전", " AM"), std::pair("오후", " PM")}) {
        if (text.find(word) != std::string::npos) {
            replaceAll(text, word, " ");
            half = mark;
        }
    }
    std::string out;
    int month = 0;
    bool monthFirst = false;
    for (std::size_t at = 0; at < text.size();) {
        if (!isLetter(text[at])) {
            out += text[at++];
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && isLetter(text[end])) {
            ++end;
        }
        const std::string word = text.substr(at, end - at);
        const std::string small = lower(word);
        if (small == "am" || small == "pm" || small == "t" || small == "h" || small == "z") {
            out += word;
        } else if (const int found = word.size() >= 3 ? monthOf(word) : 0; found > 0 && month == 0) {
            month = found;
            monthFirst = out.find_first_of("0123456789") == std::string::npos;
            out += fmt::format("<{}>", found);
        } else if (small != "uhr" && out.find_first_of("0123456789") != std::string::npos) {
            out += word;  // behind a figure and nothing that is known
        } else {
            while (end < text.size() && (text[end] == '.' || text[end] == ',')) {
                ++end;  // "Fr., 27.11."
            }
        }
        at = end;
    }
    if (month > 0) {
        // The three pieces around the name, whatever stands between them.
        std::string pieces;
        for (const char c : out) {
            pieces += c == '<' || c == '>' ? ' ' : c;
        }
        const std::size_t clock = pieces.find(':');
        std::size_t begin = clock == std::string::npos ? pieces.size() : clock;
        while (begin > 0 && isDigit(pieces[begin - 1])) {
            --begin;
        }
        std::vector<std::string> numbers;
        for (std::size_t at = 0; at < begin;) {
            std::size_t end = at;
            while (end < begin && isDigit(pieces[end])) {
                ++end;
            }
            if (end > at) {
                numbers.push_back(pieces.substr(at, end - at));
            }
            at = std::max(end, at + 1);
        }
        if (numbers.size() != 3) {
            return {};
        }
        const std::string& day = monthFirst ? numbers[1] : numbers[0];
        out = fmt::format("{}.{}.{} {}", day, month, numbers[2], trimmed(std::string_view(pieces).substr(begin)));
    }
    out = std::string(trimmed(out));
    replaceAll(out, ". ", ".");  // "27. 11. 2026"
    replaceAll(out, "  ", " ");
    return out + half;
}

}  // namespace

std::optional<Time> looseTimeOf(std::string_view given, SlashDates slashes) {
    const std::string text = withoutWords(given);
    std::size_t digits = 0;
    while (digits < text.size() && isDigit(text[digits])) {
        ++digits;
    }
    std::string date;
    std::string clock;
    if (digits == 8 || digits == 12 || digits == 14) {
        date = dateOf(std::string_view(text).substr(0, 8));
        clock = text.substr(8);
    } else if (digits > 0 && digits <= 4) {
        // Three numbers with one sign between them.
        const char between = digits < text.size() ? text[digits] : '\0';
        std::size_t end = digits;
        std::array<std::string, 3> parts{text.substr(0, digits), {}, {}};
        for (std::size_t part = 1; part < parts.size(); ++part) {
            if (end >= text.size() || text[end] != between || isDigit(between)) {
                return std::nullopt;
            }
            const std::size_t begin = ++end;
            while (end < text.size() && isDigit(text[end])) {
                ++end;
            }
            parts[part] = text.substr(begin, end - begin);
        }
        const bool yearFirst = parts[0].size() == 4;
        const bool yearLast = parts[2].size() == 4;
        if (yearFirst) {
            date = fmt::format("{}.{}.{}", parts[2], parts[1], parts[0]);
        } else if (between == '.') {
            date = fmt::format("{}.{}.{}", parts[0], parts[1], parts[2]);
        } else if (between == '/' || (between == '-' && yearLast)) {
            date = fmt::format("{}/{}/{}", parts[0], parts[1], parts[2]);
        } else {
            date = fmt::format("{}-{}-{}", parts[0], parts[1], parts[2]);
        }
        clock = text.substr(end);
        if (clock.starts_with(between) && clock.size() > 1 && between == '.') {
            clock.erase(0, 1);  // "2026.11.27. 10:11"
        }
    }
    if (date.empty()) {
        return std::nullopt;
    }
    clock = std::string(trimmed(clock));
    const std::size_t first = clock.find_first_of("0123456789");
    if (first == std::string::npos) {
        return clock.find_first_not_of("/ ") == std::string::npos ? timeOf(date, slashes) : std::nullopt;
    }
    if (clock.find_first_not_of("/ T.,_-") != first) {
        return std::nullopt;
    }
    const std::size_t end = std::min(clock.find(' ', first), clock.size());
    clock = clockOf(std::string_view(clock).substr(first, end - first)) + clock.substr(end);
    if (clock == "24:00" || clock == "24:00:00") {  // the midnight that ends the day
        auto time = timeOf(date + "/23:59:00", slashes);
        if (!time) {
            return std::nullopt;
        }
        for (Time next{time->year, time->month, time->day + 1, 0, 0, 0.0}; next.year <= time->year + 1;) {
            if (timeOf(fmt::format("{}.{}.{}", next.day, next.month, next.year))) {
                return next;
            }
            next =
                next.month == 12 ? Time{next.year + 1, 1, 1, 0, 0, 0.0} : Time{next.year, next.month + 1, 1, 0, 0, 0.0};
        }
        return std::nullopt;
    }
    return timeOf(date + '/' + clock, slashes);
}

std::optional<double> looseNumberOf(std::string_view given) {
    std::string text(trimmed(given));
    if (text.size() > 1 && (text.back() == '-' || text.back() == '+') && isDigit(text.front())) {
        text.insert(text.begin(), text.back());
        text.pop_back();
    }
    if (text.size() > 2 && (text[0] == '-' || text[0] == '+') && text[1] == ' ') {
        text = text[0] + std::string(trimmed(std::string_view(text).substr(1)));
    }
    // Thousands stand in threes, and another sign parts the fraction.
    const auto grouped = [&text](char thousands, char decimal) {
        const std::size_t point = std::min(text.find(decimal), text.size());
        const std::size_t from = text.find_first_of("0123456789");
        const auto groups =
            split(std::string_view(text).substr(std::min(from, point), point - std::min(from, point)), thousands);
        const bool fits = groups.size() > 1 && !groups.front().empty() && groups.front().size() <= 3 &&
                          std::ranges::all_of(groups, [](auto g) { return std::ranges::all_of(g, isDigit); }) &&
                          std::all_of(groups.begin() + 1, groups.end(), [](auto g) { return g.size() == 3; });
        return fits && (point < text.size() || thousands == '\'' || groups.size() > 2);
    };
    for (const auto& [thousands, decimal] : {std::pair('.', ','), std::pair(',', '.'), std::pair('\'', '.')}) {
        if (grouped(thousands, decimal)) {
            std::erase(text, thousands);
            break;
        }
    }
    return numberOf(text);
}

std::string withoutUnit(std::string_view text, std::string_view unit) {
    constexpr std::array<std::string_view, 10> kUnits{"mm",   "\xC2\xB5m", "um",  "in", "\"",
                                                      "inch", "\xC2\xB0",  "deg", "N",  "%"};
    const std::string_view whole = trimmed(text);
    std::size_t end = whole.size();
    while (end > 0 && !isDigit(whole[end - 1]) && whole[end - 1] != '.') {
        --end;
    }
    const std::string_view behind = trimmed(whole.substr(end));
    const bool known = unit.empty() ? std::ranges::find(kUnits, behind) != kUnits.end() : lower(behind) == lower(unit);
    return std::string(end > 0 && !behind.empty() && known ? whole.substr(0, end) : whole);
}

bool isRemark(std::string_view line) {
    const std::string small = lower(line);
    return small == "eof" || small == "end" || small == "[eof]" || small == "<eof>" || line.starts_with("//") ||
           line.starts_with(";") || line.starts_with("/*") || line.starts_with("*") || line.starts_with("!") ||
           (line.starts_with('[') && line.ends_with(']'));
}

}  // namespace kerf::dfq
