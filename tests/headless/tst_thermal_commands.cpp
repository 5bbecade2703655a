// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"

using kerf::test::csvRows;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using nlohmann::json;

namespace {

QString day(const char* name) {
    return QString::fromStdString(kerf::test::fixture(std::string("thermal/") + name + ".csv"));
}

QString readText(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// A day of the fixtures with one cell replaced. Row 1 is the first line after the header.
QString withCell(const char* name, int row, const QString& column, const QString& text, const QString& to) {
    QStringList lines = readText(day(name)).split(u'\n');
    const auto index = lines[0].split(u',').indexOf(column);
    QStringList cells = lines[row].split(u',');
    cells[index] = text;
    lines[row] = cells.join(u',');
    return scratchFile(to, lines.join(u'\n'));
}

QStringList thermal(const QStringList& arguments) {
    return QStringList{QStringLiteral("thermal")} + arguments;
}

}  // namespace

class TestThermalCommands : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase();
    void volumetricMatchesTheReference_data();
    void volumetricMatchesTheReference();
    void predictionsAreTheSameFromTheFile();
    void compensationSummaryHolds();
    void reportHasSensorsErrorsAndFormula();
    void simulatedDayTrainsAndPredicts();
    void simulationIsReproducible();
    void seasonsAndHardMachinesAreOtherMachines();
    void badHistoriesAreRefused_data();
    void badHistoriesAreRefused();
    void wrongModelFilesAreRefused_data();
    void wrongModelFilesAreRefused();
    void badOptionsAreRefused_data();
    void badOptionsAreRefused();
    void missingReadingsAndColumnsAreLostSensors();
    void oneDisplacementAndSixSensorsTrainAndLearn();

 private:
    QString m_model;
};

void TestThermalCommands::initTestCase() {
    m_model = QStringLiteral("model.json");
    const KerfRun run = runKerf(thermal({"train", "--history", day("H0_train"), "--history", day("H1_train"),
                                         "--history", day("H2_train"), "--model", "regression", "-o", m_model}));
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
}

void TestThermalCommands::volumetricMatchesTheReference_data() {
    QTest::addColumn<QString>("mode");
    QTest::addColumn<QString>("field");
    QTest::newRow("exact") << "exact"
                           << "e_lin";
    QTest::newRow("first-order") << "first-order"
                                 << "e_eq8";
}

void TestThermalCommands::volumetricMatchesTheReference() {
    QFETCH(QString, mode);
    QFETCH(QString, field);
    const QString cases = QString::fromStdString(kerf::test::fixture("golden/golden_htm.json"));
    const KerfRun run = runKerf(thermal({"volumetric", "--cases", cases, "--mode", mode}));
    QCOMPARE(run.exitCode, 0);
    const json out = json::parse(run.out.toStdString());
    const json golden = kerf::test::loadGolden("golden_htm.json");
    QCOMPARE(out["cases"].size(), golden["random_cases"].size());
    for (std::size_t k = 0; k < out["cases"].size(); ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto expected = golden["random_cases"][k][field.toStdString()][axis].get<double>();
            QVERIFY(std::abs(out["cases"][k]["e"][axis].get<double>() - expected) <= 1e-12);
        }
    }
}

void TestThermalCommands::predictionsAreTheSameFromTheFile() {
    const KerfRun run = runKerf(thermal({"predict", "--model", m_model, "--history", day("T1_rand")}));
    QCOMPARE(run.exitCode, 0);
    const auto rows = csvRows(run.out);
    QCOMPARE(rows.size(), 361);
    QCOMPARE(rows[0].join(u','), QStringLiteral("t_min,x_um,y_um,z_um,x_half_um,y_half_um,z_half_um"));
    const auto truth = csvRows(readText(day("T1_rand")));
    const auto first = truth[0].indexOf(QStringLiteral("yx_true"));
    for (int k = 1; k < rows.size(); ++k) {
        const QStringList& expected = truth[k + 5];
        QCOMPARE(rows[k][0].toDouble(), expected[0].toDouble());
        for (int axis = 0; axis < 3; ++axis) {
            const double error = rows[k][1 + axis].toDouble() - expected[first + axis].toDouble();
            const std::array bars{1.0, 2.5, 4.5};
            QVERIFY(std::abs(error) <= bars[static_cast<std::size_t>(axis)]);
            QVERIFY(rows[k][4 + axis].toDouble() > 0.0);
        }
    }
}

