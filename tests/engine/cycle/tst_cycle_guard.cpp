// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <mutex>
#include <stdexcept>

#include "tests/support/boring_bench.h"
#include "tests/support/cycle_guard.h"

using namespace kerf;

/// The cycle neither allocates, locks nor throws: proved on the real one through a whole part, with faults and
/// commands.
class TestCycleGuard : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() {
        if (!test::CycleGuard::available()) {
            QSKIP("a sanitizer owns malloc in this build");
        }
    }
    void guardSeesWhatItForbids() {
        std::mutex mutex;
        test::CycleGuard guard;
        auto* block = new int(1);
        delete block;
        mutex.lock();
        mutex.unlock();
        try {
            throw std::runtime_error("seen");
        } catch (const std::exception&) {
        }
        QVERIFY(guard.allocations() >= 2);
        QVERIFY(guard.locks() >= 1);
        QVERIFY(guard.throws() == 1);
    }
    void cycleNeitherAllocatesLocksNorThrows() {
        test::BoringBench bench;
        std::uint64_t allocations = 0;
        std::uint64_t locks = 0;
        std::uint64_t throws = 0;
        {
            const test::CycleGuard guard;
            (void)bench.execute(LoadBoringSchedule{test::shortSchedule()});
            (void)bench.execute(SetLoopMode{ProcessId::Boring, LoopMode::Control});
            for (int part = 0; part < 3; ++part) {
                (void)bench.runPart();
                InjectedFaults faults;
                faults.overhang = part == 0 ? SignalFault::NotANumber : SignalFault::None;
                faults.linkDown = part == 1;
                bench.machine->inject(faults);
                bench.engine->runCycles(100);
                bench.engine->holdAll();
                bench.engine->runCycles(10);
                bench.engine->cycle().emitSample(1);
                bench.machine->inject({});
                bench.engine->runCycles(10);
                (void)bench.execute(ReleaseHold{});
            }
            allocations = guard.allocations();
            locks = guard.locks();
            throws = guard.throws();
        }
        QVERIFY(bench.engine->status().boring.partsCut == 3);
        QCOMPARE(allocations, 0U);
        QCOMPARE(locks, 0U);
        QCOMPARE(throws, 0U);
    }
};
QTEST_APPLESS_MAIN(TestCycleGuard)
#include "tst_cycle_guard.moc"
