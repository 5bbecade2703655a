// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/next_part_panel.h"

#include <QGridLayout>
#include <QLabel>

#include "ui/link/texts.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

NextPartPanel::NextPartPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_diameters(new QGridLayout),
      m_feedLabel(makeLabel(TextRole::Small, this)),
      m_feed(makeLabel(TextRole::CardNumber, this)),
      m_why(makeLabel(TextRole::Body, this, true)),
      m_rests(makeLabel(TextRole::Small, this, true)),
      m_change(new QPushButton(this)),
      m_limited(new Lamp(look, this)),
      m_accept(new ActionButton(look, this)),
      m_nextLot(new QPushButton(this)),
      m_loopReason(makeLabel(TextRole::Small, this, true)),
      m_modes(new ModeButtons(look, ProcessId::Boring, this)) {
    setObjectName(QStringLiteral("boringNextPart"));
    m_feed->setObjectName(QStringLiteral("boringNextFeed"));
    m_why->setObjectName(QStringLiteral("boringNextReason"));
    m_rests->setObjectName(QStringLiteral("boringNextRests"));
    m_change->setObjectName(QStringLiteral("boringChange"));
    m_change->setFocusPolicy(Qt::TabFocus);
    m_limited->setObjectName(QStringLiteral("boringNextLimited"));
    m_accept->setObjectName(QStringLiteral("boringAccept"));
    m_nextLot->setObjectName(QStringLiteral("boringNextLot"));
    m_nextLot->setProperty("primary", true);
    m_nextLot->hide();
    m_loopReason->setObjectName(QStringLiteral("boringLoopReason"));

    body()->addLayout(m_diameters);
    body()->addWidget(m_rests);
    body()->addWidget(m_feedLabel);
    body()->addWidget(m_feed);
    body()->addWidget(m_limited);
    body()->addWidget(m_why);
    body()->setSpacing(m_look.space(Space::Hair));
    body()->addStretch(1);
    body()->addWidget(m_change);
    body()->addWidget(m_nextLot);
    body()->addWidget(m_accept);
    connect(m_change, &QPushButton::clicked, this, &NextPartPanel::changeRequested);
    connect(m_nextLot, &QPushButton::clicked, this, &NextPartPanel::lotsRequested);
    body()->addWidget(m_loopReason);
    body()->addWidget(m_modes);

    connect(m_modes, &ModeButtons::modeRequested, this, &NextPartPanel::modeRequested);
    connect(m_accept, &QPushButton::clicked, this, &NextPartPanel::acceptRequested);
    m_accept->setPredicate([this] { return whyNotAccept(); });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void NextPartPanel::retranslate() {
    m_feedLabel->setText(tr("feed, top to bottom of the bore"));
    m_accept->setText(tr("Accept"));
    m_nextLot->setText(tr("Next lot"));
    m_limited->set(Sign::Limited, tr("at limit"));
    m_diameters->setHorizontalSpacing(m_look.space(Space::Large));
    m_diameters->setVerticalSpacing(m_look.space(Space::Small));
    showNext();
    showLoop();
}

void NextPartPanel::setView(const BoringServiceView& view) {
    m_view = view;
    showNext();
}

void NextPartPanel::showNext() {
    const std::uint32_t number = m_view.parts.empty() ? 1 : m_view.parts.back().number + 1;
    const QString lot = QString::fromStdString(m_view.lot);
    const bool over = m_view.lotClosed || lotFull(m_view);
    setTitle(m_view.lotClosed  ? tr("Lot %1 is closed").arg(lot)
             : lotFull(m_view) ? tr("Lot %1 is full: %2 parts").arg(lot).arg(m_view.lotSize)
                               : tr("Next part: %1").arg(number));
    m_nextLot->setVisible(over && m_lotsThere);
    m_accept->setVisible(!over || !m_lotsThere);
    while (m_numbers.size() < m_view.depths.size()) {
        auto* display = new NumberDisplay(m_look, "mm", kDiameterDecimals, TextSize::Card, this);
        display->setObjectName(QStringLiteral("boringNextDiameter%1").arg(m_numbers.size()));
        const int index = static_cast<int>(m_numbers.size());
        m_diameters->addWidget(display, index / 2, index % 2);
        display->show();
        m_numbers.push_back(display);
    }
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        m_numbers[i]->setVisible(i < m_view.depths.size());
        if (i >= m_view.depths.size()) {
            continue;
        }
        m_numbers[i]->setWidest(m_view.targetDiameter_mm);
        m_numbers[i]->setLabel(tr("⌀ %1, expected").arg(depthName(m_view.depths[i])));
        const auto& prediction = i < m_view.nextPrediction.size() ? m_view.nextPrediction[i] : std::nullopt;
        if (prediction) {
            m_numbers[i]->setHalf95(prediction->half95_mm);
            m_numbers[i]->setValue(prediction->diameter_mm);
        } else {
            m_numbers[i]->setNothing();
        }
    }
    const BoringSchedule& next = m_view.nextSchedule;
    const UnitSystem& units = m_look.units();
    m_feed->setText(next.revision == 0
                        ? QStringLiteral("–")
                        : tr("%1 → %2", "feed at the top and at the bottom of the bore")
                              .arg(units.number(next.feed_mmPerRev(next.overhangFrom_mm), "mm/rev", kFeedDecimals),
                                   units.withUnit(next.feed_mmPerRev(next.overhangTo_mm), "mm/rev", kFeedDecimals)));
    m_why->setText(m_view.nextReason.empty() ? QString() : sentenceText(m_view.nextReason, units));
    m_rests->setText(m_view.nextRestsOn.empty() ? QString() : sentenceText(m_view.nextRestsOn, units));
    m_rests->setVisible(!m_rests->text().isEmpty());
    m_change->setText(m_view.announced ? tr("Announced: %1").arg(changeName(*m_view.announced))
                                       : tr("Tool or material changed"));
    m_change->setVisible(!over && number > 1);
    m_limited->setVisible(m_view.nextLimited);
    m_accept->setPrimary(!m_view.scheduleAccepted);
    m_accept->reconsider();
}

