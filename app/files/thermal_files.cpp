// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/thermal_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "app/files/slip.h"
#include "app/files/temperature_columns.h"
#include "app/files/thermal_model_json.h"

namespace kerf::headless {
namespace {

using files::CellKind;
using files::utf8Of;

constexpr std::array<const char*, 3> kMeasured{"yx_meas", "yy_meas", "yz_meas"};
constexpr std::array<const char*, 3> kTrue{"yx_true", "yy_true", "yz_true"};
constexpr double kLongestDay_min = 2880.0;                             ///< longer is a day in seconds
constexpr double kCoarsest_min = 30.0;                                 ///< between rows; coarser is a row a minute in s
constexpr double kWarmestShop_degC = 50.0;                             ///< at the baseline; above: degrees Fahrenheit
constexpr double kShortestDay_min = 30.0;                              ///< of many rows: a day in hours is shorter
constexpr double kLongestDay_d = 2.0;                                  ///< shorter still: a day in days
constexpr double kDayRows = 30;                                        ///< "many"
constexpr double kColdestDecade_degC = 0.5;                            ///< a tenth of a shop's 5 degC …
constexpr double kDecadeShop_degC = 5.0;                               ///< … to 50, the machine at rest …
constexpr double kDecadeHigh_degC = 15.0;                              ///< … and a tenth of a bearing's 150
constexpr std::size_t kLikeSensors = 4;                                ///< of which one can be told from the others
constexpr double kLikeStart = 0.15;                                    ///< at rest they begin alike, as a share
constexpr Eigen::Index kBridged = 2;                                   ///< rows in a row
constexpr std::size_t kFewWords = 20;                                  ///< numbers to one word that is a mark
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();  ///< inside a matrix of drifts only

std::string leaf(const std::string& path) {
    return utf8Of(std::filesystem::path(path).filename().string());
}

/// Three columns, or none at all; that of an axis without a single value is 0 and not `present`. A cell without a value
/// stays without one.
Eigen::MatrixXd threeColumns(const Table& table, const std::array<const char*, 3>& names,
                             std::array<bool, 3>& present) {
    Eigen::MatrixXd out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        present[axis] = false;
        if (table.has(names[axis])) {
            const auto column = table.columnWithGaps(names[axis]);
            present[axis] = std::ranges::any_of(column, [](const auto& value) { return value.has_value(); });
        }
    }
    if (std::ranges::none_of(present, [](bool there) { return there; })) {
        present = {true, true, true};
        return out;
    }
    out.setZero(static_cast<Eigen::Index>(table.rows()), 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!present[axis]) {
            continue;
        }
        const auto column = table.columnWithGaps(names[axis]);
        for (std::size_t row = 0; row < column.size(); ++row) {
            out(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(axis)) = column[row].value_or(kNoValue);
        }
    }
    return out;
}

/// The speed of every minute; in a prediction a missing one is the one before.
std::vector<double> speeds(const Table& table, HistoryUse use) {
    if (use == HistoryUse::Training || !table.hasGaps("rpm")) {
        table.requireRange("rpm", -100'000.0, 100'000.0);
        return table.column("rpm");
    }
    std::vector<double> out;
    std::size_t missing = 0;
    for (const auto& value : table.columnWithGaps("rpm")) {
        if (!value && out.empty()) {
            throw BadInput(fmt::format("{}no value; expected a speed in the first row.", table.where(0, "rpm")));
        }
        missing += value ? 0U : 1U;
        out.push_back(value.value_or(out.empty() ? 0.0 : out.back()));
        if (std::abs(out.back()) > 100'000.0) {
            throw BadInput(fmt::format("{}{} is out of range; expected -100000 to 100000.",
                                       table.where(out.size() - 1, "rpm"), out.back()));
        }
    }
    table.note(fmt::format("{}: column rpm: {} values missing; the speed before holds.", table.file(), missing));
    return out;
}

/// What the numbers of a thermocouple outside its range mean.
const char* faultOf(double value) {
    return value > thermal::kHighestTemp_degC ? "open" : "short";
}

bool usable(const std::optional<double>& value) {
    return value && *value >= thermal::kLowestTemp_degC && *value <= thermal::kHighestTemp_degC;
}

