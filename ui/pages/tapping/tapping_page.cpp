// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/tapping_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/dialogs/limits_sheet.h"
#include "ui/dialogs/lot_sheet.h"
#include "ui/dialogs/recipe_sheet.h"
#include "ui/link/release_stop.h"
#include "ui/link/start_obstacle.h"
#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"
#include "ui/pages/tapping/job_sheet.h"
#include "ui/pages/tapping/recovery_sheet.h"
#include "ui/pages/tapping/tapping_texts.h"
#include "ui/shell/last_verdict.h"
#include "ui/shell/start_rest.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

/// What a kept tuning's values are called where revisions are compared.
const ParamSpec* tuningSpec(const std::string& key) {
    static const std::array kSpecs{
        ParamSpec{"settings.spindle_kp_perS", KERF_TEXT("Follow gain of the spindle"), "1/s", 0.0, 0.0, 0.0, 2, ""},
        ParamSpec{"settings.z_kp_perS", KERF_TEXT("Follow gain of Z"), "1/s", 0.0, 0.0, 0.0, 2, ""},
        ParamSpec{"settings.z_velocity_ff", KERF_TEXT("Speed feed-forward of Z"), "", 0.0, 0.0, 0.0, 4, ""},
        ParamSpec{"settings.z_accel_ff", KERF_TEXT("Acceleration feed-forward of Z"), "", 0.0, 0.0, 0.0, 3, ""},
        ParamSpec{"proof.last.engaged_pp_um", KERF_TEXT("Error p-p in the work"), "um", 0.0, 0.0, 0.0, 1, ""}};
    const auto found = std::ranges::find_if(kSpecs, [&key](const ParamSpec& spec) { return key == spec.key; });
    return found == kSpecs.end() ? nullptr : &*found;
}

constexpr int kTextPeriod_ms = 200;
}  // namespace

TappingPage::TappingPage(const PageContext& page, QWidget* parent)
    : Page(page, parent), m_service(page.services.tappingService) {
    m_rows = new QVBoxLayout(this);
    if (m_service == nullptr) {
        m_missing = addNotice(m_rows);
    } else {
        build();
    }
    refresh();
}

void TappingPage::build() {
    m_contourCard = new Card(look(), this);
    m_contour = new ContourChart(look(), m_contourCard);
    m_key = makeLabel(TextRole::Dim, m_contourCard);
    m_live = makeLabel(TextRole::Body, m_contourCard);
    m_live->setObjectName(QStringLiteral("tappingLive"));
    m_note = makeLabel(TextRole::Body, m_contourCard, true);
    m_note->setObjectName(QStringLiteral("tappingNote"));
    m_contourCard->header()->addWidget(m_live);
    m_contourCard->header()->addWidget(m_key);
    m_contourCard->body()->addWidget(m_contour, 1);
    m_contourCard->body()->addWidget(m_note);

    m_barCard = new Card(look(), this);
    m_saec = new TrialBars(look(), TrialBars::Figure::Saec, m_barCard);
    m_pp = new TrialBars(look(), TrialBars::Figure::EngagedPp, m_barCard);
    m_saecTitle = makeLabel(TextRole::Small, m_barCard, true);
    m_ppTitle = makeLabel(TextRole::Small, m_barCard, true);
    m_bars = new QHBoxLayout;
    for (const auto& [title, bars] : {std::pair{m_saecTitle, m_saec}, std::pair{m_ppTitle, m_pp}}) {
        auto* column = new QVBoxLayout;
        column->addWidget(title);
        column->addWidget(bars, 1);
        m_bars->addLayout(column, 1);
    }
    addLotLine(context(), m_service->lots(), m_barCard->header());
    m_barCard->header()->addWidget(new LastVerdict(context(), ProcessId::Tapping, m_barCard));
    m_barCard->body()->addLayout(m_bars, 1);

    m_speedCard = new Card(look(), this);
    m_speeds = new SpeedChart(look(), m_speedCard);
    m_speedCard->body()->addWidget(m_speeds, 1);

    m_gains = new GainsPanel(look(), this);
    m_actions = new TapActions(look(), context().client.engine(), this);
    m_actions->setSession(context().session);
    restUntilShown(m_actions->tapButton(), context(), ProcessId::Tapping);

    m_top = new QHBoxLayout;
    m_bottom = new QHBoxLayout;
    m_top->addWidget(m_contourCard, 1);
    m_top->addWidget(m_gains);
    m_bottom->addWidget(m_barCard, 6);
    m_bottom->addWidget(m_speedCard, 4);
    m_bottom->addWidget(m_actions);
    m_rows->addLayout(m_top, 1);
    m_rows->addLayout(m_bottom);
    connectActions();
}

