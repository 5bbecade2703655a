// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/tapping/tapping_page.h"
#include "ui/pages/tapping/tapping_texts.h"
#include "ui/services/tapping_service.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

struct Pages {
    Q_DECLARE_TR_FUNCTIONS(Pages)
};

/// Error of the last tap in the work, at first that of the stored tuning; its course is the production taps' sum of
/// errors, before them the tuning's taps.
KeyFigure tappingFigure(const Services& services, const Status& status) {
    KeyFigure figure;
    figure.label = Pages::tr("Last tap, p-p in the work");
    figure.unit = "um";
    figure.decimals = kErrorDecimals;
    if (status.tapping.taps > 0 && status.tapping.last.samples > 0) {
        figure.value = status.tapping.last.engagedPp_um;
    }
    if (services.tappingService != nullptr) {
        const TappingServiceView& view = services.tappingService->view();
        for (const float saec_mm : view.productionSaec_mm) {
            figure.course.push_back(static_cast<double>(saec_mm));
        }
        if (figure.course.size() < 2) {
            figure.course.clear();
            if (view.thread.allowedPp_um > 0.0) {
                figure.upper = view.thread.allowedPp_um;
            }
            for (const TapTrialView& trial : view.trials) {
                figure.course.push_back(trial.figures.engagedPp_um);
            }
        }
        if (figure.course.empty() && view.proof) {
            figure.course = {view.proof->first.engagedPp_um, view.proof->last.engagedPp_um};
        }
        if (!figure.value && view.proof && !view.proof->rolledBack) {
            figure.label = Pages::tr("Tuned tap, p-p in the work");
            figure.value = view.proof->last.engagedPp_um;
        }
    }
    return figure;
}

}  // namespace

PageEntry tappingPageEntry() {
    return {processKey(ProcessId::Tapping), [] { return processName(ProcessId::Tapping); }, ProcessId::Tapping,
            [](const PageContext& context) -> Page* { return new TappingPage(context); }, tappingFigure};
}

}  // namespace kerf::ui
