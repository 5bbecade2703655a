// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "db/api/lot_reader.h"
#include "db/api/recipe_compare.h"
#include "db/api/store_writer.h"

namespace kerf {

/// The recipes of one process, the same way for all five: part types by name, each with its revisions. A revision is
/// never changed; a roll back is one more, and says where it came from. What a recipe may be, who may change it and
/// what the engine is told is the service's to know; the book keeps text.
///
/// Writer and reader outlive it, and are used on the thread that made the reader. `Done` runs as the writer's does; a
/// service that may be gone by then guards itself.
class RecipeBook {
 public:
    RecipeBook(StoreWriter& writer, LotReader& reader, ProcessId process)
        : m_writer(writer), m_reader(reader), m_process(process) {}

    struct Recipe {
        std::string partType{};
        RecipeRevision revision{};
    };
    [[nodiscard]] Result<std::vector<PartTypeRow>> partTypes() const { return m_reader.partTypes(m_process); }
    /// The newest revision of each part type: that of the one changed last comes last.
    [[nodiscard]] Result<std::vector<Recipe>> newest();
    /// Every revision of every part type, oldest first.
    [[nodiscard]] Result<std::vector<Recipe>> all();
    /// Newest first; none of a part type that there is not.
    [[nodiscard]] Result<std::vector<RecipeRevision>> revisions(PartTypeId partType) const {
        return m_reader.recipes(partType);
    }
    [[nodiscard]] Result<std::vector<RecipeRevision>> revisions(const std::string& partType) const;
    [[nodiscard]] Result<RecipeRevision> revision(const std::string& partType, std::uint32_t revision) const;
    /// What changes from one revision to the other, by key.
    [[nodiscard]] Result<std::vector<RecipeDifference>> compare(const std::string& partType, std::uint32_t before,
                                                                std::uint32_t after) const;

    using Done = std::function<void(const Result<Receipt>&)>;
    /// What holds of a part type that has no revision yet becomes its first, so that the change to come can be rolled
    /// back. Nothing is stored when it has one: `done` runs at once.
    void begin(const std::string& partType, const std::string& parametersJson, const std::string& author,
               Done done = {});
    /// One more revision of a part type, which is made when there is none of the name. Receipt: id, second = its
    /// number.
    void keep(const std::string& partType, const std::string& parametersJson, const std::string& author,
              const std::string& reason, std::optional<std::uint32_t> restoredFrom, Done done);

    /// A part type with its first revision. Receipt: its id.
    void add(const std::string& partType, const std::string& parametersJson, const std::string& author, Done done);
    /// As keep(), of a part type that is known by its number.
    void save(PartTypeId partType, const std::string& parametersJson, const std::string& author,
              const std::string& reason, Done done);
    void restore(PartTypeId partType, std::uint32_t revision, const std::string& author, const std::string& reason,
                 Done done);

 private:
    /// `done`, and the part type is known from then on.
    [[nodiscard]] Done noting(const std::string& partType, Done done) const;
    [[nodiscard]] Result<std::vector<Recipe>> named(const Result<std::vector<RecipeRevision>>& revisions);

    StoreWriter& m_writer;
    LotReader& m_reader;
    ProcessId m_process;
    std::shared_ptr<std::set<std::string>> m_begun{std::make_shared<std::set<std::string>>()};
};

}  // namespace kerf
