// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::ui {

void decimate(std::span<const QPointF> points, double xFrom, double xTo, int columns, QList<QPointF>& out) {
    out.clear();
    if (points.empty() || columns <= 0 || !(xTo > xFrom)) {
        return;
    }
    const auto byX = [](const QPointF& p, double x) { return p.x() < x; };
    auto first = std::lower_bound(points.begin(), points.end(), xFrom, byX);
    auto last = std::lower_bound(first, points.end(), xTo, byX);
    if (first != points.begin()) {
        --first;
    }
    if (last != points.end()) {
        ++last;
    }
    if (last - first <= 4 * static_cast<std::ptrdiff_t>(columns)) {
        out.append(QList<QPointF>(first, last));
        return;
    }
    out.reserve(static_cast<qsizetype>(columns) * 4 + 8);
    const double perColumn = (xTo - xFrom) / columns;
    auto it = first;
    while (it != last) {
        const double column = std::floor((it->x() - xFrom) / perColumn);
        auto low = it;
        auto high = it;
        auto end = it;
        while (end != last && std::floor((end->x() - xFrom) / perColumn) == column) {
            low = end->y() < low->y() ? end : low;
            high = end->y() > high->y() ? end : high;
            ++end;
        }
        std::array order{it, std::min(low, high), std::max(low, high), end - 1};
        auto written = last;
        for (const auto& point : order) {
            if (point != written) {
                out.append(*point);
                written = point;
            }
        }
        it = end;
    }
}

AxisRange roundRange(double from, double to) {
    if (to < from) {
        std::swap(from, to);
    }
    if (!(to > from)) {
        const double half = from == 0.0 ? 0.5 : std::abs(from) * 0.05;
        from -= half;
        to += half;
    }
    // The smallest round step that needs no more than five intervals; three are then the fewest.
    AxisRange range;
    double power = std::pow(10.0, std::floor(std::log10((to - from) / 5.0)));
    for (bool found = false; !found; power *= 10.0) {
        for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
            const double step = factor * power;
            const double first = std::floor(from / step + 1e-9);
            const double last = std::ceil(to / step - 1e-9);
            if (last - first < 5.5) {
                range.from = first * step;
                range.to = last * step;
                range.step = step;
                found = true;
                break;
            }
        }
    }
    range.decimals = 0;
    for (double scaled = range.step; range.decimals < 9 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled;
         scaled *= 10.0) {
        ++range.decimals;
    }
    return range;
}

}  // namespace kerf::ui
