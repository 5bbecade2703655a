// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/sheet.h"

#include <QKeyEvent>
#include <QPainter>
#include <QResizeEvent>

#include "ui/widgets/label.h"

namespace kerf::ui {

Sheet::Sheet(Look& look, QWidget* host)
    : FaceWidget(look, host),
      m_outer(new QVBoxLayout(this)),
      m_row(new QHBoxLayout),
      m_frame(new QFrame(this)),
      m_title(makeLabel(TextRole::CardNumber, m_frame, true)),
      m_text(makeLabel(TextRole::Body, m_frame, true)),
      m_body(new QVBoxLayout),
      m_buttons(new QHBoxLayout) {
    setObjectName(QStringLiteral("sheet"));
    m_frame->setProperty("role", QStringLiteral("sheet"));
    m_outer->addStretch(1);
    m_outer->addLayout(m_row);
    m_outer->addStretch(2);
    m_row->addStretch(1);
    m_row->addWidget(m_frame, 4);
    m_row->addStretch(1);
    auto* column = new QVBoxLayout(m_frame);
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addLayout(m_body);
    column->addLayout(m_buttons);
    m_text->hide();
    refresh();
}

void Sheet::setWide() {
    m_row->setStretch(0, 0);
    m_row->setStretch(2, 0);
    m_outer->setStretch(0, 0);
    m_outer->setStretch(1, 1);
    m_outer->setStretch(2, 0);
}

void Sheet::setTitle(const QString& title) {
    m_title->setText(title);
}

void Sheet::setText(const QString& text) {
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
}

void Sheet::addButton(QPushButton* button, std::function<void()> onClicked, bool closes) {
    button->setParent(m_frame);
    if (!m_list.empty()) {
        m_buttons->addStretch(1);  // the safe answer stands apart from the others
    }
    m_buttons->addWidget(button);
    button->show();
    m_list.push_back(button);
    connect(button, &QPushButton::clicked, this, [this, onClicked = std::move(onClicked), closes] {
        if (closes) {
            close();  // first: the answer may open the next sheet
        }
        if (onClicked) {
            onClicked();
        }
    });
}

QPushButton* Sheet::addButton(const QString& text, std::function<void()> onClicked, bool closes) {
    auto* button = new QPushButton(text);
    addButton(button, std::move(onClicked), closes);
    return button;
}

void Sheet::close() {
    hide();
    emit closed();
    deleteLater();
}

void Sheet::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QColor veil = look().color(Token::Ground);
    veil.setAlphaF(0.8F);
    painter.fillRect(rect(), veil);
}

void Sheet::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !m_list.empty()) {
        m_list.front()->click();
        return;
    }
    FaceWidget::keyPressEvent(event);
}

void Sheet::refresh() {
    const int large = look().space(Space::Large);
    m_frame->layout()->setContentsMargins(large, large, large, large);
    m_frame->layout()->setSpacing(large);
    m_body->setSpacing(look().space(Space::Medium));
    m_buttons->setSpacing(look().metrics().touchGap());
    m_frame->setMinimumWidth(look().metrics().sideWidth());
    FaceWidget::refresh();
}

SheetHost::SheetHost(Look& look, QWidget* parent) : QWidget(parent), m_look(look) {}

Sheet* SheetHost::open(const QString& title, const QString& text) {
    QPointer<QWidget> before = m_before;
    if (m_current != nullptr) {
        m_current->close();
    } else {
        QWidget* focus = window()->focusWidget();
        before = focus != nullptr && isAncestorOf(focus) ? focus : nullptr;
    }
    auto* sheet = new Sheet(m_look, this);
    m_current = sheet;
    connect(sheet, &Sheet::closed, this, [this, sheet] {
        if (m_current == sheet) {
            m_current = nullptr;
            giveBackFocus();
        }
    });
    m_before = before;
    sheet->setTitle(title);
    sheet->setText(text);
    sheet->setGeometry(rect());
    sheet->show();
    sheet->raise();
    sheet->setFocus();
    return sheet;
}

void SheetHost::giveBackFocus() {
    if (QWidget* before = m_before.data(); before != nullptr && before->isVisible() && before->isEnabled()) {
        before->setFocus();
    } else {
        setFocus();  // no button has it that nobody touched
    }
    m_before = nullptr;
}

void SheetHost::ask(const QString& title, const QString& text, const QString& safe, const QString& proceed,
                    std::function<void()> onProceed) {
    Sheet* sheet = open(title, text);
    sheet->addButton(safe, {})->setObjectName(QStringLiteral("sheetSafe"));
    sheet->addButton(proceed, std::move(onProceed))->setObjectName(QStringLiteral("sheetProceed"));
}

void SheetHost::tell(const QString& title, const QString& text) {
    open(title, text)->addButton(tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

void SheetHost::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (m_current != nullptr) {
        m_current->setGeometry(rect());
    }
}

}  // namespace kerf::ui
