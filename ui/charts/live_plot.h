// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/chart.h"

namespace kerf::ui {

/// Curves over time with now at the right edge. Keeps every point of the window; draws decimated ones that keep peaks.
///
/// append() new samples as they come, then advance() once per display tick. The y axis widens at once and narrows only
/// when it has become much too wide.
class LivePlot : public Chart {
    Q_OBJECT
 public:
    /// @param window_s seconds shown
    explicit LivePlot(Look& look, double window_s = 60.0, QWidget* parent = nullptr);

    void setWindow(double window_s);
    void append(CurveId curve, double time_s, double stored);
    /// Move "now" to this time and redraw, if visible.
    void advance(double now_s);
    void clear();
    void setPoints(CurveId curve, const std::vector<QPointF>& points) override;

 protected:
    void rebuild() override;
    void paintLines(QPainter& painter, const QRectF& plot) const override;
    void showEvent(QShowEvent* event) override;

 private:
    void forget(Curve& curve) const;
    void paintLine(QPainter& painter, const QRectF& plot, const Curve& curve) const;

    double m_window_s;
    double m_now_s{0.0};
};

}  // namespace kerf::ui