void TestThermalCommands::compensationSummaryHolds() {
    const KerfRun run = runKerf(thermal({"compensate", "--model", m_model, "--history", day("T0_same"), "--period-min",
                                         "5", "--quantum-um", "1", "--summary"}));
    QCOMPARE(run.exitCode, 0);
    const json out = json::parse(run.out.toStdString());
    QVERIFY(out["p95_um"]["x"].get<double>() <= 4.0);
    QVERIFY(out["p95_um"]["y"].get<double>() <= 3.0);
    QVERIFY(out["p95_um"]["z"].get<double>() <= 4.0);
    const KerfRun rows =
        runKerf(thermal({"compensate", "--model", m_model, "--history", day("T0_same"), "--period-min", "5"}));
    QCOMPARE(csvRows(rows.out).size(), 361);
    QCOMPARE(csvRows(rows.out)[5][1], QStringLiteral("0"));  // minute 4: nothing shifted yet
}

void TestThermalCommands::reportHasSensorsErrorsAndFormula() {
    const KerfRun run = runKerf(thermal({"train", "--history", day("H0_train"), "--model", "gmdh", "--criterion",
                                         "combined", "--check-rows", "240-359", "-o", "gmdh.json", "--report"}));
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const json report = json::parse(run.out.toStdString());
    QVERIFY(!report["sensors"].empty());
    QVERIFY(!report["formula"].empty());
    QCOMPARE(report["held_out"].get<bool>(), false);
}

void TestThermalCommands::simulatedDayTrainsAndPredicts() {
    const QStringList schedules{"0:0,10:3000,60:4500,120:1000,180:3500,220:0,260:4500,320:2000",
                                "0:0,5:2000,90:4000,200:500,300:4500", "0:1500,80:4500,160:0,200:3000,300:1000"};
    QStringList train = thermal({"train"});
    for (int k = 0; k < 3; ++k) {
        const KerfRun run = runKerf(
            thermal({"simulate", "--schedule", schedules[k], "--hours", "6", "--seed", QString::number(k + 1)}));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        train << "--history" << scratchFile(QStringLiteral("day%1.csv").arg(k), run.out);
    }
    QVERIFY(runKerf(train + QStringList{"--model", "regression", "-o", "own.json"}).exitCode == 0);
    const KerfRun unseen =
        runKerf(thermal({"simulate", "--schedule", "0:0,20:4000,150:1500,250:3500", "--hours", "6", "--seed", "44"}));
    const QString file = scratchFile(QStringLiteral("unseen.csv"), unseen.out);
    const KerfRun run = runKerf(thermal({"compensate", "--model", "own.json", "--history", file, "--summary"}));
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const json out = json::parse(run.out.toStdString());
    for (const char* axis : {"x", "y", "z"}) {
        QVERIFY2(out["p95_um"][axis].get<double>() <= 4.0, axis);
    }
}

void TestThermalCommands::simulationIsReproducible() {
    const QStringList arguments = thermal({"simulate", "--schedule", "0:0,10:3000", "--hours", "1", "--seed", "7"});
    const KerfRun first = runKerf(arguments);
    QCOMPARE(first.exitCode, 0);
    QCOMPARE(csvRows(first.out).size(), 66);
    QCOMPARE(runKerf(arguments).out, first.out);
    QVERIFY(runKerf(arguments.mid(0, arguments.size() - 1) + QStringList{"8"}).out != first.out);
}

