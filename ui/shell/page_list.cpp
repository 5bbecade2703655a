// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/alarms/alarms_page.h"
#include "ui/pages/boring/boring_page.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/pages/diagnostics/diagnostics_page.h"
#include "ui/pages/milling/milling_page.h"
#include "ui/pages/milling/milling_texts.h"
#include "ui/pages/overview/overview_page.h"
#include "ui/pages/parts/parts_page.h"
#include "ui/pages/quality/quality_page.h"
#include "ui/pages/sensors/sensors_page.h"
#include "ui/pages/shift/shift_page.h"
#include "ui/pages/tapping/tapping_page.h"
#include "ui/pages/tapping/tapping_texts.h"
#include "ui/pages/thermal/thermal_page.h"
#include "ui/pages/thermal/thermal_texts.h"
#include "ui/pages/turning/turning_page.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

struct Pages {
    Q_DECLARE_TR_FUNCTIONS(Pages)
};

template <class P>
Page* makePage(const PageContext& context) {
    return new P(context);
}

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
    for (const BorePartView& part : view.parts) {
        if (const BoreMeasurementView* measured = measurementAt(part, 0)) {
            figure.course.push_back(measured->diameter_mm);
        }
    }
    return figure;
}

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

/// Error of the last tap in the work; its course is the production taps' sum of errors.
KeyFigure tappingFigure(const Services& services, const Status& status) {
    KeyFigure figure;
    figure.label = Pages::tr("Last tap, p-p in the work");
    figure.unit = "um";
    figure.decimals = kErrorDecimals;
    if (status.tapping.taps > 0 && status.tapping.last.samples > 0) {
        figure.value = status.tapping.last.engagedPp_um;
    }
    if (services.tappingService != nullptr) {
        for (const float saec_mm : services.tappingService->view().productionSaec_mm) {
            figure.course.push_back(static_cast<double>(saec_mm));
        }
    }
    return figure;
}

}  // namespace

// One row per page, in the order of the navigation. A room adds its page here, with nothing else to change.
PageList standardPages() {
    return {
        {"overview", [] { return Pages::tr("Overview"); }, {}, makePage<OverviewPage>, {}},
        {"boring", [] { return processName(ProcessId::Boring); }, ProcessId::Boring, makePage<BoringPage>,
         boringFigure},
        {"milling", [] { return processName(ProcessId::Milling); }, ProcessId::Milling, makePage<MillingPage>,
         millingFigure},
        {"turning", [] { return processName(ProcessId::Turning); }, ProcessId::Turning, makePage<TurningPage>,
         turningFigure},
        {"thermal", [] { return processName(ProcessId::Thermal); }, ProcessId::Thermal, makePage<ThermalPage>,
         thermalFigure},
        {"tapping", [] { return processName(ProcessId::Tapping); }, ProcessId::Tapping, makePage<TappingPage>,
         tappingFigure},
        {"quality", [] { return Pages::tr("Quality"); }, {}, makePage<QualityPage>, {}},
        {"parts", [] { return Pages::tr("Parts"); }, {}, makePage<PartsPage>, {}},
        {"shift", [] { return Pages::tr("Shift"); }, {}, makePage<ShiftPage>, {}},
        {"sensors", [] { return Pages::tr("Sensors"); }, {}, makePage<SensorsPage>, {}},
        {"alarms", [] { return Pages::tr("Alarms"); }, {}, makePage<AlarmsPage>, {}},
        {"diagnostics", [] { return Pages::tr("Diagnostics"); }, {}, makePage<DiagnosticsPage>, {}},
    };
}

}  // namespace kerf::ui
