// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QInputMethodEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>

#include "ui/entry/gauge_wedge.h"
#include "ui/entry/hangul.h"

using namespace kerf::ui;

/// A window with a text field, a memo and a button, and a clock that only the test moves.
class TestGaugeWedge : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() { qRegisterMetaType<GaugeReading>(); }
    void init() {
        m_now_ms = 1000;
        m_wedge = std::make_unique<GaugeWedge>();
        m_wedge->setClock([this] { return m_now_ms; });
        qApp->installEventFilter(m_wedge.get());
        m_window = std::make_unique<QWidget>();
        auto* layout = new QVBoxLayout(m_window.get());
        m_line = new QLineEdit(m_window.get());
        m_memo = new QPlainTextEdit(m_window.get());
        m_button = new QPushButton(m_window.get());
        for (QWidget* widget : std::initializer_list<QWidget*>{m_line, m_memo, m_button}) {
            layout->addWidget(widget);
        }
        m_read = std::make_unique<QSignalSpy>(m_wedge.get(), &GaugeWedge::reading);
        m_again = std::make_unique<QSignalSpy>(m_wedge.get(), &GaugeWedge::repeated);
    }
    void cleanup() {
        m_window.reset();
        m_wedge.reset();
    }

    void aBurstIsAReadingWhateverHasTheFocus() {
        for (QWidget* target : std::initializer_list<QWidget*>{m_line, m_memo, m_button, m_window.get()}) {
            m_read->clear();
            m_now_ms += 10000;
            burst(target, "50.011");
            QCOMPARE(m_read->count(), 1);
            QCOMPARE(m_read->first().first().value<GaugeReading>().value, 50.011);
        }
        QVERIFY(m_line->text().isEmpty());
        QVERIFY(m_memo->toPlainText().isEmpty());
    }
    void tabEndsABurstToo() {
        burst(m_line, "50.011", Qt::Key_Tab);
        QCOMPARE(m_read->count(), 1);
    }
    void handsAreNotAGauge() {
        for (const char c : std::string("50.011")) {
            QTest::keyClick(m_line, c);
            m_now_ms += 120;
        }
        QSignalSpy entered(m_line, &QLineEdit::returnPressed);
        QTest::keyClick(m_line, Qt::Key_Return);
        QCOMPARE(m_line->text(), QStringLiteral("50.011"));
        QCOMPARE(entered.count(), 1);
        QCOMPARE(m_read->count(), 0);
    }
    void aHeldKeyGoesOnByItself() {
        QTest::keyClick(m_line, '7');
        QTRY_COMPARE(m_line->text(), QStringLiteral("7"));
    }
    void fastTypingWithoutADecimalMarkArrivesWhole() {
        QSignalSpy entered(m_line, &QLineEdit::returnPressed);
        burst(m_line, "1234");  // a code, a serial number
        QCOMPARE(m_line->text(), QStringLiteral("1234"));
        QCOMPARE(entered.count(), 1);
        QCOMPARE(m_read->count(), 0);
    }
    void textArrivesInOrder() {
        for (const char* text : {"12 holes, 3.5 deep", "M8x1.25", "+-.,FF", "lot 12/A3.5b-7", "1.2.3.4 5in 6mm"}) {
            m_line->clear();
            QTest::keyClicks(m_line, QString::fromLatin1(text));
            QTest::keyClick(m_line, Qt::Key_End);  // any other key gives back what is held
            QCOMPARE(m_line->text(), QString::fromLatin1(text));
        }
        QCOMPARE(m_read->count(), 0);
    }
    void aBarCodeIsNotADiameter() {
        burst(m_line, "A1250.5");
        QCOMPARE(m_line->text(), QStringLiteral("A1250.5"));
        QCOMPARE(m_read->count(), 0);
    }
    void backspaceAndShortcutsPassAtOnce() {
        m_line->setText(QStringLiteral("abc"));
        QTest::keyClick(m_line, '1');
        QTest::keyClick(m_line, Qt::Key_Backspace);
        QCOMPARE(m_line->text(), QStringLiteral("abc"));
        QTest::keyClick(m_line, Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(m_line->selectedText(), QStringLiteral("abc"));
    }
    void aBounceOfTheSendButtonIsLeftOutAndTold() {
        burst(m_button, "50.011");
        m_now_ms += 400;
        burst(m_button, "50.011");
        QCOMPARE(m_read->count(), 1);
        QCOMPARE(m_again->count(), 1);
        m_now_ms += GaugeWedge::kRepeat_ms + 1;
        burst(m_button, "50.011");  // the second depth may well be the same
        QCOMPARE(m_read->count(), 2);
    }
    void twoDifferentReadingsInARowAreBothTaken() {
        burst(m_button, "50.011");
        m_now_ms += 400;
        burst(m_button, "50.009");
        QCOMPARE(m_read->count(), 2);
    }
    void aRadioSendsSlower_data() {
        QTest::addColumn<int>("pace_ms");
        QTest::addColumn<int>("pause_ms");
        QTest::addColumn<QString>("frame");
        for (const char* frame :
             {"50.011", "01A+00050.011", "  +50,011 mm", "D=50.011", "1.96894 in", "OD 50.011mm OK"}) {
            for (const int pace_ms : {1, 30, 35, 50, 70, 90}) {
                for (const int pause_ms : {0, 150}) {
                    QTest::addRow("%s at %d ms, one pause of %d", frame, pace_ms, pause_ms)
                        << pace_ms << pause_ms << QString::fromLatin1(frame);
                }
            }
        }
    }
    void aRadioSendsSlower() {
        QFETCH(int, pace_ms);
        QFETCH(int, pause_ms);
        QFETCH(QString, frame);
        QSignalSpy pressed(m_button, &QPushButton::pressed);
        for (QWidget* target : std::initializer_list<QWidget*>{m_line, m_memo, m_button, m_window.get()}) {
            for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Tab}) {
                m_read->clear();
                m_now_ms += 10000;
                for (int k = 0; k < frame.size(); ++k) {
                    QTest::keyClick(target, frame[k].toLatin1());
                    m_now_ms += k == 2 && pause_ms > 0 ? pause_ms : pace_ms;
                }
                QTest::keyClick(target, end);
                m_now_ms += pace_ms;
                QTest::keyClick(target, Qt::Key_Return);  // the last key twice: LF behind CR
                QCOMPARE(m_read->count(), 1);
                QVERIFY(qAbs(m_read->first().first().value<GaugeReading>().value -
                             (frame.contains(u'i') ? 1.96894 : 50.011)) < 1e-9);
            }
        }
        QVERIFY(m_line->text().isEmpty());
        QVERIFY(m_memo->toPlainText().isEmpty());
        QCOMPARE(pressed.count(), 0);
    }
    /// Now and then a pause of 150 ms, wherever it falls, two of them next to each other too.
    void pausesMayFallAnywhere() {
        for (const char* text : {"50.011", "9.998", "  50.011mm", "01A+00050.011", "OD 50.011mm OK"}) {
            const QString frame = QString::fromLatin1(text);
            for (int one = 0; one < frame.size(); ++one) {
                for (int other = one; other < frame.size(); ++other) {
                    m_read->clear();
                    m_now_ms += 10000;
                    for (int k = 0; k < frame.size(); ++k) {
                        QTest::keyClick(m_button, frame[k].toLatin1());
                        m_now_ms += k == one || k == other ? 150 : 35 + (17 * k) % 56;
                    }
                    QTest::keyClick(m_button, Qt::Key_Return);
                    QVERIFY2(m_read->count() == 1, text);
                }
            }
        }
    }
    void paddingOfATooSlowFramePressesNothing() {
        QSignalSpy pressed(m_button, &QPushButton::pressed);
        for (const char c : std::string("50.0  11   mm ")) {
            QTest::keyClick(m_button, c);
            m_now_ms += 150;
        }
        QTest::keyClick(m_button, Qt::Key_Return);
        QCOMPARE(pressed.count(), 0);
    }
    void halfAFrameIsNoReadingAndPressesNothing_data() {
        QTest::addColumn<QString>("begin");
        QTest::addColumn<QString>("end");
        for (const char* begin : {"5", "50", "50.", "50.0", "01A+00"}) {
            for (const char* end : {"0.011", ".011", "011", "1"}) {
                QTest::addRow("%s … %s", begin, end) << QString::fromLatin1(begin) << QString::fromLatin1(end);
            }
        }
    }
    void halfAFrameIsNoReadingAndPressesNothing() {
        QFETCH(QString, begin);
        QFETCH(QString, end);
        QSignalSpy pressed(m_button, &QPushButton::pressed);
        QSignalSpy halved(m_wedge.get(), &GaugeWedge::halved);
        for (const QString& part : {begin, end}) {
            for (const QChar c : part) {
                QTest::keyClick(m_button, c.toLatin1());
                m_now_ms += 50;
            }
            m_now_ms += part == begin ? 400 : 0;
        }
        QTest::keyClick(m_button, Qt::Key_Return);
        QCOMPARE(m_read->count(), 0);
        QCOMPARE(pressed.count(), 0);
        QVERIFY(halved.count() > 0 || end.size() < 2);
    }
    void paddingPressesNoButtonAndASpaceOfAPersonDoes() {
        QSignalSpy clicked(m_button, &QPushButton::clicked);
        burst(m_button, "   50.011");
        QCOMPARE(m_read->count(), 1);
        QCOMPARE(clicked.count(), 0);
        m_now_ms += 10000;
        QTest::keyClick(m_button, Qt::Key_Space);
        QTRY_COMPARE(clicked.count(), 1);
    }
    void aMultiplexersPairRepeatedChangesNothing() {
        const auto pair = [this] {
            burst(m_button, "01A+00050.011");
            burst(m_button, "02A+00049.998");
        };
        pair();
        QCOMPARE(m_read->count(), 2);
        QCOMPARE(m_read->at(0).first().value<GaugeReading>().channel.value_or(0), 1);
        QCOMPARE(m_read->at(1).first().value<GaugeReading>().channel.value_or(0), 2);
        m_now_ms += 3000;
        pair();
        QCOMPARE(m_read->count(), 2);
        QCOMPARE(m_again->count(), 2);
        m_now_ms += 60000;
        pair();  // another part may be the same
        QCOMPARE(m_read->count(), 4);
    }
    void numLockOffIsToldAndChangesNothing() {
        QSignalSpy off(m_wedge.get(), &GaugeWedge::numLockOff);
        m_line->setText(QStringLiteral("50.012"));
        for (const Qt::Key key :
             {Qt::Key_Clear, Qt::Key_Insert, Qt::Key_Delete, Qt::Key_Insert, Qt::Key_End, Qt::Key_End}) {
            QTest::keyClick(m_line, key, Qt::KeypadModifier);
            m_now_ms += 5;
        }
        QTest::keyClick(m_line, Qt::Key_Enter, Qt::KeypadModifier);
        QCOMPARE(off.count(), 1);
        QCOMPARE(m_read->count(), 0);
        QCOMPARE(m_line->text(), QStringLiteral("50.012"));
    }
    void aKoreanInputMethodMakesNoDifference() {
        const auto compose = [this](const QString& preedit, const QString& commit) {
            QInputMethodEvent event(preedit, {});
            if (!commit.isEmpty()) event.setCommitString(commit);
            QCoreApplication::sendEvent(m_line, &event);
        };
        QTest::keyClick(m_line, '0');
        QTest::keyClick(m_line, '1');
        compose(QStringLiteral("ㅁ"), {});
        compose({}, QStringLiteral("ㅁ"));
        burst(m_line, "+00050.011");
        QCOMPARE(m_read->count(), 1);
        QCOMPARE(m_read->first().first().value<GaugeReading>().channel.value_or(0), 1);
        QVERIFY(m_line->text().isEmpty());
        m_now_ms += 10000;
        compose({}, QStringLiteral("김"));  // a person's words
        QCOMPARE(m_line->text(), QStringLiteral("김"));
        QCOMPARE(latinKeys(QStringLiteral("므ㅑㅜ")), QStringLiteral("amin"));
    }
    void aLabelIsNoReasonToHoldBackWords() {
        QTest::keyClicks(m_line, QStringLiteral("Schmidt and sons, 12"));
        QTest::keyClick(m_line, Qt::Key_End);
        QCOMPARE(m_line->text(), QStringLiteral("Schmidt and sons, 12"));
        QCOMPARE(m_read->count(), 0);
    }
    void keysThatQueuedUpBehindABusyScreenAreNoBurst() {
        // Handled at one moment, typed a hundred milliseconds apart: the events carry their own time.
        qint64 time_ms = 500000;
        for (const char c : std::string("50.011")) {
            QKeyEvent press(QEvent::KeyPress, c, Qt::NoModifier, QString(QLatin1Char(c)));
            press.setTimestamp(static_cast<quint64>(time_ms += 100));
            QSpontaneKeyEvent::setSpontaneous(&press);
            QCoreApplication::sendEvent(m_line, &press);
        }
        QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, QStringLiteral("\r"));
        enter.setTimestamp(static_cast<quint64>(time_ms + 100));
        QSpontaneKeyEvent::setSpontaneous(&enter);
        QCoreApplication::sendEvent(m_line, &enter);
        QCOMPARE(m_line->text(), QStringLiteral("50.011"));
        QCOMPARE(m_read->count(), 0);
    }
    void keysOfTheScreensOwnKeypadAreNoGauge() {
        for (const char c : std::string("50.011\r")) {
            QKeyEvent press(QEvent::KeyPress, c == '\r' ? int(Qt::Key_Return) : int(c), Qt::NoModifier,
                            QString(QLatin1Char(c)));
            QCoreApplication::sendEvent(m_line, &press);
        }
        QCOMPARE(m_line->text(), QStringLiteral("50.011"));
        QCOMPARE(m_read->count(), 0);
    }
    void theTargetMayVanishWhileKeysAreHeld() {
        auto* doomed = new QLineEdit(m_window.get());
        QTest::keyClick(doomed, '5');
        delete doomed;
        QTest::keyClick(m_line, 'x');
        QCOMPARE(m_line->text(), QStringLiteral("x"));
    }

 private:
    void burst(QWidget* target, const char* text, Qt::Key end = Qt::Key_Return) {
        for (const char c : std::string(text)) {
            QTest::keyClick(target, c);
            m_now_ms += 3;
        }
        QTest::keyClick(target, end);
    }

    qint64 m_now_ms{0};
    std::unique_ptr<GaugeWedge> m_wedge;
    std::unique_ptr<QWidget> m_window;
    QLineEdit* m_line{};
    QPlainTextEdit* m_memo{};
    QPushButton* m_button{};
    std::unique_ptr<QSignalSpy> m_read;
    std::unique_ptr<QSignalSpy> m_again;
};

QTEST_MAIN(TestGaugeWedge)
#include "tst_gauge_wedge.moc"
