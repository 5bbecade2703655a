// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/thermal/thermal_page.h"
#include "ui/pages/thermal/thermal_texts.h"

namespace kerf::ui {

PageEntry thermalPageEntry() {
    return {processKey(ProcessId::Thermal), [] { return processName(ProcessId::Thermal); }, ProcessId::Thermal,
            [](const PageContext& context) -> Page* { return new ThermalPage(context); }, thermalFigure};
}

}  // namespace kerf::ui