void TestThermalCommands::seasonsAndHardMachinesAreOtherMachines() {
    const QStringList plain = thermal({"simulate", "--schedule", "0:3000", "--hours", "2", "--seed", "7"});
    const KerfRun reference = runKerf(plain);
    QCOMPARE(reference.exitCode, 0);
    QCOMPARE(runKerf(plain + QStringList{"--machine-seed", "0", "--season", "none"}).out, reference.out);
    // Digits of the machine before it could be hard.
    QVERIFY(reference.out.contains(QStringLiteral("t_min,rpm,amb_true,T00")));
    const auto endOf = [](const KerfRun& run) { return csvRows(run.out).last().last().toDouble(); };
    const double drift_um = endOf(reference);
    for (const char* season : {"coolant", "door", "sun", "moved", "nonlinear"}) {
        const KerfRun run = runKerf(plain + QStringList{"--season", season});
        QCOMPARE(run.exitCode, 0);
        QVERIFY2(std::abs(endOf(run) - drift_um) > 0.2, season);
        QVERIFY2(std::abs(endOf(run)) < 150.0, season);
    }
    const KerfRun hard = runKerf(plain + QStringList{"--machine-seed", "5"});
    QVERIFY(std::abs(endOf(hard) - drift_um) > 0.2);
    QCOMPARE(runKerf(plain + QStringList{"--machine-seed", "5"}).out, hard.out);
    QCOMPARE(runKerf(plain + QStringList{"--season", "winter"}).exitCode, 2);

    const KerfRun robust = runKerf(thermal({"robust", "--machines", "2", "--seed", "1", "--csv"}));
    QVERIFY2(robust.exitCode == 0, qPrintable(robust.err));
    const auto rows = csvRows(robust.out);
    QCOMPARE(rows.size(), 5);
    QCOMPARE(rows[0].join(u','), QStringLiteral("machine_seed,season,rms_uncompensated_um,rms_simple_um,rms_default_um,"
                                                "rms_measured_um,inside,ratio,worse,unstable_default,unstable_simple"));
    for (int k = 1; k < rows.size(); ++k) {
        QCOMPARE(rows[k][9], QStringLiteral("0"));
        QVERIFY(rows[k][4].toDouble() < 3.0 * rows[k][2].toDouble());
    }
}

void TestThermalCommands::badHistoriesAreRefused_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("expected");
    QTest::newRow("gap in a temperature")
        << withCell("H0_train", 100, "T05", "", "gap.csv") << QStringList{"gap.csv", "line 101", "T05"};
    QTest::newRow("not a number") << withCell("H0_train", 100, "T05", "warm", "word.csv")
                                  << QStringList{"word.csv", "line 101", "T05", "warm"};
    QTest::newRow("out of range") << withCell("H0_train", 90, "T07", "700", "range.csv")
                                  << QStringList{"range.csv", "line 91", "T07", "700"};
    QTest::newRow("time goes back") << withCell("H0_train", 50, "t_min", "3", "time.csv")
                                    << QStringList{"time.csv", "line 51", "t_min"};
    QTest::newRow("drift missing") << withCell("H0_train", 50, "yz_meas", "nan", "drift.csv")
                                   << QStringList{"drift.csv", "line 51", "yz_meas"};
    const auto transformed = [](const QString& to,
                                const std::function<void(QStringList&, const QStringList&)>& change) {
        QStringList lines = readText(day("H0_train")).split(u'\n', Qt::SkipEmptyParts);
        const QStringList names = lines[0].split(u',');
        for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
            QStringList cells = line->split(u',');
            change(cells, names);
            *line = cells.join(u',');
        }
        return scratchFile(to, lines.join(u'\n'));
    };
    QTest::newRow("constant column") << transformed("constant.csv", [](QStringList& c, const QStringList& n) {
        c[n.indexOf("T10")] = "22.5";
    }) << QStringList{"constant.csv", "T10", "constant"};
    QTest::newRow("fahrenheit") << transformed("fahrenheit.csv", [](QStringList& c, const QStringList& n) {
        for (int k = 0; k < n.size(); ++k) {
            if (n[k].startsWith(u'T')) {
                c[k] = QString::number(c[k].toDouble() * 1.8 + 32.0);
            }
        }
    }) << QStringList{"fahrenheit.csv", "Fahrenheit"};
    QTest::newRow("drift in mm") << transformed("mm.csv", [](QStringList& c, const QStringList& n) {
        for (int k = 0; k < n.size(); ++k) {
            if (n[k].endsWith(QStringLiteral("_meas"))) {
                c[k] = c[k] == "nan" ? c[k] : QString::number(c[k].toDouble() / 1000.0);
            }
        }
    }) << QStringList{"mm.csv", "not mm"};
    QTest::newRow("empty") << scratchFile("empty.csv", QString()) << QStringList{"empty.csv"};
    QTest::newRow("missing") << QStringLiteral("nowhere.csv") << QStringList{"nowhere.csv"};
}

