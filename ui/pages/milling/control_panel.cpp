// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/control_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <tuple>

#include "ui/link/start_obstacle.h"
#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"
#include "ui/pages/milling/milling_texts.h"
#include "ui/shell/page.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr std::array<const char*, kMillingLawCount> kLawNames{"millingLawConstant", "millingLawPi", "millingLawModel",
                                                              "millingLawPreview"};

constexpr int kPeriod_ms = 200;

const LoopStatus& loopOf(const Status& status) {
    return status.loops[static_cast<std::size_t>(ProcessId::Milling)];
}

}  // namespace

MillingControlPanel::MillingControlPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_lamp(new Lamp(look, this)),
      m_reason(makeLabel(TextRole::Small, this, true)),
      m_numbers(new QGridLayout),
      m_reference(new NumberDisplay(look, "N", kForceDecimals, TextSize::Card, this)),
      m_margin(new NumberDisplay(look, "", 1, TextSize::Card, this)),
      m_peak(new NumberDisplay(look, "N", kForceDecimals, TextSize::Card, this)),
      m_saved(new NumberDisplay(look, "s", 1, TextSize::Card, this)),
      m_advice(makeLabel(TextRole::Small, this, true)),
      m_lawLabel(makeLabel(TextRole::Small, this)),
      m_laws(new QGridLayout),
      m_teach(new ActionButton(look, this)),
      m_start(new ActionButton(look, this)),
      m_release(new ActionButton(look, this)),
      m_actions(new QGridLayout),
      m_modes(new ModeButtons(look, ProcessId::Milling, this)) {
    setObjectName(QStringLiteral("millingControl"));
    m_lamp->setObjectName(QStringLiteral("millingState"));
    m_reason->setObjectName(QStringLiteral("millingLoopReason"));
    m_reference->setObjectName(QStringLiteral("millingReference"));
    m_margin->setObjectName(QStringLiteral("millingMargin"));
    m_peak->setObjectName(QStringLiteral("millingPeak"));
    m_saved->setObjectName(QStringLiteral("millingSaved"));
    m_advice->setObjectName(QStringLiteral("millingAdvice"));
    m_teach->setObjectName(QStringLiteral("millingTeach"));
    m_start->setObjectName(QStringLiteral("millingStart"));
    m_release->setObjectName(QStringLiteral("millingRelease"));

    header()->addWidget(m_lamp);
    body()->addWidget(m_reason);
    m_numbers->addWidget(m_reference, 0, 0);
    m_numbers->addWidget(m_margin, 0, 1);
    m_numbers->addWidget(m_peak, 1, 0);
    m_numbers->addWidget(m_saved, 1, 1);
    body()->addLayout(m_numbers);
    body()->addWidget(m_advice);
    body()->addStretch(1);
    body()->addWidget(m_lawLabel);
    for (std::size_t i = 0; i < kMillingLawCount; ++i) {
        const auto law = static_cast<MillingLaw>(i);
        auto* button = new ActionButton(look, this);
        button->setObjectName(QLatin1String(kLawNames[i]));
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setPredicate([this, law] { return whyNotLaw(law); });
        connect(button, &QPushButton::clicked, this, [this, law] {
            showLoop();  // the engine says which law is in force, not the touch
            emit lawRequested(law);
        });
        m_laws->addWidget(button, static_cast<int>(i / 2), static_cast<int>(i % 2));
        m_lawButtons[i] = button;
    }
    body()->addLayout(m_laws);
    body()->addWidget(m_teach);
    m_actions->addWidget(m_start, 0, 0);
    m_actions->addWidget(m_release, 0, 1);
    m_actions->setColumnStretch(0, 1);
    m_actions->setColumnStretch(1, 1);
    body()->addLayout(m_actions);
    body()->addWidget(m_modes);

    m_teach->setPredicate([this] { return whyNotTeach(); });
    m_start->setPredicate([this] { return whyNotStart(); });
    m_release->setPredicate([this] { return m_status.milling.stopped ? QString() : tr("Nothing is stopped."); });
    connect(m_teach, &QPushButton::clicked, this, &MillingControlPanel::teachRequested);
    connect(m_start, &QPushButton::clicked, this, &MillingControlPanel::startRequested);
    connect(m_release, &QPushButton::clicked, this, &MillingControlPanel::releaseRequested);
    connect(m_modes, &ModeButtons::modeRequested, this, &MillingControlPanel::modeRequested);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void MillingControlPanel::setSession(OperatorSession& session) {
    for (ActionButton* button : m_lawButtons) {
        allowOnly(button, session, Deed::MillingLaw);
    }
    allowOnly(m_teach, session, Deed::MillingLaw);
    m_modes->setSession(session);
    connect(m_modes, &ModeButtons::permissionChanged, this, &MillingControlPanel::showLoop);
}

void MillingControlPanel::retranslate() {
    m_reference->setLabel(tr("reference force"));
    m_margin->setLabel(termText(Term::ForceGainMargin, m_look.wording()));
    m_peak->setLabel(tr("peak of this cut"));
    m_advising.reset();
    m_lawLabel->setText(tr("Feed law"));
    for (std::size_t i = 0; i < kMillingLawCount; ++i) {
        m_lawButtons[i]->setText(lawName(static_cast<MillingLaw>(i)));
    }
    m_teach->setText(tr("Teach reference from this cut"));
    m_start->setText(tr("Start cut"));
    m_release->setText(tr("Release feed"));
    m_numbers->setHorizontalSpacing(m_look.space(Space::Large));
    m_numbers->setVerticalSpacing(m_look.space(Space::Small));
    for (QGridLayout* grid : {m_laws, m_actions}) {
        grid->setHorizontalSpacing(m_look.metrics().touchGap());
        grid->setVerticalSpacing(m_look.metrics().touchGap());
    }
    setView(m_view);
    showNumbers();
    showLoop();
}

void MillingControlPanel::setView(const MillingServiceView& view) {
    m_view = view;
    setTitle(view.partType.empty() ? tr("Milling") : QString::fromStdString(view.partType));
    m_start->reconsider();
}

void MillingControlPanel::setStatus(const Status& status, const Capabilities& capabilities) {
    const auto key = [](const Status& s) {
        const LoopStatus& loop = loopOf(s);
        return std::tuple(loop.mode, loop.state, loop.reason.text, s.milling.law, s.milling.stopped, s.milling.cutting,
                          s.program, s.partsBlocked, standingObstacle(s));
    };
    const bool changed = key(status) != key(m_status);
    m_status = status;
    m_cycleStart = capabilities.cycleStart;
    if (changed || !m_sinceShown.isValid() || m_sinceShown.elapsed() >= kPeriod_ms) {
        m_sinceShown.start();
        showNumbers();
        showLoop();
    }
}

void MillingControlPanel::showNumbers() {
    const MillingStatus& milling = m_status.milling;
    const auto show = [](NumberDisplay* display, bool known, double value) {
        known ? display->setValue(value) : display->setNothing();
    };
    show(m_reference, milling.setup != 0, milling.reference_N);
    show(m_margin, milling.gainMargin > 0.0, milling.gainMargin);
    show(m_peak, milling.peakForce_N > 0.0, milling.peakForce_N);
    show(m_saved, milling.peakForce_N > 0.0, milling.savedTime_s);
    const bool advising = loopOf(m_status).mode != LoopMode::Control;
    if (advising != m_advising) {
        m_advising = advising;
        m_saved->setLabel(advising ? tr("control would save") : tr("saved so far"));
    }
    QString advice;
    if (milling.overReference_s > 0.05 || milling.stops > 0) {
        advice = tr("%1 s above 110 % of the reference").arg(UnitSystem::fixed(milling.overReference_s, 1));
        if (milling.stops > 0) {
            advice += advising ? tr("; control would have stopped the feed") : tr("; the feed was stopped");
        }
        advice += u'.';
    }
    m_advice->setText(advice);
}

void MillingControlPanel::showLoop() {
    const LoopStatus& loop = loopOf(m_status);
    for (std::size_t i = 0; i < kMillingLawCount; ++i) {
        m_lawButtons[i]->setChecked(m_status.milling.law == static_cast<MillingLaw>(i));
        m_lawButtons[i]->reconsider();
    }
    m_modes->setLoop(loop);
    m_lamp->setState(loop.state);
    const QString why = sentenceText(loop.reason, m_look.units());
    m_reason->setText(loop.fitted ? m_modes->words() : tr("This machine has no milling loop: %1").arg(why));
    m_teach->reconsider();
    m_start->reconsider();
    m_release->setPrimary(m_status.milling.stopped);
    m_release->reconsider();
}

QString MillingControlPanel::whyNotLaw(MillingLaw law) const {
    const Sentence& why = m_status.milling.lawUnavailable[static_cast<std::size_t>(law)];
    return why.empty() ? QString() : sentenceText(why, m_look.units());
}

QString MillingControlPanel::whyNotTeach() const {
    if (m_status.milling.meanForce_N <= 0.0) {
        return tr("No cut to learn from yet.");
    }
    return {};
}

QString MillingControlPanel::whyNotStart() const {
    if (!loopOf(m_status).fitted) {
        return tr("This machine has no milling loop.");
    }
    if (const QString why = startObstacle(m_status, m_cycleStart, ProcessId::Milling, m_look.units()); !why.isEmpty()) {
        return why;
    }
    if (m_status.milling.setup == 0) {
        return tr("No milling setup is loaded.");
    }
    return {};
}

}  // namespace kerf::ui
