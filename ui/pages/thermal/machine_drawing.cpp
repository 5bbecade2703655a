// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thermal/machine_drawing.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/widgets/sign.h"

namespace kerf::ui {
namespace {

constexpr double kAspect = 1.15;  ///< width over height
/// x, y, width, height of the castings over the drawing, 0…1.
constexpr std::array kCastings{
    std::array{0.10, 0.885, 0.86, 0.105},  // bed
    std::array{0.64, 0.04, 0.30, 0.845},   // column
    std::array{0.34, 0.17, 0.225, 0.36},   // head
    std::array{0.17, 0.15, 0.17, 0.42},    // spindle with quill
    std::array{0.17, 0.02, 0.17, 0.13},    // motor
    std::array{0.565, 0.10, 0.04, 0.46},   // Z screw
    std::array{0.18, 0.80, 0.42, 0.065},   // saddle
    std::array{0.10, 0.695, 0.42, 0.085},  // table
};

}  // namespace

MachineDrawing::MachineDrawing(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setObjectName(QStringLiteral("thermalDrawing"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MachineDrawing::setSensors(const std::vector<ThermalSensorView>& sensors) {
    if (sensors.size() != m_sensors.size()) {
        m_sensors = sensors;
        update();
    }
}

void MachineDrawing::setStatus(const ThermalStatus& status) {
    if (status.couple != m_states || status.inModel != m_inModel) {
        m_states = status.couple;
        m_inModel = status.inModel;
        update();
    }
}

void MachineDrawing::select(std::optional<std::size_t> sensor) {
    m_selected = sensor;
    update();
}

QSize MachineDrawing::minimumSizeHint() const {
    const int side = look().metrics().chart();
    return {static_cast<int>(side * kAspect), side};
}

QRectF MachineDrawing::area() const {
    const double w = std::min<double>(width(), height() * kAspect);
    const double h = w / kAspect;
    return {(width() - w) / 2.0, (height() - h) / 2.0, w, h};
}

QPointF MachineDrawing::place(std::size_t sensor) const {
    const QRectF box = area();
    return {box.left() + m_sensors[sensor].x * box.width(), box.top() + m_sensors[sensor].y * box.height()};
}

void MachineDrawing::paintMachine(QPainter& painter) const {
    const QRectF box = area();
    painter.setPen(look().pen(Token::Line, Stroke::Normal));
    painter.setBrush(look().color(Token::Raised));
    for (const auto& [x, y, w, h] : kCastings) {
        painter.drawRect(
            QRectF(box.left() + x * box.width(), box.top() + y * box.height(), w * box.width(), h * box.height()));
    }
    // The tool.
    painter.drawRect(QRectF(box.left() + 0.24 * box.width(), box.top() + 0.57 * box.height(), 0.03 * box.width(),
                            0.08 * box.height()));
}

void MachineDrawing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_sensors.empty()) {
        painter.setFont(look().font(TextSize::Body));
        painter.setPen(look().color(Token::Dim));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The thermocouples appear here as soon as the machine reports them."));
        return;
    }
    paintMachine(painter);
    const double r = std::max(look().metrics().stroke(Stroke::Bold), area().width() / 140.0);
    painter.setFont(look().font(TextSize::Label, QFont::Medium));
    for (std::size_t k = 0; k < m_sensors.size(); ++k) {
        const QPointF at = place(k);
        if (isSick(m_states[k])) {
            continue;  // on top, below
        }
        const bool inModel = (m_inModel >> k & 1U) != 0U;
        painter.setPen(look().pen(m_states[k] == CoupleState::Unread ? Token::Line : Token::Dim, Stroke::Thin));
        painter.setBrush(inModel ? look().color(Token::Text) : look().color(Token::Panel));
        painter.drawEllipse(at, r, r);
    }
    for (std::size_t k = 0; k < m_sensors.size(); ++k) {
        if (!isSick(m_states[k])) {
            continue;
        }
        const double sign = 2.4 * r;
        paintSign(painter, QRectF(place(k) - QPointF(sign, sign), QSizeF(2 * sign, 2 * sign)), Sign::Alarm3, look());
        painter.setPen(look().color(Token::Text));
        painter.drawText(place(k) + QPointF(sign * 1.2, sign * 0.6), QString::fromStdString(m_sensors[k].name));
    }
    if (m_selected && *m_selected < m_sensors.size()) {
        painter.setPen(look().pen(Token::Text, Stroke::Normal));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(place(*m_selected), 2.4 * r, 2.4 * r);
    }
}

void MachineDrawing::mousePressEvent(QMouseEvent* event) {
    std::optional<std::size_t> nearest;
    double best = look().metrics().touch() / 2.0;  // a gloved finger
    for (std::size_t k = 0; k < m_sensors.size(); ++k) {
        const QPointF to = place(k) - event->position();
        const double distance = std::hypot(to.x(), to.y());
        if (distance < best) {
            best = distance;
            nearest = k;
        }
    }
    if (nearest) {
        emit sensorTouched(*nearest);
    }
}

}  // namespace kerf::ui
