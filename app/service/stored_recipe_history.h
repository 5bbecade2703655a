// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/service/recipe_book.h"
#include "ui/services/recipe_history.h"

namespace kerf {

/// The revisions of the part type a service works by, from its book. The service itself takes a revision back into
/// force: it knows what may be, and who may.
class StoredRecipeHistory final : public RecipeHistory {
 public:
    struct Links {
        RecipeBook& book;
        std::function<std::string()> partType;
        std::function<void(const RecipeRevision& revision, const std::string& author, const std::string& reason,
                           Done done)>
            restore;
    };
    explicit StoredRecipeHistory(Links links) : m_links(std::move(links)) {}

    [[nodiscard]] std::string partType() const override { return m_links.partType(); }
    [[nodiscard]] Result<std::vector<RecipeRevisionView>> revisions() override;
    [[nodiscard]] Result<std::vector<RecipeChangeView>> compare(std::uint32_t before, std::uint32_t after) override;
    void restore(std::uint32_t revision, const std::string& author, const std::string& reason, Done done) override;

 private:
    Links m_links;
};

}  // namespace kerf
