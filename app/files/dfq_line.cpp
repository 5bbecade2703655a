// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dfq_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/dfq.h"

namespace kerf::dfq {
namespace {

/// What editors and printers have made of the two separators: ¤ and ¶, or the pictures of the control characters.
constexpr std::array<std::string_view, 2> kForCharacteristics{"\xC2\xA4", "\xE2\x90\x8F"};
constexpr std::array<std::string_view, 2> kForFields{"\xC2\xB6", "\xE2\x90\x94"};

std::string replaced(std::string text, std::string_view what, char with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        text.replace(at, what.size(), 1, with);
    }
    return text;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> pieces;
    for (std::size_t begin = 0;;) {
        const auto end = text.find(at, begin);
        pieces.push_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) {
            return pieces;
        }
        begin = end + 1;
    }
}

bool isEmpty(const std::vector<std::string_view>& fields) {
    return std::ranges::all_of(fields, [](std::string_view field) { return trimmed(field).empty(); });
}

std::size_t timePlace(const std::vector<std::string_view>& fields) {
    for (std::size_t i = 2; i < std::min<std::size_t>(fields.size(), 5); ++i) {
        const std::string_view field = trimmed(fields[i]);
        if (timeOf(field) || timeOf(field, SlashDates::DayFirst)) {
            return i;
        }
    }
    return 0;
}

std::vector<std::string> repairSeparators(std::string& line) {
    std::vector<std::string> oddities;
    // Only where what follows could begin a field: such a sign may also stand in a batch's name.
    const auto follows = [&](std::size_t after) {
        return after >= line.size() || line.find_first_of("0123456789+-.#\x0F\x14 \xC2\xE2", after) == after;
    };
    const auto repair = [&](char right, const auto& wrong, const char* name) {
        if (line.find(right) != std::string::npos) {
            return;
        }
        for (const std::string_view picture : wrong) {
            bool separates = line.find(picture) != std::string::npos;
            for (auto at = line.find(picture); at != std::string::npos; at = line.find(picture, at + 1)) {
                separates = separates && follows(at + picture.size());
            }
            if (separates) {
                line = replaced(line, picture, right);
                oddities.push_back(fmt::format("a printed sign instead of {}", name));
            }
        }
    };
    repair(kBetweenCharacteristics, kForCharacteristics, "0x0F");
    repair(kBetweenFields, kForFields, "0x14");
    return oddities;
}

LineFields splitAtSeparators(std::string_view line) {
    LineFields characteristics;
    for (const std::string_view piece : split(line, kBetweenCharacteristics)) {
        characteristics.push_back(split(piece, kBetweenFields));
    }
    while (characteristics.size() > 1 && isEmpty(characteristics.back())) {
        characteristics.pop_back();  // a separator at the end of the line
    }
    return characteristics;
}

LineFields splitAtBlanks(std::string_view line, std::uint32_t characteristics) {
    std::vector<std::string_view> tokens;
    for (std::size_t begin = line.find_first_not_of(" \t;"); begin != std::string_view::npos;) {
        const auto end = std::min(line.find_first_of(" \t;", begin), line.size());
        tokens.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(" \t;", end);
    }
    std::vector<std::size_t> starts;
    for (std::size_t i = 2; i < tokens.size(); ++i) {
        if (tokens[i].size() > 7 && (timeOf(tokens[i]) || timeOf(tokens[i], SlashDates::DayFirst))) {
            starts.push_back(i - 2);
        }
    }
    if (starts.empty() && tokens.size() == characteristics) {
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            starts.push_back(i);
        }
    }
    LineFields fields;
    if (starts.empty() || starts.front() != 0) {
        return fields;
    }
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : tokens.size();
        fields.emplace_back(tokens.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                            tokens.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return fields;
}

}  // namespace kerf::dfq
