// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/tool_panel.h"

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "ui/link/vocabulary.h"
#include "ui/pages/milling/milling_texts.h"
#include "ui/pages/milling/tool_memory_sheet.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr double kFewestParts = 8.0;

double percentOf(double rise) {
    return 100.0 * (std::exp(rise) - 1.0);
}

}  // namespace

MillingToolPanel::MillingToolPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_chart(new Chart(look, this)),
      m_stiffness(new NumberDisplay(look, "", kStiffnessDecimals, TextSize::Card, this)),
      m_words(makeLabel(TextRole::Small, this, true)),
      m_band(m_chart->addBand(Token::Predicted)),
      m_mean(m_chart->addCurve({Token::Predicted, Chart::Kind::LineAndPoints, Chart::Marker::Disc, Stroke::Normal})) {
    setObjectName(QStringLiteral("millingTool"));
    m_chart->setObjectName(QStringLiteral("millingWearChart"));
    m_stiffness->setObjectName(QStringLiteral("millingStiffness"));
    m_words->setObjectName(QStringLiteral("millingWear"));
    m_stiffness->setWidest(8888.88);
    m_chart->setLowTitles(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_stiffness);
    row->addWidget(m_words, 1);
    body()->addLayout(row);
    body()->addWidget(m_chart, 1);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void MillingToolPanel::retranslate() {
    setTitle(termText(Term::StiffnessTitle, m_look.wording()));
    m_chart->setXAxis(tr("part"), "", true);
    m_chart->setYAxis(termText(Term::StiffnessAxis, m_look.wording()), "");
    m_chart->setEmptyText(tr("The wear of the tool appears here after its first part."));
    m_chart->setAccessibleName(tr("Mean cutting stiffness over the parts cut with this tool"));
    m_stiffness->setLabel(termText(Term::StiffnessNow, m_look.wording()));
    showTrend();
    showWords();
}

void MillingToolPanel::setView(const MillingServiceView& view) {
    m_view = view;
    showTrend();
    showWords();
}

void MillingToolPanel::showTrend() {
    std::vector<QPointF> points;
    std::vector<Chart::BandPoint> band;
    for (const MillingCutView& view : m_view.cuts) {
        if (!view.withThisTool || view.cut.stiffnessMean == 0.0) {
            continue;
        }
        const auto part = static_cast<double>(view.number);
        points.emplace_back(part, view.cut.stiffnessMean);
        band.push_back({part, view.cut.stiffnessMean - view.cut.stiffnessHalf95,
                        view.cut.stiffnessMean + view.cut.stiffnessHalf95});
    }
    std::vector<Chart::Limit> limits;
    if (!points.empty()) {
        const double first = points.front().x();
        m_chart->setXRange(first - 0.5, std::max(points.back().x(), first + kFewestParts) + 0.5);
        const double new_ = m_status.tool.parts > 0 ? m_status.tool.firstStiffness : points.front().y();
        limits.push_back({new_ + m_view.setup.wearWarning, tr("change the tool"), Token::Limit, false, true});
    }
    m_chart->setLimits(std::move(limits));
    m_chart->setBand(m_band, band);
    m_chart->setPoints(m_mean, points);
}

void MillingToolPanel::setStatus(const Status& status) {
    const bool otherTool = m_status.tool.firstStiffness != status.milling.tool.firstStiffness;
    const bool words =
        m_status.partsWithTool != status.milling.partsWithTool || m_status.wear != status.milling.wear || otherTool;
    m_status = status.milling;
    if (m_status.cutting && m_status.stiffnessKnown) {
        m_stiffness->setHalf95(m_status.stiffnessHalf95);
        m_stiffness->setValue(m_status.stiffness);
    } else {
        m_stiffness->setHalf95({});
        m_stiffness->setNothing();
    }
    if (otherTool) {
        showTrend();
    }
    if (words) {
        showWords();
    }
}

void MillingToolPanel::showWords() {
    if (m_status.partsWithTool == 0) {
        const QString rests = toolMemoryText(m_view.memory, m_look.wording());
        m_words->setText(tr("New tool: nothing cut with it yet.") + (rests.isEmpty() ? QString() : u' ' + rests));
        return;
    }
    QString text = tr("Part %1 with this tool, stiffness %2 % above new.", "parts, rise")
                       .arg(m_status.partsWithTool)
                       .arg(UnitSystem::fixed(percentOf(m_status.wear), 0));
    if (m_status.partsWithTool >= 3) {
        text += u' ' + tr("Trend %1 % per part.").arg(UnitSystem::fixed(percentOf(m_status.wearPerPart), 1));
    }
    m_words->setText(text);
}

}  // namespace kerf::ui