/// Says how many readings of a column are missing, and what stands for the first of them.
void tellGaps(const Table& table, std::size_t column, const std::vector<std::optional<double>>& values,
              std::size_t bridged) {
    const auto count =
        static_cast<std::size_t>(std::ranges::count_if(values, [](const auto& value) { return !usable(value); }));
    if (count == 0) {
        return;
    }
    const auto at = static_cast<std::size_t>(
        std::ranges::find_if(values, [](const auto& value) { return !usable(value); }) - values.begin());
    const std::string told = table.cellText(at, column);
    std::string why = "no value, as of an open thermocouple";
    if (values[at]) {
        why = fmt::format("beyond the range of a thermocouple: {}", faultOf(*values[at]));
    } else if (table.kind(at, column) == CellKind::OverRange) {
        why = told.starts_with('-') ? "beyond the range: short" : "beyond the range: open";
    }
    table.note(fmt::format("{}'{}' is {}; {} missing{}.", table.where(at, table.names()[column]), told, why,
                           count == 1 ? std::string("one reading") : fmt::format("{} readings", count),
                           bridged == 0       ? ""
                           : bridged == count ? ", the one before holds"
                                              : ", short gaps hold the one before"));
}

/// One temperature column, its gaps told and the short ones bridged.
void takeSensor(const Table& table, std::size_t column, HistoryUse use, thermal::ThermalHistory& history,
                Eigen::Index s) {
    const auto values = table.columnWithGaps(column, "degc");
    const Eigen::Index rows = history.rows();
    std::size_t bridged = 0;
    const auto good = [&](Eigen::Index row) { return usable(values[static_cast<std::size_t>(row)]); };
    for (Eigen::Index row = 0; row < rows; ++row) {
        const auto k = static_cast<std::size_t>(row);
        const bool word = table.kind(k, column) == CellKind::Text;  // among numbers: some logger's mark, one reading
        if (word && (use == HistoryUse::Training || table.texts(column) * kFewWords > table.rows())) {
            throw BadInput(fmt::format("{}'{}' is not a number; expected a temperature.",
                                       table.where(k, table.names()[column]), table.cellText(k, column)));
        }
        if (values[k]) {
            history.temp_degC(row, s) = *values[k];
            history.present(row, s) = true;
        }
        if (good(row) || use == HistoryUse::Training) {
            continue;
        }
        Eigen::Index before = row;
        while (before > 0 && row - before <= kBridged && !good(before))
            --before;
        Eigen::Index after = row;
        while (after + 1 < rows && after - before <= kBridged && !good(after))
            ++after;
        if (good(before) && after - before <= kBridged + 1 && good(after)) {
            history.temp_degC(row, s) = *values[static_cast<std::size_t>(before)];
            history.present(row, s) = true;
            ++bridged;
        }
    }
    if (use == HistoryUse::Prediction) {
        tellGaps(table, column, values, bridged);
    }
}

/// Lowest and highest of what a thermocouple can read, and the first of all it says; nothing when it never reads.
struct Span {
    double low{0.0}, high{0.0}, start{0.0};
};

std::optional<Span> spanOf(const thermal::ThermalHistory& history, Eigen::Index sensor) {
    std::optional<Span> span;
    const Eigen::Index baseline = std::max<Eigen::Index>(1, history.baselineRows());
    double sum = 0.0;
    int count = 0;
    for (Eigen::Index row = 0; row < history.rows(); ++row) {
        const double value = history.temp_degC(row, sensor);
        if (!history.present(row, sensor)) {
            continue;
        }
        if (!span) {
            span = Span{value, value, value};
        }
        if (usable(value)) {
            span->low = usable(span->low) ? std::min(span->low, value) : value;
            span->high = usable(span->high) ? std::max(span->high, value) : value;
        }
        if (row < baseline) {
            sum += value;
            ++count;
        }
    }
    if (span && count > 0) {
        span->start = sum / count;
    }
    return span;
}

/// Minutes: what training refuses, prediction refuses.
void requireMinutes(const Table& table, const thermal::ThermalHistory& history, const std::vector<Span>& spans,
                    const HistoryOptions& options) {
    const bool accepted = options.read.acceptImplausible;
    const double span_min = history.time_min.empty() ? 0.0 : history.time_min.back() - history.time_min.front();
    if (span_min > kLongestDay_min) {
        files::refuseUnless(
            accepted, table,
            fmt::format(
                "{}{} min is longer than two days; expected minutes, not seconds (or the unit in the name, as t [s]).",
                table.where(history.time_min.size() - 1, "t_min"), span_min));
    }
    const auto rows = static_cast<double>(history.time_min.size());
    if (const double apart_min = span_min / std::max(1.0, rows - 1.0); rows > 2 && apart_min >= kCoarsest_min) {
        files::refuseUnless(accepted, table,
                            fmt::format("{}the rows are {:.3g} min apart; expected minutes, not seconds.",
                                        table.where(1, "t_min"), apart_min));
    }
    double rise_K = 0.0;
    for (const Span& span : spans) {
        rise_K = std::max(rise_K, span.high - span.low);
    }
    // A machine takes hours to warm: a day is no quarter of an hour. A quiet day in hours cannot be told from a record
    // with a row a second, so whoever has one says so.
    if (rows >= kDayRows && span_min > 0.0 && span_min < kShortestDay_min) {
        files::refuseUnless(
            accepted, table,
            fmt::format(
                "{}{} rows last {:.3g} min, in which the machine changes by {:.1f} K; expected minutes, not {}.",
                table.where(history.time_min.size() - 1, "t_min"), history.time_min.size(), span_min, rise_K,
                span_min > kLongestDay_d ? "hours" : "days"));
    }
}

