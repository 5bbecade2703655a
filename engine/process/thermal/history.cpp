// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/history.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kerf::thermal {
namespace {

constexpr double kHottestBaseline_degC = 50.0;  // a shop at 50 °C is a shop in °F
constexpr double kSmallestDrift = 0.5;          // µm over a warm day; less is a drift in mm

std::optional<HistoryFault> timeFault(const ThermalHistory& h) {
    for (Eigen::Index row = 1; row < h.rows(); ++row) {
        const auto k = static_cast<std::size_t>(row);
        if (!(h.time_min[k] > h.time_min[k - 1])) {
            return HistoryFault{row, "t_min",
                                Sentence(KERF_TEXT("%1 min does not follow %2 min; expected rising time."),
                                         {h.time_min[k], 3}, {h.time_min[k - 1], 3})};
        }
    }
    if (h.baselineRows() == 0) {
        return HistoryFault{
            0, "t_min",
            Sentence(KERF_TEXT("no row before time 0; expected at least one baseline row with t_min < 0."))};
    }
    return std::nullopt;
}

std::optional<HistoryFault> gapFault(const ThermalHistory& h) {
    std::vector<double> steps;
    for (std::size_t k = 1; k < h.time_min.size(); ++k) {
        steps.push_back(h.time_min[k] - h.time_min[k - 1]);
    }
    std::vector<double> sorted = steps;
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
    const double usual_min = sorted[sorted.size() / 2];
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (steps[k] > 1.5 * usual_min) {
            return HistoryFault{static_cast<Eigen::Index>(k + 1), "t_min",
                                Sentence(KERF_TEXT("gap of %1 min; expected an even step of %2 min without gaps."),
                                         {steps[k], 3}, {usual_min, 3})};
        }
    }
    return std::nullopt;
}

std::optional<HistoryFault> temperatureFault(const ThermalHistory& h) {
    const Eigen::Index baseline = h.baselineRows();
    for (Eigen::Index s = 0; s < h.temp_degC.cols(); ++s) {
        const std::string& name = h.sensors[static_cast<std::size_t>(s)];
        for (Eigen::Index row = 0; row < h.rows(); ++row) {
            if (!h.present(row, s)) {
                return HistoryFault{row, name, Sentence(KERF_TEXT("no reading; training data must be without gaps."))};
            }
            const double value = h.temp_degC(row, s);
            if (value < kLowestTemp_degC || value > kHighestTemp_degC) {
                return HistoryFault{row, name,
                                    Sentence(KERF_TEXT("%1 is out of range; expected %2 to %3 degC."), {value, 3},
                                             {kLowestTemp_degC, 0}, {kHighestTemp_degC, 0})};
            }
        }
        const auto column = h.temp_degC.col(s);
        if (column.maxCoeff() == column.minCoeff()) {
            return HistoryFault{
                0, name,
                Sentence(
                    KERF_TEXT("constant at %1 in every row; expected a temperature that moves. Leave the column out."),
                    {column[0], 3})};
        }
        const double start_degC = column.head(baseline).mean();
        if (start_degC > kHottestBaseline_degC) {
            return HistoryFault{
                0, name,
                Sentence(KERF_TEXT("baseline of %1 looks like degrees Fahrenheit; expected degC."), {start_degC, 1})};
        }
    }
    return std::nullopt;
}

