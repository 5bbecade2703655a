// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/live_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::ui {
namespace {
constexpr int kColumn = 2;  ///< pixels that share one lowest and highest value
}

LivePlot::LivePlot(Look& look, double window_s, QWidget* parent) : Chart(look, parent), m_window_s(window_s) {
    setWindow(window_s);
}

void LivePlot::setWindow(double window_s) {
    m_window_s = window_s;
    setXRange(-window_s, 0.0);
    rebuild();
}

void LivePlot::append(CurveId curve, double time_s, double stored) {
    std::vector<QPointF>& points = curves()[curve].points;
    if (!points.empty() && time_s < points.back().x()) {
        points.clear();  // the clock went back: another machine, another start
    }
    points.emplace_back(time_s, stored);
}

void LivePlot::advance(double now_s) {
    m_now_s = now_s;
    for (Curve& curve : curves()) {
        forget(curve);
    }
    if (isVisible()) {
        rebuild();
    }
}

void LivePlot::clear() {
    for (Curve& curve : curves()) {
        curve.points.clear();
    }
    rebuild();
}

void LivePlot::setPoints(CurveId curve, const std::vector<QPointF>& points) {
    curves()[curve].points = points;
    rebuild();
}

void LivePlot::showEvent(QShowEvent* event) {
    Chart::showEvent(event);
    rebuild();
}

// Old points go in blocks, so that the vector is moved rarely.
void LivePlot::forget(Curve& curve) const {
    constexpr std::ptrdiff_t kBlock = 4096;
    const double oldest_s = m_now_s - m_window_s;
    const auto first = std::lower_bound(curve.points.begin(), curve.points.end(), oldest_s,
                                        [](const QPointF& p, double t) { return p.x() < t; });
    if (first - curve.points.begin() > kBlock) {
        curve.points.erase(curve.points.begin(), first - 1);
    }
}

void LivePlot::rebuild() {
    const DisplayUnit unit = look().units().of(yUnit());
    const int columns = std::max(50, static_cast<int>(chart()->plotArea().width()) / kColumn);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (Curve& curve : curves()) {
        decimate(curve.points, m_now_s - m_window_s, m_now_s, columns, curve.shown);
        for (QPointF& p : curve.shown) {
            p = {p.x() - m_now_s, unit.toShown(p.y())};
            if (p.x() >= -m_window_s) {
                low = std::min(low, p.y());
                high = std::max(high, p.y());
            }
        }
    }
    if (low <= high) {
        fitY(low, high, true);
    }
    viewport()->update();
}

void LivePlot::paintLines(QPainter& painter, const QRectF& plot) const {
    painter.save();
    painter.setClipRect(plot);
    for (const Curve& curve : curves()) {
        if (curve.style.kind != Kind::Points) {
            paintLine(painter, plot, curve);
        }
    }
    painter.restore();
}

// A noisy signal fills whole columns from its lowest to its highest value: they are filled as rectangles, as an
// oscilloscope draws them, which costs a tenth of stroking the zigzag. Where it is quiet a smooth line is drawn.
void LivePlot::paintLine(QPainter& painter, const QRectF& plot, const Curve& curve) const {
    const double width = look().metrics().stroke(curve.style.stroke);
    const double tall = 3.0 * width;
    const bool dashed = curve.style.kind == Kind::Dashed;
    const QPen pen = look().pen(curve.style.token, curve.style.stroke, dashed ? Qt::DashLine : Qt::SolidLine);
    const QColor color = look().color(curve.style.token);
    painter.setPen(pen);
    QPolygonF smooth;
    const auto flush = [&painter, &smooth] {
        if (smooth.size() > 1) {
            painter.drawPolyline(smooth);
        }
        smooth.clear();
    };
    const QList<QPointF>& points = curve.shown;
    for (qsizetype i = 0; i < points.size();) {
        const QPointF first = place(points[i]);
        const double column = std::floor((first.x() - plot.left()) / kColumn);
        double low = first.y();
        double high = first.y();
        QPointF last = first;
        for (; i < points.size(); ++i) {
            const QPointF at = place(points[i]);
            if (std::floor((at.x() - plot.left()) / kColumn) != column) {
                break;
            }
            low = std::min(low, at.y());
            high = std::max(high, at.y());
            last = at;
        }
        if (high - low <= tall) {
            smooth << last;
        } else {
            if (!smooth.isEmpty()) {  // the column reaches to where the line before it ended: no gap, no stroke
                low = std::min(low, smooth.last().y());
                high = std::max(high, smooth.last().y());
            }
            flush();
            const double left = plot.left() + column * kColumn;
            painter.fillRect(QRectF(left, low - width / 2, kColumn, high - low + width).toAlignedRect(), color);
            smooth << last;
        }
    }
    flush();
}

}  // namespace kerf::ui
