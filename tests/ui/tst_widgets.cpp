// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "tests/support/fake_engine.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/alarm_bar.h"
#include "ui/widgets/hold_all_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/lamp.h"
#include "ui/widgets/number_display.h"
#include "ui/widgets/sparkline.h"
#include "ui/widgets/value_field.h"

using namespace kerf;
using namespace kerf::ui;

namespace {
constexpr ParamSpec kDiameter{"test.diameter_mm", "Bore diameter", "mm", 40.0, 60.0, 50.0, 3, "test"};

void switchTo(Look& look, LengthUnit unit) {
    Preferences p = look.preferences();
    p.length = unit;
    look.apply(p);
}
}  // namespace

class TestWidgets : public QObject {
    Q_OBJECT
 private slots:
    void aFieldGivesTheStoredValueWhateverTheUnit() {
        Look look(96.0);
        ValueField field(look, kDiameter);
        field.setValue(50.0114);
        for (int i = 0; i < 5; ++i) {
            switchTo(look, LengthUnit::Inch);
            switchTo(look, LengthUnit::Millimetre);
        }
        QCOMPARE(field.value().value(), 50.0114);
        switchTo(look, LengthUnit::Inch);
        QCOMPARE(field.edit()->text(), QStringLiteral("1.96895"));
        field.clear();
        QTest::keyClicks(field.edit(), QStringLiteral("2.0"));
        QVERIFY(std::abs(field.value().value() - 50.8) < 1e-9);
        switchTo(look, LengthUnit::Millimetre);
        QCOMPARE(field.edit()->text(), QStringLiteral("50.800"));
    }
    void aFieldSaysWhyItRefuses() {
        Look look(96.0);
        ValueField field(look, kDiameter);
        QSignalSpy committed(&field, &ValueField::committed);
        for (const char* bad : {"", "abc", "500.11", "-1", "nan"}) {
            field.edit()->setText({});
            QTest::keyClicks(field.edit(), QString::fromLatin1(bad));
            QTest::keyClick(field.edit(), Qt::Key_Return);
            QVERIFY2(!field.value(), bad);
            QVERIFY2(!field.whyInvalid().isEmpty(), bad);
        }
        QCOMPARE(committed.count(), 0);
        field.edit()->setText({});
        QTest::keyClicks(field.edit(), QStringLiteral("50.011"));
        QTest::keyClick(field.edit(), Qt::Key_Return);
        QCOMPARE(committed.count(), 1);
        QCOMPARE(committed[0][0].toDouble(), 50.011);
        QVERIFY(field.whyInvalid().isEmpty());
    }
    void theKeypadTypesIntoItsTarget() {
        Look look(96.0);
        QWidget window;
        QVBoxLayout column(&window);
        ValueField field(look, kDiameter);
        Keypad keypad(look);
        column.addWidget(&field);
        column.addWidget(&keypad);
        keypad.setTarget(field.edit());
        window.show();
        QSignalSpy committed(&field, &ValueField::committed);
        for (const char* key : {"key5", "key0", "keyPoint", "key0", "key1", "key7", "keyBack", "key2"}) {
            QTest::mouseClick(keypad.findChild<QPushButton*>(QLatin1String(key)), Qt::LeftButton);
        }
        QCOMPARE(field.edit()->text(), QStringLiteral("50.012"));
        QTest::mouseClick(keypad.findChild<QPushButton*>(QStringLiteral("keyEnter")), Qt::LeftButton);
        QCOMPARE(committed.count(), 1);
        QTest::mouseClick(keypad.findChild<QPushButton*>(QStringLiteral("keySign")), Qt::LeftButton);
        QCOMPARE(field.edit()->text(), QStringLiteral("-50.012"));
        QTest::mouseClick(keypad.findChild<QPushButton*>(QStringLiteral("keyClear")), Qt::LeftButton);
        QVERIFY(field.edit()->text().isEmpty());
    }
    void keysAreForGloves() {
        for (const double scale : {0.8, 1.0, 1.5, 2.0}) {
            Look look(96.0);
            Preferences p = look.preferences();
            p.scale = scale;
            look.apply(p);
            Keypad keypad(look);
            keypad.resize(keypad.sizeHint());
            keypad.show();
            const auto keys = keypad.findChildren<QPushButton*>();
            QCOMPARE(keys.size(), 15);
            for (const QPushButton* a : keys) {
                QVERIFY(a->width() >= look.metrics().touch() && a->height() >= look.metrics().touch());
                for (const QPushButton* b : keys) {
                    const int gap = look.metrics().touchGap() - 1;
                    QVERIFY(a == b || !a->geometry().adjusted(-gap, -gap, gap, gap).intersects(b->geometry()));
                }
            }
        }
    }
    void aButtonSaysWhyItIsOff() {
        Look look(96.0);
        ActionButton button(look);
        button.setText(QStringLiteral("Start part"));
        QString reason = QStringLiteral("The door is open.");
        button.setPredicate([&reason] { return reason; });
        QVERIFY(!button.isEnabled());
        QCOMPARE(button.reason(), reason);
        const QImage off = button.grab().toImage();
        QVERIFY(button.sizeHint().height() >= look.metrics().touch());
        reason.clear();
        button.reconsider();
        QVERIFY(button.isEnabled());
        QVERIFY(button.reason().isEmpty());
        QVERIFY(button.grab().toImage() != off);
    }
    void holdAllActsWhenPressedAndCannotBeSwitchedOff() {
        Look look(96.0);
        test::FakeEngine engine;
        QWidget window;
        QVBoxLayout column(&window);
        auto* button = new HoldAllButton(look, engine);
        column.addWidget(button);
        window.show();
        QTest::mousePress(button, Qt::LeftButton);
        QCOMPARE(engine.holds.load(), 1);
        QTest::mouseRelease(button, Qt::LeftButton);
        QCOMPARE(engine.holds.load(), 1);
        button->setEnabled(false);
        QVERIFY(button->isEnabled());
        button->setHeld(true);
        QVERIFY(button->isEnabled());
        QTest::mousePress(button, Qt::LeftButton);
        QCOMPARE(engine.holds.load(), 2);
        QCOMPARE(engine.commands.size(), std::size_t{0});
    }
    void aNumberShowsItsQuality() {
        Look look(96.0);
        NumberDisplay number(look, "mm", 3);
        QCOMPARE(number.text(), QStringLiteral("–"));
        number.setReading({50.0114, 0, Quality::Good}, 0);
        QCOMPARE(number.text(), QStringLiteral("50.011"));
        number.setReading({50.0114, 0, Quality::Bad}, 0);
        QCOMPARE(number.text(), QStringLiteral("–"));
        number.setReading({50.0114, 0, Quality::Stale}, 5'000'000'000);
        QCOMPARE(number.text(), QStringLiteral("50.011"));
        switchTo(look, LengthUnit::Inch);
        QCOMPARE(number.text(), QStringLiteral("1.96895"));
        number.setNothing();
        QCOMPARE(number.text(), QStringLiteral("–"));
    }
    void lampsDifferInShape() {
        Look look(96.0);
        std::vector<QImage> pictures;
        for (const Sign sign : {Sign::Off, Sign::Advising, Sign::Controlling, Sign::Limited, Sign::Held, Sign::Alarm1,
                                Sign::Alarm2, Sign::Alarm3}) {
            Lamp lamp(look);
            lamp.set(sign, {});
            lamp.resize(lamp.sizeHint());
            pictures.push_back(lamp.grab().toImage().convertToFormat(QImage::Format_Grayscale8));
        }
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            for (std::size_t j = i + 1; j < pictures.size(); ++j) {
                QVERIFY2(pictures[i] != pictures[j], qPrintable(QStringLiteral("%1 %2").arg(i).arg(j)));
            }
        }
    }
    void theBottomLineShowsTheAlarmOrTheNotice() {
        Look look(96.0);
        AlarmBar bar(look);
        QVERIFY(!bar.text().isEmpty());
        bar.setAlarm(2, QStringLiteral("thermocouple HL7 disagrees"), 0);
        QCOMPARE(bar.text(), QStringLiteral("thermocouple HL7 disagrees"));
        bar.notify(QStringLiteral("not now"));
        QCOMPARE(bar.text(), QStringLiteral("not now"));
        bar.setAlarm(1, QStringLiteral("tool broken"), 2);
        QVERIFY(bar.text().contains(QStringLiteral("tool broken")));
    }
};

QTEST_MAIN(TestWidgets)
#include "tst_widgets.moc"
