// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/support/boring_bench.h"
#include "tests/support/milling_bench.h"
#include "tests/support/tapping_bench.h"
#include "tests/support/thermal_bench.h"
#include "tests/support/turning_bench.h"

using namespace kerf;

namespace {

constexpr WorkOrder kFirst{7, 31, 0};
constexpr WorkOrder kSecond{8, 32, 0};

/// What the engine says the next part of a process is of.
WorkOrder named(Engine& engine, ProcessId process) {
    return engine.status().orders[static_cast<std::size_t>(process)];
}

/// The first part of a process; empty: none came within so many cycles.
template <class Bench>
std::optional<PartRecord> nextPart(Bench& bench, int most = 400'000) {
    PartRecord part;
    for (int i = 0; i < most; ++i) {
        bench.engine->runCycles(1);
        if (bench.engine->partRecords().tryPop(part)) {
            return part;
        }
    }
    return std::nullopt;
}

/// A part is begun for the first order; while it is made the second is named, and the next part is of that.
template <class Bench, class Load>
void bringsItsOrderBack(Bench& bench, ProcessId process, const Load& load, bool reloads) {
    QVERIFY(bench.execute(load(kFirst)).done);
    QCOMPARE(named(*bench.engine, process), kFirst);
    QVERIFY(bench.execute(SetLoopMode{process, LoopMode::Advise}).done);
    // Started for another lot, or another revision: nothing begins.
    const CommandResult other = bench.execute(StartPart{process, kSecond});
    QVERIFY(!other.done && !other.reason.empty());
    QVERIFY(bench.execute(StartPart{process, kFirst}).done);
    for (int i = 0; i < 1000 && bench.engine->status().program != ProgramState::Running; ++i) {
        bench.engine->runCycles(1);
    }
    QCOMPARE(bench.engine->status().program, ProgramState::Running);
    if (reloads) {  // what the next one is cut with may be loaded now, and its order with it
        QVERIFY(bench.execute(load(kSecond)).done);
    } else {  // refused while a part is cut: so is its order
        QVERIFY(!bench.execute(load(kSecond)).done);
        QCOMPARE(named(*bench.engine, process), kFirst);
        QVERIFY(bench.execute(NameOrder{process, kSecond}).done);
    }
    QCOMPARE(named(*bench.engine, process), kSecond);
    const auto part = nextPart(bench);
    QVERIFY(part && part->process == process);
    QCOMPARE(part->order, kFirst);
}

}  // namespace

/// Lot and recipe go to the engine with what a part is cut with, and come back on its record.
class TestWorkOrder : public QObject {
    Q_OBJECT
 private slots:
    void aBoredPartBringsItsOrderBack() {
        test::BoringBench bench;
        bringsItsOrderBack(
            bench, ProcessId::Boring,
            [](const WorkOrder& order) {
                return LoadBoringSchedule{test::shortSchedule(), order};
            },
            true);
    }
    void aMilledPartBringsItsOrderAndItsToolBack() {
        test::MillingBench bench;
        bringsItsOrderBack(
            bench, ProcessId::Milling,
            [](const WorkOrder& order) {
                return LoadMillingSetup{test::millingSetup(), order};
            },
            false);
        QVERIFY(bench.execute(StartPart{ProcessId::Milling, kSecond}).done);
        const auto part = nextPart(bench);
        QVERIFY(part && part->order == kSecond);
        // What was learnt of the tool is that after this cut, not whatever the status says later.
        QCOMPARE(part->millingTool.parts, 2U);
        QCOMPARE(part->millingTool, bench.engine->status().milling.tool);
        QVERIFY(bench.execute(NewMillingTool{}).done);
        QVERIFY(part->millingTool != bench.engine->status().milling.tool);
    }
    void aTurnedPartBringsItsOrderBack() {
        test::TurningBench bench;
        bringsItsOrderBack(
            bench, ProcessId::Turning,
            [](const WorkOrder& order) {
                return LoadTurningSetup{test::shortCut(), order};
            },
            true);
    }
    void aTapBringsItsOrderBack() {
        test::TappingBench bench;
        QVERIFY(bench.makeReady(true));
        QVERIFY(!nextPart(bench, 10));  // a tap in the air is no part
        QVERIFY(bench.execute(NameOrder{ProcessId::Tapping, kFirst}).done);
        QVERIFY(!bench.execute(StartPart{ProcessId::Tapping, kSecond}).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Tapping, kFirst}).done);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.phase == TapPhase::Tapping; }));
        QVERIFY(bench.execute(NameOrder{ProcessId::Tapping, kSecond}).done);
        const auto part = nextPart(bench);
        QVERIFY(part);
        QCOMPARE(part->order, kFirst);
    }
    void aWarmUpIsStartedForTheRecipeThatIsLoaded() {
        test::ThermalBench bench;
        ThermalSetup setup;
        setup.revision = 1;
        QVERIFY(bench.execute(LoadThermalSetup{setup, kFirst}).done);
        QCOMPARE(named(*bench.engine, ProcessId::Thermal), kFirst);
        QVERIFY(!bench.execute(StartPart{ProcessId::Thermal, kSecond}).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Thermal, kFirst}).done);
    }
    void aPartUnderWayAtAStartIsOfTheOrderNamedFirst() {
        test::BoringBench bench;
        QVERIFY(bench.execute(LoadBoringSchedule{test::shortSchedule(), {}}).done);  // nobody has named one
        QVERIFY(bench.execute(StartPart{ProcessId::Boring, {}}).done);
        QVERIFY(bench.runUntil([](const Status& s) { return s.program == ProgramState::Running; }));
        bench.engine->runCycles(5);
        QVERIFY(bench.execute(NameOrder{ProcessId::Boring, kFirst}).done);
        QVERIFY(bench.execute(NameOrder{ProcessId::Boring, kSecond}).done);
        const auto part = nextPart(bench);
        QVERIFY(part);
        QCOMPARE(part->order, kFirst);
        QCOMPARE(part->order.schedule, 0U);
    }
};

QTEST_APPLESS_MAIN(TestWorkOrder)
#include "tst_work_order.moc"
