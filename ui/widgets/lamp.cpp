// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/lamp.h"

#include <QFontMetrics>
#include <QPainter>

#include "ui/link/texts.h"

namespace kerf::ui {

Lamp::Lamp(Look& look, QWidget* parent) : FaceWidget(look, parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Lamp::setState(LoopState state) {
    m_state = state;
    set(signOf(state), stateName(state));
    m_state = state;
}

void Lamp::set(Sign sign, const QString& word) {
    m_state.reset();
    if (sign == m_sign && word == m_word) {
        return;
    }
    m_sign = sign;
    m_word = word;
    setAccessibleName(word);
    updateGeometry();
    update();
}

void Lamp::refresh() {
    if (m_state) {
        setState(*m_state);
    }
    FaceWidget::refresh();
}

QSize Lamp::sizeHint() const {
    const QFontMetrics metrics(look().font(TextSize::Body));
    const int lamp = look().metrics().lamp();
    const int word = m_word.isEmpty() ? 0 : look().space(Space::Medium) + metrics.horizontalAdvance(m_word);
    return {lamp + word, qMax(lamp, metrics.height())};
}

void Lamp::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const int lamp = look().metrics().lamp();
    paintSign(painter, QRectF(0, (height() - lamp) / 2.0, lamp, lamp), m_sign, look());
    painter.setFont(look().font(TextSize::Body));
    painter.setPen(look().color(m_sign == Sign::Off ? Token::Dim : Token::Text));
    painter.drawText(rect().adjusted(lamp + look().space(Space::Medium), 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     m_word);
}

}  // namespace kerf::ui