void NextPartPanel::setLoop(const LoopStatus& loop) {
    const bool same = loop.mode == m_loop.mode && loop.fitted == m_loop.fitted && loop.state == m_loop.state &&
                      loop.reason.text == m_loop.reason.text;
    m_loop = loop;
    if (!same) {
        showLoop();
    }
}

void NextPartPanel::setBusy(bool busy) {
    m_busy = busy;
    m_accept->reconsider();
}

void NextPartPanel::setLotsThere(bool there) {
    m_lotsThere = there;
    showNext();
}

void NextPartPanel::setSession(OperatorSession& session) {
    m_modes->setSession(session);
    connect(m_modes, &ModeButtons::permissionChanged, this, &NextPartPanel::showLoop);
    showLoop();
}

void NextPartPanel::showLoop() {
    m_modes->setLoop(m_loop);
    const QString why = sentenceText(m_loop.reason, m_look.units());
    m_loopReason->setText(m_loop.fitted ? m_modes->words() : tr("This machine has no boring loop: %1").arg(why));
    m_accept->reconsider();
}

QString NextPartPanel::whyNotAccept() const {
    if (m_busy) {
        return tr("being stored");
    }
    if (m_view.nextSchedule.revision == 0) {
        return tr("no schedule yet");
    }
    switch (m_loop.mode) {
        case LoopMode::Off:
            return tr("the loop is off");
        case LoopMode::Control:
            return tr("in control, every schedule is used by itself");
        case LoopMode::Advise:
            break;
    }
    return m_view.scheduleAccepted ? tr("this schedule is accepted") : QString();
}

}  // namespace kerf::ui
