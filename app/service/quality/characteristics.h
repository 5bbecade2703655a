// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"
#include "engine/quality/verdict.h"
#include "ui/services/quality_service.h"

/// What is judged of a part: the bores of a boring recipe, the figures of the other processes that have limits.
namespace kerf {

/// Limits of figures stand in the recipe of their part type under this name. Before they did, they were room records of
/// this kind, one for the whole process: the newest still holds for what was made under a recipe without any.
inline constexpr const char* kFigureLimits = "figure_limits";

/// Limits of figures by what a part was made under: the revision of the recipe that was in force when it ended.
struct RecipeLimits {
    struct Revision {
        std::int64_t from_ms{0};  ///< in force since
        std::uint32_t revision{0};
        std::vector<FigureLimit> limits{};
        std::string partType{};
    };
    std::vector<FigureLimit> inForce{};               ///< of the parts to come
    std::map<RecipeRevisionId, Revision> ofRecipe{};  ///< for parts that say what they were cut with
    std::vector<Revision> revisions{};                ///< for others: in the order they came into force
    std::vector<FigureLimit> before{};                ///< of parts made before there was a recipe
    [[nodiscard]] const std::vector<FigureLimit>& of(const PartRow& part) const;
    [[nodiscard]] std::uint32_t revisionOf(const PartRow& part) const;  ///< 0: none

 private:
    [[nodiscard]] const Revision* under(const PartRow& part) const;
};

/// What holds when nobody has set limits: a tap may use all of its thread's tolerance (6H) and no more.
[[nodiscard]] std::vector<FigureLimit> standardLimits(ProcessId process);
[[nodiscard]] std::string limitsJson(const std::vector<FigureLimit>& limits);
/// Refused: no JSON, a key that is no figure of the process, a lower limit that is not below the upper one.
[[nodiscard]] Result<std::vector<FigureLimit>> limitsFromJson(ProcessId process, const std::string& text);
/// What a recipe says; empty optional: nothing. What cannot be read is no limit: such parts are not judged.
[[nodiscard]] std::optional<std::vector<FigureLimit>> limitsOfRecipe(ProcessId process,
                                                                     const std::string& parametersJson);

/// Boring: one per depth of the recipe, in its order. Other processes: one per limit. An unreadable recipe gives none.
[[nodiscard]] std::vector<Characteristic> characteristicsOf(ProcessId process, const std::string& recipeJson,
                                                            const std::vector<FigureLimit>& limits);

/// The same, each with the limits of its key; what has none there is not judged.
[[nodiscard]] std::vector<Characteristic> withLimits(std::vector<Characteristic> characteristics,
                                                     const std::vector<FigureLimit>& limits);

/// A characteristic without a tolerance does not count. Aborted parts and parts that still want a value are not judged,
/// unless what is known of them is out of tolerance.
[[nodiscard]] PartJudgement judgePart(const PartRow& part, const std::vector<Characteristic>& characteristics);

}  // namespace kerf
