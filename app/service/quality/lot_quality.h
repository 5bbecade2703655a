// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/service/quality/characteristics.h"
#include "engine/process/boring/stretch.h"
#include "engine/quality/capability.h"
#include "engine/quality/charts.h"

/// Everything that is said about the quality of one lot: a pure function of what is stored, so that the console, the
/// commands and the reports say the same.
namespace kerf {

/// `announced`: changes of tool or material, as the Boring page took them. After one the charts begin anew, and what is
/// expected of the next part is drawn from what the lot itself has shown (not from the lots before it).
[[nodiscard]] LotQuality analyseLot(const LotHistory& history, const RecipeLimits& limits,
                                    const std::vector<boring::AnnouncedChange>& announced = {},
                                    const quality::ChartParams& params = {});

/// Lots of one part type, oldest first, as one: parts in the order they were made and numbered through, the charts
/// begin anew with each lot, a group per lot. What another recipe measures elsewhere is left out. @pre !lots.empty()
[[nodiscard]] LotQuality joinLots(std::vector<LotQuality> lots, const quality::ChartParams& params = {});

}  // namespace kerf
