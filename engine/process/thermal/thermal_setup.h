// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/core/sentence.h"
#include "engine/process/thermal/thermal_types.h"

namespace kerf::thermal {

/// Empty when the loop can use it; the ranges stand at ThermalSetup. A revision of 0 is no setup that anybody has made.
[[nodiscard]] std::optional<Sentence> whyUnusable(const ThermalSetup& setup) noexcept;

}  // namespace kerf::thermal
