// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "engine/cycle/process_loop.h"
#include "engine/process/thermal/thermal_types.h"

namespace kerf {

/// Spans beyond the training range from which it is said.
inline constexpr double kThermalOutside = 0.25;

/// State and reason of the thermal loop, from what it has reported. `commanded`: a shift has been computed, so the
/// control reports its work offset.
[[nodiscard]] LoopVerdict thermalVerdict(const ThermalStatus& status, LoopMode mode, bool commanded) noexcept;

}  // namespace kerf
