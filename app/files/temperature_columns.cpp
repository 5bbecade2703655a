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
constexpr double kStraight = 0.03;          ///< of its way: a clock written with few digits, or read a little late
constexpr std::size_t kLeastReference = 3;  ///< temperatures from which the machine at rest is known
constexpr double kColdShop_degC = 5.0;
constexpr double kHotShop_degC = 50.0;
constexpr double kColder_K = 10.0;   ///< than the others at rest; chilled coolant is warmer
constexpr double kSlipShare = 0.15;  ///< a digit too few or degrees Fahrenheit, this near: asked about, not left out
constexpr std::size_t kStartRows = 5;
constexpr auto kOtherThings = std::to_array<std::string_view>({"load",
                                                               "count",
                                                               "counter",
                                                               "clock",
                                                               "power",
                                                               "torque",
                                                               "current",
                                                               "percent",
                                                               "pct",
                                                               "%",
                                                               "alarm",
                                                               "state",
                                                               "index",
                                                               "row",
                                                               "auslastung",
                                                               "humidity",
                                                               "rh",
                                                               "feuchte",
                                                               "voltage",
                                                               "battery",
                                                               "strom",
                                                               "leistung",
                                                               "drehmoment",
                                                               "elapsed",
                                                               "hours",
                                                               "stunden",
                                                               "sample",
                                                               "scan",
                                                               "energy",
                                                               "pressure",
                                                               "druck",
                                                               "vibration",
                                                               "counts",
                                                               "zaehler",
                                                               "parts",
                                                               "zeit",
                                                               "uhrzeit",
                                                               "flow",
                                                               "z\xC3\xA4hler",
                                                               "\xEB\xB6\x80\xED\x95\x98",
                                                               "\xEC\x8A\xB5\xEB\x8F\x84",
                                                               "\xEC\xA0\x84\xEB\xA5\x98",
                                                               "\xEC\xA0\x84\xEB\xA0\xA5",
                                                               "\xEC\x8B\x9C\xEA\xB0\x84"});

constexpr auto kTemperatureWords =
    std::to_array<std::string_view>({"temp", "thermo", "pt100", "rtd", "\xEC\x98\xA8\xEB\x8F\x84"});  ///< 온도

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

