// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"

/// The revisions of the recipe that a process works by, the same for every process. Values only; GUI thread.
namespace kerf {

/// Revisions are never changed; a roll back is a new one.
struct RecipeRevisionView {
    std::uint32_t revision{0};
    std::optional<std::uint32_t> restoredFrom{};
    std::string author{};
    std::string reason{};
    std::int64_t createdUtc_ms{0};
};

/// One value that differs between two revisions, as it is stored; its key ends in its unit.
struct RecipeChangeView {
    std::string key{};
    std::string before{};  ///< empty: not there
    std::string after{};
};

class RecipeHistory {
 public:
    RecipeHistory() = default;
    RecipeHistory(const RecipeHistory&) = delete;
    RecipeHistory& operator=(const RecipeHistory&) = delete;
    virtual ~RecipeHistory() = default;

    /// Whose recipe it is that holds now.
    [[nodiscard]] virtual std::string partType() const = 0;
    /// Newest first: the first one holds. None, while nothing was ever changed.
    [[nodiscard]] virtual Result<std::vector<RecipeRevisionView>> revisions() = 0;
    /// What changes from one revision to the other, by key.
    [[nodiscard]] virtual Result<std::vector<RecipeChangeView>> compare(std::uint32_t before, std::uint32_t after) = 0;

    /// Called on the caller's thread when it is safely on disk (or why not).
    using Done = std::function<void(const Result<void>&)>;
    /// Roll back: what `revision` says is checked as if it were typed, and holds again as a new revision.
    virtual void restore(std::uint32_t revision, const std::string& author, const std::string& reason, Done done) = 0;
};

}  // namespace kerf
