// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ui/services/thermal_service.h"

namespace kerf {

/// Names T00… of a machine's thermocouples, and for the built-in machine where each sits on the drawing (seen from the
/// side: spindle left, column right).
[[nodiscard]] std::vector<ThermalSensorView> thermalSensors(std::size_t count, bool builtIn);

}  // namespace kerf
