// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace kerf {

/// One parameter that differs between two recipe revisions.
struct RecipeDifference {
    std::string key{};  ///< path of names joined by '.', list places as numbers: "depths.0.overhang_mm"
    std::optional<std::string> before{};  ///< as JSON; empty: not there
    std::optional<std::string> after{};
};

/// What changes from one recipe to the other, by key. Numbers are equal when their values are (50 and 50.0), the order
/// of names does not matter. Fails with a sentence when one of them is no JSON object.
[[nodiscard]] Result<std::vector<RecipeDifference>> compareRecipes(const std::string& beforeJson,
                                                                   const std::string& afterJson);

}  // namespace kerf
