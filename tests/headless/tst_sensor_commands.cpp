// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"
#include "tests/support/modbus_modules.h"

using kerf::test::csvRows;
using kerf::test::KerfRun;
using kerf::test::ModbusModules;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using Json = nlohmann::json;

namespace {

Json fileFor(int port, int channels = 4) {
    Json file;
    file["modules"] = {{{"name", "A"},
                        {"transport", "tcp"},
                        {"host", "127.0.0.1"},
                        {"port", port},
                        {"period_ms", 200},
                        {"timeout_ms", 150}}};
    file["channels"] = Json::array();
    for (int i = 0; i < channels; ++i) {
        file["channels"].push_back({{"name", QString::asprintf("T%02d", i).toStdString()},
                                    {"module", "A"},
                                    {"address", i},
                                    {"scale", 0.1},
                                    {"invalid", {9999}}});
    }
    return file;
}

QString written(const Json& file, const char* name = "sensors.json") {
    return scratchFile(QString::fromLatin1(name), QString::fromStdString(file.dump(2)));
}

std::vector<Json> linesOf(const QString& out) {
    std::vector<Json> lines;
    for (const QString& line : out.split(u'\n', Qt::SkipEmptyParts)) {
        lines.push_back(Json::parse(line.toStdString()));
    }
    return lines;
}

}  // namespace

