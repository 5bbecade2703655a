// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/process.h"

namespace kerf::ui {

struct PageContext;

/// Limits of the figures that parts of a process are judged by, as they stand in the recipe of the part type it works
/// by: a change is one more revision, with a reason. Nothing, without a service of quality.
///
/// Object names: limitFigure, limitLower, limitUpper, limitReason, limitWhy; button limitSave
void openLimitsSheet(const PageContext& context, ProcessId process);

/// A button for it (recipeLimits) on the sheet that is open: a setup's.
void offerLimitsSheet(const PageContext& context, ProcessId process);

}  // namespace kerf::ui