void TestThermalCommands::badHistoriesAreRefused() {
    QFETCH(QString, file);
    QFETCH(QStringList, expected);
    const KerfRun run = runKerf(thermal({"train", "--history", file, "--model", "regression", "-o", "never.json"}));
    QCOMPARE(run.exitCode, 3);
    QVERIFY(run.out.isEmpty());
    for (const QString& part : expected) {
        QVERIFY2(run.err.contains(part), qPrintable(run.err));
    }
}

void TestThermalCommands::wrongModelFilesAreRefused_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("expected");
    const auto changed = [this](const QString& to, const std::function<void(json&)>& change) {
        json model = json::parse(readText(QStringLiteral("model.json")).toStdString());
        change(model);
        return scratchFile(to, QString::fromStdString(model.dump()));
    };
    QTest::newRow("newer") << changed("newer.json", [](json& m) { m["version"] = 2; }) << "newer program";
    QTest::newRow("another format") << changed("format.json", [](json& m) { m["format"] = "recipe"; })
                                    << "not a thermal model";
    QTest::newRow("other units") << changed("units.json", [](json& m) { m["units"]["drift"] = "mm"; }) << "drift";
    QTest::newRow("no sensors") << changed("sensors.json", [](json& m) { m["sensors"] = json::array(); }) << "sensors";
    QTest::newRow("field missing") << changed("field.json", [](json& m) { m.erase("rise_moment_K2"); })
                                   << "rise_moment_K2";
    QTest::newRow("wrong size") << changed("size.json", [](json& m) {
        m["regression"]["temperatures"]["gram"].erase(0);
    }) << "gram";
    QTest::newRow("not a number") << changed("text.json", [](json& m) { m["features"]["speed_exponent"] = "much"; })
                                  << "speed_exponent";
    QTest::newRow("not JSON") << scratchFile("not.json", "thermal") << "not JSON";
    QTest::newRow("cut off") << scratchFile("cut.json", readText(QStringLiteral("model.json")).left(2000))
                             << "not JSON";
}

void TestThermalCommands::wrongModelFilesAreRefused() {
    QFETCH(QString, file);
    QFETCH(QString, expected);
    const KerfRun run = runKerf(thermal({"predict", "--model", file, "--history", day("T1_rand")}));
    QCOMPARE(run.exitCode, 3);
    QVERIFY(run.out.isEmpty());
    QVERIFY2(run.err.contains(file) && run.err.contains(expected), qPrintable(run.err));
}

void TestThermalCommands::badOptionsAreRefused_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::newRow("unknown model") << QStringList{"train", "--history", day("H0_train"), "--model",
                                                  "deep",  "-o",        "x.json"}
                                   << 2;
    QTest::newRow("no output") << QStringList{"train", "--history", day("H0_train")} << 2;
    QTest::newRow("check rows") << QStringList{"train",   "--history", day("H0_train"), "--check-rows",
                                               "359-240", "-o",        "x.json"}
                                << 3;
    QTest::newRow("schedule") << QStringList{"simulate", "--schedule", "0:0,10"} << 3;
    QTest::newRow("schedule falls") << QStringList{"simulate", "--schedule", "0:0,10:5,5:1"} << 3;
    QTest::newRow("period") << QStringList{"compensate",   "--model",      "model.json", "--history",
                                           day("T0_same"), "--period-min", "0"}
                            << 2;
    QTest::newRow("nothing") << QStringList{} << 2;
}

void TestThermalCommands::badOptionsAreRefused() {
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    const KerfRun run = runKerf(thermal(arguments));
    QCOMPARE(run.exitCode, exitCode);
    QVERIFY(!run.err.isEmpty());
}

void TestThermalCommands::missingReadingsAndColumnsAreLostSensors() {
    const json model = json::parse(readText(m_model).toStdString());
    const auto sensor = QString::fromStdString(model["sensors"][0]["name"].get<std::string>());
    const QString gap = withCell("T1_rand", 200, sensor, "nan", "gap_predict.csv");
    const KerfRun run = runKerf(thermal({"predict", "--model", m_model, "--history", gap}));
    QCOMPARE(run.exitCode, 0);
    QVERIFY2(run.err.contains(sensor) && run.err.contains(QStringLiteral("open")), qPrintable(run.err));

    QString renamed = readText(day("T1_rand"));
    renamed.replace(renamed.indexOf("," + sensor + ","), sensor.size() + 2, QStringLiteral(",other,"));
    const KerfRun without =
        runKerf(thermal({"predict", "--model", m_model, "--history", scratchFile("renamed.csv", renamed)}));
    QCOMPARE(without.exitCode, 0);
    QVERIFY(without.err.contains(sensor));
}

