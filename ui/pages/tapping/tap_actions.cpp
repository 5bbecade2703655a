// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/tap_actions.h"

#include <QGridLayout>

#include "ui/link/start_obstacle.h"
#include "ui/link/texts.h"
#include "ui/pages/tapping/tapping_texts.h"
#include "ui/shell/page.h"

namespace kerf::ui {
namespace {
constexpr int kColumns = 6;  ///< of the grid: three buttons of two, or one of two and one of four
}

TapActions::TapActions(Look& look, const EngineApi& engine, QWidget* parent)
    : Card(look, parent), m_look(look), m_engine(engine), m_grid(new QGridLayout) {
    setObjectName(QStringLiteral("tappingActions"));
    m_job = add("tappingJob", 0, 0, 2, [this] { return tuning() ? tr("a tuning is under way") : whyTapping(); });
    m_tune = add("tappingTune", 0, 2, 2, [this] { return whyNoTune(); });
    m_tap = add("tappingTap", 0, 4, 2, [this] { return whyNoTap(); });
    m_oneMore = add("tappingOneMore", 1, 0, 2, [this] { return whyNoOneMore(); });
    m_accept = add("tappingAccept", 1, 2, 2,
                   [this] { return m_view.state == TuningState::Proposed ? QString() : tr("nothing to accept"); });
    m_rollBack = add("tappingRollBack", 1, 4, 2, [this] { return whyNoRollBack(); });
    m_abort = add("tappingAbort", 2, 2, 4, [this] { return whyNoAbort(); });
    m_recover = add("tappingRecover", 2, 2, 4, [] { return QString(); });
    m_recover->setPrimary(true);
    m_automatic = new QPushButton(this);
    m_automatic->setObjectName(QStringLiteral("tappingAutomatic"));
    m_automatic->setCheckable(true);
    m_automatic->setFocusPolicy(Qt::TabFocus);
    m_grid->addWidget(m_automatic, 2, 0, 1, 2);
    for (int column = 0; column < kColumns; ++column) {
        m_grid->setColumnStretch(column, 1);
    }
    body()->addLayout(m_grid, 1);
    connect(m_job, &QPushButton::clicked, this, &TapActions::jobRequested);
    connect(m_tune, &QPushButton::clicked, this, &TapActions::tuneRequested);
    connect(m_tap, &QPushButton::clicked, this, &TapActions::tapRequested);
    connect(m_oneMore, &QPushButton::clicked, this, &TapActions::oneMoreRequested);
    connect(m_accept, &QPushButton::clicked, this, &TapActions::acceptRequested);
    connect(m_rollBack, &QPushButton::clicked, this, &TapActions::rollBackRequested);
    connect(m_abort, &QPushButton::clicked, this, &TapActions::abortRequested);
    connect(m_recover, &QPushButton::clicked, this, &TapActions::recoveryRequested);
    connect(m_automatic, &QPushButton::clicked, this, [this](bool checked) {
        m_automatic->setChecked(m_view.automatic);  // the service says what is in force
        emit automaticRequested(checked);
    });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

ActionButton* TapActions::add(const char* name, int row, int column, int columns, ActionButton::WhyNot whyNot) {
    auto* button = new ActionButton(m_look, this);
    button->setObjectName(QLatin1String(name));
    button->setFocusPolicy(Qt::TabFocus);
    button->setPredicate(std::move(whyNot));
    m_grid->addWidget(button, row, column, 1, columns);
    return button;
}

void TapActions::retranslate() {
    m_job->setText(tr("Job…"));
    m_tune->setText(tr("Tune"));
    m_oneMore->setText(tr("One more"));
    m_accept->setText(tr("Accept"));
    m_rollBack->setText(tr("Roll back"));
    m_automatic->setText(tr("Automatic"));
    m_abort->setText(tr("Abort the tap"));
    m_recover->setText(tr("Turn the tap out…"));
    m_grid->setSpacing(m_look.metrics().touchGap());
    m_automatic->setMinimumHeight(m_look.metrics().touch());
    reconsider();
}

void TapActions::setView(const TappingServiceView& view) {
    m_view = view;
    reconsider();
}

void TapActions::setSession(OperatorSession& session) {
    allowOnly(m_job, session, Deed::TappingJob);
    for (ActionButton* button : {m_tune, m_oneMore, m_accept, m_rollBack}) {
        allowOnly(button, session, Deed::TappingTuning);
    }
}

void TapActions::setStatus(const Status& status) {
    m_status = status;
    reconsider();
}

void TapActions::reconsider() {
    setTitle(!m_view.loaded ? tr("No job is loaded") : choiceText(m_view.choice, m_view.thread));
    m_tap->setText(m_status.tapping.airTapPassed ? tr("Tap") : tr("Air tap"));
    m_automatic->setChecked(m_view.automatic);
    m_abort->setVisible(!inHole());
    m_recover->setVisible(inHole());
    const bool proposes = m_view.state == TuningState::Proposed;
    m_oneMore->setPrimary(proposes && !m_view.finished);
    m_accept->setPrimary(proposes && m_view.finished);
    m_tune->setPrimary(m_status.tapping.wantsTuning && !tuning());
    for (ActionButton* button : {m_job, m_tune, m_tap, m_oneMore, m_accept, m_rollBack, m_abort, m_recover}) {
        button->reconsider();
    }
}

bool TapActions::tuning() const {
    return m_view.state == TuningState::AirTap || m_view.state == TuningState::Trial ||
           m_view.state == TuningState::Proposed;
}

QString TapActions::whyTapping() const {
    if (inHole()) {
        return tr("a tap stands in the hole");
    }
    if (m_status.tapping.phase != TapPhase::Idle) {
        return tr("a tap is under way");
    }
    return {};
}

QString TapActions::whyNoMove() const {
    if (const QString why = whyTapping(); !why.isEmpty()) {
        return why;
    }
    return startObstacle(m_status, m_engine.capabilities().cycleStart, ProcessId::Tapping, m_look.units());
}

QString TapActions::whyNoTune() const {
    if (!m_status.loops[static_cast<std::size_t>(ProcessId::Tapping)].fitted) {
        return tr("this machine has no tapping loop");
    }
    if (!m_engine.capabilities().servoGains.fitted) {
        return sentenceText(m_engine.capabilities().servoGains.why, m_look.units());
    }
    if (tuning()) {
        return tr("a tuning is under way");
    }
    if (m_status.loops[static_cast<std::size_t>(ProcessId::Tapping)].mode != LoopMode::Control) {
        return tr("switch to control");
    }
    return whyNoTap();
}

QString TapActions::whyNoTap() const {
    if (!m_view.loaded || m_status.tapping.job == 0) {
        return tr("no job is loaded");
    }
    if (tuning()) {
        return tr("a tuning is under way");
    }
    return whyNoMove();
}

QString TapActions::whyNoOneMore() const {
    if (m_view.state != TuningState::Proposed) {
        return tr("no proposal yet");
    }
    return m_view.mayTapMore ? whyNoMove() : tr("all taps are used");
}

QString TapActions::whyNoRollBack() const {
    const bool kept = m_view.state == TuningState::Done && m_view.source == GainsSource::Tuned && m_view.proof &&
                      !m_view.proof->rolledBack;
    return kept || m_view.state == TuningState::Proposed ? QString() : tr("nothing to roll back");
}

QString TapActions::whyNoAbort() const {
    const TapPhase phase = m_status.tapping.phase;
    if (phase == TapPhase::Retracting) {
        return tr("the tap is being turned out");
    }
    if (phase == TapPhase::Idle) {
        return tr("no tap is running");
    }
    return m_status.loops[static_cast<std::size_t>(ProcessId::Tapping)].mode == LoopMode::Off
               ? tr("the loop is off: abort at the control")
               : QString();
}

}  // namespace kerf::ui
