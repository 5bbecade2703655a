// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/support/console_bench.h"
#include "tests/support/kerf_program.h"

using namespace kerf;
using namespace kerf::test;

/// "Add a machine" of docs/architecture.md, done once: kerf-testbed.so beside the programs, and nothing else changed.
class TestConsoleTestbed : public QObject {
    Q_OBJECT

 private slots:
    void theCommandReachesIt() {
        const KerfRun run = runKerf({"machine", "status", "--machine", "testbed"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const auto json = nlohmann::json::parse(run.out.toStdString());
        QCOMPARE(json["capabilities"]["machine"].get<std::string>(), std::string("Testbed"));
        QVERIFY(json["capabilities"]["loops"]["boring"]["fitted"].get<bool>());
        QVERIFY(!json["capabilities"]["loops"]["milling"]["fitted"].get<bool>());
    }
    void theConsoleBoresOnIt() {
        ConsoleBench bench;
        console::Options options;
        options.machine = "testbed";
        bench.start(options);
        QTRY_VERIFY_WITH_TIMEOUT(bench.up() || !bench.failure().isEmpty(), 20'000);
        QVERIFY2(bench.up(), qPrintable(bench.failure()));
        QVERIFY(bench.console().simulator() == nullptr);
        const auto boring = [&]() -> const LoopStatus& {
            return bench.status().loops[static_cast<std::size_t>(ProcessId::Boring)];
        };
        QTRY_VERIFY_WITH_TIMEOUT(boring().fitted && bench.status().link == LinkState::Up, 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(bench.status().boring.nextSchedule != 0, 20'000);
        Command start;
        start.action = StartPart{ProcessId::Boring};
        QVERIFY(bench.console().engine().send(start));
        QTRY_VERIFY_WITH_TIMEOUT(bench.status().boring.cutting, 20'000);
    }
    void oneThatIsNotThereIsRefused() {
        const KerfRun run = runKerf({"machine", "status", "--machine", "nowhere"});
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.err.contains(QLatin1String("testbed")), qPrintable(run.err));
    }
};

QTEST_MAIN(TestConsoleTestbed)
#include "tst_console_testbed.moc"
