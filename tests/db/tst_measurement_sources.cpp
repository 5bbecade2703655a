// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/db/db_test_support.h"

using namespace kerf;
using test::measured;
using test::stateOf;

namespace {

MeasurementId accept(test::Shop& shop, const MeasurementRow& row) {
    return shop.must(AcceptMeasurement{row, {stateOf(0.5)}, std::nullopt}).id;
}

MeasurementRow correctionOf(MeasurementId id, double diameter_mm) {
    MeasurementRow row = measured(0, 0, diameter_mm);
    row.kind = MeasurementKind::Correction;
    row.replaces = id;
    row.reason = "read again";
    return row;
}

}  // namespace

/// Where each value came from is kept with it, and many values at once are all or none.
class TestMeasurementSources : public QObject {
    Q_OBJECT
 private slots:
    void theSourceIsKeptWithEachValue() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const auto from = [&](MeasurementRow row, MeasurementSource source, const char* name) {
            row.source = source;
            row.sourceName = name;
            return accept(shop, row);
        };
        const MeasurementId typed = from(measured(part, 0, 50.1), MeasurementSource::Keypad, "");
        const MeasurementId read = from(measured(part, 1, 50.2), MeasurementSource::Gauge, "G-07; 내경 'a'");
        from(correctionOf(typed, 50.11), MeasurementSource::Gauge, "G-08");
        from(measured(shop.addPart(2), 0, 50.3), MeasurementSource::File, "값.csv");
        QVERIFY(!shop.tried(AcceptMeasurement{[&] {
                                                  MeasurementRow nameless = measured(shop.addPart(3), 0, 50.0);
                                                  nameless.source = MeasurementSource::File;
                                                  return nameless;
                                              }(),
                                              {},
                                              std::nullopt}));
        const auto history = *shop.reader()->history(shop.lot);
        QStringList sources;
        for (const MeasurementRow& row : history->measurements) {
            sources << QLatin1String(sourceKey(row.source)) + u':' + QString::fromStdString(row.sourceName);
        }
        QCOMPARE(sources, (QStringList{QStringLiteral("keypad:"), QStringLiteral("gauge:G-07; 내경 'a'"),
                                       QStringLiteral("gauge:G-08"), QStringLiteral("file:값.csv")}));
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        // What says no more than the measurement itself has no row.
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM measurement_sources"), std::int64_t{3});
        // Past the program: another gauge, or none at all, is found.
        QVERIFY(test::tryExecute(shop.database(), "DROP TRIGGER measurement_sources_no_update"));
        QVERIFY(test::tryExecute(shop.database(), "DROP TRIGGER measurement_sources_no_delete"));
        QVERIFY(test::tryExecute(shop.database(), "UPDATE measurement_sources SET name = 'G-09' WHERE name = 'G-08'"));
        QVERIFY(!shop.reader()->verifyAudit()->finding.empty());
        QVERIFY(test::tryExecute(shop.database(), "UPDATE measurement_sources SET name = 'G-08' WHERE name = 'G-09'"));
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        QVERIFY(test::tryExecute(
            shop.database(),
            ("DELETE FROM measurement_sources WHERE measurement_id = " + std::to_string(read)).c_str()));
        QVERIFY(!shop.reader()->verifyAudit()->finding.empty());
    }
    void aSourceThatWasSlippedInIsFound() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        MeasurementRow row = measured(shop.addPart(1), 0, 50.0);
        accept(shop, row);
        row.station = 1;
        row.source = MeasurementSource::Gauge;  // which one is not known
        accept(shop, row);
        const auto history = *shop.reader()->history(shop.lot);
        QCOMPARE(history->measurements[0].source, MeasurementSource::Keypad);
        QCOMPARE(history->measurements[1].source, MeasurementSource::Gauge);
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        // As version 7 wrote it: the same is said twice.
        QVERIFY(test::tryExecute(shop.database(), "INSERT INTO measurement_sources VALUES (1, 'keypad', '')"));
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        QVERIFY(test::tryExecute(shop.database(), "INSERT INTO measurement_sources VALUES (2, 'gauge', 'G-09')"));
        QVERIFY(!shop.reader()->verifyAudit()->finding.empty());
    }
    void manyAtOnceAreAllOrNothing() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        accept(shop, measured(shop.addPart(2), 0, 50.0));
        EstimatorStateRow first = stateOf(0.51);
        first.measurement = -1;
        EstimatorStateRow second = stateOf(0.52);
        second.measurement = -2;
        const AcceptMeasurements good{
            {{measured(part, 0, 50.1), {}, {}}, {measured(part, 1, 50.2), {first, second}, {}}}};
        AcceptMeasurements bad = good;
        bad.measurements[1].measurement.author.clear();
        QVERIFY(!shop.tried(bad));
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM measurements"), std::int64_t{1});
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM measurement_sources"), std::int64_t{0});
        const Receipt receipt = shop.must(good);
        QCOMPARE(receipt.id, std::int64_t{2});
        QCOMPARE(receipt.second, std::int64_t{2});
        const auto detail = *shop.reader()->part(part);
        QCOMPARE(detail->states.size(), std::size_t{2});
        QCOMPARE(detail->states[0].measurement, receipt.id);
        QCOMPARE(detail->states[0].theta[1], 0.51);
        QCOMPARE(detail->states[1].measurement, receipt.id + 1);
        QCOMPARE(detail->states[1].cause, receipt.id + 1);
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
    }
};

QTEST_GUILESS_MAIN(TestMeasurementSources)
#include "tst_measurement_sources.moc"
