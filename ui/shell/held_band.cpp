// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/held_band.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/link/release_stop.h"
#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

HeldBand::HeldBand(Look& look, EngineClient& client, QWidget* parent)
    : FaceWidget(look, parent),
      m_client(client),
      m_what(makeLabel(TextRole::Title, this)),
      m_why(new ClampLabel(2, this)),
      m_release(new ActionButton(look, this)) {
    setObjectName(QStringLiteral("heldBand"));
    m_what->setObjectName(QStringLiteral("heldWhat"));
    m_why->setObjectName(QStringLiteral("heldWhy"));
    m_release->setObjectName(QStringLiteral("heldRelease"));
    auto* row = new QHBoxLayout(this);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_what);
    words->addWidget(m_why);
    row->addLayout(words, 1);
    row->addWidget(m_release);
    connect(m_release, &QPushButton::clicked, this, [this] {
        if (m_stopped && m_status.stops[static_cast<std::size_t>(*m_stopped)].slot.kind == StopKind::InWork) {
            emit showRequested(*m_stopped);
        } else if (m_stopped) {
            emit releaseStopRequested(m_status, *m_stopped);
        } else {
            emit releaseHoldRequested(m_status);
        }
    });
    hide();
    refresh();
}

void HeldBand::setStatus(const Status& status) {
    std::optional<ProcessId> stopped;
    if (!status.held) {  // a hold comes first: what is stopped is looked at after it
        stopped = processInWork(status);
        stopped = stopped ? stopped : stoppedProcess(status);
    }
    if (!status.held && !stopped) {
        if (isVisibleTo(parentWidget())) {
            m_since = {};
            m_pressedBy.clear();
            hide();
        }
        return;
    }
    if (!m_since.isValid()) {
        m_since = QDateTime::currentDateTime();
    }
    m_status = status;
    m_stopped = stopped;
    show();
    say();
}

QString HeldBand::what() const {
    if (!m_stopped) {
        return tr("HELD: all loops");
    }
    const bool inWork = m_status.stops[static_cast<std::size_t>(*m_stopped)].slot.kind == StopKind::InWork;
    return inWork ? tr("STOPPED: a tap stands in the hole") : tr("STOPPED: %1").arg(processName(*m_stopped));
}

QString HeldBand::why() const {
    QStringList words;
    if (m_stopped) {
        const StopStatus& stop = m_status.stops[static_cast<std::size_t>(*m_stopped)];
        const AlarmSpec* spec = m_client.engine().alarmSpec(stop.slot.cause);
        words << (spec != nullptr ? alarmText(spec, stop.slot.cause).title : sentenceText(stop.reason, look().units()));
    } else if (m_status.emergencyStop) {
        words << tr("Emergency stop is pressed.");
    } else if (m_status.link != LinkState::Up) {
        words << tr("No link to the machine.");
    } else if (!m_status.machineOn) {
        words << tr("The machine is off.");
    } else if (!m_pressedBy.isEmpty()) {
        words << tr("HOLD ALL was pressed by %1.").arg(m_pressedBy);
    } else {
        words << tr("HOLD ALL was pressed, or the machine was stopped or lost: look at it.");
    }
    words << tr("since %1").arg(m_since.toString(QStringLiteral("HH:mm:ss")));
    return words.join(QStringLiteral("  "));
}

void HeldBand::refresh() {
    const int medium = look().space(Space::Medium);
    layout()->setContentsMargins(2 * medium, medium, 2 * medium, medium);
    layout()->setSpacing(look().metrics().touchGap());
    say();
    FaceWidget::refresh();
}

void HeldBand::say() {
    if (m_since.isValid()) {
        m_what->setText(what());
        m_why->say(why());
    }
    const bool inWork = m_stopped && m_status.stops[static_cast<std::size_t>(*m_stopped)].slot.kind == StopKind::InWork;
    m_release->setText(inWork ? tr("Show") : m_stopped ? tr("Release stop") : tr("Release hold"));
}

void HeldBand::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QColor colour = look().color(Token::Alarm2);
    painter.fillRect(rect(), look().color(Token::Panel));
    painter.fillRect(rect(), look().palette().band(Token::Alarm2));
    painter.fillRect(QRect(0, 0, look().space(Space::Medium), height()), colour);
}

}  // namespace kerf::ui
