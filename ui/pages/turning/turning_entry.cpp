// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/turning/turning_page.h"

namespace kerf::ui {

PageEntry turningPageEntry() {
    return {processKey(ProcessId::Turning), [] { return processName(ProcessId::Turning); }, ProcessId::Turning,
            [](const PageContext& context) -> Page* { return new TurningPage(context); }, turningFigure};
}

}  // namespace kerf::ui
