// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/turning_control_panel.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>

#include "ui/link/start_obstacle.h"
#include "ui/link/texts.h"
#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

TurningControlPanel::TurningControlPanel(Look& look, const EngineApi& engine, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_engine(engine),
      m_reason(makeLabel(TextRole::Body, this, true)),
      m_progress(new QProgressBar(this)),
      m_modes(new ModeButtons(look, ProcessId::Turning, this)),
      m_controllers(new QButtonGroup(this)),
      m_partRow(new QHBoxLayout),
      m_controllerGrid(new QGridLayout),
      m_controllerTitle(makeLabel(TextRole::Small, this)),
      m_setup(makeLabel(TextRole::Small, this, true)),
      m_start(new ActionButton(look, this)),
      m_change(new QPushButton(this)) {
    setObjectName(QStringLiteral("turningControl"));
    m_reason->setObjectName(QStringLiteral("turningLoopReason"));
    m_progress->setObjectName(QStringLiteral("turningProgress"));
    m_setup->setObjectName(QStringLiteral("turningSetupText"));
    m_start->setObjectName(QStringLiteral("turningStart"));
    m_change->setObjectName(QStringLiteral("turningSetup"));
    m_change->setFocusPolicy(Qt::TabFocus);
    m_progress->setRange(0, 100);
    m_progress->setTextVisible(false);
    const auto add = [this](QButtonGroup* group, const QString& name, int id) {
        auto* button = new QPushButton(this);
        button->setObjectName(name);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        group->addButton(button, id);
        return button;
    };
    constexpr std::array<const char*, kTurningControllers> controllers{"turningOpen", "turningPaper", "turningPi",
                                                                       "turningTones"};
    for (int i = 0; i < static_cast<int>(kTurningControllers); ++i) {
        const auto at = static_cast<std::size_t>(i);
        m_controllerButtons[at] = add(m_controllers, QLatin1String(controllers[at]), i);
        m_controllerGrid->addWidget(m_controllerButtons[at], i / 2, i % 2);
    }
    body()->addWidget(m_reason);
    body()->addWidget(m_progress);
    body()->addStretch(1);
    body()->addWidget(m_modes);
    body()->addWidget(m_controllerTitle);
    body()->addLayout(m_controllerGrid);
    body()->addStretch(1);
    body()->addWidget(m_setup);
    m_partRow->addWidget(m_change, 1);
    m_partRow->addWidget(m_start, 1);
    body()->addLayout(m_partRow);
    connect(m_modes, &ModeButtons::modeRequested, this, &TurningControlPanel::modeRequested);
    connect(m_controllers, &QButtonGroup::idClicked, this, [this](int id) {
        showLoop();
        emit controllerRequested(static_cast<TurningController>(id));
    });
    connect(m_start, &QPushButton::clicked, this, &TurningControlPanel::startRequested);
    connect(m_change, &QPushButton::clicked, this, &TurningControlPanel::setupRequested);
    m_start->setPredicate([this] { return whyNotStart(); });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void TurningControlPanel::retranslate() {
    for (std::size_t i = 0; i < m_controllerButtons.size(); ++i) {
        m_controllerButtons[i]->setText(controllerName(static_cast<TurningController>(i)));
    }
    m_controllerTitle->setText(tr("controller"));
    m_start->setText(tr("Start part"));
    m_change->setText(tr("Setup"));
    m_partRow->setSpacing(m_look.metrics().touchGap());
    m_controllerGrid->setSpacing(m_look.metrics().touchGap());
    m_progress->setFixedHeight(m_look.space(Space::Medium));
    setView(m_view);
}

void TurningControlPanel::setView(const TurningServiceView& view) {
    m_view.setup = view.setup;
    m_view.overlap = view.overlap;
    m_view.controller = view.controller;
    m_view.storeProblem = view.storeProblem;
    const UnitSystem& units = m_look.units();
    m_setup->setText(view.storeProblem.empty()
                         ? tr("Next part: %1. Overlap factor %2.")
                               .arg(setupText(view.setup, units), UnitSystem::fixed(view.overlap, 4))
                         : tr("Nothing can be stored at the moment: %1").arg(sentenceText(view.storeProblem, units)));
    showLoop();
}

void TurningControlPanel::setStatus(const Status& status) {
    const LoopStatus& loop = status.loops[static_cast<std::size_t>(ProcessId::Turning)];
    const bool ours = status.programProcess == ProcessId::Turning;
    const QString obstacle =
        startObstacle(status, m_engine.capabilities().cycleStart, ProcessId::Turning, m_look.units());
    const bool same = loop.mode == m_loop.mode && loop.fitted == m_loop.fitted && loop.state == m_loop.state &&
                      loop.reason.text == m_loop.reason.text && status.program == m_program &&
                      status.programProcess == m_programProcess && status.turning.stage == m_stage &&
                      obstacle == m_obstacle;
    m_progress->setValue(
        ours && status.program == ProgramState::Running ? static_cast<int>(100.0 * status.turning.progress) : 0);
    if (same) {
        return;
    }
    m_loop = loop;
    m_program = status.program;
    m_programProcess = status.programProcess;
    m_stage = status.turning.stage;
    m_obstacle = obstacle;
    showLoop();
}

void TurningControlPanel::setSession(OperatorSession& session) {
    m_session = &session;
    m_modes->setSession(session);
    connect(&session, &OperatorSession::changed, this, &TurningControlPanel::showLoop);
    showLoop();
}

void TurningControlPanel::setBusy(bool busy) {
    m_busy = busy;
    showLoop();
}

void TurningControlPanel::showLoop() {
    setTitle(tr("Diamond turning: %1", "stage").arg(stageName(m_stage)));
    m_modes->setLoop(m_loop);
    const bool may = m_session == nullptr || m_session->whyNot(Deed::TurningLaw).isEmpty();  // the mode buttons say who
    for (std::size_t i = 0; i < m_controllerButtons.size(); ++i) {
        m_controllerButtons[i]->setChecked(m_view.controller == static_cast<TurningController>(i));
        m_controllerButtons[i]->setEnabled(m_loop.fitted && !m_busy && may);
    }
    const QString why = sentenceText(m_loop.reason, m_look.units());
    m_reason->setText(m_loop.fitted ? m_modes->words() : tr("This machine has no turning loop: %1").arg(why));
    m_start->setPrimary(m_program != ProgramState::Running);
    m_start->reconsider();
}

QString TurningControlPanel::whyNotStart() const {
    return m_loop.fitted ? m_obstacle : tr("This machine has no turning loop.");
}

}  // namespace kerf::ui
