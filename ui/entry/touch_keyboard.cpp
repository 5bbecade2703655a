// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/entry/touch_keyboard.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QInputMethodEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

#include "ui/widgets/keypad.h"

namespace kerf::ui {
namespace {

constexpr std::array<const char*, 3> kLetterRows{"qwertyuiop", "asdfghjkl", "zxcvbnm"};
constexpr std::array<const char*, 3> kSignRows{"1234567890", "-/.,:()+#", "_&@'*=%"};

}  // namespace

TouchKeyboard::TouchKeyboard(Look& look, QWidget* area) : FaceWidget(look, area), m_rows(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("touchKeyboard"));
    setAttribute(Qt::WA_StyledBackground);
    setProperty("role", QStringLiteral("sheet"));
    build();
    hide();
    qApp->installEventFilter(this);
    refresh();
}

QPushButton* TouchKeyboard::addKey(int row, const char* name, int stretch) {
    auto* key = new QPushButton(this);
    key->setObjectName(QLatin1String(name));
    key->setFocusPolicy(Qt::NoFocus);
    key->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    static_cast<QHBoxLayout*>(m_rows->itemAt(row)->layout())->addWidget(key, stretch);
    m_all.push_back(key);
    return key;
}

void TouchKeyboard::build() {
    for (std::size_t row = 0; row < kLetterRows.size() + 1; ++row) {
        m_rows->addLayout(new QHBoxLayout);
    }
    const int lastLetters = static_cast<int>(kLetterRows.size()) - 1;
    const int bottom = lastLetters + 1;
    m_shift = addKey(lastLetters, "touchShift", 3);
    for (std::size_t row = 0; row < kLetterRows.size(); ++row) {
        for (const char letter : std::string_view(kLetterRows[row])) {
            const QByteArray name = QByteArray("touchKey_") + letter;
            QPushButton* key = addKey(static_cast<int>(row), name.constData(), 2);
            connect(key, &QPushButton::clicked, this, [this, at = m_letters.size()] { touched(at); });
            m_letters.push_back(key);
        }
    }
    QPushButton* back = addKey(lastLetters, "touchBack", 3);
    back->setText(QStringLiteral("⌫"));
    m_signs = addKey(bottom, "touchSigns", 2);
    m_language = addKey(bottom, "touchLanguage", 2);
    m_space = addKey(bottom, "touchSpace", 8);
    m_enter = addKey(bottom, "touchEnter", 3);
    m_hide = addKey(bottom, "touchHide", 2);
    m_hide->setText(QStringLiteral("▼"));
    connect(m_shift, &QPushButton::clicked, this, [this] {
        m_shifted = !m_shifted;
        showFaces();  // the syllable goes on: ㅆ may end it
    });
    connect(back, &QPushButton::clicked, this, [this] {
        HangulComposer::Step step;
        if (m_page == Page::Hangul && syllableStands() && m_composer.backspace(step)) {
            compose(step);
        } else {
            endSyllable();
            typeKey(Qt::Key_Backspace);
        }
    });
    connect(m_signs, &QPushButton::clicked, this, [this] { show(m_page == Page::Signs ? m_words : Page::Signs); });
    connect(m_language, &QPushButton::clicked, this,
            [this] { show(m_page == Page::Hangul ? Page::Latin : Page::Hangul); });
    connect(m_space, &QPushButton::clicked, this, [this] { type(QStringLiteral(" ")); });
    connect(m_enter, &QPushButton::clicked, this, [this] {
        endSyllable();
        typeKey(Qt::Key_Return, QStringLiteral("\r"));
    });
    connect(m_hide, &QPushButton::clicked, this, [this] {
        endSyllable();
        hide();
    });
}

bool TouchKeyboard::wantsLetters(const QLineEdit* field) {
    if (field == nullptr || field->isReadOnly() || !field->isEnabled() || field->property("gaugeTarget").toBool()) {
        return false;
    }
    if ((field->inputMethodHints() & (Qt::ImhFormattedNumbersOnly | Qt::ImhDigitsOnly)) == 0 &&
        field->echoMode() == QLineEdit::Normal) {
        return true;
    }
    // Figures: a number pad in the same sheet or page does it.
    for (const QWidget* parent = field->parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
        for (const Keypad* pad : parent->findChildren<Keypad*>()) {
            if (pad->isVisible()) {
                return false;
            }
        }
        if (parent->objectName() == QLatin1String("sheet")) {
            break;
        }
    }
    return true;
}

bool TouchKeyboard::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::TouchBegin:
            if (watched->isWidgetType()) {
                onTouch(watched);
            }
            break;
        case QEvent::KeyPress:
            if (event->spontaneous() && isVisible() && watched == m_field) {
                endSyllable();
                hide();  // there is a keyboard
            }
            break;
        case QEvent::Hide:
            if (watched == m_field && isVisible()) {
                hide();
            }
            break;
        case QEvent::Resize:
            if (watched == parentWidget() && isVisible()) {
                place();
            }
            break;
        default:
            break;
    }
    return false;
}

void TouchKeyboard::onTouch(QObject* watched) {
    auto* widget = static_cast<QWidget*>(watched);
    if (widget == this || isAncestorOf(widget)) {
        return;
    }
    auto* field = qobject_cast<QLineEdit*>(widget);
    if (field != nullptr && parentWidget()->isAncestorOf(field) && wantsLetters(field)) {
        openFor(field);
    } else if (isVisible()) {
        endSyllable();
        hide();
    }
}

