// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/shell/page.h"

namespace kerf::ui {

/// Which backup, why, and what becomes of the data that is there now; then it waits for the next start.
void openRestore(const PageContext& context);

}  // namespace kerf::ui