/// Degrees Celsius, and none a decade low.
void requireCelsius(const Table& table, const thermal::ThermalHistory& history, const std::vector<Span>& spans,
                    bool accepted) {
    if (spans.empty()) {
        return;
    }
    std::vector<double> starts;
    double high = spans.front().high;
    for (const Span& span : spans) {
        starts.push_back(span.start);
        high = std::max(high, span.high);
    }
    const auto middle = starts.begin() + static_cast<std::ptrdiff_t>(starts.size() / 2);
    std::ranges::nth_element(starts, middle);
    if (*middle > kWarmestShop_degC) {
        files::refuseUnless(
            accepted, table,
            fmt::format("{}baseline of {:.1f} looks like {}; expected degC.", table.where(0, history.sensors.front()),
                        *middle, *middle > 200.0 ? "kelvin" : "degrees Fahrenheit"));
    }
    if (*middle > kColdestDecade_degC && *middle < kDecadeShop_degC && high < kDecadeHigh_degC) {
        files::refuseUnless(accepted, table,
                            fmt::format("{}baseline of {:.2f}, and nothing is warmer than {:.1f}; expected degC of a "
                                        "shop, a digit too few?",
                                        table.where(0, history.sensors.front()), *middle, high));
    }
}

/// One sensor that stands where the others would with a digit less, or in degrees Fahrenheit, the machine at rest.
void requireSameDecade(const Table& table, const thermal::ThermalHistory& history, bool accepted) {
    std::vector<std::pair<Eigen::Index, double>> starts;
    std::vector<double> sorted;
    for (Eigen::Index s = 0; s < history.temp_degC.cols(); ++s) {
        if (const auto span = spanOf(history, s)) {
            starts.emplace_back(s, span->start);
            sorted.push_back(span->start);
        }
    }
    if (starts.size() < kLikeSensors) {
        return;
    }
    std::ranges::sort(sorted);
    const double middle = sorted[sorted.size() / 2];
    for (const auto& [sensor, start] : starts) {
        if (middle > kDecadeShop_degC && std::abs(10.0 * start - middle) < kLikeStart * middle) {
            files::refuseUnless(
                accepted, table,
                fmt::format("{}begins at {:.2f} where the others begin at {:.1f}; a digit too few?",
                            table.where(0, history.sensors[static_cast<std::size_t>(sensor)]), start, middle));
        }
        if (start > kWarmestShop_degC && std::abs((start - 32.0) / 1.8 - middle) < kLikeStart * middle) {
            files::refuseUnless(
                accepted, table,
                fmt::format("{}baseline of {:.1f} looks like degrees Fahrenheit where the others begin at {:.1f}; "
                            "expected degC.",
                            table.where(0, history.sensors[static_cast<std::size_t>(sensor)]), start, middle));
        }
    }
}

void requireUnits(const Table& table, const thermal::ThermalHistory& history, const HistoryOptions& options) {
    std::vector<Span> spans;
    for (Eigen::Index s = 0; s < history.temp_degC.cols() && history.rows() > 0; ++s) {
        if (const auto span = spanOf(history, s)) {
            spans.push_back(*span);
        }
    }
    requireMinutes(table, history, spans, options);
    requireCelsius(table, history, spans, options.read.acceptImplausible);
    requireSameDecade(table, history, options.read.acceptImplausible);
}

std::vector<std::size_t> knownColumns(const Table& table) {
    std::vector<std::size_t> known;
    for (const char* name : {"t_min", "rpm"}) {
        if (const auto i = table.find(name)) known.push_back(*i);
    }
    for (std::size_t i = 0; i < table.names().size(); ++i) {
        const std::string& whole = table.nameOf(i).whole;
        if (whole.ends_with(" true") || whole.ends_with(" meas")) known.push_back(i);
    }
    return known;
}

