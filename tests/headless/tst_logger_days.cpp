// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/support/kerf_program.h"
#include "tests/support/table_files.h"

using kerf::test::bytesOf;
using kerf::test::day;
using kerf::test::KerfRun;
using kerf::test::put;
using kerf::test::runKerf;
using kerf::test::withColumn;
using nlohmann::json;

namespace {

using Cell = std::function<QByteArray(int)>;

}  // namespace

Q_DECLARE_METATYPE(Cell)

/// Days as loggers write them: clocks that begin at the first row, and columns that are no temperatures.
class TestLoggerDays : public QObject {
    Q_OBJECT
    const QString m_model = QStringLiteral("M.json");

    static void expectRefused(const KerfRun& run, const QStringList& pieces) {
        QVERIFY2(run.exitCode == 3 && run.out.isEmpty(), qPrintable(run.err));
        for (const QString& piece : pieces) {
            QVERIFY2(run.err.contains(piece), qPrintable(run.err));
        }
    }
    KerfRun predict(const QString& history) const {
        return runKerf({"thermal", "predict", "--model", m_model, "--history", history});
    }

 private slots:
    void initTestCase() {
        const KerfRun run = runKerf(
            {"thermal", "train", "--history", put("H0.csv", day("H0_train")), "--model", "regression", "-o", m_model});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        put("T0.csv", day("T0_same"));
    }
    void aClockThatBeginsAtItsFirstRow_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<Cell>("value");
        const auto row = [](const char* name, const Cell& value) { QTest::newRow(name) << QByteArray(name) << value; };
        row("Time [s]", [](int k) { return QByteArray::number(60 * k); });
        row("Elapsed time (min)", [](int k) { return QByteArray::number(k); });
        row("Uhrzeit", [](int k) {
            return QByteArray::number(8 + k / 60) + ':' + QByteArray::number(k % 60).rightJustified(2, '0') + ":03";
        });
        row("t_min", [](int k) { return QByteArray::number(480 + k); });
    }
    /// Who counts from 0, or writes the time of day, has no row before 0: the machine at rest is what lies before the
    /// spindle turns, in every command.
    void aClockThatBeginsAtItsFirstRow() {
        QFETCH(QByteArray, name);
        QFETCH(Cell, value);
        const auto changed = [&](const QByteArray& text, bool speed) {
            QList<QByteArray> lines = text.split('\n');
            for (int k = 0; k < lines.size() && !lines[k].isEmpty(); ++k) {
                QList<QByteArray> cells = lines[k].split(',');
                cells[0] = k == 0 ? name : value(k - 1);
                if (!speed) cells.removeAt(1);
                lines[k] = cells.join(',');
            }
            return lines.join('\n');
        };
        const QString file = put("clock.csv", changed(day("T0_same"), true));
        const KerfRun run = predict(file);
        QVERIFY2(run.exitCode == 0 && run.err.contains("5 rows are the machine at rest"), qPrintable(run.err));
        QCOMPARE(run.out, predict("T0.csv").out);
        const QStringList compensate{"thermal", "compensate", "--model", m_model, "--history"};
        QCOMPARE(runKerf(compensate + QStringList{file}).out, runKerf(compensate + QStringList{"T0.csv"}).out);
        QCOMPARE(runKerf({"thermal", "train", "--history", put("clock_h.csv", changed(day("H0_train"), true)),
                          "--model", "regression", "-o", "clock.json"})
                     .exitCode,
                 0);
        const QString blind = put("clock_blind.csv", changed(day("T0_same"), false));
        expectRefused(predict(blind), {"--rest-min", "line 2"});
        const KerfRun said = runKerf({"thermal", "predict", "--model", m_model, "--history", blind, "--rest-min", "5"});
        QCOMPARE(said.out, predict(put("blind.csv",
                                       [] {
                                           QList<QByteArray> lines = day("T0_same").split('\n');
                                           for (QByteArray& line : lines) {
                                               QList<QByteArray> cells = line.split(',');
                                               if (cells.size() > 2) cells.removeAt(1);
                                               line = cells.join(',');
                                           }
                                           return lines.join('\n');
                                       }()))
                               .out);
    }
    /// One thermocouple of many in degrees Fahrenheit: what training refuses, prediction refuses.
    void oneSensorInFahrenheit() {
        const json model = json::parse(bytesOf(m_model).toStdString());
        const auto name = QByteArray::fromStdString(model["sensors"][0]["name"].get<std::string>());
        const auto inFahrenheit = [&](const QByteArray& text) {
            QList<QByteArray> lines = text.split('\n');
            const auto at = lines[0].split(',').indexOf(name);
            for (int k = 1; k < lines.size() && !lines[k].isEmpty(); ++k) {
                QList<QByteArray> cells = lines[k].split(',');
                cells[at] = QByteArray::number(cells[at].toDouble() * 1.8 + 32.0, 'f', 3);
                lines[k] = cells.join(',');
            }
            return lines.join('\n');
        };
        const QString file = put("one_f.csv", inFahrenheit(day("T0_same")));
        const QStringList pieces{QString::fromUtf8(name), "Fahrenheit"};
        expectRefused(predict(file), pieces);
        expectRefused(runKerf({"thermal", "compensate", "--model", m_model, "--history", file}), pieces);
        expectRefused(runKerf({"thermal", "train", "--history", put("one_fh.csv", inFahrenheit(day("H0_train"))),
                               "--model", "regression", "-o", "f.json"}),
                      pieces);
    }
    /// Columns without a unit in their names that are no temperatures, by how they behave.
    void whatIsNoTemperatureIsLeftOutAndTold_data() {
        QTest::addColumn<Cell>("value");
        const auto row = [](const char* name, const Cell& value) { QTest::newRow(name) << value; };
        const auto number = [](double value, int digits) { return QByteArray::number(value, 'f', digits); };
        row("hours since the start, two digits", [=](int k) { return number((k - 1) / 60.0, 2); });
        row("hours since the start, one digit", [=](int k) { return number((k - 1) / 60.0, 1); });
        row("days since the start", [=](int k) { return number((k - 1) / 1440.0, 3); });
        row("quarters, read late", [=](int k) { return number(k / 4.0 + 0.02 * (k % 3), 2); });
        row("an hour meter", [=](int k) { return number(120.0 + k / 60.0, 2); });
        row("parts", [=](int k) { return number(3 + k / 12, 0); });
        row("a few parts from 0", [=](int k) { return number(k / 40, 0); });
        row("a current", [=](int k) { return number(k < 8 ? 0.3 : 2.0 + 0.1 * (k % 3), 2); });
        row("a load that idles", [=](int k) { return number(2.1 + 0.005 * k + 0.2 * (k % 4), 1); });
        row("a pressure", [=](int k) { return number(5.5 + 0.05 * (k % 3), 2); });
        row("a set value", [=](int) { return number(22.0, 1); });
    }
    void whatIsNoTemperatureIsLeftOutAndTold() {
        QFETCH(Cell, value);
        const QString file = put("strange.csv", withColumn(day("H0_train"), "X", value));
        const KerfRun run =
            runKerf({"thermal", "train", "--history", file, "--model", "regression", "-o", "strange.json"});
        QVERIFY2(run.exitCode == 0 && run.err.contains("'X'") && run.err.contains("left out"), qPrintable(run.err));
        json model = json::parse(bytesOf("strange.json").toStdString());
        for (const auto& sensor : model["sensors"])
            QVERIFY(sensor["name"] != "X");
        // Said to be one, it is none the less taken for one.
        const QString said = put("said.csv", withColumn(day("H0_train"), "X [degC]", value));
        const KerfRun taken =
            runKerf({"thermal", "train", "--history", said, "--model", "regression", "-o", "said.json"});
        QVERIFY2(!taken.err.contains("left out"), qPrintable(taken.err));
    }
};

QTEST_GUILESS_MAIN(TestLoggerDays)
#include "tst_logger_days.moc"
