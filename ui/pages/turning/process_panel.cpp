// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/process_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "ui/link/vocabulary.h"
#include "ui/units/unit_system.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kDecimals = 4;
constexpr double kEnough = 3.0;
constexpr std::int64_t kProcessPeriod_ns = 200'000'000;
constexpr std::array<const char*, 3> kUnits{"", "N/um", "N/um"};

}  // namespace

ProcessPanel::ProcessPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_grid(new QGridLayout),
      m_foundTitle(makeLabel(TextRole::Small, this)),
      m_lawTitle(makeLabel(TextRole::Small, this)),
      m_excitation(makeLabel(TextRole::Small, this, true)),
      m_traceName(makeLabel(TextRole::Small, this)),
      m_trace(new Sparkline(look, this)),
      m_note(makeLabel(TextRole::Small, this, true)) {
    setObjectName(QStringLiteral("turningProcess"));
    m_excitation->setObjectName(QStringLiteral("turningExcitation"));
    m_note->setObjectName(QStringLiteral("turningProcessNote"));
    m_trace->setObjectName(QStringLiteral("turningTrace"));
    m_grid->addWidget(m_foundTitle, 0, 1);
    m_grid->addWidget(m_lawTitle, 0, 2);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        m_names[at] = makeLabel(TextRole::Dim, this);
        m_found[at] = makeLabel(TextRole::Body, this);
        m_found[at]->setObjectName(QStringLiteral("turningFound%1").arg(i));
        m_law[at] = makeLabel(TextRole::Dim, this);
        m_law[at]->setObjectName(QStringLiteral("turningLaw%1").arg(i));
        m_grid->addWidget(m_names[at], i + 1, 0);
        m_grid->addWidget(m_found[at], i + 1, 1);
        m_grid->addWidget(m_law[at], i + 1, 2);
    }
    m_grid->setColumnStretch(1, 1);
    body()->addLayout(m_grid);
    auto* row = new QHBoxLayout;
    row->addWidget(m_excitation, 3);
    row->addWidget(m_traceName);
    row->addWidget(m_trace, 2);
    body()->addLayout(row);
    body()->addWidget(m_note);
    body()->addStretch(1);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void ProcessPanel::retranslate() {
    setTitle(tr("Cutting process"));
    m_foundTitle->setText(tr("identified, 95 %"));
    m_lawTitle->setText(tr("law"));
    m_grid->setHorizontalSpacing(m_look.space(Space::Medium));
    m_grid->setVerticalSpacing(m_look.space(Space::Hair));
    constexpr std::array kTerms{Term::ForceMemory, Term::ForceOfDepthNow, Term::ForceOfDepthBefore};
    for (std::size_t i = 0; i < kTerms.size(); ++i) {
        const QString unit = m_look.units().of(kUnits[i]).symbol;
        const QString name = termText(kTerms[i], m_look.wording());
        m_names[i]->setText(unit.isEmpty() ? name : name + QStringLiteral(", ") + unit);
    }
    m_traceName->setText(termText(Term::Covariance, m_look.wording()));
    show(m_last);
}

void ProcessPanel::setStatus(const Status& status) {
    if (std::abs(status.machineTime_ns - m_shown_ns) < kProcessPeriod_ns) {
        return;
    }
    m_shown_ns = status.machineTime_ns;
    // Between parts the last one's figures stay.
    if (status.turning.stage != TurningStage::Idle || m_last.activeSetup == 0) {
        m_last = status.turning;
    }
    if (m_last.identification.available && m_last.stage == TurningStage::Cutting && m_last.identification.trace > 0.0) {
        m_trace->push(std::log10(m_last.identification.trace));
    }
    show(m_last);
}

QString ProcessPanel::excitationText(const TurningIdentification& found) const {
    const QString value = UnitSystem::fixed(found.excitation, 1);
    return found.excitation >= kEnough ? tr("excitation %1: enough to learn from").arg(value)
                                       : tr("excitation %1: too little, the values rest").arg(value);
}

void ProcessPanel::show(const TurningStatus& turning) {
    const TurningIdentification& found = turning.identification;
    const std::array<double, 3> law{turning.lawProcess.a1, turning.lawProcess.b0, turning.lawProcess.b1};
    const UnitSystem& units = m_look.units();
    const bool known = found.available && found.half95[1] > 0.0;
    for (std::size_t i = 0; i < law.size(); ++i) {
        m_found[i]->setText(known ? units.number(found.value[i], kUnits[i], kDecimals) + QStringLiteral(" ± ") +
                                        units.difference(found.half95[i], kUnits[i], kDecimals)
                                  : QStringLiteral("–"));
        m_law[i]->setText(units.number(law[i], kUnits[i], kDecimals));
    }
    m_traceName->setVisible(known);
    m_trace->setVisible(known);
    m_excitation->setText(known ? excitationText(found) : QString());
    const auto retuned = static_cast<int>(turning.retuned);
    const bool assumed = !found.available && turning.stage != TurningStage::Idle;
    m_note->setText(assumed ? tr("Identified only with a sensor of the tool's motion; the law assumes its values.")
                            : tr("The law was tuned anew %n time(s): the process had moved.", nullptr, retuned));
    m_note->setVisible(assumed || retuned > 0);
}

}  // namespace kerf::ui
