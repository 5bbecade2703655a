// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/action_button.h"

#include <QFontMetrics>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>

namespace kerf::ui {

ActionButton::ActionButton(Look& look, QWidget* parent) : QPushButton(parent), m_look(look) {
    QSizePolicy policy(QSizePolicy::MinimumExpanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&look, &Look::changed, this, [this] {
        reconsider();
        updateGeometry();
    });
}

void ActionButton::setPredicate(WhyNot whyNot) {
    m_whyNot = std::move(whyNot);
    reconsider();
}

void ActionButton::setPermission(WhyNot whoMay) {
    m_whoMay = std::move(whoMay);
    reconsider();
}

void ActionButton::reconsider() {
    QString reason = m_whoMay ? m_whoMay() : QString();
    if (reason.isEmpty() && m_whyNot) {
        reason = m_whyNot();
    }
    if (reason == m_reason && isEnabled() == reason.isEmpty()) {
        return;
    }
    m_reason = reason;
    setEnabled(reason.isEmpty());
    setAccessibleDescription(reason);
    updateGeometry();
    update();
}

void ActionButton::setPrimary(bool primary) {
    if (property("primary").toBool() == primary) {
        return;  // polishing lays out the page anew
    }
    setProperty("primary", primary);
    style()->unpolish(this);
    style()->polish(this);
}

int ActionButton::textHeight(int width) const {
    const QFontMetrics title(m_look.font(TextSize::Body, QFont::DemiBold));
    if (m_reason.isEmpty()) {
        return title.height();
    }
    const QFontMetrics small(m_look.font(TextSize::Label));
    const int inner = qMax(1, width - 2 * m_look.space(Space::Medium));
    return title.height() +
           small.boundingRect(QRect(0, 0, inner, 10000), Qt::TextWordWrap | Qt::AlignHCenter, m_reason).height();
}

int ActionButton::heightForWidth(int width) const {
    return qMax(m_look.metrics().touch(), textHeight(width) + 2 * m_look.space(Space::Small));
}

QSize ActionButton::sizeHint() const {
    const QFontMetrics title(m_look.font(TextSize::Body, QFont::DemiBold));
    int width = title.horizontalAdvance(text()) + 2 * m_look.space(Space::Large);
    if (!m_reason.isEmpty()) {
        width = qMax(width, m_look.px(40.0));
    }
    width = qMax(width, m_look.metrics().touch());
    return {width, heightForWidth(width)};
}

// Narrow, the sentence takes more lines.
QSize ActionButton::minimumSizeHint() const {
    const QFontMetrics title(m_look.font(TextSize::Body, QFont::DemiBold));
    const int width = qMax(m_look.metrics().touch(), title.horizontalAdvance(text()) + 2 * m_look.space(Space::Medium));
    return {width, qMin(heightForWidth(width), sizeHint().height())};
}

void ActionButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text.clear();
    style()->drawControl(QStyle::CE_PushButton, &option, &painter, this);
    const QFont titleFont = m_look.font(TextSize::Body, isEnabled() ? QFont::DemiBold : QFont::Normal);
    const QFontMetrics title(titleFont);
    const int inset = m_look.space(Space::Medium);
    const QRect inner = rect().adjusted(inset, 0, -inset, 0);
    const int top = (height() - textHeight(width())) / 2;
    painter.setFont(titleFont);
    painter.setPen(m_look.color(isEnabled() ? Token::Text : Token::Dim));
    painter.drawText(QRect(inner.left(), top, inner.width(), title.height()), Qt::AlignCenter, text());
    if (!m_reason.isEmpty()) {
        painter.setFont(m_look.font(TextSize::Label));
        painter.setPen(m_look.color(Token::Dim));
        painter.drawText(QRect(inner.left(), top + title.height(), inner.width(), height() - top - title.height()),
                         Qt::TextWordWrap | Qt::AlignHCenter | Qt::AlignTop, m_reason);
    }
}

}  // namespace kerf::ui
