// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>
#include <span>

namespace kerf::ui {

/// At most four points per column of [xFrom, xTo): first, lowest, highest, last in their order, so that no peak is lost
/// and the line looks as it would with every point. `points` rise in x; one point either side of the range is kept.
void decimate(std::span<const QPointF> points, double xFrom, double xTo, int columns, QList<QPointF>& out);

struct AxisRange {
    double from{0.0};
    double to{1.0};
    double step{0.2};
    int decimals{1};  ///< the tick labels need
};
/// Widen [from, to] to round ticks (1, 2, 2.5, 5 × 10^k), four to six of them; an empty span is opened around its
/// value.
[[nodiscard]] AxisRange roundRange(double from, double to);

}  // namespace kerf::ui
