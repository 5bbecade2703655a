// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/wall_panel.h"

#include <algorithm>

#include "ui/pages/milling/milling_texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr int kWallPeriod_ms = 50;
constexpr double kSettled_mm = 10.0;    // after entry, as waviness is judged
constexpr double kLeastHalf_um = 30.0;  // of the scale
}  // namespace

MillingWallPanel::MillingWallPanel(Look& look, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_chart(new Chart(look, this)),
      m_live(makeLabel(TextRole::Body, this)),
      m_note(makeLabel(TextRole::Small, this, true)),
      m_before(m_chart->addCurve({Token::Past, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_now(m_chart->addCurve({Token::Measured, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})) {
    setObjectName(QStringLiteral("millingWall"));
    m_chart->setObjectName(QStringLiteral("millingWallChart"));
    m_live->setObjectName(QStringLiteral("millingWaviness"));
    m_note->setObjectName(QStringLiteral("millingLastCut"));
    m_chart->setLowTitles(true);
    m_chart->setYIncludes({0.0});
    header()->addWidget(m_live);
    body()->addWidget(m_chart, 1);
    body()->addWidget(m_note);
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void MillingWallPanel::retranslate() {
    setTitle(tr("Wall deviation, %1", "unit").arg(m_look.units().of("um").symbol));
    m_chart->setXAxis(tr("path"), "mm");
    m_chart->setYAxis(tr("deviation"), "um");
    m_chart->setCurveLabel(m_before, tr("cut before"));
    m_chart->setEmptyText(tr("The estimated wall appears here while a part is being cut."));
    m_chart->setAccessibleName(tr("Estimated deviation of the wall along the path"));
    showNote();
}

void MillingWallPanel::setView(const MillingServiceView& view) {
    m_view = view;
    if (view.setup.revision != 0 && (view.setup.from_mm != m_from_mm || view.setup.to_mm != m_to_mm)) {
        m_from_mm = view.setup.from_mm;
        m_to_mm = view.setup.to_mm;
        m_bins = Bins{};
        m_past = Bins{};
        m_chart->setXRange(m_from_mm, m_to_mm);
        showCurves();
    }
    showNote();
}

void MillingWallPanel::showNote() {
    QString note;
    if (!m_view.cuts.empty()) {
        note = cutText(m_view.cuts.back(), m_look.units());
    }
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    m_live->setText(m_waviness_um > 0.0
                        ? tr("waviness %1").arg(m_look.units().withUnit(m_waviness_um, "um", kWallDecimals))
                        : QString());
}

void MillingWallPanel::setStatus(const Status& status) {
    const bool begins = status.milling.cutting && !m_cutting;
    m_cutting = status.milling.cutting;
    if (begins) {
        m_past = m_bins;
        m_bins = Bins{};
    }
    if (m_sinceChart.isValid() && m_sinceChart.elapsed() < kWallPeriod_ms && !begins) {
        return;
    }
    m_sinceChart.start();
    const bool changed = m_waviness_um != status.milling.waviness_um;
    m_waviness_um = status.milling.waviness_um;
    if (changed) {
        showNote();
    }
    if (isVisible() && (m_cutting || m_shownCutting)) {
        m_shownCutting = m_cutting;
        showCurves();
    }
}

void MillingWallPanel::addSamples(std::span<const Sample> samples, bool blind) {
    const double length_mm = m_to_mm - m_from_mm;
    if (length_mm <= 0.0 || blind) {
        return;
    }
    for (const Sample& sample : samples) {
        const double place = (static_cast<double>(sample.path_mm) - m_from_mm) / length_mm;
        if (sample.wallDeviation_um <= 0.0F || place < 0.0 || place > 1.0) {
            continue;
        }
        m_bins[std::min(kBins - 1, static_cast<std::size_t>(place * kBins))] = sample.wallDeviation_um;
    }
}

std::vector<QPointF> MillingWallPanel::pointsOf(const Bins& bins) const {
    std::vector<QPointF> points;
    for (std::size_t i = 0; i < kBins; ++i) {
        if (bins[i]) {
            points.emplace_back(m_from_mm + (m_to_mm - m_from_mm) * (static_cast<double>(i) + 0.5) / kBins,
                                static_cast<double>(*bins[i]));
        }
    }
    return points;
}

// Where the tool is fully in the work: there the scale shows waves of a few µm; entry and exit may leave it.
void MillingWallPanel::fitHeight() {
    std::optional<std::pair<float, float>> range;
    for (const Bins* bins : {&m_past, &m_bins}) {
        const auto first = std::ranges::find_if(*bins, [](const auto& bin) { return bin.has_value(); });
        const auto settled = static_cast<std::ptrdiff_t>(kSettled_mm / (m_to_mm - m_from_mm) * kBins);
        for (auto bin = first; bin != bins->end(); ++bin) {
            if (!*bin || bin - first < settled || bins->end() - bin < 2 * settled) {
                continue;
            }
            range = range ? std::pair(std::min(range->first, **bin), std::max(range->second, **bin))
                          : std::pair(**bin, **bin);
        }
    }
    if (!range) {
        return;
    }
    const double middle_um = 0.5 * static_cast<double>(range->first + range->second);
    const double half_um = std::max(kLeastHalf_um, 0.75 * static_cast<double>(range->second - range->first));
    m_chart->setYRange(std::max(0.0, middle_um - half_um), middle_um + half_um);
}

void MillingWallPanel::showCurves() {
    fitHeight();
    m_chart->setPoints(m_before, pointsOf(m_past));
    m_chart->setPoints(m_now, pointsOf(m_bins));
}

}  // namespace kerf::ui
