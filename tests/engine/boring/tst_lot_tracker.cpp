// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <cmath>

#include "engine/process/boring/lot_tracker.h"
#include "engine/process/boring/plant.h"
#include "tests/support/golden.h"

namespace {

using namespace kerf::boring;
using kerf::SentenceArg;

constexpr std::array<double, 3> kDepths_mm{40.0, 175.0, 310.0};

CutPart cutPart(std::uint32_t number, double factor) {
    CutPart part;
    part.number = number;
    part.schedule.lnC = std::log(kTableC) + std::log(factor);
    part.schedule.alpha = kTableAlpha;
    part.schedule.beta = kTableBeta;
    part.schedule.targetDeflection_mm = kTableTargetDeflection_mm;
    return part;
}

EstimatorParams paramsFor(EstimatorKind kind) {
    return estimatorParams(kind, 0.005, kTableTargetDeflection_mm, 0.5);
}

/// The same surviving history, entered afresh.
LotTracker freshReplay(const LotTracker& lot, bool oneByOne) {
    LotTracker fresh(lot.params());
    if (!oneByOne) {
        fresh.restore(lot.parts(), lot.entries());
        return fresh;
    }
    for (const CutPart& part : lot.parts()) {
        RC_ASSERT(fresh.addPart(part).has_value());
    }
    for (const auto& entry : lot.entries()) {
        RC_ASSERT(fresh.add(entry.id, entry.part, entry.measurement.overhang_mm, entry.measurement.deflection_mm)
                      .has_value());
    }
    return fresh;
}

bool sameSteps(const LotTracker& a, const LotTracker& b) {
    return a.steps().size() == b.steps().size() &&
           std::equal(a.steps().begin(), a.steps().end(), b.steps().begin(), [](const auto& x, const auto& y) {
               return x.visit == y.visit && x.ids == y.ids && x.rows == y.rows && x.after == y.after;
           });
}

}  // namespace

