// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>

#include "db/readers/database_reader.h"
#include "tests/console/deburring/deburring.h"
#include "tests/support/console_bench.h"

using namespace kerf;
using namespace kerf::test;

/// "Add a process" of docs/architecture.md, done once: deburring registers, runs in the cycle under the limiter, has a
/// page and a card on the console, and its figures are in the table of parts.
class TestConsoleSixthProcess : public QObject {
    Q_OBJECT

    [[nodiscard]] const LoopStatus& loop() { return m_bench.status().loops[static_cast<std::size_t>(kDeburring)]; }
    [[nodiscard]] std::vector<PartRow> stored() {
        auto reader = db::DatabaseReader::open(m_bench.console().databasePath());
        PartQuery query;
        query.process = kDeburring;
        const auto parts = reader ? (*reader)->parts(query) : Result<std::vector<PartRow>>();
        return parts ? *parts : std::vector<PartRow>();
    }
    void send(const auto& action) {
        Command command;
        command.action = action;
        QVERIFY(m_bench.console().engine().send(command));
    }
    [[nodiscard]] static double figure(const PartRow& part, std::string_view key) {
        const auto found = std::ranges::find(part.figures, key, &PartFigure::key);
        return found == part.figures.end() ? -1.0 : found->value;
    }
    /// One edge from the page's button to the data file.
    void cut(std::size_t parts) {
        QVERIFY(m_bench.press("deburringStart"));
        QTRY_COMPARE_WITH_TIMEOUT(stored().size(), parts, 20'000);
    }

    ConsoleBench m_bench;

 private slots:
    void initTestCase() {
        QVERIFY(fitProcess(kDeburringProcess));
        QVERIFY(!fitProcess(kDeburringProcess));  // its place is taken
        QCOMPARE(processes().size(), std::size_t{6});
        m_bench.setRooms([] {
            auto rooms = console::standardRooms();
            rooms.push_back(std::make_unique<DeburringRoom>());
            return rooms;
        });
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 20.0;
        options.seed = 5;
        m_bench.start(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.up() || !m_bench.failure().isEmpty(), 20'000);
        QVERIFY2(m_bench.up(), qPrintable(m_bench.failure()));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 60'000);  // its bore waits for the gauge
    }
    void itHasAPageBetweenTheOthers() {
        QVERIFY(loop().fitted);
        const auto& pages = m_bench.console().window()->pages();
        QCOMPARE(pages[6].key, "deburring");
        QCOMPARE(pages[6].title(), QStringLiteral("Deburring"));
        m_bench.console().window()->showPage("deburring");
        QTRY_VERIFY(m_bench.find("deburringPage") != nullptr);
    }
    void itsPartsAreStoredWithTheirFigures() {
        send(SetLoopMode{kDeburring, LoopMode::Off});
        QTRY_COMPARE(loop().state, LoopState::Off);
        cut(1);
        const PartRow first = stored().front();
        QVERIFY(first.complete);
        QCOMPARE(figure(first, "force_peak_N"), 45.0);  // off: three times 15 N on the burr
        send(SetLoopMode{kDeburring, LoopMode::Control});
        QTRY_COMPARE(loop().state, LoopState::Controlling);
        QTRY_VERIFY(m_bench.text("deburringState").contains(QLatin1String("Ready for the next edge.")));
        cut(2);
        const PartRow second = stored().front();
        QVERIFY(figure(first, "force_mean_N") > kForceLimit_N);  // by time: 7 s at 15 N, 3 s at 45 N
        QVERIFY(figure(second, "force_mean_N") < kForceLimit_N);
        QVERIFY(second.machineEnd_ns - second.machineBegin_ns > first.machineEnd_ns - first.machineBegin_ns);
    }
    void theyStandInTheTableOfParts() {
        m_bench.console().window()->showPage("parts");
        QComboBox* choice = nullptr;
        QTRY_VERIFY((choice = m_bench.find<QComboBox>("partsProcess")) != nullptr);
        QVERIFY(choice->findText(QStringLiteral("Deburring")) > 0);
    }
    void aStopOfItsOwnIsKeptLikeAnyOther() {
        send(ReleaseStop{kDeburring, 1, {}});
        QTRY_VERIFY(!m_bench.status().lastCommand.done);  // none stands, and it is the engine that says so
    }
    void cleanupTestCase() { m_bench.stop(); }
};

QTEST_MAIN(TestConsoleSixthProcess)
#include "tst_console_sixth_process.moc"
