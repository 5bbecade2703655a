// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/sheet.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QResizeEvent>
#include <algorithm>
#include <utility>

#include "ui/dialogs/sheet_buttons.h"
#include "ui/link/texts.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_box.h"

namespace kerf::ui {

Sheet::Sheet(Look& look, QWidget* host)
    : FaceWidget(look, host),
      m_frame(new QFrame(this)),
      m_content(new QWidget),
      m_scroll(new ScrollBox(m_frame)),
      m_buttons(new SheetButtons(look, m_frame)),
      m_column(new QVBoxLayout(m_content)),
      m_title(makeLabel(TextRole::CardNumber, m_content, true)),
      m_text(makeLabel(TextRole::Body, m_content, true)),
      m_body(new QVBoxLayout) {
    setObjectName(QStringLiteral("sheet"));
    m_frame->setProperty("role", QStringLiteral("sheet"));
    m_content->setProperty("role", QStringLiteral("scrolled"));
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->addWidget(m_title);
    m_column->addWidget(m_text);
    m_column->addLayout(m_body, 1);
    m_text->hide();
    m_scroll->setContent(m_content);
    m_content->installEventFilter(this);
    m_buttons->installEventFilter(this);
    refresh();
}

void Sheet::setWide() {
    m_wide = true;
    place();
}

// As high as it would like to be, at most the page area; below that the content scrolls and the buttons stay.
void Sheet::place() {
    const int margin = look().space(Space::Large);
    const int outer = m_wide ? look().space(Space::Medium) : 0;
    const int width_px =
        m_wide ? width() - 2 * outer : qMin(width(), qMax(2 * width() / 3, look().metrics().sideWidth()));
    const int inner = width_px - 2 * margin;
    const int buttons = m_buttons->heightForWidth(inner);
    const int gap = buttons > 0 ? margin : 0;
    const int room = height() - 2 * outer;
    const int wanted = 2 * margin + m_scroll->wantedHeight(inner) + gap + buttons;
    const int height_px = m_wide ? room : qMin(room, wanted);
    m_frame->setGeometry((width() - width_px) / 2, outer + (room - height_px) / 3, width_px, height_px);
    m_scroll->setGeometry(margin, margin, inner, qMax(0, height_px - 2 * margin - gap - buttons));
    m_buttons->setGeometry(margin, height_px - margin - buttons, inner, buttons);
}

void Sheet::resizeEvent(QResizeEvent* event) {
    FaceWidget::resizeEvent(event);
    place();
}

bool Sheet::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        place();
    }
    return FaceWidget::eventFilter(watched, event);
}

void Sheet::settleFocus() {
    const QWidget* now = QApplication::focusWidget();
    if (now != nullptr && now != this && isAncestorOf(now) && now->isVisible()) {
        return;
    }
    QWidget* wanted = nullptr;
    QWidget* first = nullptr;
    for (QWidget* child : m_content->findChildren<QWidget*>()) {
        if (!child->isVisible() || !child->isEnabled() || child->focusPolicy() == Qt::NoFocus) {
            continue;
        }
        if (child->focusWidget() == child) {
            wanted = child;
        } else if (const auto* field = qobject_cast<QLineEdit*>(child);
                   first == nullptr && field != nullptr && !field->isReadOnly()) {
            first = child;
        }
    }
    if (wanted != nullptr || first != nullptr) {
        (wanted != nullptr ? wanted : first)->setFocus();
    }
}

void Sheet::setTitle(const QString& title) {
    m_title->setText(title);
}

void Sheet::setText(const QString& text) {
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
}

