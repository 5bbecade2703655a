// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// The parts of `kerf thermal` that live in files of their own.
namespace kerf::headless {

void addThermalVolumetric(CLI::App& thermal);
void addThermalSimulate(CLI::App& thermal);
void addThermalTable(CLI::App& thermal);
void addThermalRobust(CLI::App& thermal);
/// Predict from the sensors of a real machine, row by row as CSV, for so long. @throws BadInput
void predictLive(const std::string& modelPath, const std::string& sensorPath, double seconds);

}  // namespace kerf::headless
