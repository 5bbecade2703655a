// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/navigation.h"

#include <QFontMetrics>
#include <QPainter>
#include <QVBoxLayout>
#include <cstring>

#include "ui/link/texts.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/sign.h"

namespace kerf::ui {

NavigationItem::NavigationItem(Look& look, const PageEntry& entry, QWidget* parent)
    : QAbstractButton(parent), m_look(look), m_entry(entry) {
    setCheckable(true);
    setAutoExclusive(true);
    setObjectName(QStringLiteral("nav_") + QLatin1String(entry.key));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
    retitle();
}

void NavigationItem::setLoop(const LoopStatus& loop) {
    const std::pair<LoopState, bool> now{loop.state, loop.fitted};
    if (m_loop != now) {
        m_loop = now;
        update();
    }
}

void NavigationItem::setCount(int count) {
    if (count != m_count) {
        m_count = count;
        update();
    }
}

void NavigationItem::retitle() {
    setText(m_entry.title());
    updateGeometry();
    update();
}

QSize NavigationItem::sizeHint() const {
    return {m_look.metrics().navWidth(), m_look.metrics().touch()};
}

void NavigationItem::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const int inset = m_look.space(Space::Large);
    painter.fillRect(rect(), m_look.color(isChecked() ? Token::Ground : Token::Panel));
    if (isChecked()) {
        painter.fillRect(QRect(0, 0, m_look.space(Space::Small), height()), m_look.color(Token::Text));
    }
    if (hasFocus()) {
        painter.setPen(m_look.pen(Token::Measured, Stroke::Normal));
        painter.drawRect(rect().adjusted(1, 1, -2, -2));
    }
    painter.setFont(m_look.font(TextSize::Body, isChecked() ? QFont::DemiBold : QFont::Normal));
    painter.setPen(m_look.color(Token::Text));
    const int icon = m_look.metrics().icon();
    paintIcon(painter, QRectF(inset, (height() - icon) / 2.0, icon, icon), m_entry.key, m_look.color(Token::Text));
    painter.drawText(rect().adjusted(inset + icon + m_look.space(Space::Medium), 0, 0, 0),
                     Qt::AlignVCenter | Qt::AlignLeft, text());
    QString word;
    Sign sign = Sign::None;
    if (m_loop) {
        word = m_loop->second ? stateName(m_loop->first) : stateName(LoopState::Off);
        sign = m_loop->second ? signOf(m_loop->first) : Sign::Off;
    } else if (m_count > 0) {
        word = QString::number(m_count);
    }
    if (word.isEmpty()) {
        return;
    }
    painter.setFont(m_look.font(TextSize::Label));
    painter.setPen(m_look.color(m_loop && sign == Sign::Off ? Token::Dim : Token::Text));
    const int lamp = m_look.metrics().lamp();
    const QRect right = rect().adjusted(0, 0, -inset / 2, 0);
    const int stateColumn = m_look.px(19.0);
    const int left = right.right() - stateColumn;
    if (sign != Sign::None) {
        paintSign(painter, QRectF(left, (height() - lamp) / 2.0, lamp, lamp), sign, m_look);
    }
    painter.drawText(QRect(left + lamp + m_look.space(Space::Small), 0, stateColumn, height()),
                     Qt::AlignVCenter | Qt::AlignLeft, word);
}

Navigation::Navigation(Look& look, const PageList& pages, QWidget* parent) : FaceWidget(look, parent), m_pages(pages) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        auto* item = new NavigationItem(look, m_pages[i], this);
        connect(item, &QAbstractButton::clicked, this, [this, i] { emit chosen(i); });
        column->addWidget(item);
        m_items.push_back(item);
    }
    column->addStretch(1);
    refresh();
}

void Navigation::setStatus(const Status& status) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (m_pages[i].process) {
            const LoopStatus& loop = status.loops[static_cast<std::size_t>(*m_pages[i].process)];
            m_items[i]->setLoop(loop);
            m_items[i]->setVisible(loop.fitted || m_items[i]->isChecked());  // what the machine has not needs no place
        }
    }
}

void Navigation::setAlarmCount(int count) {
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (std::strcmp(m_pages[i].key, "alarms") == 0) {
            m_items[i]->setCount(count);
        }
    }
}

void Navigation::setCurrent(std::size_t index) {
    m_items[index]->setChecked(true);
}

void Navigation::refresh() {
    for (NavigationItem* item : m_items) {
        item->retitle();
    }
    FaceWidget::refresh();
}

}  // namespace kerf::ui