struct Sensors {
    std::vector<std::size_t> columns{};
    std::vector<std::string> names{};
};

/// Thermocouples the model does without cost nothing, but a person wants to know of them.
void tellOthers(const Table& table, const std::vector<std::size_t>& taken) {
    try {
        for (const std::size_t i : files::temperatureColumns(table, knownColumns(table), taken).columns) {
            if (std::ranges::find(taken, i) == taken.end()) {
                tellGaps(table, i, table.columnWithGaps(i, "degc"), 0);
            }
        }
    } catch (const BadInput&) {  // whatever is wrong there is nobody's business here
    }
}

Sensors chooseSensors(const Table& table, const HistoryOptions& options) {
    Sensors out;
    for (const std::string& name : options.sensors) {
        if (const auto i = table.find(name)) {
            out.columns.push_back(*i);
            out.names.push_back(name);
        }
    }
    if (options.onlySensors) {
        return out;
    }
    const auto found = files::temperatureColumns(table, knownColumns(table), out.columns);
    for (const std::size_t i : found.columns) {
        if (std::ranges::find(out.columns, i) == out.columns.end()) {
            out.columns.push_back(i);
            out.names.push_back(table.names()[i]);
        }
    }
    for (const auto& one : found.leftOut) {
        table.note(fmt::format("{}: column '{}' {}; left out.", table.file(), table.names()[one.column], one.why));
    }
    return out;
}

/// A logger counts from its first row, or writes the time of day: what is at rest before the spindle first turns is the
/// baseline.
void setTimeZero(const Table& table, double rest_min, thermal::ThermalHistory& history) {
    std::vector<double>& time_min = history.time_min;
    if (time_min.empty() || time_min.front() < 0.0) {
        if (rest_min > 0.0 && !time_min.empty()) {
            throw BadInput(
                fmt::format("{}{} is before time 0 already; --rest-min is for a clock that counts from its "
                            "first row.",
                            table.where(0, "t_min"), time_min.front()));
        }
        return;
    }
    std::size_t first = 0;
    if (rest_min > 0.0) {
        while (first < time_min.size() && time_min[first] < time_min.front() + rest_min)
            ++first;
    } else {
        const auto& speed_rpm = history.speed_rpm;
        const auto turns = std::ranges::find_if(speed_rpm, [](double rpm) { return rpm != 0.0; });
        first = static_cast<std::size_t>(turns - speed_rpm.begin());
        if (first > 1 && turns != speed_rpm.end()) --first;  // it began between the last row at rest and this one
    }
    if (first == 0 || first >= time_min.size()) {
        const bool stood = rest_min > 0.0 || !history.speed_rpm.empty();
        const char* why = !stood ? "no row is before time 0, and there is no column rpm to show when the machine began"
                          : first == 0 ? "no row is before time 0, and the spindle turns from the first row on"
                                       : "the machine stands to the last row";
        throw BadInput(
            fmt::format("{}{}; expected rows of the machine at rest: t_min < 0, or --rest-min with the "
                        "minutes it stood at the beginning.",
                        table.where(0, "t_min"), why));
    }
    const double zero_min = time_min[first];
    for (double& time : time_min) {
        time -= zero_min;
    }
    table.note(fmt::format("{}: no row before time 0; the first {} are the machine at rest, time 0 is line {}{}.",
                           table.file(), first == 1 ? std::string("row") : fmt::format("{} rows", first),
                           table.lineOf(first), rest_min > 0.0 ? "" : ", where the spindle begins to turn"));
}

}  // namespace

HistoryFile readHistoryFile(const std::string& path, const HistoryOptions& options) {
    return historyOf(Table::read(path, options.read), path, options);
}

