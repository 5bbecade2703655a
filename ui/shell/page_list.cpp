// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/alarms/alarms_page.h"
#include "ui/pages/diagnostics/diagnostics_page.h"
#include "ui/pages/overview/overview_page.h"
#include "ui/pages/parts/parts_page.h"
#include "ui/pages/quality/quality_page.h"
#include "ui/pages/sensors/sensors_page.h"
#include "ui/pages/shift/shift_page.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace kerf::ui {
namespace {

struct Pages {
    Q_DECLARE_TR_FUNCTIONS(Pages)
};

template <class P>
Page* makePage(const PageContext& context) {
    return new P(context);
}

}  // namespace

PageList standardPages(PageList ofProcesses) {
    PageList pages{{"overview", [] { return Pages::tr("Overview"); }, {}, makePage<OverviewPage>, {}}};
    std::ranges::move(ofProcesses, std::back_inserter(pages));
    for (PageEntry entry : {
             PageEntry{"quality", [] { return Pages::tr("Quality"); }, {}, makePage<QualityPage>, {}},
             PageEntry{"parts", [] { return Pages::tr("Parts"); }, {}, makePage<PartsPage>, {}},
             PageEntry{"shift", [] { return Pages::tr("Shift"); }, {}, makePage<ShiftPage>, {}},
             PageEntry{"sensors", [] { return Pages::tr("Sensors"); }, {}, makePage<SensorsPage>, {}},
             PageEntry{"alarms", [] { return Pages::tr("Alarms"); }, {}, makePage<AlarmsPage>, {}},
             PageEntry{"diagnostics", [] { return Pages::tr("Diagnostics"); }, {}, makePage<DiagnosticsPage>, {}},
         }) {
        pages.push_back(std::move(entry));
    }
    return pages;
}

}  // namespace kerf::ui
