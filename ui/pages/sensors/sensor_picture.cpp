// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/sensors/sensor_picture.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace kerf::ui {

SensorPicture::SensorPicture(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setObjectName(QStringLiteral("sensorPicture"));
    refresh();
}

void SensorPicture::setPicture(const QString& file) {
    if (file != m_file) {
        m_file = file;
        m_picture = file.isEmpty() ? QPixmap() : QPixmap(file);
        update();
    }
}

void SensorPicture::setChannels(const std::vector<SensorChannelView>& channels) {
    m_channels = channels;
    update();
}

void SensorPicture::select(std::optional<std::size_t> channel) {
    m_selected = channel;
    update();
}

QSize SensorPicture::minimumSizeHint() const {
    return {look().metrics().chart(), look().metrics().chart()};
}

QRectF SensorPicture::area() const {
    if (m_picture.isNull()) {
        return rect();
    }
    const QSizeF size = QSizeF(m_picture.size()).scaled(this->size(), Qt::KeepAspectRatio);
    return {QPointF((width() - size.width()) / 2.0, (height() - size.height()) / 2.0), size};
}

void SensorPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF box = area();
    if (m_picture.isNull()) {
        painter.setPen(look().pen(Token::Line, Stroke::Thin));
        painter.setBrush(look().color(Token::Raised));
        painter.drawRect(box);
    } else {
        painter.drawPixmap(box.toRect(), m_picture);
    }
    const double r = look().metrics().lamp() / 2.0;
    painter.setFont(look().font(TextSize::Label, QFont::Medium));
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        const SensorChannelView& channel = m_channels[i];
        if (!channel.placed) {
            continue;
        }
        const QPointF at(box.left() + channel.x * box.width(), box.top() + channel.y * box.height());
        painter.setPen(look().pen(Token::Text, m_selected == i ? Stroke::Bold : Stroke::Normal));
        painter.setBrush(channel.value ? look().color(Token::Text) : look().color(Token::Panel));
        painter.drawEllipse(at, r, r);
        if (m_selected == i) {
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(at, 2.0 * r, 2.0 * r);
            painter.drawText(at + QPointF(2.4 * r, r), QString::fromStdString(channel.name));
        }
    }
}

void SensorPicture::mousePressEvent(QMouseEvent* event) {
    const QRectF box = area();
    const QPointF at = event->position();
    if (box.width() > 0.0 && box.height() > 0.0 && box.contains(at)) {
        emit touched((at.x() - box.left()) / box.width(), (at.y() - box.top()) / box.height());
    }
}

}  // namespace kerf::ui
