// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/spectrum_chart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/pages/turning/turning_texts.h"
#include "ui/widgets/sign.h"

namespace kerf::ui {
namespace {

constexpr double kLeast_Hz = 150.0;
constexpr double kMost_Hz = 420.0;
constexpr double kBeyondTone = 1.2;
constexpr double kRound_Hz = 50.0;
constexpr double kHeadroom = 1.5;  // the names of the tones stand above the peaks
constexpr int kRows = 4;

}  // namespace

SpectrumChart::SpectrumChart(Look& look, QWidget* parent)
    : Chart(look, parent),
      m_untreated(addCurve({Token::Past, Kind::Line, Marker::Disc, Stroke::Normal})),
      m_treated(addCurve({Token::Predicted, Kind::Line, Marker::Disc, Stroke::Bold})) {
    setLowTitles(true);
    retranslate();
}

void SpectrumChart::retranslate() {
    setXAxis(QStringLiteral("Hz"), "");
    setYAxis(tr("amplitude"), "um");
    setCurveLabel(m_untreated, tr("without the trim"));
    setCurveLabel(m_treated, tr("predicted surface"));
    setEmptyText(tr("The spectrum of the surface appears here after two seconds of cutting."));
    setAccessibleName(tr("Spectrum of the predicted surface"));
}

void SpectrumChart::setSpectrum(const TurningSpectrum& spectrum) {
    m_spectrum = spectrum;
    const auto pointsOf = [&](const std::vector<float>& lines) {
        std::vector<QPointF> points;
        points.reserve(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) {
            points.emplace_back(static_cast<double>(i) * spectrum.step_Hz, static_cast<double>(lines[i]));
        }
        return points;
    };
    fitRanges();
    setPoints(m_untreated, pointsOf(spectrum.untreated_um));
    setPoints(m_treated, pointsOf(spectrum.treated_um));
}

void SpectrumChart::setTones(std::vector<TurningTone> tones) {
    std::sort(tones.begin(), tones.end(),
              [](const TurningTone& a, const TurningTone& b) { return a.frequency_Hz < b.frequency_Hz; });
    m_tones = std::move(tones);
    fitRanges();
    viewport()->update();
}

void SpectrumChart::fitRanges() {
    double most_Hz = kLeast_Hz;
    for (const TurningTone& tone : m_tones) {
        most_Hz = std::max(most_Hz, tone.frequency_Hz * kBeyondTone);
    }
    most_Hz = std::min(kMost_Hz, std::ceil(most_Hz / kRound_Hz) * kRound_Hz);
    setXRange(0.0, most_Hz);
    double most_um = 0.0;
    for (const auto* lines : {&m_spectrum.untreated_um, &m_spectrum.treated_um}) {
        for (const float line : *lines) {
            most_um = std::max(most_um, static_cast<double>(line));
        }
    }
    if (most_um > 0.0) {
        setYRange(0.0, most_um * kHeadroom);
    }
}

QString SpectrumChart::axesText() const {
    return tr("amplitude, %1, over frequency, Hz", "unit").arg(look().units().of("um").symbol);
}

QString SpectrumChart::toneLabel(const TurningTone& tone) const {
    const QString frequency = UnitSystem::fixed(tone.frequency_Hz, kToneDecimals);
    return tone.blind ? tr("%1 blind", "frequency in Hz").arg(frequency) : frequency;
}

void SpectrumChart::paintLines(QPainter& painter, const QRectF& plot) const {
    if (m_spectrum.empty()) {
        return;
    }
    painter.setFont(look().font(TextSize::Label));
    const QFontMetricsF metrics(painter.font());
    const double height = metrics.height();
    const double gap = look().space(Space::Small);
    std::vector<QRectF> taken;
    for (const TurningTone& tone : m_tones) {
        const double x = place({tone.frequency_Hz, 0.0}).x();
        if (x < plot.left() || x > plot.right()) {
            continue;
        }
        const QString label = toneLabel(tone);
        const double sign = tone.blind ? height : 0.0;
        const double width = metrics.horizontalAdvance(label) + sign;
        const double left = std::clamp(x - width / 2.0, plot.left(), plot.right() - width);
        QRectF box(left, plot.top(), width, height);
        for (int row = 1; row < kRows; ++row) {
            const bool free = std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) {
                return other.adjusted(-gap, 0.0, gap, 0.0).intersects(box);
            });
            if (free) {
                break;
            }
            box.moveTop(plot.top() + row * height);
        }
        taken.push_back(box);
        painter.setPen(look().pen(Token::Dim, Stroke::Thin, Qt::DotLine));
        painter.drawLine(QPointF(x, box.bottom()), QPointF(x, plot.bottom()));
        if (tone.blind) {
            paintSign(painter, QRectF(box.left(), box.top(), height, height).adjusted(1, 1, -1, -1), Sign::Alarm3,
                      look());
        }
        painter.setFont(look().font(TextSize::Label));
        painter.setPen(look().color(Token::Text));
        painter.drawText(box.adjusted(sign, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, label);
    }
}

}  // namespace kerf::ui
