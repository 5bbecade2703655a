// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <vector>

#include "tests/support/boring_bench.h"

using namespace kerf;

/// The engine on its own thread. Waits on what it sees (QTRY), never for a fixed time.
class TestEngineThread : public QObject {
    Q_OBJECT
 private slots:
    void runsAPartFastAndReportsIt() {
        test::BoringBench bench;
        bench.engine->start();
        QVERIFY(bench.send(LoadBoringSchedule{test::shortSchedule()}) != 0);
        QVERIFY(bench.send(SetLoopMode{ProcessId::Boring, LoopMode::Control}) != 0);
        QVERIFY(bench.send(SetSimulationSpeed{0.0}) != 0);
        QVERIFY(bench.send(StartPart{ProcessId::Boring}) != 0);
        QTRY_VERIFY_WITH_TIMEOUT(bench.engine->status().boring.partsCut == 1, 20'000);
        QVERIFY(bench.engine->status().stats.cost.count() > 1000);
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        bench.engine->stop();
    }
    void commandsAreEchoedInOrder() {
        test::BoringBench bench;
        bench.engine->start();
        const std::uint32_t good = bench.send(SetLoopMode{ProcessId::Boring, LoopMode::Advise});
        const std::uint32_t bad = bench.send(SetLoopMode{ProcessId::Tapping, LoopMode::Control});
        QTRY_COMPARE(bench.engine->status().recentCommands[0].number, bad);
        QCOMPARE(bench.engine->status().recentCommands[1].number, good);
        QVERIFY(!bench.engine->status().recentCommands[0].done);
        QVERIFY(bench.engine->status().recentCommands[1].done);
        bench.engine->stop();
    }
    void nobodyDrainingLosesOnlyChartSamplesAndCountsThem() {
        test::BoringBench bench;
        for (int i = 0; i < 20'000; ++i) {
            bench.engine->cycle().emitSample(i);
        }
        bench.engine->runCycles(1);
        const std::uint64_t dropped = bench.engine->status().stats.droppedSamples;
        std::vector<Sample> samples(20'000);
        const std::size_t kept = bench.engine->drainSamples(samples);
        QCOMPARE(dropped + kept, 20'000U);
        QVERIFY(dropped > 0);
    }
    void stopAndStartAgain() {
        test::BoringBench bench;
        bench.engine->start();
        QTRY_VERIFY(bench.engine->status().cycle > 5);
        bench.engine->stop();
        const auto before = bench.engine->status().cycle;
        bench.engine->start();
        QTRY_VERIFY(bench.engine->status().cycle > before);
        bench.engine->stop();
    }
};
QTEST_GUILESS_MAIN(TestEngineThread)
#include "tst_engine_thread.moc"
