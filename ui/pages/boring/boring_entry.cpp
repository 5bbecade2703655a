// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/boring/boring_page.h"
#include "ui/pages/boring/boring_texts.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

struct Pages {
    Q_DECLARE_TR_FUNCTIONS(Pages)
};

/// The next bore as predicted; its course is what was measured at the first depth.
KeyFigure boringFigure(const Services& services, const Status& status) {
    KeyFigure figure;
    if (services.boringService == nullptr) {
        figure = {Pages::tr("Feed"), "mm/rev", kFeedDecimals, {}, {}, status.feedScaleLimited, {}};
        if (status.boring.feed_mmPerRev.good()) {
            figure.value = status.boring.feed_mmPerRev.value;
        }
        return figure;
    }
    const BoringServiceView& view = services.boringService->view();
    figure.unit = "mm";
    figure.decimals = kDiameterDecimals;
    figure.limited = view.nextLimited;
    figure.label =
        view.depths.empty() ? Pages::tr("Next bore") : Pages::tr("Next bore, %1").arg(depthName(view.depths.front()));
    if (!view.nextPrediction.empty() && view.nextPrediction.front()) {
        figure.value = view.nextPrediction.front()->diameter_mm;
        figure.half95 = view.nextPrediction.front()->half95_mm;
    }
    if (view.upperTolerance_mm > view.lowerTolerance_mm) {
        figure.lower = view.lowerTolerance_mm;
        figure.upper = view.upperTolerance_mm;
    }
    for (const BorePartView& part : view.parts) {
        if (const BoreMeasurementView* measured = measurementAt(part, 0)) {
            figure.course.push_back(measured->diameter_mm);
        }
    }
    return figure;
}

}  // namespace

PageEntry boringPageEntry() {
    return {processKey(ProcessId::Boring), [] { return processName(ProcessId::Boring); }, ProcessId::Boring,
            [](const PageContext& context) -> Page* { return new BoringPage(context); }, boringFigure};
}

}  // namespace kerf::ui
