// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

/// The parts of `kerf thermal` that live in files of their own.
namespace kerf::headless {

void addThermalVolumetric(CLI::App& thermal);
void addThermalSimulate(CLI::App& thermal);
void addThermalTable(CLI::App& thermal);

}  // namespace kerf::headless
