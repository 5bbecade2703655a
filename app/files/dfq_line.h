// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/cell.h"

/// A value line of a Q-DAS file taken apart: one part, characteristics and their fields.
namespace kerf::dfq {

inline constexpr char kBetweenCharacteristics = '\x0F';
inline constexpr char kBetweenFields = '\x14';
/// K fields by their place in the line; −3 has no name.
inline constexpr std::array<int, 10> kVariableOrder{1, 2, 4, 5, 6, 7, 8, 10, 11, 12};
inline constexpr std::array<int, 12> kAttributeOrder{20, 21, -3, 2, 4, 5, 6, 7, 8, 10, 11, 12};

using files::isDigit;
using LineFields = std::vector<std::vector<std::string_view>>;  ///< by characteristic

[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char at);
/// A characteristic without a single field that says something.
[[nodiscard]] bool isEmpty(const std::vector<std::string_view>& fields);
/// Index of the first field after value and attribute that is a time; 0: none.
[[nodiscard]] std::size_t timePlace(const std::vector<std::string_view>& fields);

/// Puts the separators back where an editor or printer has made visible signs of them. What was odd, for a person.
[[nodiscard]] std::vector<std::string> repairSeparators(std::string& line);
/// A sign that repairSeparators() would take for a separator.
[[nodiscard]] bool holdsPicture(std::string_view text);
/// Fields between the right separators.
[[nodiscard]] LineFields splitAtSeparators(std::string_view line);
/// Blanks, tabs, semicolons, bars or commas between everything: a characteristic begins two places before each time, or
/// every token is a value when there are as many as characteristics. Empty: neither.
[[nodiscard]] LineFields splitAtBlanks(std::string_view line, std::uint32_t characteristics);

}  // namespace kerf::dfq
