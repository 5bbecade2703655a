// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/bore_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <ranges>
#include <vector>

#include "ui/pages/boring/boring_texts.h"

namespace kerf::ui {
namespace {
constexpr std::size_t kParts = 25;
constexpr double kDepthShift = 0.16;  ///< of a part: depths stand beside each other
}  // namespace

BoreChart::BoreChart(Look& look, QWidget* parent) : Chart(look, parent) {
    setObjectName(QStringLiteral("boringBoreChart"));
    for (std::size_t depth = 0; depth < kMaxBoreDepths; ++depth) {
        // The first depth is a disc, the last a ring; between them the line tells.
        m_depthCurves.push_back(addCurve({depth == 0 ? Token::Measured : Token::Text, Kind::LineAndPoints,
                                          depth % 2 == 0 ? Marker::Disc : Marker::Ring, Stroke::Thin}));
    }
    setLowTitles(true);
    retranslate();
}

void BoreChart::retranslate() {
    setXAxis(tr("part"), "", true);
    setYAxis(tr("bore ⌀"), "mm");
    setEmptyText(tr("The bore of each part appears here once its diameter is entered."));
    rebuildCurves();
}

void BoreChart::setView(const BoringServiceView& view) {
    m_view = view;
    rebuildCurves();
}

void BoreChart::rebuildCurves() {
    if (m_view.depths.empty()) {
        return;
    }
    const std::size_t from = m_view.parts.size() > kParts ? m_view.parts.size() - kParts : 0;
    const auto depths = static_cast<double>(m_view.depths.size());
    const auto shift = [depths](std::size_t depth) {
        return (static_cast<double>(depth) - (depths - 1.0) / 2.0) * kDepthShift * 2.0 / std::max(1.0, depths - 1.0);
    };
    m_bars.clear();
    m_beyond.clear();
    m_bad.clear();
    m_changes.clear();
    const double width_mm = m_view.upperTolerance_mm - m_view.lowerTolerance_mm;
    const double lowest_mm = m_view.lowerTolerance_mm - width_mm;
    const double highest_mm = m_view.upperTolerance_mm + width_mm;
    double low_mm = m_view.lowerTolerance_mm - 0.3 * width_mm;
    double high_mm = m_view.upperTolerance_mm + 0.3 * width_mm;
    const auto include = [&](double from_mm, double to_mm) {
        low_mm = std::max(lowest_mm, std::min(low_mm, from_mm));
        high_mm = std::min(highest_mm, std::max(high_mm, to_mm));
    };
    const auto predict = [&](double part, std::size_t depth, const std::optional<DiameterPrediction>& prediction) {
        if (prediction) {
            m_bars.push_back({part + shift(depth), prediction->diameter_mm, prediction->half95_mm});
            include(prediction->diameter_mm - prediction->half95_mm, prediction->diameter_mm + prediction->half95_mm);
        }
    };
    for (std::size_t depth = 0; depth < m_depthCurves.size(); ++depth) {
        std::vector<QPointF> points;
        for (std::size_t i = from; i < m_view.parts.size() && depth < m_view.depths.size(); ++i) {
            const BorePartView& part = m_view.parts[i];
            if (const BoreMeasurementView* m = measurementAt(part, static_cast<std::uint8_t>(depth))) {
                const double x = part.number + shift(depth);
                points.emplace_back(x, std::clamp(m->diameter_mm, lowest_mm, highest_mm));
                include(m->diameter_mm, m->diameter_mm);
                if (m->diameter_mm < lowest_mm || m->diameter_mm > highest_mm) {
                    m_beyond.push_back({x, m->diameter_mm});
                }
                if (const quality::Verdict verdict = boreVerdict(m_view, m->diameter_mm); isBad(verdict)) {
                    m_bad.push_back({x, std::clamp(m->diameter_mm, lowest_mm, highest_mm), verdict});
                }
            } else if (depth < part.predicted.size()) {
                predict(part.number, depth, part.predicted[depth]);
            }
        }
        setPoints(m_depthCurves[depth], points);
    }
    const std::uint32_t last = m_view.parts.empty() ? 0 : m_view.parts.back().number;
    for (std::size_t depth = 0; depth < m_view.nextPrediction.size() && depth < m_view.depths.size(); ++depth) {
        predict(last + 1.0, depth, m_view.nextPrediction[depth]);
    }
    for (std::size_t i = from; i < m_view.parts.size(); ++i) {
        if (m_view.parts[i].perturbed) {
            m_changes.push_back(m_view.parts[i].number);
        }
    }
    const double first = m_view.parts.empty() ? 1.0 : m_view.parts[from].number;
    // Few parts leave room at the right: the chart fills, it does not stretch.
    setXRange(first - 0.5, std::max<double>(last + 1.5, first + 11.5));
    setYRange(low_mm, high_mm);
    const UnitSystem& units = look().units();
    const auto label = [&units](const QString& name, double diameter_mm) {
        return name + u' ' + units.number(diameter_mm, "mm", kDiameterDecimals);
    };
    setLimits({{m_view.upperTolerance_mm, label(tr("upper"), m_view.upperTolerance_mm), Token::Limit, false},
               {m_view.targetDiameter_mm, {}, Token::Wanted, true},
               {m_view.lowerTolerance_mm, label(tr("lower"), m_view.lowerTolerance_mm), Token::Limit, false, true}});
    setAccessibleName(tr("Bore against its tolerance, last 25 parts"));
}

QString BoreChart::key() const {
    QStringList words;
    for (std::size_t depth = 0; depth < m_view.depths.size(); ++depth) {
        words << (depth % 2 == 0 ? QChar(0x25CF) : QChar(0x25CB)) + QString(u' ') + depthName(m_view.depths[depth]);
    }
    words << QChar(0x25C6) + QString(u' ') + tr("expected");
    return words.join(QStringLiteral("   "));
}

QPointF BoreChart::at(double part, double diameter_mm) const {
    const QRectF plot = chart()->plotArea();
    const double shown = look().units().of("mm").toShown(diameter_mm);
    return {plot.left() + (part - xAxis()->min()) / (xAxis()->max() - xAxis()->min()) * plot.width(),
            plot.bottom() - (shown - yAxis()->min()) / (yAxis()->max() - yAxis()->min()) * plot.height()};
}

void BoreChart::drawForeground(QPainter* painter, const QRectF& rect) {
    Chart::drawForeground(painter, rect);
    if (m_view.parts.empty()) {
        return;
    }
    const QRectF plot = chart()->plotArea();
    const double r = look().metrics().stroke(Stroke::Bold) * 2.0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setClipRect(plot.adjusted(-r, -r, r, r));
    for (const Bar& bar : m_bars) {
        const QPointF low = at(bar.part, bar.diameter_mm - bar.half95_mm);
        const QPointF high = at(bar.part, bar.diameter_mm + bar.half95_mm);
        const QPointF middle = at(bar.part, bar.diameter_mm);
        painter->setPen(look().pen(Token::Predicted, Stroke::Normal));
        painter->drawLine(low, high);
        painter->drawLine(low - QPointF(r / 2, 0), low + QPointF(r / 2, 0));
        painter->drawLine(high - QPointF(r / 2, 0), high + QPointF(r / 2, 0));
        painter->setBrush(look().color(Token::Predicted));
        painter->drawPolygon(QPolygonF{middle + QPointF(0, -r), middle + QPointF(r, 0), middle + QPointF(0, r),
                                       middle + QPointF(-r, 0)});
    }
    painter->setFont(look().font(TextSize::Label));
    const QFontMetricsF metrics(painter->font());
    painter->setClipping(false);
    std::vector<QRectF> words;  // no text lies on another one: the newest is written, the sign of the others stays
    const auto free = [&words](const QRectF& box) {
        return std::ranges::none_of(words, [&box](const QRectF& other) { return other.intersects(box); });
    };
    const auto write = [&](const QRectF& box, const QString& word) {
        painter->fillRect(box, look().color(Token::Panel));  // readable where a curve passes behind it
        painter->setPen(look().color(Token::Text));
        painter->drawText(box, Qt::AlignCenter, word);
        words.push_back(box);
    };
    for (const double part : std::views::reverse(m_changes)) {
        const double x = at(part, m_view.targetDiameter_mm).x();
        painter->setPen(look().pen(Token::Dim, Stroke::Thin, Qt::DotLine));
        painter->drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        const double top = plot.top() + metrics.height() * 0.15;
        painter->setPen(Qt::NoPen);
        painter->setBrush(look().color(Token::Text));
        painter->drawPolygon(QPolygonF{QPointF(x, top), QPointF(x + r, top + 1.8 * r), QPointF(x - r, top + 1.8 * r)});
        const QString word = tr("process changed");
        const double width = metrics.horizontalAdvance(word);
        const double left = x + 2.0 * r + width > plot.right() ? x - 2.0 * r - width : x + 2.0 * r;
        const QRectF box(left, plot.top(), width, metrics.height());
        if (free(box)) {
            write(box, word);
        }
    }
    for (const Beyond& beyond : std::views::reverse(m_beyond)) {
        const bool below = beyond.diameter_mm < m_view.targetDiameter_mm;
        const double x = at(beyond.part, m_view.targetDiameter_mm).x();
        const QString value =
            QChar(below ? 0x2193 : 0x2191) + look().units().number(beyond.diameter_mm, "mm", kDiameterDecimals);
        const double side = metrics.horizontalAdvance(value);
        // Depths stand side by side: the one at the left is named at its left.
        const bool left = beyond.part < std::round(beyond.part) && x - 2.0 * r - side > plot.left();
        const QRectF box(left ? x - 2.0 * r - side : std::min(x + 2.0 * r, plot.right() - side),
                         below ? plot.bottom() - metrics.height() : plot.top(), side, metrics.height());
        if (free(box)) {
            write(box, value);
        }
    }
    for (const Bad& bad : std::views::reverse(m_bad)) {
        const QPointF centre = at(bad.part, bad.diameter_mm);
        painter->setPen(
            look().pen(bad.verdict == quality::Verdict::Scrap ? Token::Alarm1 : Token::Alarm2, Stroke::Bold));
        painter->drawLine(centre - QPointF(1.5 * r, 1.5 * r), centre + QPointF(1.5 * r, 1.5 * r));
        painter->drawLine(centre - QPointF(1.5 * r, -1.5 * r), centre + QPointF(1.5 * r, -1.5 * r));
        const QString word = verdictText(bad.verdict);
        const double width = metrics.horizontalAdvance(word);
        const double x =
            centre.x() + 2.0 * r + width > plot.right() ? centre.x() - 2.0 * r - width : centre.x() + 2.0 * r;
        // Beside the mark; where the edge holds the value already, a line nearer to the middle of the chart.
        const double step = bad.diameter_mm > m_view.targetDiameter_mm ? metrics.height() : -metrics.height();
        const double beside = bad.diameter_mm > m_view.targetDiameter_mm ? centre.y() : centre.y() - metrics.height();
        for (int line = 0; line < 3; ++line) {
            const QRectF box(x, beside + line * step, width, metrics.height());
            if (plot.contains(box) && free(box)) {
                write(box, word);
                break;
            }
        }
    }
    painter->restore();
}

void BoreChart::mousePressEvent(QMouseEvent* event) {
    const QRectF plot = chart()->plotArea();
    const double part =
        xAxis()->min() + (event->position().x() - plot.left()) / plot.width() * (xAxis()->max() - xAxis()->min());
    const auto number = static_cast<std::uint32_t>(std::max(0.0, std::round(part)));
    const bool known = std::any_of(m_view.parts.begin(), m_view.parts.end(),
                                   [number](const BorePartView& p) { return p.number == number; });
    emit partTouched(known ? number : 0);
}

}  // namespace kerf::ui
