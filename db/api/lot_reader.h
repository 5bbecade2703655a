// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"

namespace kerf {

/// Machines, part types, recipes and lots. Own read-only connection; use it on the thread that made it.
class LotReader {
 public:
    LotReader() = default;
    LotReader(const LotReader&) = delete;
    LotReader& operator=(const LotReader&) = delete;
    virtual ~LotReader() = default;

    [[nodiscard]] virtual Result<std::vector<MachineRow>> machines() = 0;
    [[nodiscard]] virtual Result<std::vector<PartTypeRow>> partTypes(std::optional<ProcessId> process) = 0;
    /// All revisions of a recipe, newest first.
    [[nodiscard]] virtual Result<std::vector<RecipeRevision>> recipes(PartTypeId partType) = 0;
    /// The newest revision of each part type of a process, in the order in which they were accepted.
    [[nodiscard]] virtual Result<std::vector<RecipeRevision>> newestRecipes(ProcessId process) = 0;
    /// All revisions of all its part types, oldest first.
    [[nodiscard]] virtual Result<std::vector<RecipeRevision>> allRecipes(ProcessId process) = 0;
    /// Newest first, at most `limit`.
    [[nodiscard]] virtual Result<std::vector<LotRow>> lots(std::optional<PartTypeId> partType, std::uint32_t limit,
                                                           std::optional<ProcessId> process = std::nullopt) = 0;
    /// The lot that parts of the process are begun for.
    [[nodiscard]] virtual Result<std::optional<LotId>> activeLot(ProcessId process) = 0;
    /// What the lot is cut to; empty optional: no such lot.
    [[nodiscard]] virtual Result<std::optional<RecipeRevision>> recipeOf(LotId lot) = 0;
    /// Everything about one lot; empty optional: no such lot.
    [[nodiscard]] virtual Result<std::optional<LotHistory>> history(LotId lot) = 0;
    /// The newest parts of a lot with schedule, feed and measurements, but without estimator states and proposed
    /// schedules: to be looked at, whatever the lot's size. `last`: that part and those before it. Empty optional: no
    /// such lot.
    [[nodiscard]] virtual Result<std::optional<LotHistory>> newestParts(LotId lot, std::uint32_t count,
                                                                        std::optional<PartId> last) = 0;
};

}  // namespace kerf
