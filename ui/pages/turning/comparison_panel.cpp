// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/comparison_panel.h"

#include <QGridLayout>
#include <QLabel>

#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

ComparisonPanel::ComparisonPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_grid(new QGridLayout),
      m_table(new QWidget(this)),
      m_empty(makeLabel(TextRole::Body, this, true)),
      m_archive(new ActionButton(look, this)) {
    setObjectName(QStringLiteral("turningComparison"));
    m_empty->setObjectName(QStringLiteral("turningNoComparison"));
    m_archive->setObjectName(QStringLiteral("turningArchive"));
    m_table->setLayout(m_grid);
    m_grid->setContentsMargins(0, 0, 0, 0);
    for (std::size_t row = 0; row <= kRows; ++row) {
        for (std::size_t column = 0; column < kColumns; ++column) {
            const TextRole role = row == 0 ? TextRole::Small : column == 0 ? TextRole::Dim : TextRole::Body;
            QLabel* cell = makeLabel(role, m_table);
            cell->setObjectName(QStringLiteral("turningComparison%1%2").arg(row).arg(column));
            cell->setAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            m_grid->addWidget(cell, static_cast<int>(row), static_cast<int>(column));
            m_cells[row][column] = cell;
        }
    }
    m_grid->setColumnStretch(0, 1);
    body()->addWidget(m_table);
    body()->addWidget(m_empty);
    body()->addStretch(1);
    body()->addWidget(m_archive);
    m_archive->setPredicate([this] { return m_parts == 0 ? tr("no part is archived yet") : QString(); });
    connect(m_archive, &QPushButton::clicked, this, &ComparisonPanel::archiveWanted);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void ComparisonPanel::retranslate() {
    setTitle(tr("Without and with the loop"));
    m_archive->setText(tr("Archive of parts"));
    m_empty->setText(
        tr("Cut one part in Advise and one in Control with the same setup: the comparison appears here after the "
           "second."));
    m_grid->setHorizontalSpacing(m_look.space(Space::Medium));
    m_grid->setVerticalSpacing(0);
    for (std::size_t row = 1; row <= kRows; ++row) {  // a minus sign may come from a taller font than the words
        m_grid->setRowMinimumHeight(static_cast<int>(row), m_look.metrics().text(TextSize::Body) * 8 / 5);
    }
    show();
}

void ComparisonPanel::setView(const TurningServiceView& view) {
    m_comparison = view.comparison;
    m_parts = view.parts.size();
    m_archive->reconsider();
    show();
}

void ComparisonPanel::show() {
    m_table->setVisible(m_comparison.has_value());
    m_empty->setVisible(!m_comparison.has_value());
    if (!m_comparison) {
        return;
    }
    const TurningComparison& c = *m_comparison;
    const UnitSystem& units = m_look.units();
    const auto fill = [&](std::size_t row, const std::array<QString, kColumns>& texts) {
        for (std::size_t column = 0; column < kColumns; ++column) {
            m_cells[row][column]->setText(texts[column]);
        }
    };
    const auto percent = [](double change) {
        return (change > 0.0 ? QStringLiteral("+") : QString()) + UnitSystem::fixed(change, 1) + QStringLiteral(" %");
    };
    const auto titled = [&](const QString& name, const char* unit) {
        return name + QStringLiteral(", ") + units.of(unit).symbol;
    };
    fill(0,
         {tr("second half"), tr("part %1, open").arg(c.openPart),
          tr("part %1, %2", "number, controller").arg(c.closedPart).arg(controllerName(c.controller)), tr("change")});
    fill(1, {titled(tr("RMS"), "um"), units.number(c.openRms_um, "um", kSurfaceDecimals),
             units.number(c.closedRms_um, "um", kSurfaceDecimals), percent(-c.rms_percent())});
    fill(2, {titled(tr("P-V"), "um"), units.number(c.openPv_um, "um", kSurfaceDecimals),
             units.number(c.closedPv_um, "um", kSurfaceDecimals), percent(-c.pv_percent())});
    fill(3, {titled(tr("mean force"), "N"), units.number(c.openForce_N, "N", kForceDecimals),
             units.number(c.closedForce_N, "N", kForceDecimals), percent(c.force_percent())});
}

}  // namespace kerf::ui
