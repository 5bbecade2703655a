// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/speed_chart.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/pages/tapping/tapping_texts.h"

namespace kerf::ui {
namespace {
constexpr double kSideAir = 0.15;  ///< of the shortest and longest hole
}

SpeedChart::SpeedChart(Look& look, QWidget* parent)
    : Chart(look, parent),
      m_tuned(addCurve({Token::Past, Kind::Points, Marker::Ring, Stroke::Normal})),
      m_current(addCurve({Token::Measured, Kind::Points, Marker::Disc, Stroke::Bold})) {
    setObjectName(QStringLiteral("tappingSpeedChart"));
    setLowTitles(true);
    retranslate();
}

void SpeedChart::retranslate() {
    setXAxis(QStringLiteral("s"), "");
    setYAxis(tr("error p-p"), "um");
    setEmptyText(tr("Each speed that has been tuned stands here as a point: error against time per hole."));
    setAccessibleName(tr("Sync error against time per hole, by speed"));
}

void SpeedChart::setView(const TappingServiceView& view) {
    m_points = view.speeds;
    m_allowed_um = view.thread.allowedPp_um;
    std::vector<QPointF> tuned;
    std::vector<QPointF> current;
    double high_um = 0.0;
    for (const TapSpeedPoint& point : m_points) {
        (point.current ? current : tuned).emplace_back(point.hole_s, point.engagedPp_um);
        high_um = std::max(high_um, point.engagedPp_um);
    }
    setPoints(m_tuned, tuned);
    setPoints(m_current, current);
    if (m_points.empty()) {
        setLimits({});
        return;
    }
    // The tolerance shows when it is near; a line far above would flatten the points.
    const bool near = m_allowed_um < 3.0 * high_um;
    setLimits(near ? std::vector<Limit>{{m_allowed_um, tr("allowed"), Token::Limit, false}} : std::vector<Limit>{});
    setYRange(0.0, 1.3 * (near ? std::max(high_um, m_allowed_um) : std::max(high_um, 1.0)));
    setXRange((1.0 - kSideAir) * m_points.front().hole_s, (1.0 + 2.0 * kSideAir) * m_points.back().hole_s);
}

QPointF SpeedChart::at(const TapSpeedPoint& point) const {
    return place({point.hole_s, look().units().of("um").toShown(point.engagedPp_um)});
}

void SpeedChart::drawForeground(QPainter* painter, const QRectF& rect) {
    Chart::drawForeground(painter, rect);
    const QRectF plot = chart()->plotArea();
    painter->save();
    painter->setFont(look().font(TextSize::Label));
    const QFontMetricsF metrics(painter->font());
    const double r = 2.0 * look().metrics().stroke(Stroke::Bold);
    for (const TapSpeedPoint& point : m_points) {
        const QString name = tr("%1 rpm").arg(point.choice.speed_rpm, 0, 'f', 0);
        const double width = metrics.horizontalAdvance(name);
        const QPointF p = at(point);
        const double left = p.x() + r + width > plot.right() ? p.x() - r - width : p.x() + r;
        painter->setPen(look().color(point.current ? Token::Text : Token::Dim));
        painter->drawText(QRectF(left, p.y() - metrics.height(), width, metrics.height()), Qt::AlignLeft, name);
    }
    painter->restore();
}

void SpeedChart::mousePressEvent(QMouseEvent* event) {
    const TapSpeedPoint* nearest = nullptr;
    double least = look().metrics().touch();  // a finger's width
    for (const TapSpeedPoint& point : m_points) {
        const QPointF away = at(point) - event->position();
        const double distance = std::hypot(away.x(), away.y());
        if (distance < least) {
            least = distance;
            nearest = &point;
        }
    }
    if (nearest != nullptr) {
        emit picked(nearest->choice);
    }
}

}  // namespace kerf::ui
