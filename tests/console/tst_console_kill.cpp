// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <map>
#include <memory>

#include "db/migrator.h"
#include "tests/support/console_bench.h"
#include "tests/support/kill_campaign.h"

using namespace kerf;

/// kill -9 on the real console while an automatic operator enters diameters as fast as it can.
class TestConsoleKill : public QObject {
    Q_OBJECT

    /// "17 part 4 depth 1 diameter_mm 50.003 next 9 -2.4 0.5 0.27", as --print-acceptances writes it.
    struct Acceptance {
        qint64 id{0};
        double diameter_mm{0.0};
        std::uint32_t revision{0};
        double lnC{0.0};
        double alpha{0.0};
        double beta{0.0};
    };
    static std::optional<Acceptance> parse(const std::string& line) {
        const QList<QByteArray> words = QByteArray::fromStdString(line).trimmed().split(' ');
        if (words.size() != 12) {
            return std::nullopt;
        }
        return Acceptance{words[0].toLongLong(), words[6].toDouble(),  words[8].toUInt(),
                          words[9].toDouble(),   words[10].toDouble(), words[11].toDouble()};
    }

    /// Everything acknowledged is in the file, the file is whole. Gives the newest measurement.
    static QString lookAtFile(const std::string& file, const std::map<qint64, Acceptance>& seen, qint64& newest) {
        if (!db::checkDatabase(file)) {
            return QStringLiteral("the file is damaged");
        }
        const auto reader = db::DatabaseReader::open(file);
        const auto parts = reader ? (*reader)->parts({}) : tl::unexpected(reader.error());
        if (!parts) {
            return QString::fromStdString(parts.error().english());
        }
        std::map<qint64, double> stored;
        for (const PartRow& part : *parts) {
            for (const MeasurementRow& row : part.measurements) {
                stored[row.id] = row.diameter_mm.value_or(0.0);
                newest = std::max<qint64>(newest, row.id);
            }
        }
        for (const auto& [id, acceptance] : seen) {
            if (stored.count(id) != 1 || stored[id] != acceptance.diameter_mm) {
                return QStringLiteral("accepted measurement %1 is missing or another one").arg(id);
            }
        }
        const auto verdict = (*reader)->verifyAudit();
        return verdict && verdict->finding.empty() ? QString() : QStringLiteral("the audit chain is broken");
    }

    /// The console starts again where its last accepted measurement left it.
    static QString restart(test::ConsoleBench& bench, const Acceptance* last) {
        console::Options again;
        again.preparedParts = 0;
        again.simulationSpeed = 1.0;
        bench.start(again);
        if (!QTest::qWaitFor([&bench] { return bench.up(); }, 20'000)) {
            return QStringLiteral("does not start again: ") + bench.failure();
        }
        if (!bench.console().boringService().restartFinding().empty()) {
            return QStringLiteral("the state computed again differs from the stored one");
        }
        const BoringSchedule& next = bench.service().nextSchedule;
        const bool same = last == nullptr || (next.revision == last->revision && next.lnC == last->lnC &&
                                              next.alpha == last->alpha && next.beta == last->beta);
        return same ? QString() : QStringLiteral("the next schedule is not the one announced last");
    }

 private slots:
    void nothingAcceptedIsLost() {
        const int asked = qEnvironmentVariableIntValue("KERF_KILL_RUNS");
        std::unique_ptr<test::ConsoleBench> bench;
        std::size_t acknowledged = 0;
        test::KillCampaign::Options options;
        options.program = QString::fromLocal8Bit(qgetenv("KERF_BIN")) + QStringLiteral("/kerf-console");
        options.arguments = QStringList{QStringLiteral("--speed"),          QStringLiteral("0"),
                                        QStringLiteral("--prepared-parts"), QStringLiteral("0"),
                                        QStringLiteral("--auto-operator"),  QStringLiteral("--print-acceptances")};
        options.prepare = [&bench](int) {
            bench = std::make_unique<test::ConsoleBench>();
            bench->prepareQuickBores();
            return QStringList{QStringLiteral("--data"), bench->folder()};
        };
        options.rounds = asked > 0 ? asked : 10;
        options.seed = 20;
        options.maxAcks = 12;
        options.ackWord = "accepted ";
        const QString finding =
            test::KillCampaign::run(options, [&](int, const std::vector<std::string>& lines) -> QString {
                std::map<qint64, Acceptance> seen;
                for (const std::string& line : lines) {
                    if (const auto acceptance = parse(line)) {
                        seen[acceptance->id] = *acceptance;
                    }
                }
                if (seen.empty()) {
                    return QStringLiteral("no line could be read: ") + QString::fromStdString(lines.front());
                }
                acknowledged += seen.size();
                qint64 newest = 0;
                const QString lost = lookAtFile(bench->folder().toStdString() + "/kerf.db", seen, newest);
                if (!lost.isEmpty()) {
                    return lost;
                }
                // Something stored after the last line we saw: then its schedule is not known here.
                const auto& [id, last] = *seen.rbegin();
                return restart(*bench, newest == id ? &last : nullptr);
            });
        QVERIFY2(finding.isEmpty(), qPrintable(finding));
        qInfo("%d kills, %zu accepted measurements, none lost", options.rounds, acknowledged);
        QVERIFY(acknowledged >= static_cast<std::size_t>(options.rounds));
    }
};
QTEST_MAIN(TestConsoleKill)
#include "tst_console_kill.moc"
