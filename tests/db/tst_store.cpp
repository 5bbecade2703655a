// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>

#include "db/data_file.h"
#include "db/head_file.h"
#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/writer_thread.h"
#include "db_test_support.h"
#include "engine/api/part_results.h"

using namespace kerf;
using test::measured;
using test::stateOf;

namespace {
MeasurementId accept(test::Shop& shop, const MeasurementRow& row, double alpha = 0.5) {
    return shop.must(AcceptMeasurement{row, {stateOf(alpha)}, std::nullopt}).id;
}
MeasurementRow correctionOf(MeasurementId id, double diameter_mm) {
    MeasurementRow row = measured(0, 0, diameter_mm);
    row.kind = MeasurementKind::Correction;
    row.replaces = id;
    row.reason = "read again";
    return row;
}
MeasurementRow voidOf(MeasurementId id) {
    MeasurementRow row = correctionOf(id, 1.0);
    row.kind = MeasurementKind::Void;
    row.diameter_mm.reset();
    return row;
}
/// A bored part that comes back with this order.
PartRecord ofOrder(std::uint32_t sequence, const WorkOrder& order) {
    PartRecord record = test::boringPart(sequence);
    record.order = order;
    return record;
}
}  // namespace

/// What the tables promise, seen through the store and past it.
class TestStore : public QObject {
    Q_OBJECT
 private slots:
    void ensuringTwiceFindsTheSame() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        QCOMPARE(shop.must(EnsureMachine{"VB-1", "simulator"}).id, shop.machine);
        QCOMPARE(shop.must(EnsurePartType{ProcessId::Boring, "Sleeve 50", "{}", "Lee"}).id, shop.partType);
        QCOMPARE(shop.must(EnsureLot{shop.machine, shop.partType, shop.recipe, "12", 30, "kalman", "Lee"}).id,
                 shop.lot);
    }
    void partKeepsScheduleAndFeedTrace() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        PartRecord record = test::boringPart(7, 3);
        const PartId id = shop.must(AddPart{shop.lot, record, "SN-0007"}).id;
        const auto detail = shop.reader()->part(id);
        QVERIFY(detail && *detail);
        QCOMPARE((*detail)->part.serial, std::string("SN-0007"));
        QCOMPARE((*detail)->part.machineEnd_ns - (*detail)->part.machineBegin_ns, std::int64_t{41'000'000'000});
        QVERIFY((*detail)->schedule);
        QCOMPARE((*detail)->schedule->schedule.revision, 3U);
        QCOMPARE((*detail)->schedule->schedule.lnC, record.schedule.lnC);
        QCOMPARE((*detail)->feed.count, record.feed.count);
        QVERIFY((*detail)->feed.overhang_mm == record.feed.overhang_mm);
        QVERIFY((*detail)->feed.feed_mmPerRev == record.feed.feed_mmPerRev);
    }
    void figuresOfAPartComeBackInTheirOrder() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        PartRecord record;
        record.process = ProcessId::Milling;
        record.milling.waviness_um = 52.25;
        record.milling.peakForce_N = 431.5;
        record.milling.meanForce_N =
            std::numeric_limits<double>::quiet_NaN();  // not stored, and no reason to lose the part
        const PartId id = shop.must(AddPart{std::nullopt, record, {}}).id;
        const auto detail = shop.reader()->part(id);
        QVERIFY(detail && *detail);
        const std::vector<PartFigure>& figures = (*detail)->part.figures;
        QCOMPARE(figures.size(), partResultRows(ProcessId::Milling).size() - 1);
        QCOMPARE(figures[0].key, std::string("waviness_um"));
        QCOMPARE(figures[0].value, 52.25);
        QCOMPARE(figures[1].key, std::string("force_peak_N"));
        QCOMPARE(figures[1].value, 431.5);
    }
    void partsOfNoLotAreNumberedPerProcess() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        PartRecord milled;
        milled.process = ProcessId::Milling;
        PartRecord turned;
        turned.process = ProcessId::Turning;
        QCOMPARE(shop.must(AddPart{std::nullopt, milled, {}}).second, 1);
        QCOMPARE(shop.must(AddPart{std::nullopt, turned, {}}).second, 1);
        QCOMPARE(shop.must(AddPart{std::nullopt, milled, {}}).second, 2);
    }
    void roomRecordsStayAndTheNewestComesFirst() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(AddRoomRecord{ProcessId::Tapping, "tuning", "M8", R"({"z_kp_per_s":40})", "Lee", "first"});
        (void)shop.must(AddRoomRecord{ProcessId::Tapping, "tuning", "M10", R"({"z_kp_per_s":41})", "Lee", ""});
        (void)shop.must(AddRoomRecord{ProcessId::Tapping, "tuning", "M8", R"({"z_kp_per_s":42})", "Kim", "new tap"});
        const auto of = [&](const std::string& subject) {
            return shop.reader()->roomRecords(ProcessId::Tapping, "tuning", subject, 10);
        };
        QCOMPARE(of("M8")->size(), std::size_t{2});
        QCOMPARE(of("M8")->front().bodyJson, std::string(R"({"z_kp_per_s":42})"));
        QCOMPARE(of("M8")->front().author, std::string("Kim"));
        QCOMPARE(of("")->size(), std::size_t{3});
        QCOMPARE(shop.reader()->roomRecords(ProcessId::Milling, "tuning", "", 10)->size(), std::size_t{0});
        QVERIFY(!shop.tried(AddRoomRecord{ProcessId::Tapping, "tuning", "M8", "{broken", "Lee", ""}));
        QVERIFY(!test::tryExecute(shop.database(), "UPDATE room_records SET body = '{}'"));
        QVERIFY(!test::tryExecute(shop.database(), "DELETE FROM room_records"));
    }
    void partsCutWithOneScheduleShareItsRow() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        ScheduleRow proposed;
        proposed.lot = shop.lot;
        proposed.schedule = test::boringPart(1, 5).schedule;
        proposed.predictionJson = "[50.003]";
        const ScheduleId id = shop.must(StoreSchedule{proposed}).id;
        QCOMPARE(shop.must(AcceptSchedule{shop.lot, 5, "Kim"}).id, id);
        const PartId a = shop.must(AddPart{shop.lot, test::boringPart(1, 5), {}}).id;
        const PartId b = shop.must(AddPart{shop.lot, test::boringPart(2, 5), {}}).id;
        const auto reader = shop.reader();
        QCOMPARE((*reader->part(a))->schedule->id, id);
        QCOMPARE((*reader->part(b))->schedule->id, id);
        QCOMPARE((*reader->part(b))->schedule->predictionJson, std::string("[50.003]"));
        QCOMPARE((*reader->part(b))->schedule->acceptedBy, std::string("Kim"));
    }
    void scheduleOfAPartIsFilledInLater() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.must(AddPart{shop.lot, test::boringPart(1, 5), {}}).id;
        ScheduleRow late;
        late.lot = shop.lot;
        late.schedule = test::boringPart(1, 5).schedule;
        late.predictionJson = "[1]";
        late.acceptedBy = "Kim";
        (void)shop.must(StoreSchedule{late});
        const auto detail = shop.reader()->part(part);
        QCOMPARE((*detail)->schedule->predictionJson, std::string("[1]"));
        QVERIFY((*detail)->schedule->acceptedUtc_ms);
    }
    void partIsKeptEvenWithAnUnstorableSchedule() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        PartRecord record = test::boringPart(1);
        record.schedule.lnC = std::numeric_limits<double>::quiet_NaN();
        record.end_ns = record.begin_ns - 5;
        const auto stored = shop.store().addParts(std::span(&record, 1));
        QVERIFY(stored);
        const auto detail = shop.reader()->part(stored->front().id);
        QVERIFY(*detail && !(*detail)->schedule);
    }
    void partOfNoLotIsKept() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartRecord record = test::boringPart(1);
        const auto stored = shop.store().addParts(std::span(&record, 1));
        QVERIFY(stored);
        QVERIFY(!stored->front().lot);
        QCOMPARE(shop.reader()->parts({})->size(), std::size_t{1});
    }
    void finishedPartsGoToTheLotOfTheirOrder() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(SetActiveLot{ProcessId::Boring, shop.lot, "Lee"});
        const std::array records{ofOrder(1, {shop.lot, shop.recipe, 1}), ofOrder(2, {shop.lot, shop.recipe, 1}),
                                 ofOrder(3, {}), ofOrder(4, {shop.lot + 7, shop.recipe + 7, 1})};
        const auto stored = shop.store().addParts(records);
        QVERIFY(stored);
        QCOMPARE(stored->at(1).lot, std::optional(shop.lot));
        QCOMPARE(stored->at(1).recipe, std::optional(shop.recipe));
        QCOMPARE(stored->at(1).number, 2U);
        QVERIFY(!stored->at(2).lot);                           // the active one is nobody's guess
        QVERIFY(!stored->at(3).lot && !stored->at(3).recipe);  // of another data file: kept without
        const auto rows = *shop.reader()->parts({});
        QCOMPARE(rows.size(), std::size_t{4});
        QCOMPARE(rows[3].recipe, std::optional(shop.recipe));
        QCOMPARE(rows[3].recipeRevision, 1U);
        QCOMPARE(rows[3].partTypeName, std::string("Sleeve 50"));
        QCOMPARE(*shop.reader()->activeLot(ProcessId::Boring), std::optional(shop.lot));
        QVERIFY(!*shop.reader()->activeLot(ProcessId::Milling));
    }
    void aMilledLotIsALotLikeABoredOne() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const Receipt rail = shop.must(EnsurePartType{ProcessId::Milling, "Rail", "{}", "Lee"});
        const EnsureLot order{shop.machine, rail.id, rail.second, "R7", 40, "", "Kim", "end mill 8", "caliper 3"};
        const LotId lot = shop.must(order).id;
        QVERIFY(lot != shop.lot);
        PartRecord record = ofOrder(1, {lot, rail.second, 0});
        record.process = ProcessId::Milling;
        PartRecord lost = record;  // a bored part is of no milled lot
        lost.process = ProcessId::Boring;
        const auto stored = shop.store().addParts(std::array{record, lost});
        QVERIFY(stored);
        QCOMPARE(stored->at(0).lot, std::optional(lot));
        QVERIFY(!stored->at(1).lot && !stored->at(1).recipe);
        (void)shop.must(CloseLot{lot, "Choi", "done"});
        QVERIFY(!shop.tried(CloseLot{lot, "Choi", "again"}));
        const auto lots = *shop.reader()->lots(std::nullopt, 9, ProcessId::Milling);
        QCOMPARE(lots.size(), std::size_t{1});
        QCOMPARE(lots[0].tool, std::string("end mill 8"));
        QCOMPARE(lots[0].gauge, std::string("caliper 3"));
        QCOMPARE(lots[0].openedBy, std::string("Kim"));
        QCOMPARE(lots[0].closedBy, std::string("Choi"));
        QCOMPARE(lots[0].recipeRevision, 1U);
        QCOMPARE(shop.reader()->lots(std::nullopt, 9, ProcessId::Boring)->size(), std::size_t{1});
        QCOMPARE(shop.reader()->lots(std::nullopt, 9)->size(), std::size_t{2});
        for (const char* sql :
             {"UPDATE lots SET tool = 'x'", "UPDATE lots SET closed_utc_ms = 1 WHERE name = 'R7'", "DELETE FROM lots",
              "UPDATE parts SET lot_id = NULL", "DELETE FROM parts", "UPDATE part_results SET results = '{}'"}) {
            QVERIFY2(!test::tryExecute(shop.database(), sql), sql);
        }
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
    }
    void aLotOrPartThatWasChangedIsFound_data() {
        QTest::addColumn<QString>("sql");
        QTest::newRow("lot's name") << "UPDATE lots SET name = '13'";
        QTest::newRow("lot's recipe") << "UPDATE lots SET recipe_revision_id = 2";
        QTest::newRow("lot's tool") << "UPDATE lots SET tool = 'x'";
        QTest::newRow("who opened it") << "UPDATE lots SET opened_by = 'Choi'";
        QTest::newRow("when it was opened") << "UPDATE lots SET opened_utc_ms = opened_utc_ms + 1";
        QTest::newRow("closed by nobody") << "UPDATE lots SET closed_utc_ms = 1";
        QTest::newRow("lot gone") << "DELETE FROM lots";
        QTest::newRow("part's lot") << "UPDATE parts SET lot_id = NULL WHERE id = 2";
        QTest::newRow("part's recipe") << "UPDATE parts SET recipe_revision_id = 2 WHERE id = 2";
        QTest::newRow("part complete") << "UPDATE parts SET complete = 0 WHERE id = 3";
        QTest::newRow("part's figure") << "UPDATE part_results SET results = '{}' WHERE part_id = 2";
        QTest::newRow("part gone") << "DELETE FROM parts WHERE id = 2";
        QTest::newRow("part slipped in")
            << "INSERT INTO parts (process, number, complete, machine_begin_ns, machine_end_ns, "
               "ended_utc_ms) VALUES ('boring', 9, 1, 0, 0, 0)";
    }
    void aLotOrPartThatWasChangedIsFound() {
        QFETCH(QString, sql);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(SaveRecipe{shop.partType, "{}", "Lee", "other", {}});
        for (std::uint32_t i = 1; i <= 3; ++i) {
            db::FinishedPart part{ofOrder(i, {shop.lot, shop.recipe, 1}), 1000 + i, R"({"force_mean_N":3.5})"};
            QVERIFY(shop.store().addParts(std::span<const db::FinishedPart>(&part, 1)));
        }
        (void)shop.must(SetPartSerial{2, "SN-2", "Lee", "engraved"});  // the one thing that may change
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        for (const char* trigger :
             {"lots_only_closed", "lots_no_delete", "parts_only_serial", "parts_no_delete", "part_results_no_update"}) {
            QVERIFY(test::tryExecute(shop.database(), QStringLiteral("DROP TRIGGER %1").arg(trigger).toUtf8()));
        }
        QVERIFY(test::tryExecute(shop.database(), "PRAGMA foreign_keys = OFF"));
        QVERIFY(test::tryExecute(shop.database(), sql.toUtf8()));
        QVERIFY(!shop.reader()->verifyAudit()->finding.empty());
    }
    void measurementIsStoredWithStateScheduleAndAudit() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        ScheduleRow next;
        next.lot = shop.lot;
        next.schedule = test::boringPart(1, 2).schedule;
        const MeasurementId id = shop.must(AcceptMeasurement{measured(part, 1, 50.0123), {stateOf(0.61)}, next}).id;
        const auto history = shop.reader()->history(shop.lot);
        QVERIFY(history && *history);
        QCOMPARE((*history)->measurements.size(), std::size_t{1});
        QCOMPARE(*(*history)->measurements[0].diameter_mm, 50.0123);
        QCOMPARE((*history)->measurements[0].position_mm, 310.0);
        QCOMPARE((*history)->lastState->measurement, id);
        QCOMPARE((*history)->lastState->theta[1], 0.61);
        QCOMPARE((*history)->schedules.back().schedule.revision, 2U);
        const auto log = shop.reader()->audit(std::nullopt, 1);
        QCOMPARE(log->front().object, std::string("measurement"));
        QCOMPARE(log->front().objectId, id);
        QCOMPARE(log->front().author, std::string("Kim"));
    }
    void failureAnywhereStoresNothing() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        EstimatorStateRow bad = stateOf(0.5);
        bad.stateJson = "{no json";
        QVERIFY(!shop.tried(AcceptMeasurement{measured(part, 0, 50.0), {stateOf(0.5), bad}, std::nullopt}));
        EstimatorStateRow noNumber = stateOf(std::numeric_limits<double>::quiet_NaN());
        noNumber.stateJson = "{}";
        QVERIFY(!shop.tried(AcceptMeasurement{measured(part, 0, 50.0), {noNumber}, std::nullopt}));
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM measurements"), std::int64_t{0});
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM estimator_states"), std::int64_t{0});
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM audit WHERE object = 'measurement'"),
                 std::int64_t{0});
        // Numbers of rolled-back rows are used again: the log and the ids stay without gaps.
        QCOMPARE(accept(shop, measured(part, 0, 50.0)), MeasurementId{1});
    }
    void impossibleMeasurementsAreRefused_data() {
        QTest::addColumn<double>("diameter_mm");
        QTest::addColumn<QString>("author");
        QTest::newRow("zero") << 0.0 << "Kim";
        QTest::newRow("negative") << -50.0 << "Kim";
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << "Kim";
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << "Kim";
        QTest::newRow("nobody") << 50.0 << "";
    }
    void impossibleMeasurementsAreRefused() {
        QFETCH(double, diameter_mm);
        QFETCH(QString, author);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        MeasurementRow row = measured(shop.addPart(1), 0, diameter_mm);
        row.author = author.toStdString();
        const auto refused = shop.tried(AcceptMeasurement{row, {}, std::nullopt});
        QVERIFY(!refused);
        QVERIFY(!refused.error().empty());
        QCOMPARE(test::number(shop.database(), "SELECT count(*) FROM measurements"), std::int64_t{0});
    }
    void appendOnlyTablesRefuseChanges_data() {
        QTest::addColumn<QString>("sql");
        for (const char* table : {"measurements", "audit", "estimator_states", "recipe_revisions"}) {
            const char* column = QByteArray(table) == "estimator_states" ? "alpha = 9" : "author = 'x'";
            QTest::addRow("update %s", table) << QStringLiteral("UPDATE %1 SET %2").arg(table, column);
            QTest::addRow("delete %s", table) << QStringLiteral("DELETE FROM %1").arg(table);
        }
        QTest::newRow("replace measurement") << "INSERT OR REPLACE INTO measurements SELECT id, part_id, kind, "
                                                "replaces_id, station, position_mm, 60.0, source, "
                                                "confirmed, author, reason, accepted_utc_ms FROM measurements";
        QTest::newRow("update measurement_sources") << "UPDATE measurement_sources SET name = 'G-08'";
        QTest::newRow("delete measurement_sources") << "DELETE FROM measurement_sources";
        QTest::newRow("replace measurement_sources") << "INSERT OR REPLACE INTO measurement_sources SELECT "
                                                        "measurement_id, 'gauge', 'G-08' FROM measurement_sources";
        QTest::newRow("replace audit")
            << "INSERT OR REPLACE INTO audit SELECT id, utc_ms, 'x', action, object, object_id, "
               "old_value, new_value, reason, previous_hash, hash FROM audit";
    }
    void appendOnlyTablesRefuseChanges() {
        QFETCH(QString, sql);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        MeasurementRow row = measured(shop.addPart(1), 0, 50.0);
        row.source = MeasurementSource::Gauge;
        row.sourceName = "G-07";
        accept(shop, row);
        QVERIFY(!test::tryExecute(shop.database(), sql.toUtf8()));
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
    }
    void correctionsFormAChain() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const MeasurementId first = accept(shop, measured(part, 0, 50.1));
        accept(shop, measured(part, 1, 50.2));
        const MeasurementId second = accept(shop, correctionOf(first, 50.01));
        const MeasurementId third = accept(shop, correctionOf(second, 50.02));
        auto history = *shop.reader()->history(shop.lot);
        QCOMPARE(history->measurements.size(), std::size_t{4});  // the old values stay on record
        auto effective = effectiveMeasurements(history->measurements);
        QCOMPARE(effective.size(), std::size_t{2});
        QCOMPARE(effective[0].id, third);  // in the place of the one it replaces
        QCOMPARE(*effective[0].diameter_mm, 50.02);
        QCOMPARE(*effective[1].diameter_mm, 50.2);
        // A row is replaced once; the second try meets a newer value.
        QVERIFY(!shop.tried(AcceptMeasurement{correctionOf(first, 50.03), {}, std::nullopt}));
        accept(shop, voidOf(third));
        history = *shop.reader()->history(shop.lot);
        effective = effectiveMeasurements(history->measurements);
        QCOMPARE(effective.size(), std::size_t{1});
        QCOMPARE(*effective[0].diameter_mm, 50.2);
    }
    void correctionNeedsReasonAndTarget() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const MeasurementId id = accept(shop, measured(shop.addPart(1), 0, 50.0));
        MeasurementRow row = correctionOf(id, 50.01);
        row.reason.clear();
        QVERIFY(!shop.tried(AcceptMeasurement{row, {}, std::nullopt}));
        QVERIFY(!shop.tried(AcceptMeasurement{correctionOf(id + 100, 50.01), {}, std::nullopt}));
        // Past the store as well: another station is no correction.
        QVERIFY(!test::tryExecute(
            shop.database(),
            "INSERT INTO measurements (part_id, kind, replaces_id, station, position_mm, diameter_mm, "
            "source, confirmed, author, reason, accepted_utc_ms) SELECT part_id, 'correction', id, 5, 1, "
            "50, 'keypad', 0, 'x', 'y', 0 FROM measurements"));
    }
    void recomputedStatesReplaceOlderOnes() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const MeasurementId a = accept(shop, measured(part, 0, 50.1), 0.5);
        const MeasurementId b = accept(shop, measured(part, 1, 50.2), 0.6);
        EstimatorStateRow again = stateOf(0.66);
        again.measurement = b;
        const MeasurementId c =
            shop.must(AcceptMeasurement{correctionOf(a, 50.0), {stateOf(0.55), again}, std::nullopt}).id;
        const auto history = *shop.reader()->history(shop.lot);
        QCOMPARE(history->states.size(), std::size_t{3});
        QCOMPARE(history->states[1].measurement, b);
        QCOMPARE(history->states[1].theta[1], 0.66);
        QCOMPARE(history->states[1].cause, c);
        QCOMPARE(history->lastState->theta[1], 0.66);
    }
    void tamperingIsFound_data() {
        QTest::addColumn<QString>("sql");
        QTest::newRow("audit text") << "UPDATE audit SET new_value = 'x' WHERE id = 4";
        QTest::newRow("audit author") << "UPDATE audit SET author = 'Choi' WHERE id = 4";
        QTest::newRow("audit entry gone") << "DELETE FROM audit WHERE id = 4";
        QTest::newRow("measurement value") << "UPDATE measurements SET diameter_mm = 50.0001 WHERE id = 2";
        QTest::newRow("measurement author") << "UPDATE measurements SET author = 'Choi' WHERE id = 2";
        QTest::newRow("measurement gone") << "DELETE FROM measurements WHERE id = 3";
        QTest::newRow("measurement slipped in")
            << "INSERT INTO measurements SELECT 99, part_id, 'entry', NULL, 4, 1, 50, source, 0, author, '', 0 FROM "
               "measurements WHERE id = 1";
    }
    void tamperingIsFound() {
        QFETCH(QString, sql);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        for (std::uint32_t i = 1; i <= 3; ++i) {
            (void)shop.must(AcceptMeasurement{measured(shop.addPart(i), 0, 50.0 + 0.001 * i), {}, std::nullopt});
        }
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        QCOMPARE(shop.reader()->verifyAudit()->measurements, std::uint64_t{3});
        for (const char* trigger :
             {"audit_no_update", "audit_no_delete", "measurements_no_update", "measurements_no_delete"}) {
            QVERIFY(test::tryExecute(shop.database(), QStringLiteral("DROP TRIGGER %1").arg(trigger).toUtf8()));
        }
        // Whoever goes past the program minds no references either.
        QVERIFY(test::tryExecute(shop.database(), "PRAGMA foreign_keys = OFF"));
        QVERIFY(test::tryExecute(shop.database(), sql.toUtf8()));
        const auto verdict = shop.reader()->verifyAudit();
        QVERIFY(verdict);
        QVERIFY(!verdict->finding.empty());
        QVERIFY(verdict->firstBad);
    }
    void aKeptModelChangedByOneDigitIsFound_data() {
        QTest::addColumn<QString>("sql");
        QTest::newRow("kept model") << "UPDATE room_records SET body = '{\"half_um\":2.2}' WHERE id = 1";
        QTest::newRow("kept model, last one gone") << "DELETE FROM room_records WHERE id = 2";
        QTest::newRow("recipe")
            << "UPDATE recipe_revisions SET parameters = '{\"target_diameter_mm\":51}' WHERE id = 1";
        QTest::newRow("setting") << "UPDATE settings SET value = 'inch' WHERE key = 'display.unit'";
    }
    void aKeptModelChangedByOneDigitIsFound() {
        QFETCH(QString, sql);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        for (int i = 0; i < 2; ++i) {
            (void)shop.must(AddRoomRecord{ProcessId::Thermal, "model", "Z", R"({"half_um":2.1})", "Lee", "trained"});
        }
        (void)shop.must(ChangeSetting{"display.unit", "mm", "Lee", "drawing"});
        QVERIFY(shop.reader()->verifyAudit()->finding.empty());
        QCOMPARE(shop.reader()->verifyAudit()->roomRecords, std::uint64_t{2});
        for (const char* trigger : {"room_records_no_update", "room_records_no_delete", "recipe_revisions_no_update"}) {
            QVERIFY(test::tryExecute(shop.database(), QStringLiteral("DROP TRIGGER %1").arg(trigger).toUtf8()));
        }
        QVERIFY(test::tryExecute(shop.database(), sql.toUtf8()));
        QVERIFY(!shop.reader()->verifyAudit()->finding.empty());
        const auto whole = db::checkDatabase(scratch.path());
        QVERIFY(!whole);
        QVERIFY(!db::backupDatabase(scratch.path(), scratch.file("copy.db")));
        QVERIFY(!QFile::exists(QString::fromStdString(scratch.file("copy.db"))));
    }
    void theHeadKnowsTheNewestRowOfEveryTableThatOnlyGrows() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const db::Head before = db::headOf(shop.database());
        QVERIFY(!before.rows.contains("measurements"));
        accept(shop, measured(part, 0, 50.0));
        accept(shop, measured(part, 1, 50.0));
        const db::Head head = db::headOf(shop.database());
        QCOMPARE(head.rows.at("parts"), std::int64_t{1});
        QCOMPARE(head.rows.at("measurements"), std::int64_t{2});
        QCOMPARE(head.rows.at("estimator_states"), std::int64_t{2});
        QCOMPARE(head.rows.at("audit"), head.auditId);
        QCOMPARE(head.rows.at("outbox"), test::number(shop.database(), "SELECT max(seq) FROM outbox"));
        QVERIFY(db::missingSince(head, shop.database()).empty());
        // The newest row taken out past the program: the number that was given out is missing.
        QVERIFY(test::tryExecute(shop.database(), "DELETE FROM outbox WHERE seq = (SELECT max(seq) FROM outbox)"));
        QVERIFY(!db::missingSince(head, shop.database()).empty());
    }
    void aLogFileThatWasCutIsNoticed() {
        test::ScratchDatabase scratch;
        const QString path = QString::fromStdString(scratch.path());
        const QString kept = path + QStringLiteral(".kept");
        {
            db::WriterThread writer(scratch.path(), nullptr);
            QVERIFY(writer.start());
            QVERIFY(QFile::copy(path, kept));  // as if the log file behind it had been thrown away
            int done = 0;
            for (int i = 0; i < 5; ++i) {
                writer.submit(ChangeSetting{"k", std::to_string(i), "Lee", ""}, [&](const auto&) { ++done; });
            }
            QTRY_COMPARE(done, 5);
        }
        {
            const auto whole = db::DataFile::open(scratch.path());
            QVERIFY(whole);
            QVERIFY((*whole)->finding().missing.empty());
        }
        QFile::remove(path + QStringLiteral("-wal"));
        QFile::remove(path + QStringLiteral("-shm"));
        QVERIFY(QFile::remove(path) && QFile::rename(kept, path));
        const auto verdict = (*db::DatabaseReader::open(scratch.path()))->verifyAudit();
        QVERIFY(verdict);
        QVERIFY2(verdict->finding.english().find("missing") != std::string::npos, verdict->finding.english().c_str());
        const auto opened = db::DataFile::open(scratch.path());
        QVERIFY(opened);
        QVERIFY(!(*opened)->finding().missing.empty());  // said, and noted in the log
        const auto log = (*db::DatabaseReader::open(scratch.path()))->audit(std::nullopt, 1);
        QCOMPARE(log->front().action, std::string("data found missing"));
    }
    void oldSealsLeaveTheLogAndTheChainStaysWhole() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(ChangeSetting{"operators", "Kim\tengineer\tsalt1:abcdef", "Kim", ""});
        (void)shop.must(ChangeSetting{"operators", "Kim\tengineer\tsalt2:fedcba\nLee\toperator\t", "Kim", ""});
        QVERIFY(shop.store().adoptEarlierForms());
        const auto verdict = shop.reader()->verifyAudit();
        QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
        QCOMPARE(verdict->redacted, std::uint64_t{2});
        const auto entries = shop.reader()->audit(std::nullopt, 100);
        for (const AuditRow& row : *entries) {
            QVERIFY(row.oldValue.find("abcdef") == std::string::npos &&
                    row.newValue.find("abcdef") == std::string::npos);
            QVERIFY(row.newValue.find("fedcba") == std::string::npos);
        }
        const auto accounts = *shop.reader()->accounts();
        QCOMPARE(accounts.size(), std::size_t{2});
        QCOMPARE(accounts[0].roleKey, std::string("engineer"));
        QCOMPARE(accounts[0].seal, std::string("old:salt2:fedcba"));
        QVERIFY(!*shop.reader()->setting("operators"));
        QVERIFY(shop.store().adoptEarlierForms());  // a second time: nothing to do
        QCOMPARE(shop.reader()->verifyAudit()->redacted, std::uint64_t{2});
        // A redacted entry that is changed once more is found.
        QVERIFY(test::tryExecute(shop.database(), "DROP TRIGGER audit_no_update"));
        QVERIFY(
            test::tryExecute(shop.database(), "UPDATE audit SET new_value = 'x' WHERE object = 'setting operators'"));
        QVERIFY(!shop.reader()->verifyAudit()->finding.empty());
    }
    void everyFieldOfAnEntryIsHashed() {
        const AuditRow row{1, 2, "a", "b", "c", 3, "d", "e", "f", "g", ""};
        const std::string hash = db::auditHash(row);
        QCOMPARE(hash.size(), std::size_t{64});
        AuditRow moved = row;  // "d"+"e" and "de"+"" would be the same text without lengths
        moved.oldValue = "de";
        moved.newValue = "";
        QVERIFY(db::auditHash(moved) != hash);
        AuditRow later = row;
        later.utc_ms = 3;
        QVERIFY(db::auditHash(later) != hash);
    }
    void settingKeepsOldValueInTheAudit() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.must(ChangeSetting{"display.unit", "mm", "Lee", "drawing"});
        (void)shop.must(ChangeSetting{"display.unit", "inch", "Kim", "customer"});
        (void)shop.must(ChangeSetting{"display.unit", "inch", "Kim", "again"});  // no change, no entry
        QCOMPARE(*shop.reader()->setting("display.unit"), std::optional<std::string>("inch"));
        QVERIFY(!*shop.reader()->setting("none"));
        const auto log = *shop.reader()->audit(std::nullopt, 2);
        QCOMPARE(log[0].oldValue, std::string("mm"));
        QCOMPARE(log[0].newValue, std::string("inch"));
        QCOMPARE(log[0].reason, std::string("customer"));
        QCOMPARE(log[1].newValue, std::string("mm"));
    }
    void recipesKeepEveryRevisionAndRollBackAsANewOne() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        QCOMPARE(shop.must(SaveRecipe{shop.partType, R"({"target_diameter_mm":51})", "Kim", "new drawing", {}}).second,
                 std::int64_t{2});
        QCOMPARE(shop.must(RestoreRecipe{shop.partType, 1, "Lee", "drawing withdrawn"}).second, std::int64_t{3});
        QVERIFY(!shop.tried(RestoreRecipe{shop.partType, 9, "Lee", "?"}));
        QVERIFY(!shop.tried(SaveRecipe{shop.partType, "not json", "Lee", "?", {}}));
        const auto revisions = *shop.reader()->recipes(shop.partType);
        QCOMPARE(revisions.size(), std::size_t{3});
        QCOMPARE(revisions[0].restoredFrom, std::optional(1U));
        QCOMPARE(revisions[0].parametersJson, revisions[2].parametersJson);
        // The lot keeps the revision it was opened with.
        QCOMPARE((*shop.reader()->history(shop.lot))->recipe.revision, 1U);
    }
    void alarmsOutliveTheConsole() {
        test::ScratchDatabase scratch;
        AlarmId standing = 0;
        {
            test::Shop shop(scratch.path());
            (void)shop.must(
                RaiseAlarm{7, 1, Sentence("Link lost after %1 s (%2)", SentenceArg(1.5, 1), SentenceArg("port"))});
            (void)shop.must(ClearAlarm{7});
            standing = shop.must(RaiseAlarm{101, 2, Sentence("Bore outside")}).id;
        }
        test::Shop shop(scratch.path());
        (void)shop.must(CloseAlarmsOfLastRun{});
        (void)shop.must(AcknowledgeAlarm{standing, "Kim"});
        (void)shop.must(AcknowledgeAlarm{standing, "Lee"});  // the first hand counts
        const auto rows = *shop.reader()->alarms(std::nullopt, 10);
        QCOMPARE(rows.size(), std::size_t{2});
        QVERIFY(rows[0].endedByRestart);
        QCOMPARE(rows[0].acknowledgedBy, std::string("Kim"));
        QVERIFY(!rows[1].endedByRestart);
        QVERIFY(rows[1].clearedUtc_ms);
        QCOMPARE(rows[1].detailText, std::string("Link lost after %1 s (%2)"));
        QCOMPARE(rows[1].detailArgs.size(), std::size_t{2});
        QCOMPARE(formatArg(rows[1].detailArgs[0]), std::string("1.5"));
        QCOMPARE(formatArg(rows[1].detailArgs[1]), std::string("port"));
        QCOMPARE(shop.reader()->openAlarms()->size(), std::size_t{1});
        QCOMPARE(shop.reader()->alarms(rows[0].id, 10)->size(), std::size_t{1});
    }
    void readersCannotWrite() {
        test::ScratchDatabase scratch;
        const test::Shop shop(scratch.path());
        const db::Connection reader(scratch.path(), db::Access::Read);
        QVERIFY(!test::tryExecute(reader.database(), "INSERT INTO settings VALUES ('a', 'b', 'c', 1)"));
    }
    void searchFindsBySerialLotAndType_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("found");
        QTest::newRow("all") << "" << 60;
        QTest::newRow("serial start") << "sn-00" << 9;
        QTest::newRow("serial whole") << "SN-007" << 1;
        QTest::newRow("lot name piece") << "lot-b" << 10;
        QTest::newRow("type piece") << "EEVE" << 50;
        QTest::newRow("wildcards are letters") << "%" << 0;
        QTest::newRow("nothing") << "zebra" << 0;
    }
    void searchFindsBySerialLotAndType() {
        QFETCH(QString, text);
        QFETCH(int, found);
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const Receipt other = shop.must(EnsurePartType{ProcessId::Boring, "Ring 80", "{}", "Lee"});
        const LotId lotB = shop.must(EnsureLot{shop.machine, other.id, other.second, "LOT-B", 10, "kalman", "Lee"}).id;
        for (std::uint32_t i = 1; i < 10; ++i) {
            (void)shop.must(AddPart{shop.lot, test::boringPart(i), "SN-00" + std::to_string(i)});
        }
        QVERIFY(shop.store().addParts(std::vector<PartRecord>(41, ofOrder(10, {shop.lot, shop.recipe, 1}))));
        QVERIFY(shop.store().addParts(std::vector<PartRecord>(10, ofOrder(1, {lotB, other.second, 1}))));
        const auto reader = shop.reader();
        PartQuery query;
        query.text = text.toStdString();
        query.limit = 7;
        // Page by page: every match once, newest first.
        int seen = 0;
        PartId last = INT64_MAX;
        while (true) {
            const auto page = reader->parts(query);
            QVERIFY(page);
            if (page->empty()) {
                break;
            }
            for (const PartRow& row : *page) {
                QVERIFY(row.id < last);
                last = row.id;
                ++seen;
            }
            query.before = last;
        }
        QCOMPARE(seen, found);
        query.before.reset();
        QCOMPARE(*reader->count(query, 1000), static_cast<std::uint64_t>(found));
        QCOMPARE(*reader->count(query, 5), static_cast<std::uint64_t>(std::min(found, 5)));
        query.lot = lotB;
        QVERIFY(*reader->count(query, 1000) <= 10);
    }
    void partsCarryTheirMeasurements() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId a = shop.addPart(1);
        const PartId b = shop.addPart(2);
        accept(shop, measured(b, 0, 50.1));
        const MeasurementId wrong = accept(shop, measured(a, 0, 50.2));
        accept(shop, correctionOf(wrong, 50.3));
        const auto rows = *shop.reader()->parts({});
        QCOMPARE(rows[0].id, b);
        QCOMPARE(rows[0].measurements.size(), std::size_t{1});
        QCOMPARE(rows[1].measurements.size(), std::size_t{2});
        QCOMPARE(*effectiveMeasurements(rows[1].measurements)[0].diameter_mm, 50.3);
    }
};

QTEST_GUILESS_MAIN(TestStore)
#include "tst_store.moc"
