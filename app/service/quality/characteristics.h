// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"
#include "engine/quality/verdict.h"
#include "ui/services/quality_service.h"

/// What is judged of a part: the bores of a boring recipe, the figures of the other processes that have limits.
namespace kerf {

/// Limits of figures are kept as room records of this kind, the newest holds.
inline constexpr const char* kFigureLimits = "figure_limits";

/// What holds when nobody has set limits: a tap may use all of its thread's tolerance (6H) and no more.
[[nodiscard]] std::vector<FigureLimit> standardLimits(ProcessId process);
[[nodiscard]] std::string limitsJson(const std::vector<FigureLimit>& limits);
/// Refused: no JSON, a key that is no figure of the process, a lower limit that is not below the upper one.
[[nodiscard]] Result<std::vector<FigureLimit>> limitsFromJson(ProcessId process, const std::string& text);

/// Boring: one per depth of the recipe, in its order. Other processes: one per limit. An unreadable recipe gives none.
[[nodiscard]] std::vector<Characteristic> characteristicsOf(ProcessId process, const std::string& recipeJson,
                                                            const std::vector<FigureLimit>& limits);

/// Aborted parts and parts that still want a value are not judged, unless what is known of them is out of tolerance.
[[nodiscard]] PartJudgement judgePart(const PartRow& part, const std::vector<Characteristic>& characteristics);

}  // namespace kerf
