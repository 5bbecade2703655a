// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <thread>

#include "tests/support/console_bench.h"

using namespace kerf;

/// A screen that stands still must not reach the engine or the database.
class TestConsoleFrozen : public QObject {
    Q_OBJECT
 private slots:
    void frozenScreenCostsNothingButChartSamples() {
        test::ConsoleBench bench;
        console::Options options;
        options.preparedParts = 1;
        options.simulationSpeed = 200.0;
        bench.setOwnThread(true);  // the screen hangs, the engine goes on
        bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.up() && bench.console().shift()->prepared() && bench.status().boring.cutting,
                                  qPrintable(bench.failure()), 30'000);
        const std::uint64_t cyclesBefore = bench.status().cycle;
        const std::uint64_t droppedBefore = bench.status().stats.droppedSamples;
        const auto reader = db::DatabaseReader::open(bench.console().databasePath());
        QVERIFY(reader.has_value());
        const auto partsStored = [&reader] { return (*reader)->parts({}).value_or(std::vector<PartRow>{}).size(); };
        const std::size_t partsBefore = partsStored();

        // The freeze itself: no event is handled until the part has been finished and stored beside it.
        const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(90);
        while (partsStored() == partsBefore && std::chrono::steady_clock::now() < patience) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }

        QVERIFY(partsStored() > partsBefore);
        const Status& after = bench.console().engine().status();
        QVERIFY(after.cycle > cyclesBefore);
        // Every chart sample is either still in the ring or counted as dropped.
        std::vector<Sample> samples(20'000);
        const std::size_t kept = bench.console().engine().drainSamples(samples);
        QVERIFY(kept + (after.stats.droppedSamples - droppedBefore) > 0);
        QCOMPARE(after.partsBlocked, false);
        // The screen goes on where the engine is.
        QTRY_VERIFY(bench.status().cycle >= after.cycle);
        QTRY_VERIFY(bench.service().awaiting.has_value());
    }
    void holdWorksWhileAPageHangs() {
        test::ConsoleBench bench;
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 20.0;
        bench.setOwnThread(true);  // the screen hangs, the engine goes on
        bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.up() && bench.status().boring.cutting, qPrintable(bench.failure()), 30'000);
        bench.console().engine().holdAll();  // what the button's press calls, with no event loop turning
        const auto begin = std::chrono::steady_clock::now();
        while (!bench.console().engine().status().held &&
               std::chrono::steady_clock::now() - begin < std::chrono::seconds(2)) {
        }
        const double took_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        QVERIFY(bench.console().engine().status().held);
        qInfo("held after %.1f ms", took_ms);
    }
};
QTEST_MAIN(TestConsoleFrozen)
#include "tst_console_frozen.moc"
