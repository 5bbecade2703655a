// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/temperature_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/process/thermal/history.h"

namespace kerf::files {
namespace {

constexpr std::size_t kLeastRows = 10;  ///< fewer say nothing about behaviour
constexpr double kEven = 0.01;          ///< of the step: a clock is at least this even
constexpr double kJump_K = 10.0;        ///< between two rows
constexpr std::size_t kManyJumps = 3;
constexpr double kStep_K = 15.0;
constexpr double kStepShare = 0.5;
constexpr double kCounted = 10.0;
constexpr std::array<std::string_view, 16> kOtherThings{
    "load", "count", "counter", "clock", "power", "torque", "current",    "percent",
    "pct",  "%",     "alarm",   "state", "index", "row",    "auslastung", "\xEB\xB6\x80\xED\x95\x98"};

std::vector<double> numbersOf(const Table& table, std::size_t column) {
    std::vector<double> out;
    for (const auto& value : table.columnWithGaps(column, "")) {
        if (value) out.push_back(*value);
    }
    return out;
}

bool inRange(double value) {
    return value >= thermal::kLowestTemp_degC && value <= thermal::kHighestTemp_degC;
}

bool isWordFor(const std::string& name, std::string_view thing) {
    const std::string padded = ' ' + name + ' ';
    return padded.find(' ' + std::string(thing) + ' ') != std::string::npos ||
           (thing == "%" && name.find('%') != std::string::npos);
}

/// Why the numbers are no temperature; empty when they may be one.
std::string whyNot(const std::vector<double>& values) {
    if (values.size() < kLeastRows) {
        return {};
    }
    const auto outside = static_cast<std::size_t>(std::ranges::count_if(values, [](double v) { return !inRange(v); }));
    if (2 * outside > values.size()) {
        return fmt::format("is beyond {:g} to {:g} for most of the day", thermal::kLowestTemp_degC,
                           thermal::kHighestTemp_degC);
    }
    const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
    bool even = step != 0.0;
    bool whole = true;
    bool rising = true;
    std::size_t jumps = 0;
    double largest = 0.0;
    double low = values[0];
    double high = values[0];
    for (std::size_t k = 0; k < values.size(); ++k) {
        whole = whole && values[k] == std::floor(values[k]);
        if (inRange(values[k])) {
            low = std::min(inRange(low) ? low : values[k], values[k]);
            high = std::max(inRange(high) ? high : values[k], values[k]);
        }
        if (k == 0) {
            continue;
        }
        const double change = values[k] - values[k - 1];
        even = even && std::abs(change - step) <= kEven * std::abs(step);
        rising = rising && change >= 0.0;
        if (inRange(values[k]) && inRange(values[k - 1])) {
            jumps += std::abs(change) >= kJump_K ? 1U : 0U;
            largest = std::max(largest, std::abs(change));
        }
    }
    if (even) {
        return "moves by the same step in every row, like a counter or a clock";
    }
    if (whole && rising && values.front() == 0.0 && values.back() >= kCounted) {
        return "counts up in whole numbers from 0";
    }
    if (jumps >= kManyJumps || (largest >= kStep_K && largest >= kStepShare * (high - low))) {
        return fmt::format("jumps by up to {:.3g} from row to row, which no machine's temperature does", largest);
    }
    return {};
}

bool looksLikeKelvin(const std::vector<double>& values) {
    if (values.size() < kLeastRows) return false;
    const auto [low, high] = std::ranges::minmax(values);
    return low > 233.0 && high < 423.0 && high - low < 120.0;
}

}  // namespace

TemperatureColumns temperatureColumns(const Table& table, const std::vector<std::size_t>& known,
                                      const std::vector<std::size_t>& wanted) {
    TemperatureColumns out;
    std::size_t kelvin = 0;
    std::optional<std::size_t> firstKelvin;
    for (std::size_t i = 0; i < table.names().size(); ++i) {
        if (table.names()[i].empty() || std::ranges::find(known, i) != known.end()) {
            continue;
        }
        if (std::ranges::find(wanted, i) != wanted.end()) {
            out.columns.push_back(i);
            continue;
        }
        const ColumnName& name = table.nameOf(i);
        if (isTemperatureUnit(name.unit) && (name.bracketed || name.unit.size() > 1)) {
            out.columns.push_back(i);
            continue;
        }
        const bool certain = name.bracketed || (name.unit.size() > 1 && name.unit != "in");
        if (!name.unit.empty() && certain) {
            out.leftOut.push_back({i, fmt::format("is in {}", name.unit)});
            continue;
        }
        const auto thing = std::ranges::find_if(kOtherThings, [&](auto word) { return isWordFor(name.whole, word); });
        if (thing != kOtherThings.end()) {
            out.leftOut.push_back({i, "is no temperature by its name"});
            continue;
        }
        const std::vector<double> values = numbersOf(table, i);
        if (table.isText(i) && values.empty()) {
            out.leftOut.push_back({i, "is words"});
            continue;
        }
        if (std::string why = whyNot(values); !why.empty()) {
            if (looksLikeKelvin(values)) {
                ++kelvin;
                firstKelvin = firstKelvin.value_or(i);
            }
            out.leftOut.push_back({i, std::move(why)});
            continue;
        }
        out.columns.push_back(i);
    }
    if (kelvin > 0 && 2 * kelvin >= out.columns.size() + kelvin) {
        throw BadInput(fmt::format("{}looks like kelvin; expected degC, or the unit in the name, as T1 [K].",
                                   table.where(0, table.names()[*firstKelvin])));
    }
    return out;
}

}  // namespace kerf::files