std::optional<HistoryFault> driftFault(const ThermalHistory& h) {
    static const std::array<const char*, 3> names{"yx_meas", "yy_meas", "yz_meas"};
    if (h.drift_um.cols() != 3 || std::ranges::none_of(h.axes, [](bool axis) { return axis; })) {
        return HistoryFault{
            0, "yx_meas",
            Sentence(KERF_TEXT("no measured drift; training needs at least one of yx_meas, yy_meas and yz_meas."))};
    }
    const Eigen::Index first = h.baselineRows();
    double largest_um = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        for (Eigen::Index row = first; row < h.rows(); ++row) {
            const double value = h.drift_um(row, axis);
            if (!std::isfinite(value) || std::abs(value) > 1000.0) {
                return HistoryFault{row, names[static_cast<std::size_t>(axis)],
                                    Sentence(KERF_TEXT("no usable drift; expected a number from -1000 to 1000 um."))};
            }
            largest_um = std::max(largest_um, std::abs(value));
        }
    }
    double largestRise_K = 0.0;
    for (Eigen::Index s = 0; s < h.temp_degC.cols(); ++s) {
        largestRise_K = std::max(largestRise_K, h.temp_degC.col(s).maxCoeff() - h.temp_degC(0, s));
    }
    if (largest_um < kSmallestDrift && largestRise_K > 1.0) {
        return HistoryFault{
            first, names[0],
            Sentence(KERF_TEXT("largest drift is %1 while the machine warms by %2 K; expected um, not mm."),
                     {largest_um, 4}, {largestRise_K, 1})};
    }
    return std::nullopt;
}

}  // namespace

Eigen::Index ThermalHistory::baselineRows() const noexcept {
    return static_cast<Eigen::Index>(std::ranges::lower_bound(time_min, 0.0) - time_min.begin());
}

std::optional<Eigen::Index> ThermalHistory::sensorIndex(const std::string& name) const {
    const auto found = std::ranges::find(sensors, name);
    if (found == sensors.end()) {
        return std::nullopt;
    }
    return static_cast<Eigen::Index>(found - sensors.begin());
}

std::optional<HistoryFault> whyNotUsable(const ThermalHistory& history) {
    if (history.rows() < 2) {
        return HistoryFault{0, "t_min",
                            Sentence(KERF_TEXT("too short; expected baseline rows and at least one row from time 0."))};
    }
    if (auto fault = timeFault(history)) {
        return fault;
    }
    if (history.workRows() == 0) {
        return HistoryFault{history.rows() - 1, "t_min", Sentence(KERF_TEXT("no row at or after time 0."))};
    }
    return std::nullopt;
}

std::optional<HistoryFault> whyNotTrainable(const ThermalHistory& history) {
    if (auto fault = whyNotUsable(history)) {
        return fault;
    }
    if (history.workRows() < 60) {
        return HistoryFault{history.rows() - 1, "t_min",
                            Sentence(KERF_TEXT("only %1 rows from time 0; training needs at least %2."),
                                     {static_cast<double>(history.workRows()), 0}, {60.0, 0})};
    }
    if (history.sensors.size() < 2) {
        return HistoryFault{0, "t_min", Sentence(KERF_TEXT("fewer than two temperature columns."))};
    }
    if (auto fault = gapFault(history)) {
        return fault;
    }
    if (auto fault = temperatureFault(history)) {
        return fault;
    }
    return driftFault(history);
}

std::uint64_t fingerprintOf(const std::vector<ThermalHistory>& histories) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    const auto byte = [&hash](std::uint8_t value) { hash = (hash ^ value) * 0x100000001B3ULL; };
    const auto number = [&byte](double value) {
        auto bits = std::bit_cast<std::uint64_t>(value);
        for (int k = 0; k < 8; ++k, bits >>= 8U) {
            byte(static_cast<std::uint8_t>(bits & 0xFFU));
        }
    };
    for (const ThermalHistory& h : histories) {
        for (const std::string& name : h.sensors) {
            for (const char c : name) {
                byte(static_cast<std::uint8_t>(c));
            }
            byte(0);
        }
        for (const double value : h.time_min) {
            number(value);
        }
        for (const double value : h.speed_rpm) {
            number(value);
        }
        for (const double value : h.temp_degC.reshaped()) {
            number(value);
        }
        const Eigen::MatrixXd measured =
            h.drift_um.size() > 0 ? h.drift_um.bottomRows(h.workRows()).eval() : h.drift_um;
        for (const double value : measured.reshaped()) {
            number(value);
        }
    }
    return hash;
}

}  // namespace kerf::thermal
