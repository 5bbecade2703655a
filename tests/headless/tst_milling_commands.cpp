// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/support/kerf_program.h"

using kerf::test::csvRows;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using nlohmann::json;

namespace {

KerfRun milling(const QString& arguments) {
    return runKerf("milling", arguments);
}

/// A recorded cut: 600 rpm, 1 kHz, 300 N with ripple, entered after `air_s`.
QString recording(double air_s) {
    QString text = QStringLiteral("t_s,angle_rev,force_y_n,feed_mm_s\n");
    for (int i = 0; i < 3000; ++i) {
        const double time_s = i * 0.001;
        const double force_N =
            time_s < air_s ? 0.0 : 300.0 * (1.0 + 0.3 * std::cos(8.0 * std::numbers::pi * time_s * 10.0));
        text += QStringLiteral("%1,%2,%3,1.5\n").arg(time_s).arg(time_s * 10.0).arg(force_N);
    }
    return scratchFile(QStringLiteral("force.csv"), text);
}

}  // namespace

class TestMillingCommands : public QObject {
    Q_OBJECT

 private slots:
    void summaryHasTheAgreedKeys() {
        const KerfRun run =
            milling(QStringLiteral("simulate --law pi --kp .75 --ki .15 --reference-n 392.266 --summary"));
        QCOMPARE(run.exitCode, 0);
        const json summary = json::parse(run.out.toStdString());
        for (const char* key :
             {"waviness_um", "waviness_raw_um", "mean_offset_um", "time_s", "force_max_n", "feed_unrest"}) {
            QVERIFY2(summary.contains(key) && summary[key].is_number(), key);
        }
        QVERIFY(std::abs(summary["waviness_um"].get<double>() - 51.92395314736277) < 1e-6);
    }
    void csvHasARowPerRevolution() {
        const KerfRun run = milling(QStringLiteral("simulate --law constant --feed-mm-s 1.53 --csv"));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows.first().join(u','),
                 QStringLiteral("rev,x_mm,depth_mm,feed_cmd_mm_s,feed_cut_mm_per_rev,force_y_n,force_meas_n"));
        QCOMPARE(rows.size(), 659);
        QVERIFY(std::abs(rows.last()[1].toDouble() - 100.0) < 0.3);
    }
    void plantFileIsReadBack() {
        const KerfRun plant = milling(QStringLiteral("plant"));
        QCOMPARE(plant.exitCode, 0);
        const QString file = scratchFile(QStringLiteral("plant.json"), plant.out);
        const QString arguments = QStringLiteral("simulate --law model --quantize --noise-n 4.9 --seed 7");
        QCOMPARE(milling(arguments + QStringLiteral(" --plant ") + file).out, milling(arguments).out);
        const QString soft = scratchFile(QStringLiteral("soft.json"), QStringLiteral("{\"kx_n_per_mm\": 196.133}"));
        QVERIFY(milling(arguments + QStringLiteral(" --plant ") + soft).out != milling(arguments).out);
    }
    void blankFileMeansTheSameAsTheBlankOption() {
        const QString file = scratchFile(QStringLiteral("blank.csv"),
                                         QStringLiteral("x_mm,height_mm\n0,1\n20,2\n40,3\n60,2\n80,1\n100,0\n"));
        QCOMPARE(milling(QStringLiteral("simulate --blank-file ") + file).out, milling(QStringLiteral("simulate")).out);
    }
    void sameSeedSameDigits() {
        const QString arguments = QStringLiteral("simulate --quantize --noise-n 4.9 --csv --seed ");
        QCOMPARE(milling(arguments + u'4').out, milling(arguments + u'4').out);
        QVERIFY(milling(arguments + u'4').out != milling(arguments + u'5').out);
    }
    void machineSeedZeroIsTheReferenceMachine() {
        QCOMPARE(milling(QStringLiteral("simulate --machine-seed 0")).out, milling(QStringLiteral("simulate")).out);
        QVERIFY(milling(QStringLiteral("simulate --machine-seed 5")).out != milling(QStringLiteral("simulate")).out);
    }
    void robustComparesWithThePapersLaw() {
        const KerfRun run = milling(QStringLiteral("robust --machines 3 --seed 2 --csv"));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows.size(), 4);
        QCOMPARE(rows.first().first(), QStringLiteral("machine_seed"));
        const json all = json::parse(milling(QStringLiteral("robust --machines 3 --seed 2")).out.toStdString());
        for (const char* key : {"share_worse", "worst_ratio", "share_unstable"}) {
            QVERIFY2(all.contains(key), key);
        }
    }
    void noiseTableOfDrawnBlanksComesFromItsSeed() {
        const QString arguments = QStringLiteral("noise --blanks drawn --count 1 --seeds 1 --blank-seed ");
        const KerfRun run = milling(arguments + u'3');
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows.size(), 1 + 3 * 7);
        QCOMPARE(rows.first().last(), QStringLiteral("force_late_revs"));
        QCOMPARE(rows.last().last(), QStringLiteral("1"));
        QVERIFY(milling(arguments + u'4').out != run.out);
        const json all = json::parse(milling(arguments + QStringLiteral("3 --summary")).out.toStdString());
        QCOMPARE(all["rows"].get<int>(), 21);
        int wavier = 0;
        for (int i = 1; i < rows.size(); ++i) {
            wavier += rows[i][5].toDouble() > rows[i][3].toDouble() ? 1 : 0;
        }
        QCOMPARE(all["rows_wavier"].get<int>(), wavier);
    }
    void replayAdvisesOncePerRevolution() {
        const KerfRun run = milling(QStringLiteral("replay ") + recording(0.5));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows.size(), 29);                      // header, 28 whole revolutions in 3 s from the second mark on
        QCOMPARE(rows[1].last(), QStringLiteral("1"));  // in air
        QCOMPARE(rows.last().last(), QStringLiteral("0"));
        QVERIFY(std::abs(rows.last()[3].toDouble() - 300.0) < 1.0);
        QVERIFY(rows.last()[6].toDouble() > 1.5);  // below the reference: it would have fed faster
    }
    void wrongUsageIsRefused_data() {
        QTest::addColumn<QString>("arguments");
        for (const char* arguments :
             {"", "simulate --law fuzzy", "simulate --reference-n 0", "simulate --noise-n -1", "simulate --lag-revs 2",
              "simulate --force-late-revs 3", "simulate --axis-lag-s -1", "robust --machines 0", "noise --blanks any",
              "noise --count 0", "simulate --csv --summary", "simulate --kp nan", "replay", "simulate --seed -3",
              "simulate --unknown 1"}) {
            QTest::newRow(arguments) << QString::fromLatin1(arguments);
        }
    }
    void wrongUsageIsRefused() {
        QFETCH(QString, arguments);
        const KerfRun run = milling(arguments);
        QCOMPARE(run.exitCode, 2);
        QVERIFY(run.out.isEmpty() || arguments.isEmpty());
        QVERIFY(!run.err.isEmpty());
    }
    void badInputIsRefusedInOneSentence_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const QString head = QStringLiteral("t_s,angle_rev,force_y_n,feed_mm_s\n");
        QTest::newRow("missing file") << "replay none.csv"
                                      << ""
                                      << "none.csv";
        QTest::newRow("missing column") << "replay bad.csv"
                                        << "t_s,angle_rev\n0,0\n"
                                        << "force_y_n";
        QTest::newRow("no number") << "replay bad.csv" << head + QStringLiteral("0,0,x,1\n")
                                   << "line 2, column force_y_n";
        QTest::newRow("not finite") << "replay bad.csv" << head + QStringLiteral("0,0,nan,1\n") << "line 2";
        QTest::newRow("time runs back") << "replay bad.csv" << head + QStringLiteral("0.2,0,1,1\n0.1,0,1,1\n")
                                        << "line 3, column t_s";
        QTest::newRow("feed negative") << "replay bad.csv" << head + QStringLiteral("0,0,1,-1\n") << "feed_mm_s";
        QTest::newRow("short row") << "replay bad.csv" << head + QStringLiteral("0,0,1\n") << "3 fields";
        QTest::newRow("plant no json") << "simulate --plant bad.csv"
                                       << "{"
                                       << "JSON";
        QTest::newRow("plant key") << "simulate --plant bad.csv"
                                   << "{\"kx\": 3}"
                                   << "kx";
        QTest::newRow("plant range") << "simulate --plant bad.csv"
                                     << "{\"kx_n_per_mm\": -3}"
                                     << "kx_n_per_mm";
        QTest::newRow("plant type") << "simulate --plant bad.csv"
                                    << "{\"m\": \"a\"}"
                                    << "m";
        QTest::newRow("blank order") << "simulate --blank-file bad.csv"
                                     << "x_mm,height_mm\n0,1\n0,2\n9,1\n"
                                     << "bad.csv";
        QTest::newRow("blank height") << "simulate --blank 1,-2"
                                      << ""
                                      << "Height of blank step 2";
        QTest::newRow("floor over ceiling") << "simulate --feed-floor-mm-s 4.5"
                                            << ""
                                            << "4.5";
    }
    void badInputIsRefusedInOneSentence() {
        QFETCH(QString, arguments);
        QFETCH(QString, text);
        QFETCH(QString, says);
        scratchFile(QStringLiteral("bad.csv"), text);
        const KerfRun run = milling(arguments);
        QCOMPARE(run.exitCode, 3);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains(says), qPrintable(run.err));
        QCOMPARE(run.err.count(u'\n'), 1);
    }
};

QTEST_APPLESS_MAIN(TestMillingCommands)
#include "tst_milling_commands.moc"
