// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/column_name.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "app/files/cell.h"

namespace kerf::files {
namespace {

using Spelling = std::pair<std::string_view, std::string_view>;
/// Signs that are not ASCII, and the one that stands between two units.
constexpr std::array kSpellings{
    Spelling{"\xC2\xB0", "deg"},           // °
    Spelling{"\xC2\xBA", "deg"},           // º, typed for it
    Spelling{"\xE2\x84\x83", "degc"},      // ℃
    Spelling{"\xE2\x84\x89", "degf"},      // ℉
    Spelling{"\xC2\xB5", "u"},             // µ
    Spelling{"\xCE\xBC", "u"},             // μ
    Spelling{"\xE3\x8E\x9B", "um"},        // ㎛
    Spelling{"\xE3\x8E\x9C", "mm"},        // ㎜
    Spelling{"\xC3\x98", "diameter"},      // Ø
    Spelling{"\xC3\xB8", "diameter"},      // ø
    Spelling{"\xE2\x8C\x80", "diameter"},  // ⌀
    Spelling{"\xC2\xA0", " "},
    Spelling{"/", " per "},
};

constexpr std::array<std::array<std::string_view, 15>, 10> kSameThings{{
    {"t", "time", "zeit", "elapsed", "elapsed time", "x value", "uhrzeit", "timestamp", "time stamp", "date time",
     "date&time", "datum per zeit", "date per time", "\xEC\x8B\x9C\xEA\xB0\x84", "\xEC\x8B\x9C\xEA\xB0\x81"},
    {"part", "number", "part no", "part number", "part nr", "teil", "nr", "no", "\xEB\xB6\x80\xED\x92\x88",
     "\xED\x92\x88\xEB\xB2\x88", "\xEB\xB2\x88\xED\x98\xB8", "\xEB\xB6\x80\xED\x92\x88 \xEB\xB2\x88\xED\x98\xB8"},
    {"overhang", "position", "bore position", "auskragung", "messposition", "\xEC\x9C\x84\xEC\xB9\x98",
     "\xEC\xB8\xA1\xEC\xA0\x95 \xEC\x9C\x84\xEC\xB9\x98", "\xEB\x8F\x8C\xEC\xB6\x9C"},
    {"diameter", "dia", "bore diameter", "durchmesser", "\xEB\x82\xB4\xEA\xB2\xBD", "\xEC\xA7\x81\xEA\xB2\xBD",
     "\xEC\xA7\x80\xEB\xA6\x84"},
    {"feed", "vorschub", "\xEC\x9D\xB4\xEC\x86\xA1"},
    {"force y", "fy", "f y", "y force"},
    {"angle", "spindle angle", "winkel", "phi"},
    {"spindle", "spindle position", "spindle revs", "spindle turns", "spindle 0", "spindle 0 revs"},
    {"rpm", "spindle speed", "speed", "drehzahl", "n"},
    {"z", "z position", "z pos", "joint 2 pos fb", "joint 2 motor pos fb", "axis z pos fb"},
}};

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const auto end = std::min(text.find(' '), text.size());
        if (end > 0) {
            words.push_back(text.substr(0, end));
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

std::string joined(const std::vector<std::string_view>& words, std::size_t first, std::size_t last) {
    std::string out;
    for (std::size_t i = first; i < last; ++i) {
        out += (out.empty() ? "" : " ");
        out += words[i];
    }
    return out;
}

}  // namespace

std::string normalised(std::string_view text) {
    std::string out;
    text = trimmedCell(text);
    for (std::size_t i = 0; i < text.size();) {
        const auto rest = text.substr(i);
        const auto known =
            std::ranges::find_if(kSpellings, [&](const Spelling& s) { return rest.starts_with(s.first); });
        if (known != kSpellings.end()) {
            out += known->second;
            i += known->first.size();
            continue;
        }
        const char c = text[i++];
        const bool blank = std::string_view(" _.\t[](){}\"',;:=").find(c) != std::string_view::npos;
        const bool dash = c == '-' && !(i < text.size() && text[i] == '1');  // min-1 is a unit
        out += blank || dash ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    }
    const auto words = wordsOf(out);
    return joined(words, 0, words.size());
}

ColumnName columnName(std::string_view text) {
    ColumnName name;
    name.whole = normalised(text);
    for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
        const auto begin = text.rfind(open);
        const auto end = begin == std::string_view::npos ? begin : text.find(close, begin);
        if (end != std::string_view::npos) {
            std::string unit = normalised(text.substr(begin + 1, end - begin - 1));
            if (isUnit(unit)) {
                name.base = normalised(std::string(text.substr(0, begin)) + ' ' + std::string(text.substr(end + 1)));
                name.unit = std::move(unit);
                name.bracketed = true;
                return name;
            }
        }
    }
    const auto words = wordsOf(name.whole);
    for (std::size_t length = std::min<std::size_t>(3, words.size() > 0 ? words.size() - 1 : 0); length > 0; --length) {
        std::string unit = joined(words, words.size() - length, words.size());
        if (isUnit(unit)) {
            std::size_t kept = words.size() - length;
            if (kept > 1 && (words[kept - 1] == "per" || words[kept - 1] == "in")) {
                --kept;  // "Diameter / mm" and "Diameter in mm"
            }
            name.base = joined(words, 0, kept);
            name.unit = std::move(unit);
            return name;
        }
    }
    name.base = name.whole;
    return name;
}

bool sameThing(std::string_view base, std::string_view other) {
    return std::ranges::any_of(kSameThings, [&](const auto& words) {
        return !base.empty() && !other.empty() && std::ranges::find(words, base) != words.end() &&
               std::ranges::find(words, other) != words.end();
    });
}

}  // namespace kerf::files