void TouchKeyboard::openFor(QLineEdit* field) {
    if (m_field != field) {
        endSyllable();
    }
    m_field = field;
    field->setFocus(Qt::MouseFocusReason);
    const bool figures = (field->inputMethodHints() & (Qt::ImhFormattedNumbersOnly | Qt::ImhDigitsOnly)) != 0 ||
                         field->echoMode() != QLineEdit::Normal;
    m_words = look().preferences().language == Language::Korean ? Page::Hangul : Page::Latin;
    show(figures ? Page::Signs : m_words);
    place();
    QWidget::show();
    raise();
}

/// At the bottom of the page area, or at its top when the field would lie beneath.
void TouchKeyboard::place() {
    const QWidget* area = parentWidget();
    const int rows = m_rows->count();
    const int height = rows * look().metrics().touch() + (rows + 1) * look().metrics().touchGap();
    int y = area->height() - height;
    if (const QLineEdit* edit = m_field.data(); edit != nullptr) {
        const int fieldBottom = edit->mapTo(area, QPoint(0, edit->height())).y();
        y = fieldBottom > y ? 0 : y;
    }
    setGeometry(0, y, area->width(), height);
}

void TouchKeyboard::show(Page page) {
    endSyllable();
    m_page = page;
    m_shifted = false;
    if (page != Page::Signs) {
        m_words = page;
    }
    showFaces();
}

void TouchKeyboard::showFaces() {
    std::size_t at = 0;
    for (std::size_t row = 0; row < kLetterRows.size(); ++row) {
        for (std::size_t k = 0; kLetterRows[row][k] != '\0'; ++k) {
            const QChar letter = QLatin1Char(kLetterRows[row][k]);
            const QChar shifted = m_shifted ? letter.toUpper() : letter;
            QString face(shifted);
            if (m_page == Page::Signs) {
                face = QString(QLatin1Char(kSignRows[row][k])).replace(u'&', QStringLiteral("&&"));
            } else if (m_page == Page::Hangul) {
                const QString jamo = hangulOf(QString(shifted));
                face = jamo.isEmpty() ? hangulOf(QString(letter)) : jamo;
            }
            m_letters[at++]->setText(face);
        }
    }
    m_shift->setEnabled(m_page != Page::Signs);
    m_shift->setText(m_shifted ? QStringLiteral("⬆") : QStringLiteral("⇧"));
    m_signs->setText(m_page == Page::Signs ? tr("ABC") : QStringLiteral("123"));
    m_language->setText(m_page == Page::Hangul ? QStringLiteral("A") : QStringLiteral("한"));
}

void TouchKeyboard::touched(std::size_t key) {
    std::size_t row = 0;
    std::size_t at = key;
    while (at >= std::string_view(kLetterRows[row]).size()) {
        at -= std::string_view(kLetterRows[row++]).size();
    }
    const QChar letter = QLatin1Char(kLetterRows[row][at]);
    if (m_page == Page::Signs) {
        type(QString(QLatin1Char(kSignRows[row][at])));
        return;
    }
    const QChar shifted = m_shifted ? letter.toUpper() : letter;
    if (m_page == Page::Hangul) {
        if (!syllableStands()) {
            endSyllable();
        }
        compose(m_composer.type(shifted));
    } else {
        type(QString(shifted));
    }
    if (m_shifted) {
        m_shifted = false;
        showFaces();
    }
}

void TouchKeyboard::type(const QString& text) {
    endSyllable();
    typeKey(text.front().toUpper().unicode(), text);
}

void TouchKeyboard::typeKey(int key, const QString& text) {
    if (!m_field) {
        return;
    }
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier, text);
    QApplication::sendEvent(m_field, &press);
    if (m_field) {  // Enter may have closed its sheet
        QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier, text);
        QApplication::sendEvent(m_field, &release);
    }
}

// The syllable in the making is text at once, and each key replaces it: a search finds it, a button counts it, and it
// is not lost with the keyboard.
void TouchKeyboard::compose(const HangulComposer::Step& step) {
    if (m_field) {
        const int length = static_cast<int>(m_syllable.size());
        QInputMethodEvent event;
        event.setCommitString(step.commit + step.preedit, -length, length);
        m_syllable = step.preedit;
        QApplication::sendEvent(m_field, &event);
    }
}

// Not when the field took no more letters, when the cursor was moved, or when somebody else wrote.
bool TouchKeyboard::syllableStands() const {
    if (!m_field || m_field->hasSelectedText()) {
        return m_syllable.isEmpty();
    }
    const int length = static_cast<int>(m_syllable.size());
    return m_field->text().left(m_field->cursorPosition()).right(length) == m_syllable;
}

void TouchKeyboard::endSyllable() {
    m_composer.finish();
    m_syllable.clear();
}

void TouchKeyboard::refresh() {
    const int gap = look().metrics().touchGap();
    m_rows->setContentsMargins(gap, gap, gap, gap);
    m_rows->setSpacing(gap);
    for (int row = 0; row < m_rows->count(); ++row) {
        m_rows->itemAt(row)->layout()->setSpacing(gap);
    }
    for (QPushButton* key : m_all) {
        key->setMinimumHeight(look().metrics().touch());
    }
    m_space->setText(tr("Space"));
    m_enter->setText(tr("Enter"));
    m_hide->setAccessibleName(tr("Hide the keyboard"));
    show(m_page);
    if (isVisible()) {
        place();
    }
    FaceWidget::refresh();
}

}  // namespace kerf::ui