class TestLotTracker : public QObject {
    Q_OBJECT
 private slots:
    void anyHistoryEqualsItsFreshReplay_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("perturbation") << static_cast<int>(EstimatorKind::Perturbation);
        QTest::newRow("kalman") << static_cast<int>(EstimatorKind::Kalman);
    }
    void anyHistoryEqualsItsFreshReplay() {
        QFETCH(int, kind);
        const bool held = rc::check("add, correct, void in any order == replay", [kind] {
            LotTracker lot(paramsFor(static_cast<EstimatorKind>(kind)));
            const auto parts = *rc::gen::inRange<std::uint32_t>(1, 12);
            for (std::uint32_t part = 1; part <= parts; ++part) {
                RC_ASSERT(lot.addPart(cutPart(part, 0.7 + 0.05 * part)).has_value());
            }
            std::int64_t nextId = 1;
            const auto actions = *rc::gen::inRange(1, 40);
            for (int i = 0; i < actions; ++i) {
                const auto kindOfAction = *rc::gen::inRange(0, 10);
                const double d_mm = 0.05 + 0.001 * *rc::gen::inRange(1, 200);
                if (kindOfAction < 7 || lot.entries().empty()) {
                    const auto part = *rc::gen::inRange<std::uint32_t>(1, parts + 1);
                    const auto depth = *rc::gen::inRange<std::size_t>(0, kDepths_mm.size());
                    (void)lot.add(nextId++, part, kDepths_mm[depth], d_mm);  // refused when measured already
                } else {
                    const auto victim = *rc::gen::inRange<std::size_t>(0, lot.entries().size());
                    const auto id = lot.entries()[victim].id;
                    RC_ASSERT((kindOfAction < 9 ? lot.correct(id, nextId++, d_mm) : lot.voidEntry(id)).has_value());
                }
            }
            RC_ASSERT(sameSteps(lot, freshReplay(lot, true)));
            RC_ASSERT(sameSteps(lot, freshReplay(lot, false)));
            RC_ASSERT(lot.state() == freshReplay(lot, true).state());
        });
        QVERIFY(held);
    }
    void lateBoreUsesTheFeedItsOwnPartWasCutWith() {
        LotTracker lot(paramsFor(EstimatorKind::Kalman));
        QVERIFY(lot.addPart(cutPart(1, 1.0)).has_value());
        QVERIFY(lot.addPart(cutPart(2, 2.0)).has_value());
        QVERIFY(lot.add(1, 2, 40.0, 0.1).has_value());
        QVERIFY(lot.add(2, 1, 40.0, 0.12).has_value());
        QCOMPARE(lot.entries()[1].measurement.feed_mmPerRev, lot.part(1)->schedule.feed_mmPerRev(40.0));
        QVERIFY(lot.entries()[0].measurement.feed_mmPerRev != lot.entries()[1].measurement.feed_mmPerRev);
    }
    void orderOfEntryDoesNotMatterToOurs() {
        const auto build = [](const std::vector<std::pair<std::uint32_t, double>>& order) {
            LotTracker lot(paramsFor(EstimatorKind::Kalman));
            for (std::uint32_t part = 1; part <= 3; ++part) {
                (void)lot.addPart(cutPart(part, 1.0));
            }
            std::int64_t id = 0;
            for (const auto& [part, overhang_mm] : order) {
                (void)lot.add(++id, part, overhang_mm, 0.1 + 0.01 * part);
            }
            return lot.state();
        };
        const EstimatorState inOrder = build({{1, 40.0}, {1, 310.0}, {2, 40.0}, {2, 310.0}, {3, 40.0}, {3, 310.0}});
        QVERIFY(build({{2, 40.0}, {3, 40.0}, {2, 310.0}, {1, 40.0}, {3, 310.0}, {1, 310.0}}) == inOrder);
    }
    void feedComesFromTheTraceOfTheCut() {
        CutPart part = cutPart(1, 1.0);
        part.feed.count = 3;
        part.feed.overhang_mm = {40.0F, 100.0F, 300.0F};
        part.feed.feed_mmPerRev = {0.25F, 0.2F, 0.1F};
        KERF_CLOSE(cutFeed_mmPerRev(part, 70.0), 0.225, 1e-7);
        KERF_CLOSE(cutFeed_mmPerRev(part, 310.0), 0.1, 1e-7);
        KERF_CLOSE(cutFeed_mmPerRev(part, 10.0), 0.25, 1e-7);
        part.feed.count = 0;
        QCOMPARE(cutFeed_mmPerRev(part, 70.0), part.schedule.feed_mmPerRev(70.0));
    }
    void runUpAtTheEndsIsNotTheFeedThatIsGauged() {
        CutPart part = cutPart(1, 1.0);
        part.feed.count = 6;
        part.feed.overhang_mm = {40.0F, 41.25F, 42.5F, 100.0F, 118.75F, 120.0F};
        part.feed.feed_mmPerRev = {0.02F, 0.2F, 0.3F, 0.2F, 0.18F, 0.01F};
        KERF_CLOSE(cutFeed_mmPerRev(part, 40.0), 0.3, 1e-7);
        KERF_CLOSE(cutFeed_mmPerRev(part, 120.0), 0.18, 1e-7);
        part.feed.feed_mmPerRev = {0.02F, 0.02F, 0.02F, 0.02F, 0.3F, 0.3F};  // an override turned up, not a run-up
        KERF_CLOSE(cutFeed_mmPerRev(part, 42.5), 0.02, 1e-7);
    }
    void refusalsChangeNothing() {
        LotTracker lot(paramsFor(EstimatorKind::Kalman));
        QVERIFY(lot.addPart(cutPart(1, 1.0)).has_value());
        QVERIFY(!lot.addPart(cutPart(1, 1.0)).has_value());
        QVERIFY(lot.add(1, 1, 40.0, 0.11).has_value());
        const EstimatorState before = lot.state();
        QVERIFY(!lot.add(2, 1, 40.0, 0.12).has_value());   // measured there already
        QVERIFY(!lot.add(1, 1, 310.0, 0.12).has_value());  // id in use
        QVERIFY(!lot.add(2, 9, 40.0, 0.12).has_value());   // not cut
        QVERIFY(!lot.add(2, 1, 310.0, 0.0).has_value());
        QVERIFY(!lot.add(2, 1, 310.0, std::nan("")).has_value());
        QVERIFY(!lot.add(2, 1, -1.0, 0.1).has_value());
        QVERIFY(!lot.correct(7, 8, 0.1).has_value());
        QVERIFY(!lot.correct(1, 8, -0.1).has_value());
        QVERIFY(!lot.voidEntry(7).has_value());
        QVERIFY(lot.state() == before);
        QCOMPARE(lot.entries().size(), std::size_t{1});
    }
    void voidingEverythingLeadsBackToTheBeginning() {
        LotTracker lot(paramsFor(EstimatorKind::Perturbation));
        QVERIFY(lot.addPart(cutPart(1, 1.0)).has_value());
        QVERIFY(lot.add(1, 1, 40.0, 0.11).has_value());
        QVERIFY(lot.add(2, 1, 310.0, 0.12).has_value());
        QVERIFY(estimateOf(lot.state()).ready);
        QVERIFY(lot.voidEntry(1).has_value() && lot.voidEntry(2).has_value());
        QVERIFY(lot.state() == initialState(lot.params()));
    }
    void snapshotNumbersTellStatesApart() {
        LotTracker lot(paramsFor(EstimatorKind::Kalman));
        QVERIFY(lot.addPart(cutPart(1, 1.0)).has_value());
        QVERIFY(lot.add(1, 1, 40.0, 0.11).has_value());
        const auto before = numbersOf(lot.state());
        QVERIFY(lot.correct(1, 2, 0.11 + 1e-9).has_value());
        const auto after = numbersOf(lot.state());
        QCOMPARE(before.count, after.count);
        QVERIFY(before.value != after.value);
    }
};
QTEST_APPLESS_MAIN(TestLotTracker)
#include "tst_lot_tracker.moc"
