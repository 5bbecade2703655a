// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/support/golden.h"
#include "tests/support/kerf_program.h"

using kerf::test::csvRows;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using nlohmann::json;

namespace {

const QString kHeader = QStringLiteral("part,overhang_mm,feed_mm_per_rev,deflection_mm\n");
const QString kPartOne = QStringLiteral("1,40,0.5,0.165\n1,310,0.5,0.2854\n");

/// The scenario as an input file of `replay`, from what the reference says was cut and measured.
QString replayFile(const json& scenario) {
    QString text = kHeader;
    for (const auto& part : scenario["parts"]) {
        for (std::size_t i = 0; i < 2; ++i) {
            text += QStringLiteral("%1,%2,%3,%4\n")
                        .arg(part["part"].get<int>())
                        .arg(i == 0 ? 40 : 310)
                        .arg(part["S"][i].get<double>(), 0, 'g', 17)
                        .arg(part["d_meas"][i].get<double>(), 0, 'g', 17);
        }
    }
    return text;
}

QString noiseFile(const json& scenario) {
    QString text = QStringLiteral("run,part,overhang_mm,z\n");
    for (std::size_t part = 0; part < scenario["z"].size(); ++part) {
        for (std::size_t i = 0; i < 2; ++i) {
            text += QStringLiteral("1,%1,%2,%3\n")
                        .arg(part + 1)
                        .arg(i == 0 ? 40 : 310)
                        .arg(scenario["z"][part][i].get<double>(), 0, 'g', 17);
        }
    }
    return text;
}

QStringList lawOptions(const json& scenario) {
    return {QStringLiteral("--estimator"), QStringLiteral("perturbation"),
            QStringLiteral("--sigma-mm"),  QString::number(scenario["sigma"].get<double>(), 'g', 17),
            QStringLiteral("--alpha0"),    QString::number(scenario["alpha0"].get<double>(), 'g', 17)};
}

/// The default reading of the paper is what the program runs.
bool runnable(const json& scenario) {
    return scenario["form"] == "K" && scenario["trigger"] == "either" && scenario["timing"] == "before" &&
           scenario["part1_update"] == true;
}

}  // namespace

class TestBoringCommands : public QObject {
    Q_OBJECT
    const json m_golden = kerf::test::loadGolden("golden_boring.json");

    static void expectRefused(const KerfRun& run, int exitCode, const QStringList& pieces) {
        QCOMPARE(run.exitCode, exitCode);
        QCOMPARE(run.out, QString());
        for (const QString& piece : pieces) {
            QVERIFY2(run.err.contains(piece), qPrintable(run.err));
        }
        if (exitCode == 3) {
            QCOMPARE(run.err.trimmed().count(u'\n'), 0);  // one sentence
        }
    }