/// On a straight line from first to last but for the steps it is written in: a clock, an hour meter, a counter of
/// parts. A machine nears its end temperature ever more slowly: of 640 recorded columns the straightest is 20 % off.
bool isStraight(const std::vector<double>& values, bool whole) {
    const double way = values.back() - values.front();
    const double step = way / static_cast<double>(values.size() - 1);
    double furthest = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        furthest = std::max(furthest, std::abs(values[k] - values.front() - step * static_cast<double>(k)));
        largest = k > 0 ? std::max(largest, std::abs(values[k] - values[k - 1])) : 0.0;
    }
    const bool counter = whole && std::abs(way) >= kCounted && furthest <= largest + kStraight * std::abs(way);
    return way != 0.0 && (furthest <= kStraight * std::abs(way) || counter);
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
    if (isStraight(values, whole)) {
        return "moves evenly from its first to its last row, like a counter or a clock";
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

/// A column that may be a temperature.
struct Candidate {
    std::size_t column{0};
    bool certain{false};  ///< its unit says it, or it was asked for
    std::string stem{};   ///< first word without its digits: "t" of T07
    std::optional<double> start{};
    bool moves{true};
};

Candidate candidateOf(const Table& table, std::size_t column, bool certain) {
    Candidate out{column, certain, {}, {}, true};
    const std::string& name = table.nameOf(column).base;
    out.stem = name.substr(0, name.find(' '));
    std::erase_if(out.stem, [](char c) { return c >= '0' && c <= '9'; });
    std::vector<double> first;
    std::optional<double> low, high;
    for (const auto& value : table.columnWithGaps(column, certain ? "degc" : "")) {
        if (!value || !inRange(*value)) continue;
        if (first.size() < kStartRows) first.push_back(*value);
        low = std::min(low.value_or(*value), *value);
        high = std::max(high.value_or(*value), *value);
    }
    if (!first.empty()) {
        std::ranges::sort(first);
        out.start = first[first.size() / 2];
        out.moves = table.rows() < kLeastRows || *low != *high;
    }
    return out;
}

/// A load, a current, a pressure at rest: far from where the machine's temperatures begin. One of a family (T07 beside
/// T00) that a slip would put among the others is left for the question whether it slipped; so is one that stands
/// still.
void leaveOutStrangers(const Table& table, const std::vector<Candidate>& candidates, TemperatureColumns& out) {
    std::vector<double> starts;
    for (const Candidate& one : candidates) {
        if (one.start && *one.start >= kColdShop_degC && *one.start <= kHotShop_degC) starts.push_back(*one.start);
    }
    std::ranges::sort(starts);
    const auto middle = starts.size() >= kLeastReference ? std::optional(starts[starts.size() / 2]) : std::nullopt;
    const bool someMove = std::ranges::any_of(candidates, [](const Candidate& one) { return one.moves; });
    const auto isFar = [&](const Candidate& one) {
        return middle && one.start && !one.certain && (*one.start < *middle - kColder_K || *one.start > kHotShop_degC);
    };
    for (const Candidate& one : candidates) {
        const bool family = std::ranges::any_of(candidates, [&](const Candidate& other) {
            return other.column != one.column && other.stem == one.stem && !isFar(other) && other.moves;
        });
        if (!one.certain && !one.moves && someMove && !family) {
            out.leftOut.push_back({one.column, "is the same in every row"});
            continue;
        }
        if (isFar(one)) {
            const auto near = [&](double value) { return std::abs(value - *middle) < kSlipShare * *middle; };
            if (!family || (!near(10.0 * *one.start) && !near((*one.start - 32.0) / 1.8))) {
                out.leftOut.push_back(
                    {one.column, fmt::format("begins at {:.3g} where the temperatures begin at {:.1f} (a temperature "
                                             "has its unit in the name, as {} [degC])",
                                             *one.start, *middle, table.names()[one.column])});
                continue;
            }
        }
        out.columns.push_back(one.column);
    }
}

}  // namespace

TemperatureColumns temperatureColumns(const Table& table, const std::vector<std::size_t>& known,
                                      const std::vector<std::size_t>& wanted) {
    TemperatureColumns out;
    std::vector<Candidate> candidates;
    std::size_t kelvin = 0;
    std::optional<std::size_t> firstKelvin;
    for (std::size_t i = 0; i < table.names().size(); ++i) {
        if (table.names()[i].empty() || std::ranges::find(known, i) != known.end()) {
            continue;
        }
        if (std::ranges::find(wanted, i) != wanted.end()) {
            candidates.push_back(candidateOf(table, i, true));
            continue;
        }
        const ColumnName& name = table.nameOf(i);
        if (isTemperatureUnit(name.unit) && (name.bracketed || name.unit.size() > 1)) {
            candidates.push_back(candidateOf(table, i, true));
            continue;
        }
        const bool certain = name.bracketed || (name.unit.size() > 1 && name.unit != "in");
        if (!name.unit.empty() && certain) {
            out.leftOut.push_back({i, fmt::format("is in {}", name.unit)});
            continue;
        }
        const bool said = std::ranges::any_of(kTemperatureWords,
                                              [&](auto word) { return name.whole.find(word) != std::string::npos; });
        const auto thing = std::ranges::find_if(kOtherThings, [&](auto word) { return isWordFor(name.whole, word); });
        if (!said && thing != kOtherThings.end()) {
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
        candidates.push_back(candidateOf(table, i, false));
    }
    if (kelvin > 0 && 2 * kelvin >= candidates.size() + kelvin) {
        throw BadInput(fmt::format("{}looks like kelvin; expected degC, or the unit in the name, as T1 [K].",
                                   table.where(0, table.names()[*firstKelvin])));
    }
    leaveOutStrangers(table, candidates, out);
    return out;
}

}  // namespace kerf::files
