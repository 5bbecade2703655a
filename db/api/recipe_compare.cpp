// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/api/recipe_compare.h"

#include <map>
#include <nlohmann/json.hpp>

namespace kerf {
namespace {

using Leaves = std::map<std::string, nlohmann::json>;

void flatten(const nlohmann::json& value, const std::string& key, Leaves& leaves) {
    if (!value.is_structured() || value.empty()) {
        leaves.emplace(key, value);
        return;
    }
    std::size_t place = 0;
    for (const auto& [name, child] : value.items()) {
        const std::string part = value.is_array() ? std::to_string(place++) : name;
        flatten(child, key.empty() ? part : key + '.' + part, leaves);
    }
}

Result<Leaves> leavesOf(const std::string& text) {
    const nlohmann::json recipe = nlohmann::json::parse(text, nullptr, false);
    if (!recipe.is_object()) {
        return fail(KERF_TEXT("This recipe revision cannot be read: it is no list of parameters."));
    }
    Leaves leaves;
    if (!recipe.empty()) {
        flatten(recipe, {}, leaves);
    }
    return leaves;
}

}  // namespace

Result<std::vector<RecipeDifference>> compareRecipes(const std::string& beforeJson, const std::string& afterJson) {
    const Result<Leaves> before = leavesOf(beforeJson);
    const Result<Leaves> after = leavesOf(afterJson);
    if (!before || !after) {
        return tl::unexpected<Sentence>(before ? after.error() : before.error());
    }
    std::map<std::string, RecipeDifference> differences;  // in the order of the keys
    for (const auto& [key, value] : *before) {
        const auto other = after->find(key);
        if (other == after->end()) {
            differences[key] = {key, value.dump(), std::nullopt};
        } else if (other->second != value) {
            differences[key] = {key, value.dump(), other->second.dump()};
        }
    }
    for (const auto& [key, value] : *after) {
        if (!before->contains(key)) {
            differences[key] = {key, std::nullopt, value.dump()};
        }
    }
    std::vector<RecipeDifference> list;
    for (auto& [key, difference] : differences) {
        list.push_back(std::move(difference));
    }
    return list;
}

}  // namespace kerf
