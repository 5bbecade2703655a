// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/contour_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/pages/tapping/tapping_texts.h"

namespace kerf::ui {
namespace {

constexpr double kAir = 0.1;           ///< of the range, above and below
constexpr double kZoomAir = 0.3;       ///< of the band
constexpr double kFirstNamedAt = 0.6;  ///< depths along the way
constexpr double kLastNamedAt = 1.3;
constexpr double kLeastRange_um = 5;  ///< half, without a tolerance

/// The way out is drawn on behind the way in.
std::vector<QPointF> unfolded(const TapCurve& curve, double depth_rev) {
    std::vector<QPointF> points;
    points.reserve(curve.error_um.size());
    for (std::size_t k = 0; k < curve.error_um.size(); ++k) {
        const auto spindle_rev = static_cast<double>(curve.spindle_rev[k]);
        points.emplace_back(k <= curve.reversal ? spindle_rev : 2.0 * depth_rev - spindle_rev,
                            static_cast<double>(curve.error_um[k]));
    }
    return points;
}

}  // namespace

ContourChart::ContourChart(Look& look, QWidget* parent)
    : Chart(look, parent),
      m_first(addCurve({Token::Past, Kind::Line, Marker::Disc, Stroke::Normal})),
      m_current(addCurve({Token::Measured, Kind::Line, Marker::Disc, Stroke::Bold})),
      m_band(addBand(Token::Limit)) {
    setObjectName(QStringLiteral("tappingContourChart"));
    setLowTitles(true);
    retranslate();
}

void ContourChart::retranslate() {
    setXAxis(tr("rev", "spindle revolutions, on an axis"), "");
    setYAxis(tr("error"), "um");
    setEmptyText(tr("The contour error of the first tap appears here as soon as it is made."));
    setAccessibleName(tr("Contour error over the spindle's way, in and out"));
    show();
}

void ContourChart::setView(const TappingServiceView& view) {
    m_depth_rev = view.choice.depth_rev;
    m_engage_rev = view.engage_rev;
    m_allowed_um = view.thread.allowedPp_um;
    m_worn_um = view.thread.allowedPpWornTap_um;
    m_firstPoints = unfolded(view.first, m_depth_rev);
    m_currentPoints = unfolded(view.current, m_depth_rev);
    show();
}

void ContourChart::show() {
    setPoints(m_first, m_firstPoints);
    setPoints(m_current, m_currentPoints);
    if (m_firstPoints.empty() && m_currentPoints.empty()) {
        setBand(m_band, {});
        setLimits({});
        setMarks({});
        return;
    }
    const std::vector<QPointF>& last = m_currentPoints.empty() ? m_firstPoints : m_currentPoints;
    double low = 0.0;
    double high = 0.0;
    bool any = false;
    for (const QPointF& p : last) {
        if (p.x() < m_engage_rev || p.x() > 2.0 * m_depth_rev - m_engage_rev) {
            continue;
        }
        low = any ? std::min(low, p.y()) : p.y();
        high = any ? std::max(high, p.y()) : p.y();
        any = true;
    }
    const double middle = (low + high) / 2.0;
    const double half = m_allowed_um / 2.0;
    const double from = m_engage_rev;
    const double to = 2.0 * m_depth_rev - m_engage_rev;
    setBand(m_band, {{from, middle - half, middle + half}, {to, middle - half, middle + half}});
    const QString name = tr("6H: %1 p-p").arg(errorText(m_allowed_um, look().units()));
    setLimits({{middle + half, name, Token::Limit, false},
               {middle - half, {}, Token::Limit, false},
               {middle + m_worn_um / 2.0, {}, Token::Limit, true},
               {middle - m_worn_um / 2.0, {}, Token::Limit, true}});
    setMarks({{m_depth_rev, tr("reversal")}});
    low = middle - half;
    high = middle + half;
    if (!m_zoomed) {
        for (const auto* points : {&m_firstPoints, &m_currentPoints}) {
            for (const QPointF& p : *points) {
                low = std::min(low, p.y());
                high = std::max(high, p.y());
            }
        }
    }
    const double air = std::max((high - low) * (m_zoomed ? kZoomAir / 2.0 : kAir), kLeastRange_um);
    setXRange(0.0, 2.0 * m_depth_rev);
    setYRange(low - air, high + air);
}

QString ContourChart::key() const {
    if (m_firstPoints.empty() && m_currentPoints.empty()) {
        return {};
    }
    return m_zoomed ? tr("touch: whole course") : tr("touch: the band alone");
}

void ContourChart::drawForeground(QPainter* painter, const QRectF& rect) {
    Chart::drawForeground(painter, rect);
    name(*painter, m_firstPoints, kFirstNamedAt, Token::Dim, tr("first tap"));
    name(*painter, m_currentPoints, kLastNamedAt, Token::Measured, tr("last tap"));
}

// Beside the curve where it runs level, on the side towards zero.
void ContourChart::name(QPainter& painter, const std::vector<QPointF>& points, double at, Token token,
                        const QString& text) const {
    const auto there = std::ranges::find_if(points, [&](const QPointF& p) { return p.x() >= at * m_depth_rev; });
    if (there == points.end()) {
        return;
    }
    const DisplayUnit y = look().units().of("um");
    const QPointF p = place({there->x(), y.toShown(there->y())});
    const QRectF plot = chart()->plotArea();
    if (p.y() < plot.top() || p.y() > plot.bottom()) {
        return;
    }
    painter.save();
    painter.setFont(look().font(TextSize::Label));
    painter.setPen(look().color(token));
    const QFontMetricsF metrics(painter.font());
    const double gap = look().metrics().stroke(Stroke::Bold);
    const bool below = there->y() >= 0.0;
    const double top =
        std::clamp(below ? p.y() + gap : p.y() - gap - metrics.height(), plot.top(), plot.bottom() - metrics.height());
    painter.drawText(QPointF(p.x(), top + metrics.ascent()), text);
    painter.restore();
}

void ContourChart::mousePressEvent(QMouseEvent*) {
    m_zoomed = !m_zoomed;
    show();
    emit touched();
}

}  // namespace kerf::ui
