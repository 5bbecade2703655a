// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/thermal_files.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "app/files/thermal_model_json.h"

namespace kerf::headless {
namespace {

constexpr std::array<const char*, 3> kMeasured{"yx_meas", "yy_meas", "yz_meas"};
constexpr std::array<const char*, 3> kTrue{"yx_true", "yy_true", "yz_true"};

bool isTemperature(const std::string& name) {
    return name != "t_min" && name != "rpm" && !name.ends_with("_true") && !name.ends_with("_meas");
}

/// Three columns, or none at all.
Eigen::MatrixXd threeColumns(const Table& table, const std::array<const char*, 3>& names) {
    Eigen::MatrixXd out;
    if (!table.has(names[0]) && !table.has(names[1]) && !table.has(names[2])) {
        return out;
    }
    out.resize(static_cast<Eigen::Index>(table.rows()), 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& column = table.column(names[axis]);
        out.col(static_cast<Eigen::Index>(axis)) = Eigen::Map<const Eigen::VectorXd>(column.data(), out.rows());
    }
    return out;
}

/// Gaps are for temperatures and drifts; time and speed must be there.
void requireNumbers(const Table& table, std::string_view name) {
    const auto& column = table.column(name);
    for (std::size_t row = 0; row < column.size(); ++row) {
        if (!std::isfinite(column[row])) {
            throw BadInput(fmt::format("{}no value; expected a finite decimal number.", table.where(row, name)));
        }
    }
}

}  // namespace

thermal::ThermalHistory readThermalHistory(const std::string& path, HistoryUse use) {
    const Table table = Table::read(path, Table::Gaps::Allowed);
    requireNumbers(table, "t_min");
    thermal::ThermalHistory history;
    history.label = std::filesystem::path(path).filename().string();
    history.time_min = table.column("t_min");
    if (table.has("rpm")) {
        requireNumbers(table, "rpm");
        table.requireRange("rpm", -100'000.0, 100'000.0);
        history.speed_rpm = table.column("rpm");
    }
    for (const std::string& name : table.names()) {
        if (isTemperature(name)) {
            history.sensors.push_back(name);
        }
    }
    const auto rows = static_cast<Eigen::Index>(table.rows());
    const auto sensors = static_cast<Eigen::Index>(history.sensors.size());
    history.temp_degC = Eigen::MatrixXd::Zero(rows, sensors);
    history.present = thermal::PresentMask::Constant(rows, sensors, false);
    for (Eigen::Index s = 0; s < sensors; ++s) {
        const auto& column = table.column(history.sensors[static_cast<std::size_t>(s)]);
        for (Eigen::Index row = 0; row < rows; ++row) {
            const double value = column[static_cast<std::size_t>(row)];
            if (std::isfinite(value)) {
                history.temp_degC(row, s) = value;
                history.present(row, s) = true;
            }
        }
    }
    history.drift_um = threeColumns(table, kMeasured);
    history.trueDrift_um = threeColumns(table, kTrue);
    const auto fault = use == HistoryUse::Training ? thermal::whyNotTrainable(history) : thermal::whyNotUsable(history);
    if (fault) {
        if (table.rows() == 0) {
            throw BadInput(fmt::format("{}, line 1: {}", path, fault->reason.english()));
        }
        throw BadInput(table.where(static_cast<std::size_t>(fault->row), fault->column) + fault->reason.english());
    }
    return history;
}

std::vector<thermal::ThermalHistory> readThermalHistories(const std::vector<std::string>& paths) {
    std::vector<thermal::ThermalHistory> days;
    for (const std::string& path : paths) {
        days.push_back(readThermalHistory(path, HistoryUse::Training));
        const auto& first = days.front().sensors;
        const auto& own = days.back().sensors;
        for (std::size_t k = 0; k < std::max(first.size(), own.size()); ++k) {
            if (k >= first.size() || k >= own.size() || first[k] != own[k]) {
                throw BadInput(fmt::format(
                    "{}, line 1, column {}: expected {} as in {}; train with days of one machine.", path,
                    k < own.size() ? own[k] : "(none)", k < first.size() ? first[k] : "(none)", paths.front()));
            }
        }
    }
    return days;
}

thermal::ThermalModel readThermalModel(const std::string& path) {
    auto model = formats::thermalModelFromJson(readFile(path));
    if (!model) {
        throw BadInput(fmt::format("{}: {}", path, model.error().english()));
    }
    return std::move(*model);
}

}  // namespace kerf::headless
