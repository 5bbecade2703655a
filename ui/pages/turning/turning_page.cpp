// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/turning_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/dialogs/limits_sheet.h"
#include "ui/dialogs/lot_sheet.h"
#include "ui/dialogs/recipe_sheet.h"
#include "ui/link/texts.h"
#include "ui/pages/turning/comparison_panel.h"
#include "ui/pages/turning/force_panel.h"
#include "ui/pages/turning/margin_panel.h"
#include "ui/pages/turning/process_panel.h"
#include "ui/pages/turning/surface_panel.h"
#include "ui/pages/turning/turning_archive.h"
#include "ui/pages/turning/turning_control_panel.h"
#include "ui/pages/turning/turning_setup_form.h"
#include "ui/pages/turning/turning_texts.h"
#include "ui/shell/last_verdict.h"
#include "ui/shell/start_rest.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

TurningPage::TurningPage(const PageContext& page, QWidget* parent)
    : Page(page, parent), m_service(page.services.turningService) {
    m_rows = new QVBoxLayout(this);
    if (m_service == nullptr) {
        m_missing = addNotice(m_rows);
    } else {
        build();
    }
    refresh();
}

TurningPage::~TurningPage() = default;

void TurningPage::build() {
    EngineClient& client = context().client;
    m_force = new ForcePanel(look(), this);
    m_surface = new SurfacePanel(look(), this);
    m_control = new TurningControlPanel(look(), client.engine(), this);
    m_process = new ProcessPanel(look(), this);
    m_margins = new MarginPanel(look(), this);
    m_comparison = new ComparisonPanel(look(), this);
    addLotLine(context(), m_service->lots(), m_surface->header());
    m_surface->header()->addWidget(new LastVerdict(context(), ProcessId::Turning, m_surface));
    m_top = new QHBoxLayout;
    m_bottom = new QHBoxLayout;
    m_charts = new QVBoxLayout;
    m_charts->addWidget(m_force, 4);
    m_charts->addWidget(m_surface, 5);
    m_top->addLayout(m_charts, 1);
    m_top->addWidget(m_control);
    m_bottom->addWidget(m_process, 3);
    m_bottom->addWidget(m_margins, 3);
    m_bottom->addWidget(m_comparison, 4);
    m_rows->addLayout(m_top, 1);
    m_rows->addLayout(m_bottom);

    m_control->setSession(context().session);
    restUntilShown(m_control->startButton(), context(), ProcessId::Turning);
    connect(m_control, &TurningControlPanel::modeRequested, this, [this](LoopMode mode) {
        context().withPermission(Deed::SwitchLoop, [this, mode] {
            context().client.sendAction(SetLoopMode{ProcessId::Turning, mode});
        });
    });
    connect(m_control, &TurningControlPanel::startRequested, this,
            [this] { context().client.startPart(ProcessId::Turning); });
    connect(m_control, &TurningControlPanel::controllerRequested, this, [this](TurningController controller) {
        context().withPermission(Deed::TurningLaw, [this, controller] { setController(controller); });
    });
    connect(m_control, &TurningControlPanel::setupRequested, this,
            [this] { context().withPermission(Deed::TurningSetup, [this] { openSetup(m_service->view().setup); }); });
    connect(m_surface, &SurfacePanel::speedWanted, this, [this](double speed_rpm) {
        context().withPermission(Deed::TurningSetup, [this, speed_rpm] {
            TurningSetup setup = m_service->view().setup;
            setup.spindleSpeed_rpm = speed_rpm;
            openSetup(setup);
        });
    });
    connect(m_comparison, &ComparisonPanel::archiveWanted, this,
            [this] { TurningArchive::open(context(), *m_service); });
    connect(&client, &EngineClient::statusChanged, this, &TurningPage::onStatus);
    connect(&client, &EngineClient::samplesArrived, m_force, &ForcePanel::addSamples);
    m_subscription = m_service->onChanged([this] { onServiceChanged(); });
}

void TurningPage::refresh() {
    setObjectName(QStringLiteral("turningPage"));
    const int gap = look().space(Space::Medium);
    m_rows->setContentsMargins(gap, gap, gap, gap);
    m_rows->setSpacing(gap);
    if (m_missing != nullptr) {
        m_missing->setText(
            tr("This machine has no turning loop: force feedback needs a lathe with a 0.2 ms cycle, a force sensor and "
               "a fast tool trim."));
    } else {
        for (QBoxLayout* row : std::initializer_list<QBoxLayout*>{m_top, m_bottom, m_charts}) {
            row->setSpacing(gap);
        }
        m_control->setFixedWidth(look().metrics().sideWidth());
        m_force->retranslate();
        m_behind = true;
        onServiceChanged();
    }
    Page::refresh();
}

void TurningPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_behind) {
        onServiceChanged();
    }
}

void TurningPage::onServiceChanged() {
    if (m_service == nullptr) {
        return;
    }
    m_behind = !isVisible();
    if (m_behind && m_shownRevision != 0) {
        return;
    }
    const TurningServiceView& view = m_service->view();
    m_shownRevision = view.revision;
    m_surface->setView(view);
    m_control->setView(view);
    m_margins->setView(view);
    m_comparison->setView(view);
}

void TurningPage::onStatus(const Status& status) {
    m_force->setStatus(status);  // keeps its course while another page is shown
    if (!isVisible()) {
        return;
    }
    m_surface->setStatus(status);
    m_control->setStatus(status);
    m_process->setStatus(status);
    m_margins->setStatus(status);
}

void TurningPage::openSetup(const TurningSetup& setup) {
    TurningSetupForm::open(
        context().sheets, look(), *m_service, [this] { return context().session.author(); }, setup, context().notify);
    offerRecipeSheet(
        context(), m_service->recipes(), Deed::TurningSetup,
        [this](const std::string& key) { return turningRecipeSpec(*m_service, key); }, turningRecipeWord);
    offerLimitsSheet(context(), ProcessId::Turning);
    offerLotSheet(context(), m_service->lots());
}

void TurningPage::setController(TurningController controller) {
    m_control->setBusy(true);
    const QPointer<TurningPage> self(this);
    m_service->setController(controller, context().session.author(), [self](const Result<void>& result) {
        TurningPage* page = self.data();
        if (page == nullptr) {
            return;
        }
        page->m_control->setBusy(false);
        if (!result) {
            page->context().notify(sentenceText(result.error(), page->look().units()));
        }
    });
}

/// Of the part under the tool or of the last one; its course is that of the last parts.
KeyFigure turningFigure(const Services& services, const Status& status) {
    KeyFigure figure{TurningPage::tr("Predicted surface, RMS"), "um", kSurfaceDecimals, {}, {}, false, {}};
    if (status.turning.stage == TurningStage::Cutting) {
        figure.value = status.turning.surfaceRms_um;
    }
    if (services.turningService != nullptr) {
        for (const TurningPartView& part : services.turningService->view().parts) {
            if (part.complete) {
                figure.course.push_back(part.record.surfaceRms_um);
            }
        }
    }
    if (!figure.value && !figure.course.empty()) {
        figure.value = figure.course.back();
    }
    figure.limited = status.loops[static_cast<std::size_t>(ProcessId::Turning)].state == LoopState::Limited;
    return figure;
}

}  // namespace kerf::ui
