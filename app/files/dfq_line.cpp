// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dfq_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/dfq.h"

namespace kerf::dfq {
namespace {

/// What editors, printers, mails and markup have made of the two separators: ¤ and ¶, the pictures of the control
/// characters, ^O and ^T, their names and numbers.
constexpr std::array<std::string_view, 8> kForCharacteristics{"\xC2\xA4", "\xE2\x90\x8F", "^O",    "<SI>",
                                                              "[SI]",     "\\x0F",        "&#15;", "&#x0F;"};
constexpr std::array<std::string_view, 8> kForFields{"\xC2\xB6", "\xE2\x90\x94", "^T",    "<DC4>",
                                                     "[DC4]",    "\\x14",        "&#20;", "&#x14;"};

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
        return after >= line.size() || line.find_first_of("0123456789+-.#\x0F\x14 \xC2\xE2^<[\\&", after) == after;
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

bool holdsPicture(std::string_view text) {
    const auto in = [text](std::string_view picture) { return text.find(picture) != std::string_view::npos; };
    return std::ranges::any_of(kForCharacteristics, in) || std::ranges::any_of(kForFields, in);
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

namespace {

LineFields splitAtAny(std::string_view line, std::string_view signs, std::uint32_t characteristics) {
    std::vector<std::string_view> tokens;
    for (std::size_t begin = line.find_first_not_of(signs); begin != std::string_view::npos;) {
        const auto end = std::min(line.find_first_of(signs, begin), line.size());
        tokens.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(signs, end);
    }
    std::vector<std::size_t> starts;
    for (std::size_t i = 2; i < tokens.size(); ++i) {
        if (tokens[i].size() > 7 && (timeOf(tokens[i]) || timeOf(tokens[i], SlashDates::DayFirst))) {
            starts.push_back(i - 2);
        }
    }
    const auto isNumber = [](std::string_view token) { return numberOf(token).has_value(); };
    if (starts.empty() && tokens.size() == characteristics && std::ranges::all_of(tokens, isNumber)) {
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

}  // namespace

LineFields splitAtBlanks(std::string_view line, std::uint32_t characteristics) {
    for (const std::string_view signs : {" \t;", "|", ","}) {
        LineFields fields = splitAtAny(line, signs, characteristics);
        // Between commas events would come apart: only what ends with the time is sure.
        const bool sure = signs != "," || std::ranges::all_of(fields, [](const auto& one) { return one.size() <= 3; });
        if (!fields.empty() && sure) {
            return fields;
        }
    }
    return {};
}

}  // namespace kerf::dfq
