// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/slip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace kerf::files {
namespace {

constexpr double kInch_mm = 25.4;
constexpr std::array kSlips{Slip{kInch_mm, "inch?"},
                            Slip{1.0 / kInch_mm, "mm for inch?"},
                            Slip{10.0, "a digit too few?"},
                            Slip{0.1, "a digit too many?"},
                            Slip{1000.0, "metres?"},
                            Slip{0.001, "micrometres?"},
                            Slip{100.0, "two digits too few?"},
                            Slip{0.01, "two digits too many?"}};
constexpr std::size_t kLeast = 10;     ///< values from which their like is known
constexpr double kSpread = 0.5;        ///< of the others, as a share of their middle
constexpr double kFar = 3.0;           ///< ranges of the others a slip is away at least
constexpr double kSameStation = 1e-3;  ///< share; an inch value has a few digits only

}  // namespace

std::optional<Slip> slipTo(double value, double meant, double within) noexcept {
    for (const Slip& slip : kSlips) {
        if (std::abs(value * slip.factor - meant) < within * std::abs(meant)) {
            return slip;
        }
    }
    return std::nullopt;
}

std::optional<SlippedRow> slippedAmongItsLike(std::span<const double> values) {
    if (values.size() < kLeast) {
        return std::nullopt;
    }
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const double middle = sorted[sorted.size() / 2];
    // The like of a value: those within half the middle. One in ten may be apart.
    double low = middle, high = middle;
    std::size_t like = 0;
    for (const double value : sorted) {
        if (std::abs(value - middle) <= kSpread * std::abs(middle)) {
            low = std::min(low, value);
            high = std::max(high, value);
            ++like;
        }
    }
    if (middle == 0.0 || like * 10 < sorted.size() * 9 || high - low > kSpread * std::abs(middle)) {
        return std::nullopt;
    }
    const double range = std::max(high - low, 1e-6 * std::abs(middle));
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (values[row] >= low - kFar * range && values[row] <= high + kFar * range) {
            continue;
        }
        for (const Slip& slip : kSlips) {
            const double meant = values[row] * slip.factor;
            if (meant >= low - range && meant <= high + range) {
                return SlippedRow{row, slip};
            }
        }
    }
    return std::nullopt;
}

std::optional<SlippedRow> slippedStation(std::span<const double> values) {
    const auto count = [&](double station) {
        return std::ranges::count_if(
            values, [&](double v) { return std::abs(v - station) <= kSameStation * std::abs(station); });
    };
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (count(values[row]) > 1) {
            continue;
        }
        for (const Slip& slip : kSlips) {
            if (count(values[row] * slip.factor) > 1) {
                return SlippedRow{row, slip};
            }
        }
    }
    return std::nullopt;
}

std::optional<Slip> slippedColumn(std::span<const double> values, double low, double high) {
    constexpr double kEdge = 0.05;  // an inch value has a few digits, and a bore may be measured a little outside
    if (values.empty()) {
        return std::nullopt;
    }
    const auto [least, most] = std::ranges::minmax(values);
    if (most >= low * (1.0 - kEdge) && least <= high * (1.0 + kEdge)) {
        return std::nullopt;
    }
    constexpr std::array kColumnSlips{Slip{kInch_mm, "inch?"}, Slip{10.0, "cm?"}, Slip{1000.0, "metres?"},
                                      Slip{0.001, "micrometres?"}, Slip{1.0 / kInch_mm, "mm for inch?"}};
    for (const Slip& slip : kColumnSlips) {
        if (least * slip.factor >= low * (1.0 - kEdge) && most * slip.factor <= high * (1.0 + kEdge)) {
            return slip;
        }
    }
    return std::nullopt;
}

void refuseUnless(bool accepted, const Table& table, const std::string& what) {
    if (!accepted) {
        throw BadInput(what + " --accept-implausible takes it all the same.");
    }
    table.note(what + " Taken, as was asked for.");
}

void askAbout(const Table& table, std::string_view column, double value, const std::optional<SlippedRow>& slipped,
              bool accepted) {
    if (!slipped) {
        return;
    }
    const std::string what = fmt::format("{}{} does not fit the other rows; {}", table.where(slipped->row, column),
                                         value, slipped->slip.guess);
    refuseUnless(accepted, table, what);
}

}  // namespace kerf::files
