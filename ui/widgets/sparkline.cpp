// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/sparkline.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <utility>

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

void Sparkline::setLimits(const std::optional<Limit>& lower, const std::optional<Limit>& upper) {
    if (lower != m_lower || upper != m_upper) {
        m_lower = lower;
        m_upper = upper;
        update();
    }
}

// The name on the side of its line that is outside the band, out of the course's way.
void Sparkline::paintLimit(QPainter& painter, const Limit& limit, double y, bool nameAbove) const {
    painter.setPen(look().pen(Token::Limit, Stroke::Thin));
    painter.drawLine(QPointF(rect().left(), y), QPointF(rect().right(), y));
    const QFontMetrics metrics(painter.font());
    const double gap = look().metrics().stroke(Stroke::Normal);
    painter.drawText(QPointF(rect().left(), nameAbove ? y - gap - metrics.descent() : y + gap + metrics.ascent()),
                     limit.name);
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
    const double name = QFontMetrics(look().font(TextSize::Label)).height();
    const QRectF area =
        QRectF(rect()).adjusted(dot, dot + (m_upper ? name : 0.0), -dot * 2, -dot - (m_lower ? name : 0.0));
    painter.setPen(look().pen(Token::Line, Stroke::Thin));
    painter.drawLine(QPointF(rect().left(), rect().bottom()), QPointF(rect().right(), rect().bottom()));
    if (m_values.size() < 2) {
        return;
    }
    auto [lowest, highest] = std::ranges::minmax(m_values);
    lowest = m_lower ? std::min(lowest, m_lower->value) : lowest;
    highest = m_upper ? std::max(highest, m_upper->value) : highest;
    const double span = highest - lowest;
    const auto yOf = [&](double value) {
        return area.bottom() - (span > 0.0 ? (value - lowest) / span : 0.5) * area.height();
    };
    painter.setFont(look().font(TextSize::Label));
    for (const auto& [limit, above] : {std::pair(&m_lower, false), std::pair(&m_upper, true)}) {
        if (*limit) {
            paintLimit(painter, **limit, yOf((*limit)->value), above);
        }
    }
    const double step = area.width() / static_cast<double>(m_capacity - 1);
    QPolygonF line;
    line.reserve(static_cast<qsizetype>(m_values.size()));
    double x = area.right() - step * static_cast<double>(m_values.size() - 1);
    for (const double value : m_values) {
        line << QPointF(x, yOf(value));
        x += step;
    }
    painter.setPen(look().pen(Token::Measured, Stroke::Normal));
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look().color(Token::Measured));
    painter.drawEllipse(line.last(), dot, dot);
}

}  // namespace kerf::ui
