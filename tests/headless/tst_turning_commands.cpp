// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "tests/support/golden.h"
#include "tests/support/kerf_document.h"

using kerf::test::csvRows;
using kerf::test::document;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using nlohmann::json;

namespace {

KerfRun turning(const QString& arguments) {
    return runKerf("turning", arguments);
}

}  // namespace

/// The contract of `kerf turning …`.
class TestTurningCommands : public QObject {
    Q_OBJECT
 private slots:
    void overlapAnswersInJson() {
        const KerfRun run = turning(QStringLiteral("overlap --tool-radius-um 800 --depth-um 6 --infeed-um 5.8"));
        QCOMPARE(run.exitCode, 0);
        KERF_CLOSE(document(run)["overlap"].get<double>(), 0.9555529619612392, 1e-12);
    }
    void identifyRepeatsTheReference() {
        const json reference = kerf::test::loadGolden("golden_diamond.json")["rls"];
        QString text = QStringLiteral("k,u_um,f_n\n");
        for (std::size_t k = 0; k < reference["u"].size(); ++k) {
            text += QStringLiteral("%1,%2,%3\n")
                        .arg(k)
                        .arg(reference["u"][k].get<double>(), 0, 'g', 17)
                        .arg(reference["F"][k].get<double>(), 0, 'g', 17);
        }
        const QString file = scratchFile(QStringLiteral("rls.csv"), text);
        const KerfRun run = turning(QStringLiteral("identify %1 --lambda 0.9 --method paper --p0 1e4").arg(file));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows[0].join(u','), QStringLiteral("k,a1,b0,b1,trace"));
        QCOMPARE(rows.size(), 61);
        for (int k = 0; k < 60; ++k) {
            const auto at = static_cast<std::size_t>(k);
            for (int i = 0; i < 3; ++i) {
                KERF_CLOSE(rows[k + 1][i + 1].toDouble(),
                           reference["modes"]["plain"]["theta"][at][static_cast<std::size_t>(i)].get<double>(), 1e-9);
            }
            KERF_CLOSE(rows[k + 1][4].toDouble(), reference["modes"]["plain"]["trace"][at].get<double>(), 1e-6);
        }
        QCOMPARE(turning(QStringLiteral("identify %1 --lambda 0.9").arg(file)).exitCode, 0);
    }
    void robustDrawsHardLathesThatCanBeHadAgain() {
        const KerfRun run = turning(QStringLiteral("robust --machines 3 --seed 5 --csv"));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows[0].join(u','),
                 QStringLiteral("machine_seed,plant,disturbance,rms_open_um,rms_paper_um,rms_pi_um,rms_default_um,"
                                "ratio,worse,unstable_default,unstable_simple"));
        QCOMPARE(rows.size(), 7);
        for (qsizetype i = 1; i < rows.size(); ++i) {
            const KerfRun same = turning(QStringLiteral("simulate --machine-seed %1 --plant %2 --controller default "
                                                        "--seconds 2 --seed 5 --summary")
                                             .arg(rows[i][0], rows[i][1]));
            KERF_CLOSE(document(same)["rms_steady_um"].get<double>(), rows[i][6].toDouble(), 1e-9);
        }
        QCOMPARE(document(turning(QStringLiteral("robust --machines 3 --seed 5")))["share_unstable"].get<double>(),
                 0.0);
        const QString plain = QStringLiteral("simulate --plant b2 --controller pi --seconds 0.2 --summary");
        QCOMPARE(turning(plain + QStringLiteral(" --machine-seed 0")).out, turning(plain).out);
    }
    void simulateReproducesTheReferenceFromAFile() {
        const json reference = kerf::test::loadGolden("golden_diamond.json");
        QString text = QStringLiteral("k,d_um\n");
        for (std::size_t k = 0; k < reference["R0"]["da"].size(); ++k) {
            text += QStringLiteral("%1,%2\n").arg(k).arg(reference["R0"]["da"][k].get<double>(), 0, 'g', 17);
        }
        const QString file = scratchFile(QStringLiteral("da.csv"), text);
        const KerfRun run = turning(
            QStringLiteral("simulate --plant r1 --controller paper --step-um 6 --disturbance %1 --csv").arg(file));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows[0].join(u','),
                 QStringLiteral("k,t_s,disturbance_um,command_um,force_n,inner_modulation_um,depth_um"));
        QCOMPARE(rows.size(), 301);
        for (int k = 0; k < 300; ++k) {
            KERF_CLOSE(rows[k + 1][5].toDouble(),
                       reference["R1"]["closed_step"][static_cast<std::size_t>(k)].get<double>(), 1e-9);
        }
    }
    void summaryHasItsKeysAndBeatsOpenLoop() {
        const QString common =
            QStringLiteral("simulate --plant b2 --seconds 2 --step-um 6 --seed 41 --summary --controller ");
        const json open = document(turning(common + QStringLiteral("open")));
        const json closed = document(turning(common + QStringLiteral("default")));
        for (const char* key : {"rms_um", "pv_um", "rms_steady_um", "pv_steady_um", "mean_force_n"}) {
            QVERIFY2(closed.contains(key), key);
        }
        QVERIFY(closed["rms_steady_um"].get<double>() < 0.15 * open["rms_steady_um"].get<double>());
        bool named = false;
        for (const auto& tone : closed["tones"]) {
            named = named || (tone["blind"].get<bool>() && std::abs(tone["frequency_hz"].get<double>() - 86.0) < 0.3);
        }
        QVERIFY(named);
    }
    void blindNamesTonesAndABetterSpeed() {
        const json report = document(turning(QStringLiteral("blind --spindle-rps 17.2 --tones 17,52,86,113,120")));
        QCOMPARE(report["tones"].size(), std::size_t{5});
        QVERIFY(report["tones"][2]["blind"].get<bool>());
        QVERIFY(report["suggested_worst_visibility"].get<double>() > 0.3);
    }
    void limitsPrintsTheFive() {
        const json limits = document(turning(QStringLiteral("limits")))["gain_limits"];
        QCOMPARE(limits.size(), std::size_t{5});
        QVERIFY(std::abs(limits["l_pc"].get<double>() - 0.0960) < 0.00096);
    }
    void wrongUsageIsTwo_data() {
        QTest::addColumn<QString>("arguments");
        QTest::newRow("nothing") << "";
        QTest::newRow("no plant") << "simulate --controller open --summary";
        QTest::newRow("unknown plant") << "simulate --plant b9 --controller open --summary";
        QTest::newRow("no output asked") << "simulate --plant b1 --controller open";
        QTest::newRow("unknown method") << "identify x.csv --lambda 0.9 --method magic";
        QTest::newRow("half an overlap") << "overlap --depth-um 6";
    }
    void wrongUsageIsTwo() {
        QFETCH(QString, arguments);
        QCOMPARE(turning(arguments).exitCode, 2);
    }
    void badInputIsThreeWithOneSentenceAndNoOutput_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("says");
        QTest::newRow("no file") << ""
                                 << "identify nowhere.csv --lambda 0.9"
                                 << "nowhere.csv";
        QTest::newRow("missing column") << "k,u_um\n0,6\n"
                                        << "identify bad.csv --lambda 0.9"
                                        << "f_n";
        QTest::newRow("no number") << "k,u_um,f_n\n0,6,abc\n"
                                   << "identify bad.csv --lambda 0.9"
                                   << "line 2, column f_n";
        QTest::newRow("not finite") << "k,u_um,f_n\n0,nan,1\n"
                                    << "identify bad.csv --lambda 0.9"
                                    << "line 2, column u_um";
        QTest::newRow("lambda") << "k,u_um,f_n\n0,6,1\n"
                                << "identify bad.csv --lambda 1.5"
                                << "1.5";
        QTest::newRow("first covariance") << "k,u_um,f_n\n0,6,1\n"
                                          << "identify bad.csv --lambda 0.9 --p0 0"
                                          << "covariance";
        QTest::newRow("huge disturbance") << "k,d_um\n0,1e9\n"
                                          << "simulate --plant b1 --controller open --disturbance bad.csv --summary"
                                          << "line 2, column d_um";
        QTest::newRow("no time") << ""
                                 << "simulate --plant b1 --controller open --seconds 0 --summary"
                                 << "--seconds";
        QTest::newRow("delay") << ""
                               << "simulate --plant b1 --controller open --extra-delay 7 --summary"
                               << "0 or 1";
        QTest::newRow("gain") << ""
                              << "simulate --plant b1 --controller open --gain-error 0 --summary"
                              << "gain";
        QTest::newRow("spindle") << ""
                                 << "blind --spindle-rps 0 --tones 17"
                                 << "spindle";
        QTest::newRow("tone") << ""
                              << "blind --spindle-rps 17.2 --tones 9000"
                              << "9000";
        QTest::newRow("depth above radius") << ""
                                            << "overlap --tool-radius-um 5 --depth-um 6 --infeed-um 1"
                                            << "depth";
    }
    void badInputIsThreeWithOneSentenceAndNoOutput() {
        QFETCH(QString, file);
        QFETCH(QString, arguments);
        QFETCH(QString, says);
        (void)scratchFile(QStringLiteral("bad.csv"), file);
        const KerfRun run = turning(arguments);
        QCOMPARE(run.exitCode, 3);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains(says), qPrintable(run.err));
        QCOMPARE(run.err.count(u'\n'), 1);
    }
    void helpStandsEverywhere() {
        for (const char* name : {"overlap", "identify", "simulate", "blind", "limits", "table"}) {
            const KerfRun run = turning(QString::fromLatin1(name) + QStringLiteral(" --help"));
            QCOMPARE(run.exitCode, 0);
            QVERIFY(!run.out.isEmpty());
        }
    }
};
QTEST_APPLESS_MAIN(TestTurningCommands)
#include "tst_turning_commands.moc"