void TappingPage::connectActions() {
    connect(m_contour, &ContourChart::touched, this, [this] { m_key->setText(m_contour->key()); });
    m_gains->setSession(context().session);
    connect(m_gains, &GainsPanel::modeRequested, this, [this](LoopMode mode) {
        context().withPermission(Deed::SwitchLoop, [this, mode] {
            context().client.sendAction(SetLoopMode{ProcessId::Tapping, mode});
        });
    });
    connect(m_actions, &TapActions::jobRequested, this, [this] {
        context().withPermission(Deed::TappingJob, [this] {
            JobForm::open(context().sheets, look(), *m_service, [this] { return context().session.author(); });
            offerRecipeSheet(context(), m_service->recipes(), Deed::TappingTuning, tuningSpec);
            offerLimitsSheet(context(), ProcessId::Tapping);
            offerLotSheet(context(), m_service->lots());
        });
    });
    connect(m_actions, &TapActions::tuneRequested, this, [this] {
        context().withPermission(Deed::TappingTuning, [this] {
            tell(m_service->begin(context().session.author(), m_service->view().automatic));
        });
    });
    connect(m_actions, &TapActions::tapRequested, this, [this] { context().client.startPart(ProcessId::Tapping); });
    connect(m_actions, &TapActions::oneMoreRequested, this, [this] {
        context().withPermission(Deed::TappingTuning, [this] { m_service->oneMore(context().session.author()); });
    });
    connect(m_actions, &TapActions::acceptRequested, this, [this] {
        context().withPermission(Deed::TappingTuning, [this] { m_service->accept(context().session.author()); });
    });
    connect(m_actions, &TapActions::rollBackRequested, this, [this] {
        context().withPermission(Deed::TappingTuning, [this] { m_service->rollBack(context().session.author()); });
    });
    connect(m_actions, &TapActions::automaticRequested, this, [this](bool automatic) {
        context().withPermission(Deed::TappingTuning,
                                 [this, automatic] { m_service->setAutomatic(automatic, context().session.author()); });
    });
    connect(m_actions, &TapActions::abortRequested, this, [this] { m_service->abort(); });
    connect(m_actions, &TapActions::recoveryRequested, this, [this] {
        RecoverySheet::open(context().sheets, look(), *m_service, context().client, [this] { sayGone(); });
    });
    connect(m_speeds, &SpeedChart::picked, this, [this](const TapChoice& choice) {
        context().sheets.ask(tr("Load this point?"), choiceText(choice, m_service->view().thread), tr("Cancel"),
                             tr("Load"), [this, choice] {
                                 context().withPermission(Deed::TappingJob, [this, choice] {
                                     tell(m_service->load(choice, context().session.author()));
                                 });
                             });
    });
    connect(&context().client, &EngineClient::statusChanged, this, &TappingPage::onStatus);
}

