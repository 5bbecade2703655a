// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/thermal_commands.h"
namespace kerf::headless {
void addThermalSimulate(CLI::App&) {}
}  // namespace kerf::headless
