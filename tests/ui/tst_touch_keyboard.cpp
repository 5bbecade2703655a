// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "ui/entry/touch_keyboard.h"
#include "ui/widgets/keypad.h"

using namespace kerf::ui;

/// Words typed by touch alone.
class TestTouchKeyboard : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_area = std::make_unique<QWidget>();
        auto* column = new QVBoxLayout(m_area.get());
        m_name = new QLineEdit(m_area.get());
        m_number = new QLineEdit(m_area.get());
        m_number->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
        m_button = new QPushButton(m_area.get());
        for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_number, m_button}) {
            column->addWidget(widget);
        }
        column->addStretch(1);
        m_keyboard = new TouchKeyboard(m_look, m_area.get());
        m_area->resize(1083, 670);
        m_area->show();
    }
    void cleanup() { m_area.reset(); }

    void syllables_data() {
        QTest::addColumn<QString>("keys");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* keys, const char* words) {
            QTest::newRow(keys) << QString::fromLatin1(keys) << QString::fromUtf8(words);
        };
        row("rlacjftn", "김철수");
        row("dlTek", "있다");
        row("rksk", "가나");     // the last consonant goes along with the vowel
        row("ekfrdms", "닭은");  // a final of two
        row("ekfrl", "달기");    // … is parted
        row("dhkswjs", "완전");
        row("rhk", "과");
        row("Rkalf", "까밀");
        row("znzn", "쿠쿠");
        row("k", "ㅏ");
        row("dmldl", "의이");
    }
    void syllables() {
        QFETCH(QString, keys);
        QFETCH(QString, words);
        HangulComposer composer;
        QString text;
        for (const QChar key : keys) {
            text += composer.type(key).commit;
        }
        text += composer.finish();
        QCOMPARE(text, words);
    }
    void everySyllableIsTyped() {
        for (char16_t code = 0xAC00; code <= 0xD7A3; ++code) {
            const QString syllable{QChar(code)};
            HangulComposer composer;
            QString text;
            for (const QChar key : latinKeys(syllable)) {
                text += composer.type(key).commit;
            }
            if (text + composer.finish() != syllable) {
                QFAIL(qPrintable(syllable + u' ' + latinKeys(syllable)));
            }
        }
    }
    void itComesWithATouchOnAFieldAndGoesWithOneElsewhere() {
        QVERIFY(!m_keyboard->isVisible());
        QTest::mouseClick(m_name, Qt::LeftButton);
        QVERIFY(m_keyboard->isVisible());
        QVERIFY(m_keyboard->geometry().top() > m_name->geometry().bottom());
        QTest::mouseClick(m_button, Qt::LeftButton);
        QVERIFY(!m_keyboard->isVisible());
        QTest::mouseClick(m_name, Qt::LeftButton);
        QTest::keyClick(m_name, 'x');  // there is a real one
        QVERIFY(!m_keyboard->isVisible());
        QTest::mouseClick(m_name, Qt::LeftButton);
        touch("touchHide");
        QVERIFY(!m_keyboard->isVisible());
    }
    void aNameAReasonANumber() {
        QTest::mouseClick(m_name, Qt::LeftButton);
        touch("touchShift");
        for (const char* key : {"touchKey_k", "touchKey_i", "touchKey_m", "touchSpace"}) {
            touch(key);
        }
        touch("touchSigns");
        touch("touchKey_q");
        touch("touchKey_w");
        touch("touchBack");
        QCOMPARE(m_name->text(), QStringLiteral("Kim 1"));
        touch("touchSigns");
        touch("touchLanguage");
        for (const char* key : {"touchKey_r", "touchKey_l", "touchKey_a"}) {
            touch(key);
        }
        touch("touchKey_d");
        touch("touchKey_l");
        touch("touchShift");
        touch("touchKey_t");
        touch("touchSpace");
        QCOMPARE(m_name->text(), QStringLiteral("Kim 1김있 "));
        touch("touchKey_r");
        touch("touchKey_k");
        touch("touchBack");
        touch("touchBack");
        touch("touchBack");
        QCOMPARE(m_name->text(), QStringLiteral("Kim 1김있"));
        QSignalSpy entered(m_name, &QLineEdit::returnPressed);
        touch("touchEnter");
        QCOMPARE(entered.count(), 1);
    }
    void theSyllableInTheMakingIsTextAtOnce() {
        QTest::mouseClick(m_name, Qt::LeftButton);
        touch("touchLanguage");
        QSignalSpy edited(m_name, &QLineEdit::textEdited);
        const std::vector<std::pair<const char*, const char*>> steps{{"touchKey_r", "ㄱ"}, {"touchKey_l", "기"},
                                                                     {"touchKey_a", "김"}, {"touchKey_c", "김ㅊ"},
                                                                     {"touchBack", "김"},  {"touchKey_r", "김ㄱ"}};
        int count = 0;
        for (const auto& [key, text] : steps) {
            touch(key);
            QCOMPARE(m_name->text(), QString::fromUtf8(text));
            QCOMPARE(edited.count(), ++count);
        }
        QTest::mouseClick(m_button, Qt::LeftButton);  // nothing is added when the keyboard goes
        QCOMPARE(m_name->text(), QStringLiteral("김ㄱ"));
    }
    void aSyllableIsWrittenWhereTheCursorIs() {
        m_name->setText(QStringLiteral("박수"));
        QTest::mouseClick(m_name, Qt::LeftButton);
        touch("touchLanguage");
        m_name->setCursorPosition(1);
        touch("touchKey_r");
        touch("touchKey_l");
        m_name->setCursorPosition(3);
        touch("touchKey_a");  // another syllable: 기 no longer stands before the cursor
        QCOMPARE(m_name->text(), QStringLiteral("박기수ㅁ"));
        m_name->selectAll();
        touch("touchKey_r");
        QCOMPARE(m_name->text(), QStringLiteral("ㄱ"));
    }
    void aFullFieldLosesNothing() {
        m_name->setMaxLength(2);
        m_name->setText(QStringLiteral("박수"));
        QTest::mouseClick(m_name, Qt::LeftButton);
        touch("touchLanguage");
        touch("touchKey_r");
        touch("touchKey_l");
        QCOMPARE(m_name->text(), QStringLiteral("박수"));
    }
    void figuresComeFromAPadWhereThereIsOne() {
        QTest::mouseClick(m_number, Qt::LeftButton);
        QVERIFY(m_keyboard->isVisible());
        touch("touchKey_q");
        QCOMPARE(m_number->text(), QStringLiteral("1"));
        auto* pad = new Keypad(m_look, Keypad::Shape::Wide, m_area.get());
        m_area->layout()->addWidget(pad);
        pad->show();
        touch("touchHide");
        QTest::mouseClick(m_number, Qt::LeftButton);
        QVERIFY(!m_keyboard->isVisible());
        m_button->setFocus();
        QTest::mouseClick(pad->findChild<QPushButton*>(QStringLiteral("key7")), Qt::LeftButton);
        QCOMPARE(m_number->text(), QStringLiteral("17"));  // the field touched last waits
    }
    void everyKeyIsLargeEnough() {
        QTest::mouseClick(m_name, Qt::LeftButton);
        QCoreApplication::processEvents();
        for (const auto* key : m_keyboard->findChildren<QPushButton*>()) {
            QVERIFY2(key->width() >= m_look.metrics().touch() && key->height() >= m_look.metrics().touch(),
                     qPrintable(key->objectName()));
        }
    }

 private:
    void touch(const char* name) {
        auto* key = m_keyboard->findChild<QPushButton*>(QLatin1String(name));
        QVERIFY2(key != nullptr, name);
        QTest::mouseClick(key, Qt::LeftButton);
    }

    Look m_look{96.0};
    std::unique_ptr<QWidget> m_area;
    QLineEdit* m_name{};
    QLineEdit* m_number{};
    QPushButton* m_button{};
    TouchKeyboard* m_keyboard{};
};

QTEST_MAIN(TestTouchKeyboard)
#include "tst_touch_keyboard.moc"
