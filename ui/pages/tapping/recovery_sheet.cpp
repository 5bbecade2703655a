// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/recovery_sheet.h"

#include <cmath>

#include "ui/link/start_obstacle.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr double kDegreesPerTurn = 360.0;
}

RecoverySheet* RecoverySheet::open(SheetHost& host, Look& look, TappingService& service, EngineClient& client,
                                   std::function<void()> gone) {
    Sheet* sheet = host.open({});
    auto* content = new RecoverySheet(*sheet, look, service, client, std::move(gone));
    sheet->body()->addWidget(content);
    return content;
}

RecoverySheet::RecoverySheet(Sheet& sheet, Look& look, TappingService& service, EngineClient& client,
                             std::function<void()> gone)
    : FaceWidget(look, &sheet),
      m_sheet(sheet),
      m_service(service),
      m_client(client),
      m_where(makeLabel(TextRole::Body, this, true)),
      m_what(makeLabel(TextRole::Body, this, true)),
      m_state(makeLabel(TextRole::CardNumber, this, true)),
      m_turn(new ActionButton(look)) {
    setObjectName(QStringLiteral("tappingRecovery"));
    m_where->setObjectName(QStringLiteral("recoveryWhere"));
    m_what->setObjectName(QStringLiteral("recoveryWhat"));
    m_state->setObjectName(QStringLiteral("recoveryState"));
    m_turn->setObjectName(QStringLiteral("recoveryTurn"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_where);
    column->addWidget(m_what);
    column->addWidget(m_state);
    m_close = sheet.addButton(QString(), {});
    m_close->setObjectName(QStringLiteral("recoveryClose"));
    m_gone = sheet.addButton(QString(), std::move(gone));
    m_gone->setObjectName(QStringLiteral("recoveryGone"));
    m_turn->setPrimary(true);
    m_turn->setPredicate([this] { return whyNotTurn(); });
    sheet.addButton(
        m_turn,
        [this] {
            m_asked = true;
            m_service.recover();
        },
        false);
    connect(&client, &EngineClient::statusChanged, this, &RecoverySheet::onStatus);
    refresh();
}

QString RecoverySheet::whyNotTurn() const {
    const Status& status = m_client.status();
    if (m_step != Step::Ready) {
        return m_step == Step::Turning ? tr("the tap is turning out") : tr("the tap is out");
    }
    if (const QString why = machineObstacle(status); !why.isEmpty()) {
        return why;
    }
    return status.loops[static_cast<std::size_t>(ProcessId::Tapping)].mode == LoopMode::Control
               ? QString()
               : tr("switch tapping to control");
}

void RecoverySheet::onStatus(const Status& status) {
    const TapPhase phase = status.tapping.phase;
    if (phase == TapPhase::Retracting) {
        m_step = Step::Turning;
    } else if (phase == TapPhase::InHole) {
        m_step = Step::Ready;
    } else if (m_asked || m_step == Step::Turning) {
        m_step = Step::Out;
    }
    show();
}

void RecoverySheet::refresh() {
    FaceWidget::refresh();
    layout()->setSpacing(look().space(Space::Large));
    show();
}

void RecoverySheet::show() {
    const TappingStatus& tapping = m_client.status().tapping;
    const UnitSystem& units = look().units();
    const double turn = tapping.stoppedSpindle_rev - std::floor(tapping.stoppedSpindle_rev);
    m_sheet.setTitle(tr("A tap stands in the hole"));
    m_where->setText(
        tr("Where: %1 revolutions in, %2 deep; the spindle stands %3° after a whole turn. Both are stored.")
            .arg(UnitSystem::fixed(tapping.stoppedSpindle_rev, 2), units.withUnit(tapping.stoppedZ_mm, "mm", 3),
                 UnitSystem::fixed(kDegreesPerTurn * turn, 0)));
    m_what->setText(tr("What will happen: the accepted gains are set, then the spindle turns back %1 revolutions and Z "
                       "follows it at %2 per revolution until the tap is out. No other axis moves. Do not jog Z or the "
                       "spindle alone: it breaks the tap.")
                        .arg(UnitSystem::fixed(tapping.stoppedSpindle_rev, 2),
                             units.withUnit(m_service.view().thread.pitch_mm, "mm", 3)));
    switch (m_step) {
        case Step::Ready: {
            const QString why = whyNotTurn();
            m_state->setText(why.isEmpty() ? tr("Ready. Keep a hand at the emergency stop.")
                                           : tr("Not ready: %1.").arg(why));
            break;
        }
        case Step::Turning:
            m_state->setText(
                tr("Turning out: %1 revolutions to go.").arg(UnitSystem::fixed(std::max(0.0, tapping.spindle_rev), 1)));
            break;
        case Step::Out:
            m_state->setText(tr("The tap is out. Gauge the thread and look at the tap before the next one."));
            break;
    }
    m_close->setText(m_step == Step::Out ? tr("Close") : tr("Leave it in the hole"));
    m_gone->setText(tr("The tap is gone"));
    m_gone->setVisible(m_step == Step::Ready);
    m_turn->setText(tr("Turn out in sync"));
    m_turn->reconsider();
}

}  // namespace kerf::ui