void Sheet::addButton(QPushButton* button, std::function<void()> onClicked, bool closes) {
    m_buttons->add(button);
    m_list.push_back(button);
    place();
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

void Sheet::sent() {
    m_sent.clear();
    for (const QLineEdit* field : findChildren<QLineEdit*>()) {
        m_sent.insert(field, field->text());
    }
}

bool Sheet::taken() {
    const auto fields = findChildren<QLineEdit*>();
    const bool typed = std::any_of(fields.begin(), fields.end(), [this](const QLineEdit* field) {
        const auto sent = m_sent.constFind(field);
        return sent != m_sent.constEnd() && *sent != field->text();
    });
    m_sent.clear();
    if (typed) {
        setText(tr("That is stored. What was typed since then is not yet."));
        return false;
    }
    close();
    return true;
}

Sheet::Answer Sheet::whenStored(QPushButton* button, Answer then) {
    sent();
    button->setEnabled(false);
    return [here = QPointer<Sheet>(this), save = QPointer<QPushButton>(button),
            then = std::move(then)](const Result<void>& result) {
        if (QPushButton* again = save.data(); again != nullptr) {
            again->setEnabled(true);
        }
        if (Sheet* sheet = here.data(); sheet != nullptr) {
            if (result) {
                sheet->taken();
            } else {
                sheet->setText(sentenceText(result.error(), sheet->look().units()));
            }
        }
        then(result);
    };
}

void Sheet::followLanguage(std::function<void()> remake) {
    m_follows = true;
    m_remake = std::move(remake);
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
    m_column->setSpacing(look().space(Space::Large));
    m_body->setSpacing(look().space(Space::Medium));
    FaceWidget::refresh();
    place();
}

SheetHost::SheetHost(Look& look, QWidget* parent)
    : QWidget(parent), m_look(look), m_language(look.preferences().language) {
    connect(&look, &Look::changed, this, [this] {
        const Language language = m_look.preferences().language;
        if (std::exchange(m_language, language) != language && m_current != nullptr && m_current->m_remake) {
            const auto remake = m_current->m_remake;
            m_current->close();
            remake();
        }
    });
}

bool SheetHost::languageMayChange() const {
    return m_current == nullptr || (m_current->m_follows && m_beneath.empty());
}

Sheet* SheetHost::open(const QString& title, const QString& text) {
    QPointer<QWidget> before = m_before;
    for (const Beneath& one : std::exchange(m_beneath, {})) {
        one.sheet->close();
    }
    if (m_current != nullptr) {
        m_current->close();
    } else {
        QWidget* focus = window()->focusWidget();
        before = focus != nullptr && isAncestorOf(focus) ? focus : nullptr;
    }
    Sheet* sheet = make(title, text);
    m_before = before;
    return sheet;
}

Sheet* SheetHost::openOver(const QString& title, const QString& text) {
    if (m_current == nullptr) {
        return open(title, text);
    }
    QWidget* focus = window()->focusWidget();
    m_beneath.push_back({m_current, m_current->isAncestorOf(focus) ? focus : nullptr});
    m_current->hide();
    return make(title, text);
}

Sheet* SheetHost::make(const QString& title, const QString& text) {
    auto* sheet = new Sheet(m_look, this);
    m_current = sheet;
    connect(sheet, &Sheet::closed, this, [this, sheet] { onClosed(sheet); });
    sheet->setTitle(title);
    sheet->setText(text);
    sheet->setGeometry(rect());
    sheet->show();
    sheet->raise();
    sheet->setFocus();
    settleLater(sheet);
    return sheet;
}

// After the events by which its fields are shown, and those are posted while it is filled, after this.
void SheetHost::settleLater(Sheet* sheet) {
    const auto settle = [sheet] { sheet->settleFocus(); };
    QMetaObject::invokeMethod(
        sheet, [sheet, settle] { QMetaObject::invokeMethod(sheet, settle, Qt::QueuedConnection); },
        Qt::QueuedConnection);
}

void SheetHost::onClosed(Sheet* sheet) {
    if (std::erase_if(m_beneath, [sheet](const Beneath& one) { return one.sheet == sheet; }) > 0) {
        return;  // its answer came while others lay over it
    }
    if (m_current != sheet) {
        return;
    }
    m_current = nullptr;
    if (m_beneath.empty()) {
        giveBackFocus();
        return;
    }
    const Beneath former = m_beneath.back();
    m_beneath.pop_back();
    m_current = former.sheet;
    m_current->setGeometry(rect());
    m_current->show();
    m_current->raise();
    if (former.focus) {
        former.focus->setFocus();
    } else {
        settleLater(m_current);
    }
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
    Sheet* sheet = openOver(title, text);
    sheet->addButton(safe, {})->setObjectName(QStringLiteral("sheetSafe"));
    sheet->addButton(proceed, std::move(onProceed))->setObjectName(QStringLiteral("sheetProceed"));
}

void SheetHost::tell(const QString& title, const QString& text) {
    openOver(title, text)->addButton(tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

void SheetHost::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (m_current != nullptr) {
        m_current->setGeometry(rect());
    }
}

}  // namespace kerf::ui
