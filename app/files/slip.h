// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/files/table.h"

/// Values that cannot be meant: a decade, an inch or a metre away from their like.
namespace kerf::files {

/// Times this a value would be what was meant; `guess` says how it came about: "inch?".
struct Slip {
    double factor{1.0};
    std::string_view guess{};
};

/// What makes `value` `meant`, within `within` (a share of `meant`); nothing when no slip does.
[[nodiscard]] std::optional<Slip> slipTo(double value, double meant, double within = 0.02) noexcept;

/// The first value far from all others that a slip would put among them. Looked for only where a slip shows: ten values
/// at least, all others of one sign and within half their middle. Nothing is said of an outlier without such a reason.
struct SlippedRow {
    std::size_t row{0};
    Slip slip{};
};
[[nodiscard]] std::optional<SlippedRow> slippedAmongItsLike(std::span<const double> values);

/// The first of the values that come again and again (depths, stations) which comes once and is a slip of another.
[[nodiscard]] std::optional<SlippedRow> slippedStation(std::span<const double> values);

/// A whole column in another unit: every value lies below `low` (or every one above `high`), and one slip puts all of
/// them inside.
[[nodiscard]] std::optional<Slip> slippedColumn(std::span<const double> values, double low, double high);

/// What cannot be meant: refused, or noted when the person accepts it. `what`: a sentence with its full stop.
/// @throws headless::BadInput
void refuseUnless(bool accepted, const Table& table, const std::string& what);

/// Refuses it with its line, or notes it when the person accepts it. @throws headless::BadInput
void askAbout(const Table& table, std::string_view column, double value, const std::optional<SlippedRow>& slipped,
              bool accepted);

}  // namespace kerf::files