namespace {
/// Only these columns of a day of the fixtures.
QString columnsOf(const char* name, const QStringList& kept, const QString& to) {
    QStringList lines = readText(day(name)).split(u'\n', Qt::SkipEmptyParts);
    const QStringList names = lines[0].split(u',');
    for (QString& line : lines) {
        const QStringList cells = line.split(u',');
        QStringList out;
        for (const QString& column : kept) {
            out << cells[names.indexOf(column)];
        }
        line = out.join(u',');
    }
    return scratchFile(to, lines.join(u'\n') + u'\n');
}
}  // namespace

void TestThermalCommands::oneDisplacementAndSixSensorsTrainAndLearn() {
    const QStringList kept{"t_min", "T00", "T05", "T12", "T20", "T33", "T50", "yy_meas"};
    QStringList train = thermal({"train"});
    for (const char* name : {"H0_train", "H1_train", "H2_train"}) {
        train << "--history" << columnsOf(name, kept, QString::fromLatin1(name) + "_one.csv");
    }
    const KerfRun trained = runKerf(train + QStringList{"-o", "one.json", "--report"});
    QVERIFY2(trained.exitCode == 0, qPrintable(trained.err));
    const json report = json::parse(trained.out.toStdString());
    QCOMPARE(QString::fromStdString(report["model"].get<std::string>()), QStringLiteral("hierarchical"));
    QVERIFY(report["rms_um"]["x"].is_null() && report["rms_um"]["y"].is_number());

    const QString unseen = columnsOf("T1_rand", kept, "T1_one.csv");
    const QStringList predict = thermal({"predict", "--model", "one.json", "--history", unseen});
    const KerfRun plainRun = runKerf(predict);
    QVERIFY2(plainRun.exitCode == 0, qPrintable(plainRun.err));
    const auto plain = csvRows(plainRun.out);
    const KerfRun learntRun = runKerf(predict + QStringList{"--measure-every-min", "60"});
    QVERIFY2(learntRun.exitCode == 0, qPrintable(learntRun.err));
    const auto learnt = csvRows(learntRun.out);
    QCOMPARE(plain.size(), 361);
    QCOMPARE(learnt.size(), 361);
    const auto truth = csvRows(readText(unseen));
    double plain_um2 = 0.0;
    double learnt_um2 = 0.0;
    for (int k = 1; k < plain.size(); ++k) {
        QVERIFY(plain[k][1].isEmpty() && plain[k][3].isEmpty() && plain[k][4].isEmpty());
        QVERIFY(plain[k][5].toDouble() > 0.0);
        if (k <= 61) {  // row k is minute k - 1; used from minute 61 on
            QCOMPARE(learnt[k], plain[k]);
        }
        const double measured_um = truth[k + 5].last().toDouble();
        plain_um2 += std::pow(plain[k][2].toDouble() - measured_um, 2);
        learnt_um2 += std::pow(learnt[k][2].toDouble() - measured_um, 2);
    }
    QVERIFY(learnt[62] != plain[62]);
    QVERIFY2(std::sqrt(plain_um2 / 360) <= 4.0, qPrintable(QString::number(std::sqrt(plain_um2 / 360))));
    QVERIFY2(learnt_um2 <= plain_um2,
             qPrintable(QStringLiteral("%1 %2").arg(std::sqrt(plain_um2 / 360)).arg(std::sqrt(learnt_um2 / 360))));
    // The regression of before learns nothing from a measurement, and says so.
    const KerfRun refused =
        runKerf(thermal({"predict", "--model", m_model, "--history", day("T1_rand"), "--measure-every-min", "60"}));
    QCOMPARE(refused.exitCode, 3);
    QVERIFY(refused.err.contains(QStringLiteral("hierarchical")));
}

QTEST_GUILESS_MAIN(TestThermalCommands)
#include "tst_thermal_commands.moc"
