// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "ui/services/turning_service.h"

/// What the turning service keeps in the room records, as JSON; numbers under keys that end in their unit.
namespace kerf {

/// What a face is turned by.
struct TurningRecipe {
    TurningSetup setup{};
    TurningController controller{TurningController::Tones};
};
[[nodiscard]] std::string turningRecipeJson(const TurningRecipe& recipe);
/// Empty: not of this version, or a setup that cannot be cut. A revision of before the law stood in the recipe says
/// none: `otherwise` holds.
[[nodiscard]] std::optional<TurningRecipe> turningRecipeFrom(const std::string& json, TurningController otherwise);
[[nodiscard]] bool turningRecipeSaysLaw(const std::string& json);

[[nodiscard]] const char* turningControllerKey(TurningController controller) noexcept;
/// A room record of before the law stood in the recipe.
[[nodiscard]] std::optional<TurningController> turningControllerFrom(const std::string& json);

[[nodiscard]] std::string turningPartJson(const TurningPartView& part);
[[nodiscard]] std::optional<TurningPartView> turningPartFrom(const std::string& json);

}  // namespace kerf
