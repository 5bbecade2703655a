// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/recipe_book.h"

#include <algorithm>
#include <map>

namespace kerf {
namespace {

tl::unexpected<Sentence> noSuch(std::uint32_t revision) {
    return fail(KERF_TEXT("The recipe has no revision %1."), SentenceArg(revision, 0));
}

}  // namespace

Result<std::vector<RecipeBook::Recipe>> RecipeBook::named(const Result<std::vector<RecipeRevision>>& revisions) {
    const auto types = partTypes();
    if (!revisions || !types) {
        return tl::unexpected(revisions ? types.error() : revisions.error());
    }
    std::map<PartTypeId, std::string> names;
    for (const PartTypeRow& type : *types) {
        names[type.id] = type.name;
    }
    std::vector<Recipe> recipes;
    for (const RecipeRevision& revision : *revisions) {
        m_begun->insert(names[revision.partType]);
        recipes.push_back({names[revision.partType], revision});
    }
    return recipes;
}

Result<std::vector<RecipeBook::Recipe>> RecipeBook::newest() {
    return named(m_reader.newestRecipes(m_process));
}

Result<std::vector<RecipeBook::Recipe>> RecipeBook::all() {
    return named(m_reader.allRecipes(m_process));
}

Result<std::vector<RecipeRevision>> RecipeBook::revisions(const std::string& partType) const {
    const auto types = partTypes();
    if (!types) {
        return tl::unexpected(types.error());
    }
    const auto found = std::ranges::find(*types, partType, &PartTypeRow::name);
    return found == types->end() ? Result<std::vector<RecipeRevision>>() : revisions(found->id);
}

Result<RecipeRevision> RecipeBook::revision(const std::string& partType, std::uint32_t revision) const {
    const auto known = revisions(partType);
    if (!known) {
        return tl::unexpected(known.error());
    }
    const auto found = std::ranges::find(*known, revision, &RecipeRevision::revision);
    return found == known->end() ? Result<RecipeRevision>(noSuch(revision)) : *found;
}

Result<std::vector<RecipeDifference>> RecipeBook::compare(const std::string& partType, std::uint32_t before,
                                                          std::uint32_t after) const {
    const auto one = revision(partType, before);
    const auto other = revision(partType, after);
    if (!one || !other) {
        return tl::unexpected(one ? other.error() : one.error());
    }
    return compareRecipes(one->parametersJson, other->parametersJson);
}

void RecipeBook::begin(const std::string& partType, const std::string& parametersJson, const std::string& author,
                       Done done) {
    if (m_begun->contains(partType)) {
        if (done) {
            done(Receipt{});
        }
        return;
    }
    m_writer.submit(EnsurePartType{m_process, partType, parametersJson, author}, noting(partType, std::move(done)));
}

RecipeBook::Done RecipeBook::noting(const std::string& partType, Done done) const {
    return [begun = m_begun, partType, done = std::move(done)](const Result<Receipt>& receipt) {
        if (receipt) {
            begun->insert(partType);
        }
        if (done) {
            done(receipt);
        }
    };
}

void RecipeBook::keep(const std::string& partType, const std::string& parametersJson, const std::string& author,
                      const std::string& reason, std::optional<std::uint32_t> restoredFrom, Done done) {
    m_writer.submit(KeepRecipe{m_process, partType, parametersJson, author, reason, restoredFrom},
                    noting(partType, std::move(done)));
}

void RecipeBook::add(const std::string& partType, const std::string& parametersJson, const std::string& author,
                     Done done) {
    m_writer.submit(EnsurePartType{m_process, partType, parametersJson, author}, std::move(done));
}

void RecipeBook::save(PartTypeId partType, const std::string& parametersJson, const std::string& author,
                      const std::string& reason, Done done) {
    m_writer.submit(SaveRecipe{partType, parametersJson, author, reason, {}}, std::move(done));
}

void RecipeBook::restore(PartTypeId partType, std::uint32_t revision, const std::string& author,
                         const std::string& reason, Done done) {
    m_writer.submit(RestoreRecipe{partType, revision, author, reason}, std::move(done));
}

}  // namespace kerf
