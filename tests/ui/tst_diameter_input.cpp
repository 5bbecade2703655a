// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "ui/entry/diameter_input.h"
#include "ui/entry/gauge_reading.h"

using namespace kerf::ui;

namespace {

const UnitSystem kMetric;
const UnitSystem kInch(LengthUnit::Inch, TemperatureUnit::Celsius);

DiameterInput typed(const char* text, double expected_mm = 50.010, const UnitSystem& units = kMetric) {
    DiameterInput input;
    input.expect(expected_mm, units);
    input.type(QString::fromLatin1(text));
    return input;
}

}  // namespace

class TestDiameterInput : public QObject {
    Q_OBJECT
 private slots:
    void twoFiguresAreTheNearestDiameterThatEndsSo_data() {
        QTest::addColumn<QString>("figures");
        QTest::addColumn<double>("expected_mm");
        QTest::addColumn<double>("value_mm");
        QTest::newRow("same tenth") << "12" << 50.010 << 50.012;
        QTest::newRow("one tenth below") << "98" << 50.010 << 49.998;
        QTest::newRow("one tenth above") << "03" << 49.995 << 50.003;
        QTest::newRow("zero") << "00" << 50.010 << 50.000;
        QTest::newRow("small bore") << "51" << 6.046 << 6.051;
        QTest::newRow("large bore") << "07" << 310.098 << 310.107;
    }
    void twoFiguresAreTheNearestDiameterThatEndsSo() {
        QFETCH(QString, figures);
        QFETCH(double, expected_mm);
        QFETCH(double, value_mm);
        const DiameterInput input = typed(figures.toLatin1().constData(), expected_mm);
        QCOMPARE(input.value_mm().value_or(0.0), value_mm);  // exact: the number that was read
        QCOMPARE(input.shown().all(), UnitSystem::fixed(value_mm, 3));
    }
    void theFieldShowsWhatIsStillOpen() {
        QCOMPARE(typed("").shown().all(), QStringLiteral("50.0\u25AF\u25AF"));
        QCOMPARE(typed("1").shown().all(), QStringLiteral("50.01\u25AF"));
        QVERIFY(!typed("").value_mm());
        QVERIFY(!typed("1").value_mm());
    }
    void aWholeDiameterIsTakenAsTyped() {
        QCOMPARE(typed("50.011").value_mm().value_or(0.0), 50.011);
        QCOMPARE(typed("49,9").value_mm().value_or(0.0), 49.9);
        QCOMPARE(typed("500").value_mm().value_or(0.0), 500.0);
        QCOMPARE(typed("-3.").value_mm().value_or(0.0), -3.0);
    }
    void whatIsNoNumberStaysAndHasNoValue() {
        const DiameterInput input = typed("5o.o1");
        QVERIFY(!input.value_mm());
        QCOMPARE(input.shown().all(), QStringLiteral("5o.o1"));
    }
    void theOtherDiameterWithTheseFiguresIsNamed() {
        QCOMPARE(typed("98").alternative_mm().value_or(0.0), 50.098);
        QCOMPARE(typed("12").alternative_mm().value_or(0.0), 49.912);
        QVERIFY(!typed("50.098").alternative_mm());
    }
    void inchIsReadInTenthsOfAThousandth() {
        const DiameterInput input = typed("91", 50.010, kInch);
        QCOMPARE(input.shown().all(), QStringLiteral("1.9691"));
        QVERIFY(std::abs(input.value_mm().value_or(0.0) - 1.9691 * 25.4) < 1e-12);
    }
    void switchingUnitsInTheMiddleOfAnEntryChangesNothing() {
        DiameterInput input = typed("1");
        input.expect(50.010, kInch);
        input.type(QStringLiteral("2"));
        QCOMPARE(input.value_mm().value_or(0.0), 50.012);
        QCOMPARE(input.units().length(), LengthUnit::Millimetre);
        input.clear();
        QCOMPARE(input.units().length(), LengthUnit::Inch);
        input.type(QStringLiteral("1.9691"));
        QVERIFY(std::abs(input.value_mm().value_or(0.0) - 1.9691 * 25.4) < 1e-12);
    }
    void aGaugeReadingKeepsAllItsDecimals() {
        DiameterInput input = typed("");
        input.set_mm(50.01234567);
        QCOMPARE(input.value_mm().value_or(0.0), 50.01234567);
        QCOMPARE(input.shown().all(), QStringLiteral("50.012"));
        input.backspace();
        QCOMPARE(input.value_mm().value_or(0.0), 50.01);
        input.set_mm(50.01234567);
        input.type(QStringLiteral("07"));  // figures after a reading are a new entry
        QCOMPARE(input.value_mm().value_or(0.0), 50.007);
    }
    void withoutAnExpectedBoreNothingIsCompleted() {
        QVERIFY(!typed("12", 0.0).completing());
        QCOMPARE(typed("12", 0.0).value_mm().value_or(0.0), 12.0);
    }

