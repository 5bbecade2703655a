// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/sign.h"

#include <QPainter>
#include <QPolygonF>
#include <cmath>
#include <numbers>

namespace kerf::ui {
namespace {

QPolygonF polygon(const QRectF& box, int corners, double turn) {
    QPolygonF shape;
    for (int i = 0; i < corners; ++i) {
        const double angle = (2.0 * i / corners + turn) * std::numbers::pi;
        shape << box.center() + QPointF(std::sin(angle), -std::cos(angle)) * box.width() * 0.5;
    }
    return shape;
}

void paintAlarm(QPainter& painter, const QPolygonF& shape, Token token, const Look& look, const QRectF& box) {
    const QColor area = look.color(token);
    painter.setPen(QPen(look.color(Token::Text), look.metrics().stroke(Stroke::Thin)));
    painter.setBrush(area);
    painter.drawPolygon(shape);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Palette::on(area));
    const double w = box.width();  // an exclamation mark, drawn: fonts differ
    const QPointF c = shape.boundingRect().center();
    painter.drawRect(QRectF(c.x() - w * 0.05, c.y() - w * 0.20, w * 0.10, w * 0.27));
    painter.drawRect(QRectF(c.x() - w * 0.05, c.y() + w * 0.13, w * 0.10, w * 0.10));
}

}  // namespace

Sign signOf(LoopState state) {
    switch (state) {
        case LoopState::Off:
            return Sign::Off;
        case LoopState::Advising:
            return Sign::Advising;
        case LoopState::Controlling:
            return Sign::Controlling;
        case LoopState::Limited:
            return Sign::Limited;
        case LoopState::Held:
            return Sign::Held;
        case LoopState::Faulted:
            return Sign::Alarm1;
    }
    return Sign::None;
}

Sign signOfAlarm(int priority) {
    return priority <= 1 ? Sign::Alarm1 : priority == 2 ? Sign::Alarm2 : Sign::Alarm3;
}

void paintSign(QPainter& painter, const QRectF& box, Sign sign, const Look& look) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double w = box.width();
    const double bold = look.metrics().stroke(Stroke::Bold);
    const QRectF inner = box.adjusted(bold / 2, bold / 2, -bold / 2, -bold / 2);
    switch (sign) {
        case Sign::None:
            break;
        case Sign::Off:
            painter.setPen(QPen(look.color(Token::Dim), bold));
            painter.drawLine(QPointF(box.left() + w * 0.15, box.center().y()),
                             QPointF(box.right() - w * 0.15, box.center().y()));
            break;
        case Sign::Advising:
            painter.setPen(QPen(look.color(Token::Acting), bold));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(inner);
            break;
        case Sign::Up:
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.color(Token::Dim));
            painter.drawEllipse(box.adjusted(w * 0.15, w * 0.15, -w * 0.15, -w * 0.15));
            break;
        case Sign::Controlling:
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.color(Token::Acting));
            painter.drawEllipse(box);
            break;
        case Sign::Limited:
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.color(Token::Acting));
            painter.drawEllipse(box.adjusted(w * 0.12, w * 0.24, -w * 0.12, 0));
            painter.setBrush(look.color(Token::Limit));
            painter.drawRect(QRectF(box.left(), box.top(), w, w * 0.14));
            break;
        case Sign::Held:
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.color(Token::Text));
            painter.drawRect(QRectF(box.left() + w * 0.16, box.top() + w * 0.1, w * 0.24, w * 0.8));
            painter.drawRect(QRectF(box.left() + w * 0.60, box.top() + w * 0.1, w * 0.24, w * 0.8));
            break;
        case Sign::Alarm1:
            paintAlarm(painter, polygon(box, 8, 0.125), Token::Alarm1, look, box);
            break;
        case Sign::Alarm2: {
            const QPolygonF triangle{QPointF(box.center().x(), box.top()), box.bottomRight(), box.bottomLeft()};
            paintAlarm(painter, triangle, Token::Alarm2, look, box.translated(0, w * 0.1));
            break;
        }
        case Sign::Alarm3:
            paintAlarm(painter, polygon(box, 4, 0.0), Token::Alarm3, look, box);
            break;
    }
    painter.restore();
}

}  // namespace kerf::ui
