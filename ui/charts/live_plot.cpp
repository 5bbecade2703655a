// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/live_plot.h"

#include <algorithm>
#include <limits>

namespace kerf::ui {

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
    const int columns = std::max(50, static_cast<int>(chart()->plotArea().width()));
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Curve& curve : curves()) {
        decimate(curve.points, m_now_s - m_window_s, m_now_s, columns, m_scratch);
        for (QPointF& p : m_scratch) {
            p = {p.x() - m_now_s, unit.toShown(p.y())};
            if (p.x() >= -m_window_s) {
                low = std::min(low, p.y());
                high = std::max(high, p.y());
            }
        }
        curve.series->replace(m_scratch);
    }
    if (low <= high) {
        fitY(low, high, true);
    }
    viewport()->update();
}

}  // namespace kerf::ui
