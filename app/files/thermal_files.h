// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/files/table.h"
#include "engine/process/thermal/history.h"
#include "engine/process/thermal/thermal_model.h"

namespace kerf::headless {

/// What a history file is read for: training refuses gaps, prediction takes a missing reading as a sick sensor.
enum class HistoryUse : std::uint8_t { Training, Prediction };

/// Columns t_min, rpm (optional), any temperature columns, y?_meas and y?_true (optional); see docs/thermal.md.
/// @throws BadInput with file, line and column
[[nodiscard]] thermal::ThermalHistory readThermalHistory(const std::string& path, HistoryUse use);
/// Of one machine: the same temperature columns in every file. @throws BadInput
[[nodiscard]] std::vector<thermal::ThermalHistory> readThermalHistories(const std::vector<std::string>& paths);

/// @throws BadInput
[[nodiscard]] thermal::ThermalModel readThermalModel(const std::string& path);

}  // namespace kerf::headless
