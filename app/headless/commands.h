// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <array>

/// Each adds its process's commands to `kerf`. A command's callback does the work, prints, and throws BadInput.
namespace kerf::headless {

void addBoringCommands(CLI::App& kerf);
void addMillingCommands(CLI::App& kerf);
void addTurningCommands(CLI::App& kerf);
void addThermalCommands(CLI::App& kerf);
void addTappingCommands(CLI::App& kerf);
/// The data file: export, verify, check, backup.
void addDataCommands(CLI::App& kerf);
/// Charts, capability, gauge studies, Q-DAS files.
void addQualityCommands(CLI::App& kerf);
/// Temperatures and gauges of a real machine: check, watch, scan.
void addSensorCommands(CLI::App& kerf);
/// A real machine: status, watch, jitter.
void addMachineCommands(CLI::App& kerf);
/// Rehearse a scenario of faults and commands.
void addRehearseCommand(CLI::App& kerf);

/// Many consoles, one PostgreSQL: init, enroll, status, push, verify.
void addShopCommands(CLI::App& kerf);

/// In the order `kerf --help` shows them.
inline constexpr std::array kCommands{addBoringCommands,  addMillingCommands, addTurningCommands, addTappingCommands,
                                      addThermalCommands, addDataCommands,    addQualityCommands, addSensorCommands,
                                      addMachineCommands, addRehearseCommand, addShopCommands};

}  // namespace kerf::headless
