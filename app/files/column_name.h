// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// Names of columns as people and loggers spell them.
namespace kerf::files {

struct ColumnName {
    std::string whole{};    ///< normalised: "feed mm per rev" of "feed [mm/rev]" as of "Feed_mm_per_rev"
    std::string base{};     ///< without the unit: "feed"
    std::string unit{};     ///< normalised, empty when none is declared: "mm per rev"
    bool bracketed{false};  ///< the unit stood in brackets: it is one for certain
};

/// Lower case; blanks for _ - . and brackets; "per" for /; degc for °C, um for µm.
[[nodiscard]] std::string normalised(std::string_view text);
[[nodiscard]] ColumnName columnName(std::string_view text);
/// Both are words for the same thing: t and time, part and number, overhang and position.
[[nodiscard]] bool sameThing(std::string_view base, std::string_view other);

}  // namespace kerf::files
