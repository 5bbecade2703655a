// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"
#include "ui/pages/alarms_page.h"
#include "ui/pages/diagnostics_page.h"
#include "ui/pages/overview_page.h"

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

}  // namespace

// One row per page, in the order of the navigation. A room adds its page here, with nothing else to change.
PageList standardPages() {
    return {
        {"overview", [] { return Pages::tr("Overview"); }, {}, makePage<OverviewPage>, {}},
        {"alarms", [] { return Pages::tr("Alarms"); }, {}, makePage<AlarmsPage>, {}},
        {"diagnostics", [] { return Pages::tr("Diagnostics"); }, {}, makePage<DiagnosticsPage>, {}},
    };
}

}  // namespace kerf::ui