    void framesInUseAreRead_data() {
        QTest::addColumn<QString>("frame");
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("unit");  // -1 none, 0 mm, 1 in
        QTest::newRow("plain") << "50.011" << 50.011 << -1;
        QTest::newRow("comma and sign") << "+50,011" << 50.011 << -1;
        QTest::newRow("minus") << "-0.012" << -0.012 << -1;
        QTest::newRow("unit") << "50.011mm" << 50.011 << 0;
        QTest::newRow("inch") << "1.96894 in" << 1.96894 << 1;
        QTest::newRow("inch mark") << "1.96894\"" << 1.96894 << 1;
        QTest::newRow("multiplexer") << "01A+00050.011" << 50.011 << -1;
        QTest::newRow("padded") << "   50.011  " << 50.011 << -1;
        QTest::newRow("label") << "D=50.011" << 50.011 << -1;
        QTest::newRow("label and blank") << "DIA 50,011 mm" << 50.011 << 0;
        QTest::newRow("channel") << "CH2: +50.011mm" << 50.011 << 0;
        QTest::newRow("number") << "2:50.011" << 50.011 << -1;
        QTest::newRow("status") << "50.011 mm OK" << 50.011 << 0;
        QTest::newRow("status behind a comma") << "50.011,NG" << 50.011 << -1;
        QTest::newRow("prefix and sign") << "N+50.011" << 50.011 << -1;
        QTest::newRow("radio base") << "DT10002+0050.011M" << 50.011 << 0;
        QTest::newRow("raw mm") << "FFFF005001130" << 50.011 << 0;
        QTest::newRow("raw inch") << "FFFF019689451" << 1.96894 << 1;
        QTest::newRow("raw negative") << "FFFF800001230" << -0.012 << 0;
    }
    void framesInUseAreRead() {
        QFETCH(QString, frame);
        QFETCH(double, value);
        QFETCH(int, unit);
        const auto reading = parseGaugeFrame(frame);
        QVERIFY(reading.has_value());
        QVERIFY(std::abs(reading->value - value) < 1e-12);
        QCOMPARE(reading->unit.has_value() ? static_cast<int>(*reading->unit) : -1, unit);
    }
    void whatIsNoFrameIsNotOne() {
        for (const char* text : {"", "1234", "50", "A50.011", "50.011kg", "5.0.1", "50.", "FFFF0050011", "50.011mmm",
                                 "A1250.5", "lot 12.5", "50.011 51.2", "1.2.3.4"}) {
            QVERIFY2(!parseGaugeFrame(QString::fromLatin1(text)), text);
        }
    }
    void channelsAreKept() {
        for (const auto& [frame, channel] : {std::pair("01A+00050.011", 1), std::pair("12B-00000.011", 12),
                                             std::pair("CH2: 50.011", 2), std::pair("DT10003+0050.011M", 3)}) {
            QCOMPARE(parseGaugeFrame(QString::fromLatin1(frame))->channel.value_or(0), channel);
        }
        QVERIFY(!parseGaugeFrame(QStringLiteral("50.011"))->channel);
    }
    void aDeviationIsNeverADiameter() {
        const auto judge = [](const char* frame, double ring_mm) {
            return judgeReading(*parseGaugeFrame(QString::fromLatin1(frame)), 50.010, LengthUnit::Millimetre, ring_mm);
        };
        QCOMPARE(judge("+0.011", 50.0).value_mm, 50.011);
        QCOMPARE(judge("-0.004mm", 50.002).value_mm, 49.998);
        QVERIFY(std::abs(judge("0.0005in", 50.0).value_mm - 50.0127) < 1e-9);
        QCOMPARE(judge("50.011", 50.0).value_mm, 50.011);  // switched to absolute
        for (const char* frame : {"+0.011", "-0.004", "0.050", "0.5001"}) {
            QCOMPARE(judge(frame, 0.0).doubt, GaugeDoubt::Deviation);
        }
    }
    void unitAndDecadeSlipsAreNoticed() {
        const auto judge = [](const char* frame, LengthUnit shown) {
            return judgeReading(*parseGaugeFrame(QString::fromLatin1(frame)), 50.010, shown);
        };
        QCOMPARE(judge("50.011", LengthUnit::Millimetre).doubt, GaugeDoubt::None);
        QCOMPARE(judge("50.3", LengthUnit::Millimetre).doubt, GaugeDoubt::None);  // a question of the process
        QCOMPARE(judge("1.9689", LengthUnit::Millimetre).doubt, GaugeDoubt::OtherUnit);
        QVERIFY(std::abs(judge("1.9689", LengthUnit::Millimetre).otherUnit_mm - 50.010) < 0.001);
        QCOMPARE(judge("50.011", LengthUnit::Inch).doubt, GaugeDoubt::OtherUnit);
        QCOMPARE(judge("1.9689in", LengthUnit::Millimetre).doubt, GaugeDoubt::None);
        QCOMPARE(judge("50.011mm", LengthUnit::Inch).doubt, GaugeDoubt::None);
        QCOMPARE(judge("5.0011", LengthUnit::Millimetre).doubt, GaugeDoubt::DecadeSlip);
        QCOMPARE(judge("500.11", LengthUnit::Millimetre).doubt, GaugeDoubt::DecadeSlip);
    }
};

QTEST_APPLESS_MAIN(TestDiameterInput)
#include "tst_diameter_input.moc"
