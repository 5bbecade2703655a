// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/milling/milling_page.h"
#include "ui/pages/milling/milling_texts.h"
#include "ui/services/milling_service.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

struct Pages {
    Q_DECLARE_TR_FUNCTIONS(Pages)
};

/// Waviness of the cut under way or of the last one; its course is that of the last cuts.
KeyFigure millingFigure(const Services& services, const Status& status) {
    KeyFigure figure{Pages::tr("Waviness of the cut"), "um", kWallDecimals, {}, {}, status.feedScaleLimited, {}};
    if (services.millingService != nullptr) {
        for (const MillingCutView& cut : services.millingService->view().cuts) {
            if (cut.complete && cut.cut.waviness_um > 0.0) {
                figure.course.push_back(cut.cut.waviness_um);
            }
        }
    }
    if (status.milling.cutting && status.milling.waviness_um > 0.0) {
        figure.value = status.milling.waviness_um;
    } else if (!figure.course.empty()) {
        figure.value = figure.course.back();
    }
    figure.limited = figure.limited && status.milling.cutting;
    return figure;
}

}  // namespace

PageEntry millingPageEntry() {
    return {processKey(ProcessId::Milling), [] { return processName(ProcessId::Milling); }, ProcessId::Milling,
            [](const PageContext& context) -> Page* { return new MillingPage(context); }, millingFigure};
}

}  // namespace kerf::ui
