// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thermal/offset_panel.h"

#include <QLabel>

#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"
#include "ui/pages/thermal/thermal_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

OffsetPanel::OffsetPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_ready(makeLabel(TextRole::CardNumber, this, true)),
      m_reason(makeLabel(TextRole::Small, this, true)),
      m_modes(new ModeButtons(look, ProcessId::Thermal, this)),
      m_numbers(new QHBoxLayout) {
    setObjectName(QStringLiteral("thermalOffsets"));
    m_ready->setObjectName(QStringLiteral("thermalReady"));
    m_reason->setObjectName(QStringLiteral("thermalLoopReason"));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const QString name = QLatin1String(kThermalAxes[axis]);
        m_drift[axis] = new NumberDisplay(look, "um", kDriftDecimals, TextSize::Page, this);
        m_drift[axis]->setObjectName(QStringLiteral("thermalDrift") + name);
        m_drift[axis]->setWidest(-88.8);
        m_shift[axis] = makeLabel(TextRole::Body, this);
        m_shift[axis]->setObjectName(QStringLiteral("thermalShift") + name);
        m_limit[axis] = new Lamp(look, this);
        m_limit[axis]->setObjectName(QStringLiteral("thermalLimited") + name);
        auto* column = new QVBoxLayout;
        column->addWidget(m_drift[axis]);
        column->addWidget(m_shift[axis]);
        column->addWidget(m_limit[axis]);
        m_numbers->addLayout(column, 1);
    }
    body()->addLayout(m_numbers);
    auto* below = new QHBoxLayout;
    auto* words = new QVBoxLayout;
    words->addWidget(m_ready);
    words->addWidget(m_reason);
    below->addLayout(words, 1);
    below->addWidget(m_modes);
    body()->addLayout(below);
    connect(m_modes, &ModeButtons::modeRequested, this, &OffsetPanel::modeRequested);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void OffsetPanel::setSession(OperatorSession& session) {
    m_modes->setSession(session);
    connect(m_modes, &ModeButtons::permissionChanged, this, [this] { show(m_status, m_loop); });
    show(m_status, m_loop);
}

void OffsetPanel::retranslate() {
    setTitle(termText(Term::DriftTitle, m_look.wording()));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_drift[axis]->setLabel(termText(Term::DriftOfAxis, m_look.wording()).arg(QLatin1String(kThermalAxes[axis])));
        m_limit[axis]->set(Sign::Limited, tr("at limit"));
    }
    m_numbers->setSpacing(m_look.space(Space::Large));
    show(m_status, m_loop);
}

void OffsetPanel::setStatus(const ThermalStatus& status, const LoopStatus& loop) {
    show(status, loop);
    m_status = status;
    m_loop = loop;
}

void OffsetPanel::show(const ThermalStatus& status, const LoopStatus& loop) {
    const UnitSystem& units = m_look.units();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (status.stage == ThermalStage::Following) {
            m_drift[axis]->setHalf95(status.half_um[axis]);
            m_drift[axis]->setValue(status.drift_um[axis]);
        } else {
            m_drift[axis]->setHalf95(std::nullopt);
            m_drift[axis]->setNothing();
        }
        m_limit[axis]->setVisible(status.sizeLimited[axis] || status.rateLimited[axis]);
        const Reading& shifted = status.shifted_um[axis];
        QString text =
            shifted.good() ? tr("shifted %1").arg(units.withUnit(shifted.value, "um", 0)) : tr("shift not reported");
        if (shifted.good() && loop.mode != LoopMode::Control && status.stage == ThermalStage::Following) {
            text = tr("shifted %1, would be %2")
                       .arg(units.number(shifted.value, "um", 0), units.withUnit(status.target_um[axis], "um", 0));
        }
        m_shift[axis]->setText(text);
    }
    m_ready->setText(warmUpText(status, units));
    m_modes->setLoop(loop);
    const QString why = sentenceText(loop.reason, units);
    m_reason->setText(loop.fitted ? m_modes->words() : tr("This machine has no thermal loop: %1").arg(why));
}

}  // namespace kerf::ui
