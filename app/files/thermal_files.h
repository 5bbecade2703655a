// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/files/table.h"
#include "engine/process/thermal/history.h"
#include "engine/process/thermal/thermal_model.h"

namespace kerf::headless {

/// What a history file is read for: training refuses gaps; prediction takes a missing reading as a sick sensor, and
/// bridges one or two in a row with the reading before them.
enum class HistoryUse : std::uint8_t { Training, Prediction };

struct HistoryOptions {
    HistoryUse use{HistoryUse::Training};
    std::vector<std::string> sensors{};  ///< taken under these names whatever they do; the rest if temperatures
    bool onlySensors{false};             ///< no others
    ReadOptions read{};
    double rest_min{0.0};  ///< of a clock that counts from its first row: how long the machine stood; 0: found by rpm
};

/// A day and what a person should know about how it was read.
struct HistoryFile {
    thermal::ThermalHistory history{};
    std::vector<std::string> notes{};
};

/// Columns t_min, rpm (optional), temperature columns, y?_meas and y?_true (optional); see docs/thermal.md.
/// A logger's clock has no row before 0: time 0 is then the first row in which the spindle turns, or rest_min later.
/// @throws BadInput with file, line and column
[[nodiscard]] HistoryFile readHistoryFile(const std::string& path, const HistoryOptions& options);
/// The same of a table that has been read. @throws BadInput
[[nodiscard]] HistoryFile historyOf(Table table, const std::string& path, const HistoryOptions& options);
[[nodiscard]] thermal::ThermalHistory readThermalHistory(const std::string& path, HistoryUse use);
/// Of one machine: the temperature columns of the first file, in every file. @throws BadInput
[[nodiscard]] std::vector<thermal::ThermalHistory> readThermalHistories(const std::vector<std::string>& paths,
                                                                        const ReadOptions& read = {},
                                                                        std::vector<std::string>* notes = nullptr,
                                                                        double rest_min = 0.0);

/// @throws BadInput
[[nodiscard]] thermal::ThermalModel readThermalModel(const std::string& path);
/// Measured (else true) drift that is too small for a machine that warms: mm, most likely. @throws BadInput
void requireMicrometres(const thermal::ThermalHistory& history, const std::string& path);

}  // namespace kerf::headless
