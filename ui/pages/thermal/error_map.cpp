// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thermal/error_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/pages/thermal/thermal_texts.h"

namespace kerf::ui {

double largestError_um(const ThermalErrorMap& map) {
    double largest = 0.0;
    for (const auto& error_um : map.error_um) {
        for (const double value_um : error_um) {
            largest = std::max(largest, std::abs(value_um));
        }
    }
    return largest;
}

ErrorMap::ErrorMap(Look& look, std::size_t axis, QWidget* parent) : FaceWidget(look, parent), m_axis(axis) {
    setObjectName(QStringLiteral("thermalErrorMap%1").arg(QLatin1String(kThermalAxes[axis])));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ErrorMap::setMap(const ThermalErrorMap& map, double scale_um) {
    m_map = map;
    m_scale_um = scale_um;
    update();
}

QSize ErrorMap::minimumSizeHint() const {
    const QFontMetrics label(look().font(TextSize::Label));
    return {3 * label.horizontalAdvance(QStringLiteral("−88.8")) + 2 * look().space(Space::Large),
            look().metrics().chart() + 2 * label.height()};
}

void ErrorMap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QFontMetricsF label(look().font(TextSize::Label));
    painter.setFont(look().font(TextSize::Label));
    painter.setPen(look().color(Token::Text));
    const UnitSystem& units = look().units();
    painter.drawText(QRectF(0, 0, width(), label.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("error in %1, %2").arg(QLatin1String(kThermalAxes[m_axis]), units.of("um").symbol));
    if (!m_map.known || m_map.columns == 0 || m_map.rows == 0) {
        return;
    }
    const QRectF plot(0, label.height() * 1.2, width(), height() - label.height() * 2.6);
    const double w = plot.width() / m_map.columns;
    const double h = plot.height() / m_map.rows;
    const auto value = [&](std::uint32_t column, std::uint32_t row) {
        return m_map.error_um[row * m_map.columns + column][m_axis];
    };
    const auto box = [&](std::uint32_t column, std::uint32_t row) {
        // Whole pixels: neighbours neither overlap nor leave a gap.
        const QPointF topLeft(std::round(plot.left() + column * w), std::round(plot.bottom() - (row + 1) * h));
        return QRectF(topLeft,
                      QPointF(std::round(plot.left() + (column + 1) * w), std::round(plot.bottom() - row * h)));
    };
    for (std::uint32_t row = 0; row < m_map.rows; ++row) {
        for (std::uint32_t column = 0; column < m_map.columns; ++column) {
            QColor shade = look().color(Token::Predicted);
            shade.setAlphaF(static_cast<float>(0.6 * std::min(1.0, std::abs(value(column, row)) / m_scale_um)));
            painter.fillRect(box(column, row), shade);
        }
    }
    painter.setPen(look().pen(Token::Line, Stroke::Thin));
    painter.drawRect(plot);
    painter.setPen(look().color(Token::Text));
    const double margin = look().space(Space::Small);
    const auto figure = [&](std::uint32_t column, std::uint32_t row, Qt::Alignment where) {
        painter.drawText(plot.adjusted(margin, margin, -margin, -margin), static_cast<int>(where),
                         units.number(value(column, row), "um", kDriftDecimals));
    };
    figure(0, 0, Qt::AlignLeft | Qt::AlignBottom);
    figure(m_map.columns - 1, 0, Qt::AlignRight | Qt::AlignBottom);
    figure(0, m_map.rows - 1, Qt::AlignLeft | Qt::AlignTop);
    figure(m_map.columns - 1, m_map.rows - 1, Qt::AlignRight | Qt::AlignTop);
    figure(m_map.columns / 2, m_map.rows / 2, Qt::AlignCenter);
    painter.setPen(look().color(Token::Dim));
    painter.drawText(
        QRectF(0, plot.bottom(), width(), height() - plot.bottom()), Qt::AlignCenter,
        tr("X 0 to %1, Y 0 to %2")
            .arg(units.number(m_map.range_mm[0].second, "mm", 0), units.withUnit(m_map.range_mm[1].second, "mm", 0)));
}

}  // namespace kerf::ui
