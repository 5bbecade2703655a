// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/sparkline.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace kerf::ui {

Sparkline::Sparkline(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void Sparkline::push(double value) {
    if (!std::isfinite(value)) {
        return;
    }
    // A full line of one value looks the same with another of it: nothing is painted that did not change.
    const bool same = m_values.size() == m_capacity &&
                      std::all_of(m_values.begin(), m_values.end(), [value](double other) { return other == value; });
    m_values.push_back(value);
    while (m_values.size() > m_capacity) {
        m_values.pop_front();
    }
    if (!same) {
        update();
    }
}

void Sparkline::setValues(const std::vector<double>& values) {
    if (std::ranges::equal(m_values, values)) {
        return;
    }
    m_values.assign(values.begin(), values.end());
    m_capacity = std::max<std::size_t>(2, values.size());
    update();
}

void Sparkline::clear() {
    m_values.clear();
    update();
}

QSize Sparkline::sizeHint() const {
    return {look().px(40.0), look().metrics().sparkline()};
}

QSize Sparkline::minimumSizeHint() const {
    return {look().px(20.0), look().metrics().sparkline()};
}

void Sparkline::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double dot = look().metrics().stroke(Stroke::Bold);
    const QRectF area = QRectF(rect()).adjusted(dot, dot, -dot * 2, -dot);
    painter.setPen(look().pen(Token::Line, Stroke::Thin));
    painter.drawLine(QPointF(rect().left(), rect().bottom()), QPointF(rect().right(), rect().bottom()));
    if (m_values.size() < 2) {
        return;
    }
    const auto [lowest, highest] = std::minmax_element(m_values.begin(), m_values.end());
    const double span = *highest - *lowest;
    const double step = area.width() / static_cast<double>(m_capacity - 1);
    QPolygonF line;
    line.reserve(static_cast<qsizetype>(m_values.size()));
    double x = area.right() - step * static_cast<double>(m_values.size() - 1);
    for (const double value : m_values) {
        const double share = span > 0.0 ? (value - *lowest) / span : 0.5;
        line << QPointF(x, area.bottom() - share * area.height());
        x += step;
    }
    painter.setPen(look().pen(Token::Measured, Stroke::Normal));
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look().color(Token::Measured));
    painter.drawEllipse(line.last(), dot, dot);
}

}  // namespace kerf::ui
