// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "engine/core/param_spec.h"
#include "ui/services/permissions.h"

namespace kerf {
class RecipeHistory;
}

namespace kerf::ui {

struct PageContext;

/// Name and unit of a stored value; null: it is shown by its key.
using RecipeSpecOf = std::function<const ParamSpec*(const std::string& key)>;
/// A stored text in the shop's words (a law); empty: as it is stored.
using RecipeWordOf = std::function<QString(const std::string& key, const QString& stored)>;

/// The revisions of the recipe that holds, of any process: who changed it when and why, what differs in one of them
/// from what holds now, and the way back to it, with a reason. Object names: recipeRevisions (the table),
/// recipeDifference, recipeReason, recipeMessage; button recipeRestore. `deed`: whoever may change it.
void openRecipeSheet(const PageContext& context, RecipeHistory& history, Deed deed, const RecipeSpecOf& specOf = {},
                     const RecipeWordOf& wordOf = {});

/// A button for it (recipeHistory) on the sheet that is open: a form's. Nothing, without a history.
void offerRecipeSheet(const PageContext& context, RecipeHistory* history, Deed deed, const RecipeSpecOf& specOf = {},
                      const RecipeWordOf& wordOf = {});

}  // namespace kerf::ui