void TappingPage::refresh() {
    setObjectName(QStringLiteral("tappingPage"));
    const int gap = look().space(Space::Medium);
    m_rows->setContentsMargins(gap, gap, gap, gap);
    m_rows->setSpacing(gap);
    if (m_missing != nullptr) {
        m_missing->setText(tr("This machine does not tap with Kerf. The page fills when its tapping loop is fitted."));
    } else {
        for (QBoxLayout* row : {m_top, m_bottom}) {
            row->setSpacing(gap);
        }
        m_bars->setSpacing(look().space(Space::Large));
        m_gains->setFixedWidth(look().metrics().sideWidth());
        m_actions->setFixedWidth(look().metrics().sideWidth() * 5 / 4);
        m_contourCard->setTitle(termText(Term::ContourTitle, look().wording()).arg(look().units().of("um").symbol));
        m_barCard->setTitle(tr("Trial taps"));
        m_saecTitle->setText(termText(Term::SumOfErrors, look().wording()).arg(look().units().of("mm").symbol));
        m_ppTitle->setText(termText(Term::WidthOfError, look().wording()).arg(look().units().of("um").symbol));
        m_speedCard->setTitle(tr("Error p-p, %1, over time per hole", "unit").arg(look().units().of("um").symbol));
        m_contour->retranslate();
        m_speeds->retranslate();
        m_shown.reset();
        onStatus(context().client.status());
    }
    Page::refresh();
}

void TappingPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_service != nullptr) {
        m_sinceText.invalidate();
        onStatus(context().client.status());
    }
}

void TappingPage::showView() {
    const TappingServiceView& view = m_service->view();
    m_shown = view.revision;
    m_contour->setView(view);
    m_key->setText(m_contour->key());
    m_saec->setView(view);
    m_pp->setView(view);
    m_speeds->setView(view);
    m_gains->setView(view);
    m_actions->setView(view);
}

TappingPage::Situation TappingPage::situation(const Status& status) {
    const LoopStatus& loop = status.loops[static_cast<std::size_t>(ProcessId::Tapping)];
    const TappingStatus& tapping = status.tapping;
    return {tapping.phase,
            tapping.airTapPassed,
            loop.mode,
            loop.fitted,
            standingObstacle(status),
            status.partsBlocked,
            status.program,
            tapping.job,
            tapping.productionTaps,
            tapping.wantsTuning,
            tapping.problem.text};
}

void TappingPage::onStatus(const Status& status) {
    if (m_service == nullptr || (!isVisible() && m_shown)) {
        return;
    }
    const bool news = m_shown != m_service->view().revision;
    if (news) {
        showView();
    }
    const Situation now = situation(status);
    const bool changed = news || m_situation != now;
    m_situation = now;
    if (changed || !m_sinceText.isValid() || m_sinceText.elapsed() >= kTextPeriod_ms) {
        m_sinceText.start();
        m_gains->setStatus(status);
        m_actions->setStatus(status);
        showNote(status);
    }
}

void TappingPage::showNote(const Status& status) {
    const UnitSystem& units = look().units();
    const TappingStatus& tapping = status.tapping;
    const TappingServiceView& view = m_service->view();
    const bool turns = tapping.phase == TapPhase::Tapping || tapping.phase == TapPhase::Retracting;
    m_live->setText(
        turns
            ? tr("%1 rev, error %2").arg(UnitSystem::fixed(tapping.spindle_rev, 1), errorText(tapping.error_um, units))
            : QString());
    QStringList notes;
    if (tapping.phase == TapPhase::InHole) {
        notes << tr("A tap stands %1 revolutions (%2) in the hole. Turn it out in sync before anything else moves.")
                     .arg(UnitSystem::fixed(tapping.stoppedSpindle_rev, 1),
                          units.withUnit(tapping.stoppedZ_mm, "mm", 2));
    } else if (!tapping.problem.empty() && tapping.phase == TapPhase::Idle) {
        notes << tr("No tap was made: %1").arg(sentenceText(tapping.problem, units));
    }
    if (!view.storeProblem.empty()) {
        notes << tr("The tuning could not be stored: %1").arg(sentenceText(view.storeProblem, units));
    }
    if (const QString proof = proofText(view, units); !proof.isEmpty() && notes.isEmpty()) {
        notes << proof;
    }
    m_note->setText(notes.join(u' '));
    m_note->setVisible(!notes.isEmpty());
}

void TappingPage::sayGone() {
    const Status status = context().client.status();
    context().withOperator([this, status] {
        context().client.sendAction(releaseOf(status, ProcessId::Tapping, context().session.author()));
    });
}

void TappingPage::tell(const Result<void>& result) {
    if (!result) {
        context().notify(sentenceText(result.error(), look().units()));
    }
}

}  // namespace kerf::ui
