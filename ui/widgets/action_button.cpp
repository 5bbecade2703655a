// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/action_button.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>

namespace kerf::ui {

void forgetStyledWidth(QAbstractButton& button) {
    if (button.property("_q_stylesheet_minw").toBool()) {  // the style sheet's mark of its own doing
        button.setMinimumWidth(0);
    }
}

namespace {
constexpr int kTitle = Qt::AlignHCenter | Qt::AlignTop;

/// That of the style's other buttons.
int leastWidth(const Look& look) {
    return look.metrics().touch() + 2 * look.space(Space::Medium);
}
}  // namespace

ActionButton::ActionButton(Look& look, QWidget* parent) : QPushButton(parent), m_look(look) {
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
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

void ActionButton::setRest(WhyNot whyNow) {
    m_whyNow = std::move(whyNow);
    reconsider();
}

// What it was told may be of a moment ago.
void ActionButton::mousePressEvent(QMouseEvent* event) {
    reconsider();
    isEnabled() ? QPushButton::mousePressEvent(event) : event->ignore();
}

void ActionButton::keyPressEvent(QKeyEvent* event) {
    reconsider();
    isEnabled() ? QPushButton::keyPressEvent(event) : event->ignore();
}

void ActionButton::reconsider() {
    QString reason;
    for (const WhyNot* ask : {&m_whoMay, &m_whyNot, &m_whyNow}) {
        if (reason.isEmpty() && *ask) {
            reason = (*ask)();
        }
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
    forgetStyledWidth(*this);
}

// Where the button is too narrow for its title, that takes another line too.
int ActionButton::titleHeight(int width) const {
    const QFontMetrics title(m_look.font(TextSize::Body, QFont::DemiBold));
    const int inner = qMax(1, width - 2 * m_look.space(Space::Medium));
    if (title.horizontalAdvance(text()) <= inner) {
        return title.height();
    }
    return qMax(title.height(),
                title.boundingRect(QRect(0, 0, inner, 10000), kTitle | Qt::TextWordWrap, text()).height());
}

int ActionButton::textHeight(int width) const {
    if (m_reason.isEmpty()) {
        return titleHeight(width);
    }
    const QFontMetrics small(m_look.font(TextSize::Label));
    const int inner = qMax(1, width - 2 * m_look.space(Space::Medium));
    return titleHeight(width) +
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
    width = qMax(width, leastWidth(m_look));
    return {width, heightForWidth(width)};
}

// Narrow, the sentence takes more lines.
QSize ActionButton::minimumSizeHint() const {
    const QFontMetrics title(m_look.font(TextSize::Body, QFont::DemiBold));
    const int width = qMax(leastWidth(m_look), title.horizontalAdvance(text()) + 2 * m_look.space(Space::Medium));
    return {width, qMin(heightForWidth(width), sizeHint().height())};
}

void ActionButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text.clear();
    style()->drawControl(QStyle::CE_PushButton, &option, &painter, this);
    const QFont titleFont = m_look.font(TextSize::Body, isEnabled() ? QFont::DemiBold : QFont::Normal);
    const int inset = m_look.space(Space::Medium);
    const QRect inner = rect().adjusted(inset, 0, -inset, 0);
    const int top = (height() - textHeight(width())) / 2;
    painter.setFont(titleFont);
    painter.setPen(m_look.color(isEnabled() ? Token::Text : Token::Dim));
    const int titled = titleHeight(width());
    const bool wraps = titled > QFontMetrics(m_look.font(TextSize::Body, QFont::DemiBold)).height();
    painter.drawText(QRect(inner.left(), top, inner.width(), titled), wraps ? kTitle | Qt::TextWordWrap : kTitle,
                     text());
    if (!m_reason.isEmpty()) {
        painter.setFont(m_look.font(TextSize::Label));
        painter.setPen(m_look.color(Token::Dim));
        painter.drawText(QRect(inner.left(), top + titled, inner.width(), height() - top - titled),
                         Qt::TextWordWrap | Qt::AlignHCenter | Qt::AlignTop, m_reason);
    }
}

}  // namespace kerf::ui
