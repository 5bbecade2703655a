// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"
#include "tests/support/table_files.h"

using kerf::test::bytesOf;
using kerf::test::csvRows;
using kerf::test::day;
using kerf::test::KerfRun;
using kerf::test::put;
using kerf::test::runKerf;
using kerf::test::withColumn;
using nlohmann::json;

namespace {

QString caseFile(const char* name) {
    return QString::fromStdString(kerf::test::fixture(std::string("cases/") + name));
}

/// One cell of a day replaced, by line (the header is 0) and column.
QByteArray withCell(const QByteArray& text, int line, const QByteArray& column, const QByteArray& value) {
    QList<QByteArray> lines = text.split('\n');
    const auto at = lines[0].split(',').indexOf(column);
    QList<QByteArray> cells = lines[line].split(',');
    cells[at] = value;
    lines[line] = cells.join(',');
    return lines.join('\n');
}

}  // namespace

/// Inputs that people filed complaints about, tried on the program; tests/fixtures/cases has the files.
class TestInputCases : public QObject {
    Q_OBJECT
    const QString m_model = QStringLiteral("M.json");

    static QStringList boring(const QString& file) { return {"boring", "replay", file, "--target-diameter-mm", "50"}; }
    static void expectRefused(const KerfRun& run, const QStringList& pieces) {
        QVERIFY2(run.exitCode == 3, qPrintable(QString::number(run.exitCode) + run.err));
        QCOMPARE(run.out, QString());
        QVERIFY2(run.err.trimmed().count(u'\n') == 0, qPrintable(run.err));
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
            {"thermal", "train", "--history", put("H0.csv", day("H0_train")), "--model", "gmdh", "-o", m_model});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        put("T0.csv", day("T0_same"));
    }
    // ── case 01
    void namesInAnotherCodePage() {
        QByteArray text = day("H0_train");
        const auto end = text.indexOf('\n');
        const QByteArray header = text.left(end).replace(",T", ",\xBF\xC2\xB5\xB5");
        put("H0_cp949.csv", header + text.mid(end));
        put("kept.json", "something good");
        const KerfRun run =
            runKerf({"thermal", "train", "--history", "H0_cp949.csv", "--model", "gmdh", "-o", "kept.json"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QVERIFY(run.err.contains("CP949"));
        const json model = json::parse(bytesOf("kept.json").toStdString());
        QVERIFY(model["sensors"][0]["name"].get<std::string>().starts_with("\xEC\x98\xA8\xEB\x8F\x84"));
        QVERIFY2(runKerf({"thermal", "predict", "--model", "kept.json", "--history", "H0_cp949.csv"}).exitCode == 0,
                 "predict");
    }
    void aFileNameInAnotherCodePage() {
        QProcess shell;  // QString cannot hold such a name
        shell.start("sh", {"-c",
                           "n=\"$(printf '\\277\\302\\265\\265.csv')\"; cp H0.csv \"$n\"; exec \"$KERF_BIN/kerf\" "
                           "thermal train --history \"$n\" --model gmdh -o named.json"});
        QVERIFY(shell.waitForFinished(60000));
        QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
        QCOMPARE(json::parse(bytesOf("named.json").toStdString())["trained_on"]["days"][0].get<std::string>(),
                 std::string("\xEC\x98\xA8\xEB\x8F\x84.csv"));
    }
    void aFailedWriteLeavesWhatWasThere() {
        put("good.json", "good");
        expectRefused(runKerf({"thermal", "train", "--history", put("broken.csv", day("H0_train").left(30000)),
                               "--model", "gmdh", "-o", "good.json"}),
                      {"broken.csv"});
        QCOMPARE(bytesOf("good.json"), QByteArray("good"));
        const QByteArray before = bytesOf("H0.csv");
        expectRefused(runKerf({"thermal", "train", "--history", "H0.csv", "--model", "gmdh", "-o", "./H0.csv"}),
                      {"history"});
        QCOMPARE(bytesOf("H0.csv"), before);
        if (QFile::exists("/dev/full")) {
            const KerfRun full =
                runKerf({"thermal", "train", "--history", "H0.csv", "--model", "gmdh", "-o", "/dev/full"});
            QCOMPARE(full.exitCode, 3);
            QProcess shell;
            shell.start("sh", {"-c", "\"$KERF_BIN/kerf\" boring table --runs 2 > /dev/full"});
            QVERIFY(shell.waitForFinished(60000));
            QCOMPARE(shell.exitCode(), 3);
        }
    }
    // ── case 05
    void rowsThatCannotBeMeant_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("pieces");
        QTest::newRow("one inch row") << caseFile("05-boring-unit-slip/one_inch_row.csv")
                                      << QStringList{"line 8", "1.9688", "inch"};
        QTest::newRow("one decade") << caseFile("05-boring-unit-slip/one_decade_slip.csv")
                                    << QStringList{"line 8", "5.0008", "50"};
        QTest::newRow("all inch") << caseFile("05-boring-unit-slip/all_inch.csv") << QStringList{"line 2", "inch"};
        const QByteArray good = bytesOf(caseFile("05-boring-unit-slip/good.csv"));
        QTest::newRow("a decade up") << put("up.csv", QByteArray(good).replace("50.003", "500.03"))
                                     << QStringList{"line 11", "500.03"};
        QTest::newRow("micrometres") << put("um.csv", QByteArray(good).replace("50.003", "50003"))
                                     << QStringList{"line 11", "50003"};
        QTest::newRow("another part's diameter")
            << put("other.csv", QByteArray(good).replace("50.003", "48.003")) << QStringList{"line 11", "48.003"};
    }
    void rowsThatCannotBeMeant() {
        QFETCH(QString, file);
        QFETCH(QStringList, pieces);
        expectRefused(runKerf(boring(file)), pieces);
    }
    void aPlausibleFilePassesAndAnImplausibleRowOnRequest() {
        QCOMPARE(runKerf(boring(caseFile("05-boring-unit-slip/good.csv"))).exitCode, 0);
        const KerfRun run =
            runKerf(boring(caseFile("05-boring-unit-slip/one_inch_row.csv")) + QStringList{"--accept-implausible"});
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.err.contains("line 8"));
    }
    // ── cases 15 and 17
    void dialectsAndBlanksGiveTheSame_data() {
        QTest::addColumn<QString>("file");
        for (const char* name :
             {"15-semicolon-quotes/german_excel", "15-semicolon-quotes/quoted_r", "15-semicolon-quotes/tab",
              "17-excel-blank-rows/blank_rows", "17-excel-blank-rows/blank_columns"}) {
            QTest::newRow(name) << caseFile((std::string(name) + ".csv").c_str());
        }
    }
    void dialectsAndBlanksGiveTheSame() {
        QFETCH(QString, file);
        const KerfRun run = runKerf(boring(file));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(run.out, runKerf(boring(caseFile("05-boring-unit-slip/good.csv"))).out);
    }
    // ── case 07
    void oneMarkCostsOneReading_data() {
        QTest::addColumn<QByteArray>("mark");
        QTest::addColumn<QString>("named");
        for (const char* mark : {"NaN", "NAN", "nan", "NA", "#N/A", "OL", "Open", "-----", "", "null", "#NV", "TC OPEN",
                                 "S.br", "E-01", "I/O Timeout"}) {
            QTest::newRow(*mark != '\0' ? mark : "empty") << QByteArray(mark) << QStringLiteral("open");
        }
        QTest::newRow("9.9E+37") << QByteArray("9.9E+37") << QStringLiteral("open");
        QTest::newRow("1372") << QByteArray("1372") << QStringLiteral("open");
        QTest::newRow("850") << QByteArray("850") << QStringLiteral("open");
        QTest::newRow("-9999") << QByteArray("-9999") << QStringLiteral("short");
    }
    void oneMarkCostsOneReading() {
        QFETCH(QByteArray, mark);
        QFETCH(QString, named);
        const json model = json::parse(bytesOf(m_model).toStdString());
        const auto sensor = QByteArray::fromStdString(model["sensors"][0]["name"].get<std::string>());
        const QByteArray text = withCell(day("T0_same"), 106, sensor, mark);
        const KerfRun run = predict(put("marked.csv", text));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QVERIFY2(run.err.contains("line 107") && run.err.contains(QString::fromUtf8(sensor)) &&
                     run.err.contains(named) && run.err.contains("one reading"),
                 qPrintable(run.err));
        const auto rows = csvRows(run.out);
        const auto whole = csvRows(predict("T0.csv").out);
        QCOMPARE(rows.size(), whole.size());
        QCOMPARE(rows.back(), whole.back());  // the sensor is not lost for the rest of the day
        expectRefused(
            runKerf({"thermal", "train", "--history", put("marked_h.csv", withCell(day("H0_train"), 106, sensor, mark)),
                     "--model", "gmdh", "-o", "x.json"}),
            {"line 107", QString::fromUtf8(sensor)});
    }
    void aMarkInAColumnTheModelDoesNotUseIsNamedAndChangesNothing() {
        const json model = json::parse(bytesOf(m_model).toStdString());
        QByteArray other;
        for (int k = 0; other.isEmpty(); ++k) {
            const QByteArray name = "T" + QByteArray::number(k).rightJustified(2, '0');
            bool used = false;
            for (const auto& sensor : model["sensors"]) {
                used = used || sensor["name"].get<std::string>() == name.toStdString();
            }
            if (!used) other = name;
        }
        const KerfRun run = predict(put("other_mark.csv", withCell(day("T0_same"), 106, other, "OL")));
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.err.contains(QString::fromUtf8(other)) && run.err.contains("line 107"), qPrintable(run.err));
        QCOMPARE(run.out, predict("T0.csv").out);
    }
    void aTurningRecordWithAHoleOrInMillimetresIsRefused() {
        QByteArray whole = "k,u_um,f_n\n", hole = whole, millimetres = whole, lost = whole;
        for (int k = 0; k < 100; ++k) {
            const QByteArray head = QByteArray::number(k) + ',';
            const double chip_um = 5.0 + k % 7;
            const QByteArray force = ',' + QByteArray::number(0.1 * chip_um) + '\n';
            whole += head + QByteArray::number(chip_um) + force;
            hole += k == 50 ? QByteArray() : head + QByteArray::number(chip_um) + force;
            millimetres += head + QByteArray::number(chip_um / 1000.0) + force;
            lost += head + QByteArray::number(chip_um) + (k == 50 ? QByteArray(",-9999\n") : force);
        }
        const auto identify = [](const QString& file) {
            return runKerf({"turning", "identify", file, "--lambda", "0.98"});
        };
        QCOMPARE(identify(put("whole.csv", whole)).exitCode, 0);
        expectRefused(identify(put("hole.csv", hole)), {"line 52", "51 follows 49"});
        expectRefused(identify(put("mm.csv", millimetres)), {"not mm"});
        expectRefused(identify(put("lost.csv", lost)), {"line 52", "-9999"});
    }
    void aTapRecordInMillisecondsIsRefused() {
        QList<QByteArray> lines = bytesOf(caseFile("12-tapping-index-reset/control_from_sync.csv")).split('\n');
        for (int k = 1; k < lines.size() && !lines[k].isEmpty(); ++k) {
            const auto comma = lines[k].indexOf(',');
            lines[k] = QByteArray::number(lines[k].left(comma).toDouble() * 1000.0) + lines[k].mid(comma);
        }
        expectRefused(runKerf({"tapping", "evaluate", put("ms.csv", lines.join('\n')), "--pitch-mm", "1.25"}),
                      {"in ms?"});
    }
    void oneForceOfALoggerCostsOneRevolution() {
        QByteArray text = bytesOf(caseFile("08-milling-angle/control_up.csv"));
        const KerfRun whole = runKerf({"milling", "replay", put("force.csv", text)});
        QList<QByteArray> lines = text.split('\n');
        QList<QByteArray> cells = lines[52].split(',');
        cells[2] = "-9999";
        lines[52] = cells.join(',');
        const KerfRun run = runKerf({"milling", "replay", put("force.csv", lines.join('\n'))});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(run.err.contains("1 samples without a value"), qPrintable(run.err));
        for (const int column : {0, 3, 4}) {  // revolution, mean and peak force
            QCOMPARE(csvRows(run.out).back()[column], csvRows(whole.out).back()[column]);
        }
    }
    void marksInOtherColumnsDoNotMatter() {
        const QByteArray text = withColumn(day("T0_same"), "remark", [](int k) {
            return k % 50 == 0 ? QByteArray("\"door, open\"") : QByteArray("OL");
        });
        const KerfRun run = predict(put("remark.csv", text));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(run.out, predict("T0.csv").out);
    }
    void tooManyLostSensorsHoldWithAnInterval() {
        QList<QByteArray> lines = day("T0_same").split('\n');
        const json model = json::parse(bytesOf(m_model).toStdString());
        const QList<QByteArray> names = lines[0].split(',');
        for (int k = 100; k < lines.size() && !lines[k].isEmpty(); ++k) {
            QList<QByteArray> cells = lines[k].split(',');
            for (const auto& sensor : model["sensors"]) {
                cells[names.indexOf(QByteArray::fromStdString(sensor["name"].get<std::string>()))] = "OL";
            }
            lines[k] = cells.join(',');
        }
        const KerfRun run = predict(put("lost.csv", lines.join('\n')));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(rows.back()[4 + axis].toDouble() > rows[50][4 + axis].toDouble());
        }
    }
    // ── case 08
    void anglesAreReadOrRefused() {
        const KerfRun up = runKerf({"milling", "replay", caseFile("08-milling-angle/control_up.csv")});
        QCOMPARE(up.exitCode, 0);
        const auto rows = csvRows(up.out);
        QCOMPARE(rows.size(), 1 + 11);
        QVERIFY(std::abs(rows[1][5].toDouble() - 1.53) < 0.01);  // not all the way before the first mark
        for (const char* name : {"08-milling-angle/wraps_each_rev.csv", "08-milling-angle/counts_down.csv"}) {
            const KerfRun run = runKerf({"milling", "replay", caseFile(name)});
            QVERIFY2(run.exitCode == 0, qPrintable(run.err));
            const auto other = csvRows(run.out);
            QCOMPARE(other.size(), rows.size());
            for (int k = 1; k < rows.size(); ++k) {
                KERF_CLOSE(other[k][3].toDouble(), rows[k][3].toDouble(), 1e-6);
            }
        }
        expectRefused(runKerf({"milling", "replay", caseFile("08-milling-angle/degrees.csv")}),
                      {"18", "rev between samples"});
        expectRefused(runKerf({"milling", "replay", caseFile("08-milling-angle/degrees_wrapped.csv")}),
                      {"rev between samples"});
    }
    void anglesOfOurOwn() {
        const QByteArray degrees = bytesOf(caseFile("08-milling-angle/degrees.csv"));
        const KerfRun named = runKerf(
            {"milling", "replay", put("named_deg.csv", QByteArray(degrees).replace("angle_rev", "angle [deg]"))});
        QVERIFY2(named.exitCode == 0, qPrintable(named.err));
        QCOMPARE(csvRows(named.out).size(), 1 + 11);
        QByteArray standing = "t_s,angle_rev,force_y_n,feed_mm_s\n";
        QByteArray both = standing, short_ = standing;
        for (int k = 0; k < 300; ++k) {
            standing += QByteArray::number(k * 0.001) + ",0.25,100,1.5\n";
            both += QByteArray::number(k * 0.001) + ',' + QByteArray::number(k < 150 ? k * 0.02 : 6.0 - k * 0.02) +
                    ",100,1.5\n";
            short_ += QByteArray::number(k * 0.001) + ',' + QByteArray::number(0.1 + k * 0.002) + ",100,1.5\n";
        }
        expectRefused(runKerf({"milling", "replay", put("standing.csv", standing)}), {"does not move"});
        expectRefused(runKerf({"milling", "replay", put("both.csv", both)}), {"one way"});
        expectRefused(runKerf({"milling", "replay", put("short.csv", short_)}), {"whole revolution"});
    }
    // ── case 12
    void aTapIsFoundWhereZBeginsToFollow() {
        const auto evaluate = [](const QString& file) {
            return runKerf({"tapping", "evaluate", file, "--pitch-mm", "1.25"});
        };
        const KerfRun control = evaluate(caseFile("12-tapping-index-reset/control_from_sync.csv"));
        QCOMPARE(control.exitCode, 0);
        const json expected = json::parse(control.out.toStdString());
        for (const char* name :
             {"12-tapping-index-reset/spindle_ran_before.csv", "12-tapping-index-reset/index_reset_at_sync.csv"}) {
            const KerfRun run = evaluate(caseFile(name));
            QVERIFY2(run.exitCode == 0, qPrintable(run.err));
            const json found = json::parse(run.out.toStdString());
            KERF_CLOSE(found["saec_mm"].get<double>(), expected["saec_mm"].get<double>(), 1e-3);
            KERF_CLOSE(found["engaged_pp_um"].get<double>(), expected["engaged_pp_um"].get<double>(), 1e-3);
            QVERIFY(run.err.contains("begins"));
        }
        // the spindle goes on when Z stands again; a mirrored record; a sample lost
        QList<QByteArray> lines =
            bytesOf(caseFile("12-tapping-index-reset/spindle_ran_before.csv")).trimmed().split('\n');
        QByteArray after = lines.join('\n') + '\n';
        for (int k = 1; k <= 300; ++k) {
            after += QByteArray::number(2.0 + k * 0.001, 'f', 3) + ',' + QByteArray::number(125.37 - k * 0.01, 'f', 6) +
                     ",0.0\n";
        }
        const KerfRun goesOn = evaluate(put("after.csv", after));
        QVERIFY2(goesOn.exitCode == 0, qPrintable(goesOn.err));
        KERF_CLOSE(json::parse(goesOn.out.toStdString())["engaged_pp_um"].get<double>(),
                   expected["engaged_pp_um"].get<double>(), 0.01);
        lines[900] = lines[900].left(lines[900].lastIndexOf(',')) + ",OL";
        const KerfRun lost = evaluate(put("lost_tap.csv", lines.join('\n')));
        QVERIFY2(lost.exitCode == 0, qPrintable(lost.err));
        KERF_CLOSE(json::parse(lost.out.toStdString())["saec_mm"].get<double>(), expected["saec_mm"].get<double>(),
                   0.01);
    }
    // ── temperatures and units
    void onlyTemperaturesTrain() {
        QByteArray text = withColumn(day("H0_train"), "cycle", [](int k) { return QByteArray::number(k); });
        text = withColumn(text, "load_pct", [](int k) { return QByteArray::number(k % 7 < 3 ? 60 : 0); });
        text = withColumn(text, "spindle", [](int k) { return QByteArray::number(k % 9 < 4 ? 45.5 : 2.0); });
        text = withColumn(text, "clock", [](int k) { return QByteArray::number(45000.0 + k / 1440.0, 'f', 6); });
        const KerfRun run = runKerf({"thermal", "train", "--history", put("more.csv", text), "--model", "regression",
                                     "-o", "more.json", "--report"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        for (const char* name : {"cycle", "load_pct", "spindle", "clock"}) {
            QVERIFY2(run.err.contains(name), qPrintable(run.err));
        }
        const KerfRun plain = runKerf(
            {"thermal", "train", "--history", "H0.csv", "--model", "regression", "-o", "plain.json", "--report"});
        QVERIFY(json::parse(run.out.toStdString())["sensors"] == json::parse(plain.out.toStdString())["sensors"]);
    }
    void unitsThatTrainingRefusesPredictionRefuses_data() {
        QTest::addColumn<double>("factor");
        QTest::addColumn<double>("offset");
        QTest::addColumn<bool>("time");
        QTest::addColumn<QString>("piece");
        QTest::newRow("fahrenheit") << 1.8 << 32.0 << false << QStringLiteral("Fahrenheit");
        QTest::newRow("kelvin") << 1.0 << 273.15 << false << QStringLiteral("kelvin");
        QTest::newRow("seconds") << 60.0 << 0.0 << true << QStringLiteral("seconds");
    }
    void unitsThatTrainingRefusesPredictionRefuses() {
        QFETCH(double, factor);
        QFETCH(double, offset);
        QFETCH(bool, time);
        QFETCH(QString, piece);
        const auto changed = [&](const QByteArray& text) {
            QList<QByteArray> lines = text.split('\n');
            const QList<QByteArray> names = lines[0].split(',');
            for (int k = 1; k < lines.size() && !lines[k].isEmpty(); ++k) {
                QList<QByteArray> cells = lines[k].split(',');
                for (int c = 0; c < cells.size(); ++c) {
                    const bool mine = time ? names[c] == "t_min" : names[c].startsWith('T');
                    if (mine) cells[c] = QByteArray::number(cells[c].toDouble() * factor + offset, 'f', 3);
                }
                lines[k] = cells.join(',');
            }
            return lines.join('\n');
        };
        expectRefused(predict(put("unit_t.csv", changed(day("T0_same")))), {piece});
        expectRefused(runKerf({"thermal", "train", "--history", put("unit_h.csv", changed(day("H0_train"))), "--model",
                               "gmdh", "-o", "x.json"}),
                      {piece});
    }
    void driftInMillimetresIsNoResidual() {
        QList<QByteArray> lines = day("T0_same").split('\n');
        const QList<QByteArray> names = lines[0].split(',');
        for (int k = 1; k < lines.size() && !lines[k].isEmpty(); ++k) {
            QList<QByteArray> cells = lines[k].split(',');
            for (int c = 0; c < cells.size(); ++c) {
                if (names[c].startsWith('y') && cells[c] != "nan")
                    cells[c] = QByteArray::number(cells[c].toDouble() / 1000.0, 'g', 9);
            }
            lines[k] = cells.join(',');
        }
        expectRefused(
            runKerf({"thermal", "compensate", "--model", m_model, "--history", put("mm.csv", lines.join('\n'))}),
            {"not mm"});
    }
    void columnsInAnyOrderAndSpellingPredictTheSame() {
        QByteArray text = day("T0_same");
        const auto end = text.indexOf('\n');
        QByteArray header = text.left(end);
        header.replace("t_min", "Time [min]");
        for (int k = 0; k < 64; ++k) {
            const QByteArray name = "T" + QByteArray::number(k).rightJustified(2, '0');
            header.replace("," + name + ",", "," + name +
                                                 " (\xC2\xB0"
                                                 "C),");
        }
        const KerfRun run = predict(put("spelling.csv", header + text.mid(end)));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(run.out, predict("T0.csv").out);
    }
    // ── values that cannot be meant, of our own
    void aStationOrAValueThatSlippedIsRefusedAndTakenOnRequest() {
        QList<QByteArray> lines = bytesOf(caseFile("05-boring-unit-slip/good.csv")).trimmed().split('\n');
        const auto overhang = lines[0].split(',').indexOf("overhang_mm");
        const auto withOverhang = [&](double factor) {
            QList<QByteArray> changed = lines;
            QList<QByteArray> cells = changed[7].split(',');
            cells[overhang] = QByteArray::number(cells[overhang].toDouble() * factor, 'g', 6);
            changed[7] = cells.join(',');
            return put("overhang.csv", changed.join('\n'));
        };
        for (const double factor : {10.0, 0.1, 1.0 / 25.4}) {
            const QString file = withOverhang(factor);
            expectRefused(runKerf(boring(file)), {"line 8", "overhang_mm", "--accept-implausible"});
            QCOMPARE(runKerf(boring(file) + QStringList{"--accept-implausible"}).exitCode, 0);
        }
        QByteArray values = "part,value\n";
        for (int k = 0; k < 30; ++k) {
            values += QByteArray::number(k + 1) + ',' + QByteArray::number(50.0 + 0.002 * ((7 * k) % 11 - 5)) + '\n';
        }
        const auto slipped = [&](const QByteArray& value) {
            QList<QByteArray> rows = values.split('\n');
            rows[12] = "12," + value;
            return put("values.csv", rows.join('\n'));
        };
        const QStringList limits{"--lower", "49.95", "--upper", "50.05"};
        for (const char* value : {"500.02", "5.0002", "1.96858", "50002"}) {
            expectRefused(runKerf({"quality", "charts", slipped(value)}), {"line 13", value});
            expectRefused(runKerf(QStringList{"quality", "capability", slipped(value)} + limits), {"line 13", value});
            expectRefused(runKerf({"quality", "gauge-study", slipped(value), "--method", "type1", "--tolerance", ".1"}),
                          {"line 13", value});
            QCOMPARE(runKerf({"quality", "charts", slipped(value), "--accept-implausible"}).exitCode, 0);
        }
        // far from the others and no slip of them: a bad part is no slip of the pen
        QCOMPARE(runKerf({"quality", "charts", slipped("50.9")}).exitCode, 0);
        QByteArray inches = "value\n";
        for (int k = 0; k < 30; ++k) {
            inches += QByteArray::number((50.0 + 0.002 * (k % 5)) / 25.4, 'g', 8) + '\n';
        }
        expectRefused(runKerf(QStringList{"quality", "capability", put("inches.csv", inches)} + limits), {"inch"});
    }
    void boresOfAChartAreAskedAboutLikeThoseOfAReplay() {
        QByteArray text = "part,overhang_mm,feed_mm_per_rev,deflection_mm\n";
        for (int part = 1; part <= 6; ++part) {
            for (const double overhang_mm : {175.0, 310.0}) {
                const double deflection_mm = 0.1 * std::pow(overhang_mm / 310.0, 0.27) * (1.0 + 0.01 * (part % 3));
                text += QByteArray::number(part) + ',' + QByteArray::number(overhang_mm) + ",0.3," +
                        QByteArray::number(deflection_mm, 'g', 6) + '\n';
            }
        }
        QCOMPARE(runKerf({"quality", "charts", put("bores.csv", text)}).exitCode, 0);
        QList<QByteArray> lines = text.split('\n');
        lines[8] = "4,310,0.3,2.54";
        expectRefused(runKerf({"quality", "charts", put("bores.csv", lines.join('\n'))}), {"line 9", "2.54"});
        lines[8] = "4,310,,0.1";
        expectRefused(runKerf({"quality", "charts", put("bores.csv", lines.join('\n'))}), {"line 9"});
    }
    void aMeasuredBoreWithoutItsFeedOrDepthCostsOneRow() {
        for (const char* column : {"overhang_mm", "feed_mm_per_rev", "diameter_mm"}) {
            const QByteArray good = bytesOf(caseFile("05-boring-unit-slip/good.csv"));
            const KerfRun run = runKerf(boring(put("gap.csv", withCell(good, 7, column, "n/a"))));
            QVERIFY2(run.exitCode == 0 && run.err.contains("line 8"), qPrintable(run.err));
            QCOMPARE(csvRows(run.out).size(), csvRows(runKerf(boring(put("whole.csv", good))).out).size() - 1);
        }
    }
    void unitsOfForcesTimesAndFeedsAreRefused() {
        const QByteArray cut = bytesOf(caseFile("08-milling-angle/control_up.csv"));
        const auto scaled = [&](int column, double factor) {
            QList<QByteArray> lines = cut.trimmed().split('\n');
            for (int k = 1; k < lines.size(); ++k) {
                QList<QByteArray> cells = lines[k].split(',');
                cells[column] = QByteArray::number(cells[column].toDouble() * factor, 'g', 9);
                lines[k] = cells.join(',');
            }
            return QStringList{"milling", "replay", put("scaled.csv", lines.join('\n'))};
        };
        expectRefused(runKerf(scaled(2, 0.001)), {"kN"});
        expectRefused(runKerf(scaled(0, 1000.0)), {"in ms?"});
        expectRefused(runKerf(scaled(3, 60.0)), {"mm/min"});
        QCOMPARE(runKerf(scaled(2, 2.0)).exitCode, 0);
        QByteArray chips = "k,u_um,f_n\n", milli = chips, kilo = chips;
        for (int k = 0; k < 100; ++k) {
            const QByteArray head = QByteArray::number(k) + ',' + QByteArray::number(5.0 + k % 7) + ',';
            chips += head + QByteArray::number(0.1 * (5.0 + k % 7)) + '\n';
            milli += head + QByteArray::number(100.0 * (5.0 + k % 7)) + '\n';
            kilo += head + QByteArray::number(1e-4 * (5.0 + k % 7)) + '\n';
        }
        const auto identify = [](const QString& file) {
            return runKerf({"turning", "identify", file, "--lambda", "0.98"});
        };
        QCOMPARE(identify(put("chips.csv", chips)).exitCode, 0);
        expectRefused(identify(put("milli.csv", milli)), {"not mN"});
        expectRefused(identify(put("kilo.csv", kilo)), {"not kN"});
    }
    void anHourOfSecondsAndADriftInNanometresAreRefused() {
        QList<QByteArray> lines = day("T0_same").split('\n');
        const QList<QByteArray> names = lines[0].split(',');
        QList<QByteArray> hour{lines[0]}, nano{lines[0]};
        for (int k = 1; k < lines.size() && !lines[k].isEmpty(); ++k) {
            QList<QByteArray> cells = lines[k].split(',');
            if (k < 40) {
                QList<QByteArray> early = cells;
                early[0] = QByteArray::number(early[0].toDouble() * 60.0);
                hour.append(early.join(','));
            }
            for (int c = 0; c < cells.size(); ++c) {
                if (names[c].startsWith('y') && cells[c] != "nan")
                    cells[c] = QByteArray::number(cells[c].toDouble() * 1000.0, 'g', 9);
            }
            nano.append(cells.join(','));
        }
        expectRefused(predict(put("hour.csv", hour.join('\n'))), {"60 min apart", "seconds"});
        expectRefused(
            runKerf({"thermal", "compensate", "--model", m_model, "--history", put("nm.csv", nano.join('\n'))}),
            {"not nm"});
    }
    void aSampleThatIsNoMotionCostsOneSample() {
        const QString control = caseFile("12-tapping-index-reset/control_from_sync.csv");
        const auto evaluate = [](const QString& file) {
            return runKerf({"tapping", "evaluate", file, "--pitch-mm", "1.25"});
        };
        const json expected = json::parse(evaluate(control).out.toStdString());
        for (const int column : {1, 2}) {
            for (const char* value : {"0.4321", "1372", "-9998.7"}) {
                QList<QByteArray> lines = bytesOf(control).trimmed().split('\n');
                QList<QByteArray> cells = lines[701].split(',');
                cells[column] = value;
                lines[701] = cells.join(',');
                const KerfRun run = evaluate(put("strayed.csv", lines.join('\n')));
                QVERIFY2(run.exitCode == 0 && run.err.contains("line 702"), qPrintable(value + run.err));
                KERF_CLOSE(json::parse(run.out.toStdString())["engaged_pp_um"].get<double>(),
                           expected["engaged_pp_um"].get<double>(), 0.01);
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestInputCases)
#include "tst_input_cases.moc"
