// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/stored_recipe_history.h"

namespace kerf {
namespace {
/// What the engine counts its setups by stands among the stored values of two processes; nobody has set it.
constexpr const char* kEngineCount = "revision";
}  // namespace

Result<std::vector<RecipeRevisionView>> StoredRecipeHistory::revisions() {
    const auto known = m_links.book.revisions(partType());
    if (!known) {
        return tl::unexpected(known.error());
    }
    std::vector<RecipeRevisionView> shown;
    for (const RecipeRevision& row : *known) {
        shown.push_back({row.revision, row.restoredFrom, row.author, row.reason, row.createdUtc_ms});
    }
    return shown;
}

Result<std::vector<RecipeChangeView>> StoredRecipeHistory::compare(std::uint32_t before, std::uint32_t after) {
    const auto differences = m_links.book.compare(partType(), before, after);
    if (!differences) {
        return tl::unexpected(differences.error());
    }
    std::vector<RecipeChangeView> shown;
    for (const RecipeDifference& one : *differences) {
        if (one.key == kEngineCount) {
            continue;
        }
        shown.push_back({one.key, one.before.value_or(std::string()), one.after.value_or(std::string())});
    }
    return shown;
}

void StoredRecipeHistory::restore(std::uint32_t revision, const std::string& author, const std::string& reason,
                                  Done done) {
    const auto found = m_links.book.revision(partType(), revision);
    if (found) {
        return m_links.restore(*found, author, reason, std::move(done));
    }
    if (done) {
        done(tl::unexpected(found.error()));
    }
}

}  // namespace kerf
