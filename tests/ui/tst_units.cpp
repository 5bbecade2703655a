// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "ui/units/unit_system.h"

using namespace kerf::ui;

class TestUnits : public QObject {
    Q_OBJECT
 private slots:
    void metricIsShownAsStored() {
        const UnitSystem units;
        QCOMPARE(units.number(50.0114, "mm", 3), QStringLiteral("50.011"));
        QCOMPARE(units.withUnit(12.0, "um", 1), QStringLiteral("12.0\u00a0µm"));
        QCOMPARE(units.withUnit(21.36, "degC", 1), QStringLiteral("21.4\u00a0°C"));
    }
    void inchKeepsWhatTheGaugeResolved() {
        const UnitSystem units(LengthUnit::Inch, TemperatureUnit::Celsius);
        for (const double stored_mm : {50.011, 50.012, 49.999, 0.251}) {
            double shown = 0.0;
            QVERIFY(UnitSystem::parse(units.number(stored_mm, "mm", 3), shown));
            QVERIFY(std::abs(units.of("mm").toStored(shown) - stored_mm) < 0.0005);
        }
        QCOMPARE(units.withUnit(0.254, "mm/rev", 3), QStringLiteral("0.01000\u00a0in/rev"));
        QCOMPARE(units.withUnit(2.54, "um", 1), QStringLiteral("100\u00a0µin"));
    }
    void temperatureHasAnOffsetButADifferenceHasNone() {
        const UnitSystem units(LengthUnit::Millimetre, TemperatureUnit::Fahrenheit);
        QCOMPARE(units.number(100.0, "degC", 1), QStringLiteral("212.0"));
        QCOMPARE(units.difference(5.0, "K", 1), QStringLiteral("9.0"));
        QCOMPARE(units.difference(5.0, "degC", 1), QStringLiteral("9.0"));
    }
    void anAmericanShopSaysPoundsAndInchesPerMinute() {
        const UnitSystem units(LengthUnit::Inch, TemperatureUnit::Fahrenheit);
        QCOMPARE(units.withUnit(444.82216152605, "N", 0), QStringLiteral("100.0\u00a0lbf"));
        QCOMPARE(units.withUnit(25.4, "mm/s", 1), QStringLiteral("60.0\u00a0in/min"));
        QCOMPARE(units.withUnit(254.0, "mm/min", 0), QStringLiteral("10.0\u00a0in/min"));
        QCOMPARE(units.withUnit(1.0, "N/um", 0), QStringLiteral("5710\u00a0lbf/in"));
    }
    void unknownUnitsPassThrough() {
        QCOMPARE(UnitSystem(LengthUnit::Inch, TemperatureUnit::Fahrenheit).withUnit(3.0, "rpm", 0),
                 QStringLiteral("3\u00a0rpm"));
        QCOMPARE(UnitSystem().withUnit(0.5025, "", 3), QStringLiteral("0.502"));
    }
    void minusIsAMinusAndZeroHasNoSign() {
        QCOMPARE(UnitSystem::fixed(-1.26, 1), QStringLiteral("\u22121.3"));
        QCOMPARE(UnitSystem::fixed(-0.0004, 3), QStringLiteral("0.000"));
    }
    void typedNumbersAreReadOrRefused() {
        double value = 0.0;
        QVERIFY(UnitSystem::parse(QStringLiteral(" 50,011 "), value));
        QCOMPARE(value, 50.011);
        for (const char* bad : {"", "abc", "1.2.3", "nan", "inf", "5 0"}) {
            QVERIFY2(!UnitSystem::parse(QString::fromLatin1(bad), value), bad);
        }
    }
    void everyRowReturnsToTheStoredValue() {
        const UnitSystem units(LengthUnit::Inch, TemperatureUnit::Fahrenheit);
        for (const char* unit :
             {"mm", "um", "mm/rev", "mm/s", "mm/min", "mm/tooth", "degC", "K", "N/mm", "N/um", "N", ""}) {
            const DisplayUnit shown = units.of(unit);
            QVERIFY(std::abs(shown.toStored(shown.toShown(12.345)) - 12.345) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(TestUnits)
#include "tst_units.moc"
