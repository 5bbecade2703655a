// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/card.h"

#include <QEvent>

#include "ui/widgets/label.h"

namespace kerf::ui {

Card::Card(Look& look, QWidget* parent)
    : QFrame(parent),
      m_look(look),
      m_outer(new QVBoxLayout(this)),
      m_header(new QHBoxLayout),
      m_body(new QVBoxLayout),
      m_title(makeLabel(TextRole::Title, this)) {
    setProperty("role", QStringLiteral("card"));
    m_header->addWidget(m_title);
    m_header->addStretch(1);
    m_outer->addLayout(m_header);
    m_outer->addLayout(m_body, 1);
    m_title->hide();
    connect(&look, &Look::changed, this, [this] { refresh(); });
    refresh();
}

void Card::setTitle(const QString& title) {
    m_title->setText(title);
    m_title->setVisible(!title.isEmpty());
}

void Card::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void Card::refresh() {
    const int large = m_look.space(Space::Large) * 3 / 4;
    m_outer->setContentsMargins(large, m_look.space(Space::Medium), large, m_look.space(Space::Medium));
    m_outer->setSpacing(m_look.space(Space::Small));
    m_body->setSpacing(m_look.space(Space::Medium));
    m_header->setSpacing(m_look.space(Space::Medium));
}

}  // namespace kerf::ui
