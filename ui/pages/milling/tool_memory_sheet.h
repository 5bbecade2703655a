// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/services/milling_service.h"
#include "ui/shell/page.h"

namespace kerf::ui {

/// "Begins from 3 tools before: k_x 36 N/mm (27 to 48), ln(C·b) 7.91 ± 0.28"; empty when there are none.
[[nodiscard]] QString toolMemoryText(const MillingMemoryView& memory, Wording wording);

/// The tools of this kind that were in the spindle before, what each showed, and the two touches that leave one out or
/// take it in again. Object names: millingToolsBefore (the list), millingToolReason, millingToolsMessage, and per tool
/// millingLeaveOut_<its `since`>.
void openToolMemory(const PageContext& context, MillingService& service);

}  // namespace kerf::ui
