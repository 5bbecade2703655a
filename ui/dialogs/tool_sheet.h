// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/shell/page.h"

namespace kerf::ui {

/// The tools of the machine: parts made with each, the life it is given, and "New tool". @pre a shift service is there
///
/// Object names, per process: tool_KEY, toolNew_KEY, toolLife_KEY; with the life open: toolLifeField, toolLifeSave.
void openTools(const PageContext& context);

}  // namespace kerf::ui
