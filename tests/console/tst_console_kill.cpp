// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <map>

#include "db/migrator.h"
#include "engine/core/random.h"
#include "tests/support/console_bench.h"

using namespace kerf;

/// kill -9 on the real console while an automatic operator enters diameters as fast as it can.
class TestConsoleKill : public QObject {
    Q_OBJECT

    struct Acceptance {
        qint64 id{0};
        double diameter_mm{0.0};
        std::uint32_t revision{0};
        double lnC{0.0};
        double alpha{0.0};
        double beta{0.0};
    };
    static std::optional<Acceptance> parse(const QByteArray& line) {
        const QList<QByteArray> words = line.trimmed().split(' ');
        if (words.size() != 13 || words[0] != "accepted") {
            return std::nullopt;  // the last line may be cut by the kill
        }
        return Acceptance{words[1].toLongLong(), words[7].toDouble(),  words[9].toUInt(),
                          words[10].toDouble(),  words[11].toDouble(), words[12].toDouble()};
    }

 private slots:
    void nothingAcceptedIsLost() {
        const int asked = qEnvironmentVariableIntValue("KERF_KILL_RUNS");
        const int runs = asked > 0 ? asked : 10;
        Random random(20);
        int acknowledged = 0;
        for (int run = 0; run < runs; ++run) {
            test::ConsoleBench bench;
            QProcess victim;
            victim.setProcessChannelMode(QProcess::SeparateChannels);
            victim.start(QString::fromLocal8Bit(qgetenv("KERF_BIN")) + QStringLiteral("/kerf-console"),
                         {QStringLiteral("--data"), bench.folder(), QStringLiteral("--speed"), QStringLiteral("0"),
                          QStringLiteral("--prepared-parts"), QStringLiteral("0"), QStringLiteral("--auto-operator"),
                          QStringLiteral("--print-acceptances")});
            QVERIFY(victim.waitForStarted());
            const int wanted = 1 + static_cast<int>(random.uniform(0.0, 12.0));
            std::map<qint64, Acceptance> seen;
            while (static_cast<int>(seen.size()) < wanted && victim.state() == QProcess::Running) {
                QVERIFY(victim.waitForReadyRead(30'000));
                while (victim.canReadLine()) {
                    if (const auto acceptance = parse(victim.readLine())) {
                        seen[acceptance->id] = *acceptance;
                    }
                }
            }
            for (double spin = random.uniform(0.0, 3e6); spin > 0.0;
                 spin -= 1.0) {  // a random moment, without sleeping
                asm volatile("" ::: "memory");
            }
            ::kill(static_cast<pid_t>(victim.processId()), SIGKILL);
            victim.waitForFinished();
            while (victim.canReadLine()) {
                if (const auto acceptance = parse(victim.readLine())) {
                    seen[acceptance->id] = *acceptance;
                }
            }
            acknowledged += static_cast<int>(seen.size());

            const std::string file = bench.folder().toStdString() + "/kerf.db";
            QVERIFY(db::checkDatabase(file).has_value());
            qint64 newest = 0;
            {
                const auto reader = db::DatabaseReader::open(file);
                QVERIFY(reader.has_value());
                const auto parts = (*reader)->parts({});
                QVERIFY(parts.has_value());
                std::map<qint64, double> stored;
                for (const PartRow& part : *parts) {
                    for (const MeasurementRow& row : part.measurements) {
                        stored[row.id] = row.diameter_mm.value_or(0.0);
                        newest = std::max<qint64>(newest, row.id);
                    }
                }
                for (const auto& [id, acceptance] : seen) {
                    QVERIFY2(stored.count(id) == 1, "an accepted measurement is missing");
                    QCOMPARE(stored[id], acceptance.diameter_mm);
                }
                const auto verdict = (*reader)->verifyAudit();
                QVERIFY(verdict.has_value());
                QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
            }
            console::Options again;
            again.preparedParts = 0;
            again.simulationSpeed = 1.0;
            bench.start(again);
            QTRY_VERIFY2_WITH_TIMEOUT(bench.up(), qPrintable(bench.failure()), 20'000);
            QVERIFY(bench.console().boringDesk().restartFinding().empty());
            if (!seen.empty() && newest == seen.rbegin()->first) {  // nothing was stored after the last line we saw
                const Acceptance& last = seen.rbegin()->second;
                const BoringSchedule& next = bench.desk().nextSchedule;
                QCOMPARE(next.revision, last.revision);
                QCOMPARE(next.lnC, last.lnC);
                QCOMPARE(next.alpha, last.alpha);
                QCOMPARE(next.beta, last.beta);
            }
            bench.stop();
        }
        qInfo("%d kills, %d accepted measurements, none lost", runs, acknowledged);
        QVERIFY(acknowledged >= runs);
    }
};
QTEST_MAIN(TestConsoleKill)
#include "tst_console_kill.moc"
