// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/diameter_field.h"

#include <QClipboard>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <utility>

namespace kerf::ui {

DiameterField::DiameterField(Look& look, QWidget* parent) : QLineEdit(parent), m_look(look) {
    setAttribute(Qt::WA_InputMethodEnabled, false);  // figures only: no composing of Korean syllables here
    setContextMenuPolicy(Qt::NoContextMenu);
    setAcceptDrops(false);
    setProperty("gaugeTarget", true);
    connect(this, &QLineEdit::textEdited, this, [this] {
        takeText();
        emit typed();
    });
    connect(&look, &Look::changed, this, [this] { updateGeometry(); });
}

void DiameterField::showInput() {
    setText(m_input.shown().all());
    setAccessibleDescription(m_input.units().of("mm").symbol);
    update();
}

void DiameterField::takeText() {
    if (text() != m_input.shown().all()) {
        m_input.clear();
        m_input.type(text());
        showInput();
    }
}

void DiameterField::setWrong(bool wrong) {
    if (property("wrong").toBool() != wrong) {
        setProperty("wrong", wrong);
        style()->unpolish(this);
        style()->polish(this);
    }
}

QSize DiameterField::sizeHint() const {
    const QFontMetrics metrics(m_look.font(TextSize::Card, QFont::Medium));
    return {metrics.horizontalAdvance(QStringLiteral("000.00000")) + 2 * m_look.space(Space::Large),
            m_look.metrics().touch()};
}

void DiameterField::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Paste)) {
        m_input.clear();
        m_input.type(QGuiApplication::clipboard()->text().trimmed());
        showInput();
        emit typed();
        return;
    }
    const bool keypad = (event->modifiers() & Qt::KeypadModifier) != 0;
    if (keypad && event->text().trimmed().isEmpty() && event->key() != Qt::Key_Enter &&
        event->key() != Qt::Key_Return) {
        m_numLockOff = true;
        emit numLockOff();
        return;
    }
    if (keypad && event->key() == Qt::Key_Delete) {  // its text is DEL: the decimal point's key
        m_numLockOff = true;
        emit numLockOff();
        return;
    }
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            takeText();
            if (std::exchange(m_numLockOff, false)) {
                emit numLockOff();
                return;
            }
            emit entered();
            return;
        case Qt::Key_Escape:
            m_numLockOff = false;
            m_input.clear();
            showInput();
            emit cleared();
            return;
        case Qt::Key_Backspace:
        case Qt::Key_Delete:
            m_numLockOff = false;
            m_input.backspace();
            showInput();
            emit typed();
            return;
        default:
            break;
    }
    const bool command = (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
    if (!command && !event->text().isEmpty() && event->text().front().isPrint()) {
        m_numLockOff = false;
        m_input.type(event->text());
        showInput();
        emit typed();
        return;
    }
    QWidget::keyPressEvent(event);
}

void DiameterField::mousePressEvent(QMouseEvent*) {
    setFocus(Qt::MouseFocusReason);
}

void DiameterField::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QStyleOptionFrame option;
    initStyleOption(&option);
    style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
    const QFont plain = m_look.font(TextSize::Card);
    const QFont strong = m_look.font(TextSize::Card, QFont::DemiBold);
    int x = m_look.space(Space::Large);
    const auto draw = [&](const QString& text, const QFont& font, Token token) {
        painter.setFont(font);
        painter.setPen(m_look.color(isEnabled() ? token : Token::Dim));
        painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter | Qt::AlignLeft, text);
        x += QFontMetrics(font).horizontalAdvance(text);
    };
    const DiameterInput::Shown shown = m_input.shown();
    draw(shown.head, plain, Token::Dim);
    draw(shown.typed, strong, Token::Text);
    if (hasFocus()) {
        painter.setPen(m_look.pen(Token::Measured, Stroke::Normal));
        const int inset = m_look.space(Space::Large);
        painter.drawLine(x, inset, x, height() - inset);
    }
    draw(shown.open, plain, Token::Dim);
}

}  // namespace kerf::ui
