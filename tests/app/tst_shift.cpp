// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDateTime>
#include <QTest>

#include "app/service/boring/boring_recipe.h"
#include "app/service/shift/shift_records.h"
#include "tests/db/db_test_support.h"

using namespace kerf;

namespace {

constexpr std::int64_t kMinute_ms = 60'000;

}  // namespace

/// A shift is what is stored between two handovers; tools are counted from their last change.
class TestShift : public QObject {
    Q_OBJECT

    static Result<ShiftView> read(db::DatabaseReader& file, int back, std::int64_t now_ms) {
        return readShift({file, file, file, file, file}, back, now_ms);
    }

 private slots:
    void pausesLongerThanThreeMinutesAreStops() {
        const std::vector<ShiftCut> cuts{
            {10 * kMinute_ms, 12 * kMinute_ms},
            {14 * kMinute_ms, 16 * kMinute_ms},
            {15 * kMinute_ms, 15 * kMinute_ms + 1},  // another spindle, within the one before
            {30 * kMinute_ms, 31 * kMinute_ms}};
        const auto stops = stopsBetween(cuts, 0, 32 * kMinute_ms, true);
        QCOMPARE(stops.size(), std::size_t{2});
        QCOMPARE(stops[0].fromUtc_ms, 0);
        QCOMPARE(stops[0].toUtc_ms, 10 * kMinute_ms);
        QCOMPARE(stops[1].fromUtc_ms, 16 * kMinute_ms);
        QCOMPARE(stops[1].toUtc_ms, 30 * kMinute_ms);
        const auto open = stopsBetween(cuts, 0, 60 * kMinute_ms, true);
        QVERIFY(open.back().goesOn && open.back().fromUtc_ms == 31 * kMinute_ms);
        QVERIFY(!stopsBetween(cuts, 0, 60 * kMinute_ms, false).back().goesOn);
    }
    void aHandoverEndsTheShiftAndItsNameStands() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        for (std::uint32_t i = 1; i <= 3; ++i) {
            (void)shop.addPart(i);
        }
        (void)shop.must(AddRoomRecord{ProcessId::Boring, kShiftNote, {}, noteJson("coolant is low", false), "Kim", {}});
        (void)shop.must(RaiseAlarm{7, 1, Sentence("Link lost"), {}, {}, {}});
        const auto file = shop.reader();
        const std::int64_t now_ms = QDateTime::currentMSecsSinceEpoch() + 1;
        const auto first = read(*file, 0, now_ms);
        QVERIFY(first.has_value());
        QVERIFY(first->current && first->takenFrom.empty());
        QCOMPARE(first->parts.size(), std::size_t{1});
        QCOMPARE(first->parts[0].made, 3U);
        QCOMPARE(first->parts[0].notJudged, 3U);
        QCOMPARE(first->notes.size(), std::size_t{1});
        QCOMPARE(first->alarms.size(), std::size_t{1});
        QVERIFY(first->alarms[0].stands);
        QVERIFY(!first->changes.empty());  // the lot was opened by somebody
        QVERIFY(first->stops.empty());     // the hours before the first part are no stop
        const auto later = read(*file, 0, now_ms + 10 * kMinute_ms);
        QVERIFY(later.has_value());
        QCOMPARE(later->stops.size(), std::size_t{1});
        QVERIFY(later->stops[0].goesOn && later->stops[0].toUtc_ms - later->stops[0].fromUtc_ms < 11 * kMinute_ms);

        QTest::qWait(2);  // the clock goes on by a millisecond at least
        (void)shop.must(AddRoomRecord{ProcessId::Boring,
                                      kShiftStopReason,
                                      std::to_string(later->stops[0].fromUtc_ms),
                                      stopReasonJson("setup"),
                                      "Kim",
                                      {}});
        (void)shop.must(AddRoomRecord{ProcessId::Boring, kShiftNote, {}, noteJson("all well", true), "Kim", {}});
        const std::int64_t later_ms = QDateTime::currentMSecsSinceEpoch() + 10;
        const auto next = read(*file, 0, later_ms);
        QVERIFY(next.has_value() && next->current);
        QCOMPARE(next->takenFrom, std::string("Kim"));
        QVERIFY(next->parts.empty());
        QCOMPARE(next->notes.size(), std::size_t{1});  // the handover itself is read by who takes over
        const auto before = read(*file, 1, later_ms);
        QVERIFY(before.has_value() && !before->current);
        QCOMPARE(before->toUtc_ms, next->fromUtc_ms);
        QCOMPARE(before->parts[0].made, 3U);
        QCOMPARE(before->notes.size(), std::size_t{2});
    }
    void whatTheLawHasSavedIsAgainstTheFirstFeed() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const BoringRecipe recipe;
        const Receipt type = shop.must(EnsurePartType{ProcessId::Boring, "Cylinder", recipeJson(recipe), "Lee"});
        const auto lot = shop.must(EnsureLot{shop.machine, type.id, type.second, "13", 30, "kalman", "Lee"}).id;
        PartRecord cut = test::boringPart(1);
        cut.schedule.targetDeflection_mm = recipe.targetDeflection_mm;
        const PartId part = shop.must(AddPart{lot, cut, {}}).id;
        AcceptMeasurement top;
        top.measurement = test::measured(part, 0, recipe.targetDiameter_mm);
        top.states = {test::stateOf(0.5)};
        (void)shop.must(top);
        AcceptMeasurement bottom;
        bottom.measurement = test::measured(part, 1, recipe.upperTolerance_mm + 0.01);  // out of it, whatever was done
        bottom.states = {test::stateOf(0.5)};
        (void)shop.must(bottom);
        const auto shift = read(*shop.reader(), 0, QDateTime::currentMSecsSinceEpoch() + 1);
        QVERIFY(shift.has_value());
        // At twice the feed cut at the top (.25 against .5) the deflection is √2 as large: far outside ±15 µm.
        QCOMPARE(shift->saving.bores, 2U);
        QCOMPARE(shift->saving.partsKept, 1U);
    }
    void partsAreCountedFromTheLastToolChange() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        (void)shop.addPart(1);
        const PartId last = shop.addPart(2);
        const auto file = shop.reader();
        auto tools = readTools(*file, *file);
        QVERIFY(tools.has_value());
        QCOMPARE(tools->size(), std::size_t{4});
        QCOMPARE(tools->front().parts, 2U);
        QCOMPARE(tools->front().life, 0U);
        (void)shop.must(AddRoomRecord{ProcessId::Boring, kToolChange, "boring", toolChangeJson(last), "Kim", {}});
        (void)shop.must(AddRoomRecord{ProcessId::Boring, kToolLife, "boring", toolLifeJson(50), "Kim", {}});
        (void)shop.addPart(3);
        tools = readTools(*file, *file);
        QCOMPARE(tools->front().parts, 1U);
        QCOMPARE(tools->front().life, 50U);
        QCOMPARE(tools->front().changedBy, std::string("Kim"));
        QCOMPARE(tools->at(1).parts, 0U);  // another process has its own tool
    }
};

QTEST_GUILESS_MAIN(TestShift)
#include "tst_shift.moc"
