// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/sheet.h"
#include "ui/services/milling_service.h"

namespace kerf::ui {

/// The last cuts, newest first: law, mode, programmed against controlled time, peak and where, waviness.
/// Object names: millingCutLog (QTableWidget), millingCutLogClose.
void openMillingCutLog(SheetHost& host, Look& look, const MillingService& service);

}  // namespace kerf::ui
