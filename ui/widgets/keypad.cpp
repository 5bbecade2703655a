// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/keypad.h"

#include <QApplication>
#include <QKeyEvent>

namespace kerf::ui {

Keypad::Keypad(Look& look, Shape shape, QWidget* parent) : FaceWidget(look, parent), m_grid(new QGridLayout(this)) {
    const bool wide = shape == Shape::Wide;
    m_grid->setContentsMargins(0, 0, 0, 0);
    for (int digit = 1; digit <= 9; ++digit) {
        const QString face = QString::number(digit);
        const QByteArray name = "key" + face.toLatin1();
        connect(addKey(face, name.constData(), 2 - (digit - 1) / 3, (digit - 1) % 3), &QPushButton::clicked, this,
                [this, face, digit] { type(face, Qt::Key_0 + digit); });
    }
    connect(addKey(QStringLiteral("0"), "key0", wide ? 2 : 3, wide ? 3 : 0), &QPushButton::clicked, this,
            [this] { type(QStringLiteral("0"), Qt::Key_0); });
    connect(addKey(QStringLiteral("."), "keyPoint", wide ? 1 : 3, wide ? 3 : 1), &QPushButton::clicked, this,
            [this] { type(QStringLiteral("."), Qt::Key_Period); });
    if (!wide) {
        addSign(3, 2);
    }
    connect(addKey(QStringLiteral("⌫"), "keyBack", 0, 3), &QPushButton::clicked, this,
            [this] { type({}, Qt::Key_Backspace); });
    m_clear = addKey(QStringLiteral("C"), "keyClear", wide ? 0 : 1, wide ? 4 : 3);
    connect(m_clear, &QPushButton::clicked, this, [this] {
        QLineEdit* edit = field();
        if (edit != nullptr) {
            edit->clear();
            emit edit->textEdited({});
        }
    });
    m_enter = addKey({}, "keyEnter", wide ? 1 : 2, wide ? 4 : 3);
    m_grid->addWidget(m_enter, wide ? 1 : 2, wide ? 4 : 3, 2, 1);
    m_enter->setProperty("primary", true);
    connect(m_enter, &QPushButton::clicked, this, [this] { type({}, Qt::Key_Return); });
    qApp->installEventFilter(this);
    refresh();
}

/// In the same sheet, or on the same page.
bool Keypad::beside(const QWidget* widget) const {
    for (const QWidget* room = parentWidget(); room != nullptr; room = room->parentWidget()) {
        if (room->objectName() == QLatin1String("sheet") || room->inherits("kerf::ui::Page") || room->isWindow()) {
            return room->isAncestorOf(widget);
        }
    }
    return false;
}

bool Keypad::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::TouchBegin ||
        event->type() == QEvent::FocusIn) {
        if (auto* edit = qobject_cast<QLineEdit*>(watched); edit != nullptr && beside(edit)) {
            m_touched = edit;
        }
    }
    return false;
}

QLineEdit* Keypad::field() const {
    if (m_target) {
        return m_target;
    }
    // Without a window manager no window is active and the application knows no focus; the window does.
    const QWidget* top = window();
    QWidget* focus = QApplication::focusWidget();
    if (focus == nullptr && top != nullptr) {
        focus = top->focusWidget();
    }
    auto* focused = qobject_cast<QLineEdit*>(focus);
    if (focused != nullptr && focused->isEnabled() && beside(focused)) {
        return focused;
    }
    if (QLineEdit* touched = m_touched.data(); touched != nullptr && touched->isVisible() && touched->isEnabled()) {
        return touched;
    }
    for (QWidget* room = parentWidget(); room != nullptr; room = room->parentWidget()) {
        for (QLineEdit* edit : room->findChildren<QLineEdit*>()) {
            if ((edit->inputMethodHints() & Qt::ImhFormattedNumbersOnly) != 0 && edit->isVisible() &&
                edit->isEnabled()) {
                return edit;
            }
        }
        if (room->objectName() == QLatin1String("sheet")) {
            break;
        }
    }
    return nullptr;
}

void Keypad::addSign(int row, int column) {
    connect(addKey(QStringLiteral("±"), "keySign", row, column), &QPushButton::clicked, this, [this] {
        QLineEdit* edit = field();
        if (edit != nullptr) {
            const QString text = edit->text();
            edit->selectAll();
            edit->insert(text.startsWith(u'-') ? text.mid(1) : u'-' + text);
            emit edit->textEdited(edit->text());
        }
    });
}

QPushButton* Keypad::addKey(const QString& face, const char* name, int row, int column, int columns) {
    auto* key = new QPushButton(face, this);
    key->setObjectName(QLatin1String(name));
    key->setFocusPolicy(Qt::NoFocus);
    key->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_grid->addWidget(key, row, column, 1, columns);
    m_keys.push_back(key);
    return key;
}

void Keypad::setEnterText(const QString& text) {
    m_enterText = text;
    refresh();
}

void Keypad::type(const QString& text, int key) {
    QLineEdit* edit = field();
    if (edit == nullptr) {
        return;
    }
    edit->setFocus();
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier, text);
    QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier, text);
    const QPointer<QLineEdit> kept(edit);
    QApplication::sendEvent(edit, &press);
    if (kept) {  // Enter may have closed its sheet
        QApplication::sendEvent(edit, &release);
    }
}

void Keypad::refresh() {
    m_grid->setSpacing(look().metrics().touchGap());
    const QString style = QStringLiteral("padding: 0; font-size: %1px").arg(look().metrics().text(TextSize::Card));
    for (QPushButton* key : m_keys) {
        key->setMinimumSize(look().metrics().touch(), look().metrics().touch());
        key->setStyleSheet(style);
    }
    m_enter->setText(m_enterText.isEmpty() ? QStringLiteral("⏎") : m_enterText);
    m_enter->setAccessibleName(tr("Enter"));
    m_clear->setAccessibleName(tr("Clear"));
    FaceWidget::refresh();
}

}  // namespace kerf::ui