 private slots:
    void robustDefaultIsNoWorseOnHardMachines() {
        const auto run = runKerf({"boring", "robust", "--machines", "200", "--seed", "11"});
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        const auto all = nlohmann::json::parse(run.out.toStdString());
        QCOMPARE(all["share_unstable"].get<double>(), 0.0);
        QVERIFY(all["share_worse"].get<double>() <= 0.05);
        QVERIFY(all["worst_ratio"].get<double>() < 1.3);
        QVERIFY(all["ratio_median"].get<double>() < 0.8);
        QVERIFY(all["share_wrong_sigma_noticed"].get<double>() >= 0.9);
    }
    void replayGivesTheReferencesStates() {
        int replayed = 0;
        for (const auto& scenario : m_golden["scenarios"]) {
            if (!runnable(scenario)) {
                continue;
            }
            const auto run = runKerf(QStringList{"boring", "replay", scratchFile("replay.csv", replayFile(scenario))} +
                                     lawOptions(scenario));
            QVERIFY2(run.exitCode == 0, qPrintable(run.err));
            const auto rows = csvRows(run.out);
            QCOMPARE(rows[0].join(u','),
                     QStringLiteral("part,overhang_mm,ln_c,alpha,beta,p00,p01,p02,p11,p12,p22,perturbed,"
                                    "next_feed_mm_per_rev"));
            const auto& parts = scenario["parts"];
            QCOMPARE(static_cast<std::size_t>(rows.size()), 1 + 2 * parts.size());
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const auto& row = rows[static_cast<qsizetype>(2 * i + 2)];
                KERF_CLOSE(row[2].toDouble(), parts[i]["lnC"].get<double>(), 1e-9);
                KERF_CLOSE(row[3].toDouble(), parts[i]["alpha"].get<double>(), 1e-9);
                KERF_CLOSE(row[4].toDouble(), parts[i]["beta"].get<double>(), 1e-9);
                for (int k = 0; k < 6; ++k) {
                    KERF_CLOSE(row[5 + k].toDouble(), parts[i]["P"][static_cast<std::size_t>(k)].get<double>(), 1e-9);
                }
                if (i + 1 < parts.size()) {
                    KERF_CLOSE(row[12].toDouble(), parts[i + 1]["S"][1].get<double>(), 1e-9);
                }
            }
            ++replayed;
        }
        QVERIFY(replayed >= 3);
    }
    void simulateWithGivenNoiseFollowsTheReference() {
        int simulated = 0;
        for (const auto& scenario : m_golden["scenarios"]) {
            if (!runnable(scenario)) {
                continue;
            }
            const auto run = runKerf(QStringList{"boring", "simulate", "--csv", "--noise",
                                                 scratchFile("noise.csv", noiseFile(scenario)), "--change",
                                                 "11:.7,.4,.15", "--change", "21:.6,.5,.075", "--feed0",
                                                 QString::number(scenario["S0"].get<double>())} +
                                     lawOptions(scenario));
            QVERIFY2(run.exitCode == 0, qPrintable(run.err));
            ++simulated;
            int measured = 0;
            for (const auto& row : csvRows(run.out).mid(1)) {
                const auto& part = scenario["parts"][row[1].toUInt() - 1];
                if (row[3] == QStringLiteral("1")) {
                    const std::size_t depth = row[2].toDouble() == 40.0 ? 0 : 1;
                    KERF_CLOSE(row[4].toDouble(), part["S"][depth].get<double>(), 1e-9);
                    KERF_CLOSE(row[6].toDouble(), part["d_meas"][depth].get<double>(), 1e-9);
                    ++measured;
                }
            }
            QCOMPARE(measured, 60);
        }
        QVERIFY(simulated >= 3);
    }
    void diametersReplayLikeTheirDeflections() {
        const auto deflections = runKerf({"boring", "replay", scratchFile("d.csv", kHeader + kPartOne)});
        const auto diameters = runKerf({"boring", "replay", "--target-diameter-mm", "50",
                                        scratchFile("dia.csv",
                                                    "part,overhang_mm,feed_mm_per_rev,diameter_mm\n"
                                                    "1,40,0.5,49.9515\n1,310,0.5,49.8311\n")});
        QCOMPARE(diameters.exitCode, 0);
        const auto a = csvRows(deflections.out);
        const auto b = csvRows(diameters.out);
        QCOMPARE(a.size(), b.size());
        KERF_CLOSE(a[2][2].toDouble(), b[2][2].toDouble(), 1e-9);
        KERF_CLOSE(a[2][12].toDouble(), b[2][12].toDouble(), 1e-9);
    }
    void lateRowsCountWhereTheirPartBelongs() {
        const QString two = QStringLiteral("2,40,0.25,0.12\n2,310,0.09,0.12\n");
        const QString three = QStringLiteral("3,40,0.25,0.11\n3,310,0.09,0.11\n");
        const auto inOrder = runKerf({"boring", "replay", scratchFile("a.csv", kHeader + kPartOne + two + three)});
        const auto late = runKerf({"boring", "replay", scratchFile("b.csv", kHeader + kPartOne + three + two)});
        QCOMPARE(csvRows(inOrder.out)[6], csvRows(late.out)[4]);  // part 3, 310 mm
    }
    void truthFileAndChangesSayTheSame() {
        QString truth = QStringLiteral("run,part,alpha,beta,c_mm\n");
        for (int run = 1; run <= 3; ++run) {
            for (int part = 1; part <= 20; ++part) {
                truth +=
                    QStringLiteral("%1,%2,%3\n").arg(run).arg(part).arg(part < 11 ? ".5025,.2676,.0871" : ".7,.4,.15");
            }
        }
        const QStringList common{"boring", "simulate", "--parts", "20", "--seed", "4", "--summary"};
        const auto fromFile = runKerf(common + QStringList{"--truth", scratchFile("truth.csv", truth)});
        const auto fromOption = runKerf(common + QStringList{"--runs", "3", "--change", "11:.7,.4,.15"});
        QCOMPARE(fromFile.exitCode, 0);
        QCOMPARE(fromFile.out, fromOption.out);
    }
    void summaryHasTheFiguresOfTheContract() {
        const auto run = runKerf({"boring", "simulate", "--parts", "12", "--runs", "5", "--change", "7:.7,.4,.15"});
        QCOMPARE(run.exitCode, 0);
        const json summary = json::parse(run.out.toStdString());
        for (const char* key : {"scrap_mean", "scrap_ci95", "false_alarm"}) {
            QVERIFY2(summary[key].is_number(), key);
        }
        QCOMPARE(summary["perturbed_after_change"].size(), std::size_t{1});
        QCOMPARE(summary["bad_parts_after_change"].size(), std::size_t{1});
        QCOMPARE(summary["feed_error_percent_mean"].size(), std::size_t{12});
    }
    void lotsFollowEachOtherAndRemember() {
        QString truth = QStringLiteral("run,lot,part,alpha,beta,c_mm\n");
        QString announced = QStringLiteral("run,lot,part\n");
        for (int lot = 1; lot <= 3; ++lot) {
            for (int part = 1; part <= 8; ++part) {
                truth += QStringLiteral("1,%1,%2,.5025,.2676,%3\n").arg(lot).arg(part).arg(part < 5 ? ".0871" : ".09");
            }
            announced += QStringLiteral("1,%1,5\n").arg(lot);
        }
        const QStringList common{"boring",      "simulate",
                                 "--parts",     "8",
                                 "--lots",      "3",
                                 "--truth",     scratchFile("truth.csv", truth),
                                 "--announced", scratchFile("announced.csv", announced)};
        const auto on = runKerf(common + QStringList{"--memory", "on"});
        const auto off = runKerf(common + QStringList{"--memory", "off"});
        QCOMPARE(on.exitCode, 0);
        const json with = json::parse(on.out.toStdString());
        const json without = json::parse(off.out.toStdString());
        QCOMPARE(with["scrap_per_lot"], json({1.0, 0.0, 0.0}));
        QCOMPARE(without["scrap_per_lot"], json({1.0, 1.0, 1.0}));
        const auto rows = csvRows(runKerf(common + QStringList{"--memory", "on", "--csv"}).out);
        const auto lotColumn = rows[0].indexOf("lot");
        QVERIFY(lotColumn > 0);
        QCOMPARE(rows.last()[lotColumn], QStringLiteral("3"));
        // Without memory, a lot of its own is what a run of one lot is.
        const auto one = csvRows(runKerf({"boring", "simulate", "--parts", "8", "--seed", "4", "--csv"}).out);
        const auto two = csvRows(
            runKerf({"boring", "simulate", "--parts", "8", "--seed", "4", "--csv", "--lots", "2", "--memory", "off"})
                .out);
        QCOMPARE(two.first(one.size()), one);
    }
    void firstPartThatTeachesIsMeasuredInTheMiddleToo() {
        const auto rows = csvRows(
            runKerf({"boring", "simulate", "--parts", "2", "--first-part", "teach", "--csv", "--sigma-mm", ".005"})
                .out);
        int measured = 0;
        for (const auto& row : rows) {
            measured += row[1] == u"1" && row[3] == u"1" ? 1 : 0;
        }
        QCOMPARE(measured, 3);
    }
    void sameSeedPrintsTheSame() {
        const QStringList arguments{"boring", "simulate", "--parts", "8", "--runs", "3", "--seed", "9", "--csv"};
        QCOMPARE(runKerf(arguments).out, runKerf(arguments).out);
        QVERIFY(runKerf(arguments).out != runKerf(QStringList(arguments).replaceInStrings("9", "10")).out);
    }
    void tableListsEveryWayToChooseTheFeed() {
        const auto run = runKerf({"boring", "table", "--runs", "3"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(csvRows(run.out).size(), 13);
    }

    void badFilesAreRefusedInOneSentence_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("says");
        const auto row = [](const char* name, const QString& text, const QStringList& says) {
            QTest::newRow(name) << text << says;
        };
        row("empty", "", {"bad.csv", "header"});
        row("no rows", kHeader, {"bad.csv", "at least one row"});
        row("column missing", "part,overhang_mm,deflection_mm\n1,40,0.1\n", {"line 1", "feed_mm_per_rev"});
        row("field missing", kHeader + kPartOne + "2,40,0.1\n", {"line 4", "expected 4"});
        row("text", kHeader + kPartOne + "2,40,0.1,x\n", {"line 4", "deflection_mm", "number"});
        row("empty field", kHeader + kPartOne + "2,40,,0.1\n", {"line 4", "feed_mm_per_rev", "number"});
        row("nan", kHeader + kPartOne + "2,40,0.1,nan\n", {"line 4", "deflection_mm", "number"});
        row("deflection zero", kHeader + kPartOne + "2,40,0.1,0\n", {"line 4", "deflection_mm", "above 0"});
        row("deflection negative", kHeader + kPartOne + "2,40,0.1,-0.1\n", {"line 4", "deflection_mm", "above 0"});
        row("feed zero", kHeader + kPartOne + "2,40,0,0.1\n", {"line 4", "feed_mm_per_rev", "range"});
        row("overhang negative", kHeader + "1,-40,0.5,0.1\n", {"line 2", "overhang_mm", "range"});
        row("part zero", kHeader + "0,40,0.5,0.1\n", {"line 2", "part", "range"});
        row("part broken", kHeader + "1.5,40,0.5,0.1\n", {"line 2", "part", "whole number"});
        QString many = kHeader;
        for (int i = 0; i < 9; ++i) {
            many += QStringLiteral("1,%1,0.5,0.1\n").arg(40 + i);
        }
        row("too many bores", many, {"line 10", "part", "at most 8"});
    }
    void badFilesAreRefusedInOneSentence() {
        QFETCH(QString, text);
        QFETCH(QStringList, says);
        expectRefused(runKerf({"boring", "replay", scratchFile("bad.csv", text)}), 3, says);
    }
    void paperWithoutASecondOverhangIsRefused() {
        expectRefused(runKerf({"boring", "replay", "--estimator", "perturbation",
                               scratchFile("bad.csv", kHeader + "1,40,0.5,0.1\n2,40,0.5,0.1\n")}),
                      3, {"bad.csv", "overhang_mm", "two different"});
    }
    void impossibleDiameterIsRefused() {
        expectRefused(runKerf({"boring", "replay", "--target-diameter-mm", "50",
                               scratchFile("bad.csv", "part,overhang_mm,feed_mm_per_rev,diameter_mm\n1,40,0.5,51\n")}),
                      3, {"line 2", "diameter_mm", "above 0"});
    }
    void missingFilesAreRefused() {
        expectRefused(runKerf({"boring", "replay", "no-such.csv"}), 3, {"no-such.csv"});
        expectRefused(runKerf({"boring", "simulate", "--noise", "no-such.csv"}), 3, {"no-such.csv"});
        expectRefused(runKerf({"boring", "simulate", "--truth", "no-such.csv"}), 3, {"no-such.csv"});
    }
    void noiseAndTruthFilesMustBeWhole() {
        const QString noise = QStringLiteral("run,part,overhang_mm,z\n1,1,40,0.1\n1,1,310,0.2\n1,2,40,0.3\n");
        const QStringList two{"boring", "simulate", "--parts", "2", "--csv"};
        expectRefused(runKerf(two + QStringList{"--noise", scratchFile("bad.csv", noise)}), 3,
                      {"run 1", "part 2", "310"});
        expectRefused(runKerf(two + QStringList{"--runs", "2", "--noise", scratchFile("bad.csv", noise)}), 3,
                      {"expected 2"});
        const QString truth = QStringLiteral("run,part,alpha,beta,c_mm\n1,1,.5,.3,.1\n");
        expectRefused(runKerf(two + QStringList{"--truth", scratchFile("bad.csv", truth)}), 3, {"run 1", "part 2"});
        expectRefused(runKerf(two + QStringList{"--truth", scratchFile("bad.csv", truth + "1,2,0,.3,.1\n")}), 3,
                      {"line 3", "alpha", "range"});
        expectRefused(runKerf(two + QStringList{"--truth", scratchFile("bad.csv", truth + "1,2,.5,.3,-1\n")}), 3,
                      {"line 3", "c_mm", "range"});
        const QString lots = QStringLiteral("run,lot,part,alpha,beta,c_mm\n1,1,1,.5,.3,.1\n1,2,1,.5,.3,.1\n");
        const QStringList one{"boring", "simulate", "--parts", "1", "--truth", scratchFile("lots.csv", lots)};
        expectRefused(runKerf(one + QStringList{"--lots", "3"}), 3, {"column lot", "2 lots", "expected 3"});
        expectRefused(runKerf(one + QStringList{"--announced", scratchFile("bad.csv", "run,part\n1,1\n")}), 3, {"lot"});
        expectRefused(runKerf(one + QStringList{"--announced", scratchFile("bad.csv", "run,lot,part\n1,1,0\n")}), 3,
                      {"line 2", "part", "range"});
    }
    void wrongUsageExitsWithTwo_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no command") << QStringList{"boring"};
        QTest::newRow("no file") << QStringList{"boring", "replay"};
        QTest::newRow("estimator") << QStringList{"boring", "simulate", "--estimator", "magic"};
        QTest::newRow("sigma") << QStringList{"boring", "simulate", "--sigma-mm", "-1"};
        QTest::newRow("alpha0") << QStringList{"boring", "simulate", "--alpha0", "1.5"};
        QTest::newRow("change") << QStringList{"boring", "simulate", "--change", "11:.7,.4"};
        QTest::newRow("change with rest") << QStringList{"boring", "simulate", "--change", "11:.7,.4,.15x"};
        QTest::newRow("change backwards")
            << QStringList{"boring", "simulate", "--change", "11:.7,.4,.15", "--change", "5:.7,.4,.15"};
        QTest::newRow("same depth twice") << QStringList{"boring", "simulate", "--measure-at", "40,40"};
        QTest::newRow("csv and summary") << QStringList{"boring", "simulate", "--csv", "--summary"};
        QTest::newRow("random and given")
            << QStringList{"boring", "simulate", "--random-changes", "--change", "2:.7,.4,.1"};
        QTest::newRow("memory") << QStringList{"boring", "simulate", "--memory", "perhaps"};
        QTest::newRow("paper has none") << QStringList{"boring", "simulate",    "--memory",
                                                       "on",     "--estimator", "perturbation"};
        QTest::newRow("first part") << QStringList{"boring", "simulate", "--first-part", "preach"};
        QTest::newRow("no lots") << QStringList{"boring", "simulate", "--lots", "0"};
        QTest::newRow("unknown option") << QStringList{"boring", "simulate", "--fast"};
    }
    void wrongUsageExitsWithTwo() {
        QFETCH(QStringList, arguments);
        const KerfRun run = runKerf(arguments);
        expectRefused(run, 2, {});
        QVERIFY(!run.err.isEmpty());
    }
    void everyCommandExplainsItself() {
        for (const char* command : {"replay", "simulate", "table"}) {
            const auto run = runKerf({"boring", command, "--help"});
            QCOMPARE(run.exitCode, 0);
            QVERIFY(run.out.contains(QStringLiteral("--")));
        }
    }
};
QTEST_GUILESS_MAIN(TestBoringCommands)
#include "tst_boring_commands.moc"