HistoryFile historyOf(Table table, const std::string& path, const HistoryOptions& options) {
    if (options.use == HistoryUse::Prediction) {
        table.dropRowsWithGaps({"t_min"});
    }
    HistoryFile file;
    thermal::ThermalHistory& history = file.history;
    history.label = leaf(path);
    history.time_min = table.column("t_min");
    if (table.has("rpm")) {
        history.speed_rpm = speeds(table, options.use);
    }
    setTimeZero(table, options.rest_min, history);
    Sensors sensors = chooseSensors(table, options);
    history.sensors = std::move(sensors.names);
    const auto rows = static_cast<Eigen::Index>(table.rows());
    const auto count = static_cast<Eigen::Index>(history.sensors.size());
    history.temp_degC = Eigen::MatrixXd::Zero(rows, count);
    history.present = thermal::PresentMask::Constant(rows, count, false);
    for (Eigen::Index s = 0; s < count; ++s) {
        takeSensor(table, sensors.columns[static_cast<std::size_t>(s)], options.use, history, s);
    }
    if (options.use == HistoryUse::Prediction && options.onlySensors) {
        tellOthers(table, sensors.columns);
    }
    history.drift_um = threeColumns(table, kMeasured, history.axes);
    std::array<bool, 3> known{};
    history.trueDrift_um = threeColumns(table, kTrue, known);
    if (history.drift_um.size() == 0) {
        history.axes = known;
    }
    const bool training = options.use == HistoryUse::Training;
    const auto fault = training ? thermal::whyNotTrainable(history) : thermal::whyNotUsable(history);
    if (fault) {
        if (table.rows() == 0) {
            throw BadInput(fmt::format("{}, line 1: {}", utf8Of(path), fault->reason.english()));
        }
        std::string cell;
        const auto row = static_cast<std::size_t>(fault->row);
        if (const auto column = table.find(fault->column); column && table.kind(row, *column) != CellKind::Number) {
            const std::string text = table.cellText(row, *column);
            cell = text.empty() ? "" : fmt::format("'{}': ", text);
        }
        throw BadInput(table.where(row, fault->column) + cell + fault->reason.english());
    }
    requireUnits(table, history, options);
    file.notes = table.notes();
    return file;
}

thermal::ThermalHistory readThermalHistory(const std::string& path, HistoryUse use) {
    return readHistoryFile(path, {use, {}, false, {}, 0.0}).history;
}

std::vector<thermal::ThermalHistory> readThermalHistories(const std::vector<std::string>& paths,
                                                          const ReadOptions& read, std::vector<std::string>* notes,
                                                          double rest_min) {
    std::vector<thermal::ThermalHistory> days;
    for (const std::string& path : paths) {
        HistoryOptions options{HistoryUse::Training, {}, false, read, rest_min};
        if (!days.empty()) {
            options.sensors = days.front().sensors;
            options.onlySensors = true;
        }
        HistoryFile file = readHistoryFile(path, options);
        days.push_back(std::move(file.history));
        if (notes != nullptr) {
            notes->insert(notes->end(), file.notes.begin(), file.notes.end());
        }
        const auto& first = days.front().sensors;
        const auto& own = days.back().sensors;
        for (const std::string& name : first) {
            if (std::ranges::find(own, name) == own.end()) {
                throw BadInput(
                    fmt::format("{}, line 1: column {} is missing; expected it as in {}; train with days of "
                                "one machine.",
                                utf8Of(path), name, utf8Of(paths.front())));
            }
        }
    }
    return days;
}

thermal::ThermalModel readThermalModel(const std::string& path) {
    auto model = formats::thermalModelFromJson(readFile(path));
    if (!model) {
        throw BadInput(fmt::format("{}: {}", utf8Of(path), model.error().english()));
    }
    return std::move(*model);
}

void requireMicrometres(const thermal::ThermalHistory& history, const std::string& path) {
    constexpr double kSmallest_um = 0.5;
    constexpr double kLargest_um = 5000.0;
    const bool measured = history.drift_um.size() > 0;
    const Eigen::MatrixXd& drift = measured ? history.drift_um : history.trueDrift_um;
    double largest_um = 0.0;
    for (Eigen::Index row = history.baselineRows(); row < drift.rows(); ++row) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            if (std::isfinite(drift(row, axis))) largest_um = std::max(largest_um, std::abs(drift(row, axis)));
        }
    }
    double rise_K = 0.0;
    for (Eigen::Index s = 0; s < history.temp_degC.cols(); ++s) {
        for (Eigen::Index row = 0; row < history.rows(); ++row) {
            if (history.present(row, s) && history.present(0, s) &&
                history.temp_degC(row, s) <= thermal::kHighestTemp_degC) {
                rise_K = std::max(rise_K, history.temp_degC(row, s) - history.temp_degC(0, s));
            }
        }
    }
    if (largest_um > kLargest_um) {
        throw BadInput(fmt::format("{}, column {}: largest drift is {:.0f}; expected um, at most {:.0f}, not nm.",
                                   utf8Of(path), measured ? kMeasured[0] : kTrue[0], largest_um, kLargest_um));
    }
    if (drift.size() > 0 && largest_um < kSmallest_um && rise_K > 1.0) {
        throw BadInput(
            fmt::format("{}, column {}: largest drift is {:.4f} while the machine warms by {:.1f} K; expected "
                        "um, not mm.",
                        utf8Of(path), measured ? kMeasured[0] : kTrue[0], largest_um, rise_K));
    }
}

}  // namespace kerf::headless
