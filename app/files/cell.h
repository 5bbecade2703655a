// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// What one field of a table says.
namespace kerf::files {

enum class CellKind : std::uint8_t {
    Number,
    Missing,    ///< empty, or a mark for "no value" of some program or logger
    OverRange,  ///< a mark or number that says the signal was beyond the range: OL, 9.9E+37
    Text
};

/// Which decimal marks a number was written with.
enum class Marks : std::uint8_t {
    None,            ///< 40, 1E3
    Point,           ///< 49.95
    Comma,           ///< 49,95
    PointMaybe,      ///< 49.951: a point, or thousands
    CommaMaybe,      ///< 49,951: a comma, or thousands
    PointThousands,  ///< 1,234.5
    CommaThousands   ///< 1.234,5
};

struct Cell {
    CellKind kind{CellKind::Text};
    double value{0.0};  ///< of a Number, read with its own mark as the decimal mark
    Marks marks{Marks::None};
};

/// 0 to 9, whatever the locale.
[[nodiscard]] constexpr bool isDigit(char c) noexcept {
    return c >= '0' && c <= '9';
}

/// `decimal`: '.' or ',' when it is known; the other one is then thousands. 0: as written.
[[nodiscard]] Cell readCell(std::string_view text, char decimal = 0) noexcept;

/// Without blanks, no-break spaces and tabs on either side.
[[nodiscard]] std::string_view trimmedCell(std::string_view text) noexcept;

/// A unit a column may be declared in, as a factor on the unit that is asked for.
struct UnitChange {
    double factor{1.0};
    double offset{0.0};  ///< wanted = factor · found + offset
};
/// Normalised spellings ("mm per rev", "degc", "s"). Empty when one of them is no unit, or they measure different
/// things.
[[nodiscard]] std::optional<UnitChange> unitChange(std::string_view found, std::string_view wanted) noexcept;
[[nodiscard]] bool isUnit(std::string_view normalised) noexcept;
[[nodiscard]] bool isTemperatureUnit(std::string_view normalised) noexcept;

}  // namespace kerf::files