class TestSensorCommands : public QObject {
    Q_OBJECT
 private slots:
    void checkTakesAFileAndRefusesWithKeyAndSentence() {
        Json file = fileFor(502);
        KerfRun run = runKerf({"sensors", "check", written(file)});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(Json::parse(run.out.toStdString())["temperatures"].get<int>(), 4);
        file["channels"][2]["colour"] = "red";
        run = runKerf({"sensors", "check", written(file)});
        QCOMPARE(run.exitCode, 3);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains(QStringLiteral("sensors.json: channels[2].colour: unknown key")),
                 qPrintable(run.err));
        QCOMPARE(runKerf({"sensors", "check", QStringLiteral("nothing.json")}).exitCode, 3);
        QCOMPARE(runKerf({"sensors", "check"}).exitCode, 2);
        QCOMPARE(runKerf({"sensors", "watch", written(fileFor(502)), "--seconds", "-1"}).exitCode, 2);
        for (const char* option : {"--seconds", "--period"}) {  // "nan" lies outside no range
            run = runKerf({"sensors", "watch", written(fileFor(502)), option, "nan"});
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.err.contains(QStringLiteral("nan is no number")), qPrintable(run.err));
        }
        QCOMPARE(runKerf({"sensors", "scan", "--modbus", "127.0.0.1:0"}).exitCode, 3);
    }
    void watchPrintsEveryChannelAndNoNumberThatIsNone() {
        if (const QString why = ModbusModules::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        ModbusModules modules;
        QVERIFY(modules.start());
        int id = 0;
        const int port = modules.addTcp(id);
        QVERIFY(modules.set(id, "input", 0, {215, 9999, 217, 32767}));
        const KerfRun run = runKerf({"sensors", "watch", written(fileFor(port)), "--seconds", "3"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const std::vector<Json> lines = linesOf(run.out);
        QCOMPARE(lines.size(), 12U);
        for (const Json& line : lines) {
            QCOMPARE(line.size(), 5U);
            QVERIFY(line["t_s"].is_number());
        }
        QCOMPARE(lines[8]["name"].get<std::string>(), std::string("T00"));
        QVERIFY(std::abs(lines[8]["value"].get<double>() - 21.5) < 1e-9);
        QCOMPARE(lines[8]["quality"].get<std::string>(), std::string("good"));
        QVERIFY(lines[8]["age_s"].get<double>() < 2.0);
        QVERIFY(lines[9]["value"].is_null() && lines[9]["quality"] == "bad");
        QVERIFY(lines[11]["value"].is_null() && lines[11]["quality"] == "bad");
        QVERIFY2(run.err.contains(QStringLiteral("T01: ")), qPrintable(run.err));
    }
    void watchOfNobodySaysMissing() {
        const KerfRun run = runKerf({"sensors", "watch", written(fileFor(1, 1)), "--seconds", "2"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const Json last = linesOf(run.out).back();
        QVERIFY(last["value"].is_null() && last["age_s"].is_null());
        QCOMPARE(last["quality"].get<std::string>(), std::string("missing"));
    }
    void scanFindsWhatAnswers() {
        if (const QString why = ModbusModules::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        ModbusModules modules;
        QVERIFY(modules.start());
        int id = 0;
        const int port = modules.addTcp(id, 10, 3);
        QVERIFY(modules.set(id, "input", 8, {77}, 3));
        const KerfRun run = runKerf({"sensors", "scan", "--modbus", QStringLiteral("127.0.0.1:%1").arg(port), "--units",
                                     "2-4", "--timeout-ms", "200"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const Json units = Json::parse(run.out.toStdString())["units"];
        QCOMPARE(units.size(), 1U);
        QCOMPARE(units[0]["unit"].get<int>(), 3);
        const Json& second = units[0]["answers"][1];  // the tenth register is found though a block of 8 is refused
        QCOMPARE(second["address"].get<int>(), 8);
        QCOMPARE(second["registers"][0].get<int>(), 77);
        QCOMPARE(units[0]["identity"].get<std::string>(), std::string("Kerf TH8? 2.1"));  // a letter that is no ASCII
    }
    void scanOfNobodyIsRefused() {
        const KerfRun run = runKerf({"sensors", "scan", "--modbus", "127.0.0.1:1"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains(QStringLiteral("127.0.0.1:1")), qPrintable(run.err));
    }
    void predictionsComeFromTheMachine() {
        if (const QString why = ModbusModules::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        const auto day = [](const char* name) {
            return QString::fromStdString(kerf::test::fixture(std::string("thermal/") + name + ".csv"));
        };
        const QString model = QStringLiteral("model.json");
        KerfRun run = runKerf({"thermal", "train", "--history", day("H0_train"), "--history", day("H1_train"),
                               "--model", "regression", "-o", model});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QFile history(day("T0_same"));
        QVERIFY(history.open(QIODevice::ReadOnly));
        const QList<QStringList> rows = csvRows(QString::fromUtf8(history.readAll()));
        ModbusModules modules;
        QVERIFY(modules.start());
        int id = 0;
        const int port = modules.addTcp(id);
        Json file = fileFor(port, 0);
        std::vector<int> registers;
        for (int column = 0; column < rows[0].size(); ++column) {
            if (rows[0][column].startsWith(u'T') && !rows[0][column].contains(u'_')) {
                file["channels"].push_back({{"name", rows[0][column].toStdString()},
                                            {"module", "A"},
                                            {"address", static_cast<int>(registers.size())},
                                            {"scale", 0.01}});
                registers.push_back(static_cast<int>(std::lround(100.0 * rows[1][column].toDouble())));
            }
        }
        QVERIFY(registers.size() == 64);
        QVERIFY(modules.set(id, "input", 0, registers));
        run = runKerf({"thermal", "predict", "--model", model, "--sensors", written(file), "--seconds", "6"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const QList<QStringList> out = csvRows(run.out);
        QCOMPARE(out[0].join(u','), QStringLiteral("t_min,x_um,y_um,z_um,x_half_um,y_half_um,z_half_um"));
        QVERIFY2(out.size() >= 4, qPrintable(run.out));
        for (qsizetype row = 1; row < out.size(); ++row) {
            QCOMPARE(out[row].size(), 7);
            for (int axis = 1; axis <= 3; ++axis) {  // nothing has warmed since the baseline
                QVERIFY2(std::abs(out[row][axis].toDouble()) < 2.0, qPrintable(run.out));
            }
        }
        QCOMPARE(runKerf({"thermal", "predict", "--model", model}).exitCode, 2);
        QCOMPARE(
            runKerf({"thermal", "predict", "--model", model, "--history", day("T0_same"), "--seconds", "5"}).exitCode,
            2);
        run =
            runKerf({"thermal", "predict", "--model", model, "--sensors", written(fileFor(port, 4)), "--seconds", "2"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains(QStringLiteral("of the model are missing")), qPrintable(run.err));
    }
};

QTEST_GUILESS_MAIN(TestSensorCommands)
#include "tst_sensor_commands.moc"
