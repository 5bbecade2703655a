// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/db/db_test_support.h"
#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"

using kerf::test::KerfRun;
using kerf::test::runKerf;
using nlohmann::json;

/// What one command writes as a table, every command that takes such rows reads, in every dialect it is written in.
class TestReadBack : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] QString file(const QString& name) const { return m_folder.filePath(name); }
    void keep(const QString& name, const QStringList& arguments) {
        const KerfRun run = runKerf(arguments);
        QVERIFY2(run.exitCode == 0, qPrintable(arguments.join(u' ') + u'\n' + run.err));
        QFile out(file(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(run.out.toUtf8());
    }
    [[nodiscard]] static double numberOf(const KerfRun& run, const char* key) {
        return json::parse(run.out.toStdString())[key].get<double>();
    }

 private slots:
    void initTestCase() {
        // A lot of twelve parts with bores as the law has them.
        QVERIFY(QDir().mkpath(file("data")));
        const std::string path = file("data/kerf.db").toStdString();
        QVERIFY(kerf::db::prepareDatabase(path));
        kerf::test::Shop shop(path);
        for (std::uint32_t part = 1; part <= 12; ++part) {
            const kerf::PartId id = shop.addPart(part);
            for (std::uint8_t station = 0; station < 2; ++station) {
                kerf::MeasurementRow row =
                    kerf::test::measured(id, station, 49.95 + 0.01 * station + 0.003 * ((part * 7) % 5));
                row.source = kerf::MeasurementSource::Gauge;
                row.sourceName = "G-07, \"new\"; 내경";
                (void)shop.must(kerf::AcceptMeasurement{row, {kerf::test::stateOf(0.5)}, std::nullopt});
            }
        }
        keep("simulated.csv", {"boring", "simulate", "--csv", "--seed", "3"});
        keep("tap.csv", {"tapping", "simulate", "--csv"});
        keep("day.csv", {"thermal", "simulate", "--hours", "2"});
        keep("values.csv", {"data", "export", "measurements", "--data", file("data")});
        keep("charts.csv", {"quality", "charts", file("values.csv"), "--column", "diameter_mm", "--csv"});
        keep("lot.csv", {"quality", "charts", "--data", file("data"), "--lot", "12", "--csv"});
    }
    void whatDataExportWrites_data() {
        QTest::addColumn<QStringList>("dialect");
        QTest::newRow("plain") << QStringList{};
        QTest::newRow("semicolon") << QStringList{"--separator", ";", "--decimal", ","};
        QTest::newRow("tab") << QStringList{"--separator", "tab"};
        QTest::newRow("excel") << QStringList{"--excel"};
        QTest::newRow("local") << QStringList{"--local-time"};
    }
    void whatDataExportWrites() {
        QFETCH(QStringList, dialect);
        for (const char* what : {"parts", "measurements", "bores"}) {
            const QString name = QStringLiteral("%1.csv").arg(QLatin1String(what));
            keep(name, QStringList{"data", "export", what, "--data", file("data")} + dialect);
            for (const QStringList& reading :
                 {QStringList{"quality", "capability", file(name), "--column", "diameter_mm", "--lower", "49.9",
                              "--upper", "50.1", "--json"},
                  QStringList{"quality", "charts", file(name), "--column", "diameter_mm", "--json"}}) {
                const KerfRun run = runKerf(reading);
                QVERIFY2(run.exitCode == 0, qPrintable(reading.join(u' ') + u'\n' + run.err));
                QCOMPARE(numberOf(run, "n"), 24.0);
            }
        }
        const KerfRun replay =
            runKerf({"boring", "replay", file("bores.csv"), "--target-diameter-mm", "50", "--accept-implausible"});
        QVERIFY2(replay.exitCode == 0, qPrintable(replay.err));
        QCOMPARE(kerf::test::csvRows(replay.out).size(), 25);
    }
    void whatOtherCommandsWrite_data() {
        QTest::addColumn<QStringList>("reading");
        const auto row = [](const char* name, const QStringList& reading) { QTest::newRow(name) << reading; };
        row("simulated lots: replay", {"boring", "replay", "simulated.csv"});
        row("simulated lots: charts", {"quality", "charts", "simulated.csv"});
        row("simulated lots: capability", {"quality", "capability", "simulated.csv", "--column", "deflection_true_mm",
                                           "--lower", "0.05", "--upper", "0.4"});
        row("a tap", {"tapping", "evaluate", "tap.csv", "--pitch-mm", "1.25"});
        row("charts: charts", {"quality", "charts", "charts.csv"});
        row("charts: charts of the errors", {"quality", "charts", "charts.csv", "--column", "error"});
        row("charts: capability", {"quality", "capability", "charts.csv", "--lower", "49.9", "--upper", "50.1"});
        row("charts of a lot", {"quality", "charts", "lot.csv", "--sigma", "0.005"});
    }
    void whatOtherCommandsWrite() {
        QFETCH(QStringList, reading);
        reading[2] = file(reading[2]);
        const KerfRun run = runKerf(reading);
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QVERIFY(!run.out.trimmed().isEmpty());
    }
    void aSimulatedDayIsTrainedOnAndCompensated() {
        const QString model = file("model.json");
        const KerfRun train =
            runKerf({"thermal", "train", "--history", file("day.csv"), "--model", "regression", "-o", model});
        QVERIFY2(train.exitCode == 0, qPrintable(train.err));
        for (const char* command : {"predict", "compensate"}) {
            keep(QStringLiteral("%1.csv").arg(QLatin1String(command)),
                 {"thermal", command, "--model", model, "--history", file("day.csv")});
        }
        const KerfRun run = runKerf({"quality", "capability", file("compensate.csv"), "--column", "residual_x_um",
                                     "--lower", "-50", "--upper", "50"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QVERIFY(numberOf(run, "n") > 100.0);
    }
};

QTEST_GUILESS_MAIN(TestReadBack)
#include "tst_read_back.moc"
