// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/golden.h"
#include "tests/support/kerf_document.h"

using kerf::test::csvRows;
using kerf::test::document;
using kerf::test::KerfRun;
using kerf::test::runKerf;
using kerf::test::scratchFile;
using nlohmann::json;

namespace {

KerfRun tapping(const QString& arguments) {
    return runKerf("tapping", arguments);
}

}  // namespace

/// The contract of `kerf tapping …`.
class TestTappingCommands : public QObject {
    Q_OBJECT
 private slots:
    void simulateGivesTheReferenceFromAFileAndFromSettings() {
        const json golden = kerf::test::loadGolden("golden_tapping.json");
        const QString file = scratchFile(QStringLiteral("base.json"), QString::fromStdString(golden["BASE"].dump()));
        const KerfRun b =
            tapping(QStringLiteral("simulate --drive %1 --set Kpz=44 --set amax_s=520 --summary").arg(file));
        QCOMPARE(b.exitCode, 0);
        KERF_CLOSE(document(b)["saec_mm"].get<double>(), golden["B"]["SAEC"].get<double>(), 1e-9);
        KERF_CLOSE(document(b)["engaged_pp_um"].get<double>(), golden["B"]["stats"]["eng_pp_um"].get<double>(), 1e-9);
        const auto rows = csvRows(tapping(QStringLiteral("simulate --csv")).out);
        QCOMPARE(rows[0].join(u','), QStringLiteral("t_s,spindle_rev,z_mm,error_um"));
        QCOMPARE(rows.size(), 1181);
        KERF_CLOSE(rows[101][2].toDouble(), golden["A"]["z_every10"][10].get<double>(), 1e-9);
    }

    void tuneTellsTrialsAndSummary() {
        const KerfRun paper = tapping(QStringLiteral("tune --tuner paper --max-taps 4 --seed 1 --csv"));
        const auto rows = csvRows(paper.out);
        QVERIFY(rows[0].join(u',').startsWith(QStringLiteral("trial,kps,kpz,ffz")));
        QVERIFY(rows[0].join(u',').endsWith(QStringLiteral("saec_mm,peak_um,rms_um,engaged_pp_um,accepted")));
        QCOMPARE(rows.size(), 5);
        KERF_CLOSE(rows[2][2].toDouble(), 41.40245981842313, 1e-9);
        const QString noisy = QStringLiteral(
            "tune --tuner default --max-taps 4 --noise-um 2 --encoder-spindle-counts 4096 --encoder-z-um 1 "
            "--load-spread .2 --friction-spread .1 --assume wz=280 --seed 7 --summary");
        const KerfRun run = tapping(noisy);
        QCOMPARE(run.exitCode, 0);
        const json out = document(run);
        QVERIFY(out["reduction_percent"].get<double>() > 98.0);
        QVERIFY(out["taps_used"].get<int>() <= 4);
        KERF_CLOSE(out["saec_initial_mm"].get<double>(), 219.91800605256228, 1e-9);
        QVERIFY(out["parameters"]["kpz"].is_number());
        QCOMPARE(tapping(noisy).out, run.out);  // same seed, same digits
    }

    void tuneSaysWhatLimitsItAndWhatARampCosts() {
        const json held = document(tapping(QStringLiteral("tune --summary")));
        QCOMPARE(held["within_tolerance"].get<bool>(), true);
        QCOMPARE(held["limited_by"].get<std::string>(), "none");
        QVERIFY(held["proposed_acc_rev_s2"].is_null());
        KERF_CLOSE(held["hole_time_s"]["programmed"].get<double>(), 1.08, 1e-9);
        QVERIFY(held["hole_time_s"]["proposed"].is_null());
        const json weak = document(tapping(QStringLiteral("tune --summary --set amax_s=300")));
        QCOMPARE(weak["within_tolerance"].get<bool>(), false);
        QCOMPARE(weak["limited_by"].get<std::string>(), "torque");
        const double ramp_revPerS2 = weak["proposed_acc_rev_s2"].get<double>();
        QVERIFY(ramp_revPerS2 > 200.0 && ramp_revPerS2 < 300.0);
        KERF_CLOSE(weak["hole_time_s"]["programmed"].get<double>(), 1.08, 1e-9);
        QVERIFY(weak["hole_time_s"]["proposed"].get<double>() > 1.2);
        QVERIFY(!weak["would_help"].get<std::string>().empty());
        const json eased =
            document(tapping(QStringLiteral("tune --summary --set amax_s=300 --set acc=%1").arg(ramp_revPerS2)));
        QVERIFY(eased["engaged_pp_um"].get<double>() < 5.0);
        QVERIFY(eased["proposed_acc_rev_s2"].is_null());
        const json unknown = document(tapping(QStringLiteral("tune --summary --set pitch=1.33")));
        QVERIFY(unknown["within_tolerance"].is_null());  // no tolerance is known for this pitch
        QCOMPARE(tapping(QStringLiteral("tune --summary --thread M6")).exitCode, 2);
    }

    void robustDrawsHardMachinesThatCanBeHadAgain() {
        const KerfRun run = tapping(QStringLiteral("robust --machines 4 --seed 3 --csv"));
        QCOMPARE(run.exitCode, 0);
        const auto rows = csvRows(run.out);
        QCOMPARE(rows[0].join(u','),
                 QStringLiteral("machine_seed,pp_default_um,pp_simple_um,saec_default_mm,saec_simple_mm,ratio,worse,"
                                "unstable_default,unstable_simple,within_default,within_simple,limited_by,"
                                "proposed_acc_rev_s2,pp_proposed_um,within_proposed,taps"));
        QCOMPARE(rows.size(), 5);
        for (qsizetype i = 1; i < rows.size(); ++i) {
            QCOMPARE(rows[i][6], QStringLiteral("0"));  // worse
            QCOMPARE(rows[i][7], QStringLiteral("0"));  // unstable
            const json same = document(tapping(QStringLiteral("simulate --machine-seed %1 --summary").arg(rows[i][0])));
            KERF_CLOSE(same["engaged_pp_um"].get<double>(), rows[i][2].toDouble(), 1e-9);
        }
        QCOMPARE(tapping(QStringLiteral("robust --machines 4 --seed 3 --csv")).out, run.out);
        const json all = document(tapping(QStringLiteral("robust --machines 4 --seed 3")));
        QCOMPARE(all["share_worse"].get<double>(), 0.0);
        QCOMPARE(all["share_unstable"].get<double>(), 0.0);
        QCOMPARE(tapping(QStringLiteral("simulate --machine-seed 0 --summary")).out,
                 tapping(QStringLiteral("simulate --summary")).out);
    }

    void evaluateJudgesARecordAndRefusesAWrongPitch() {
        const QString file = scratchFile(QStringLiteral("record.csv"), tapping(QStringLiteral("simulate --csv")).out);
        const KerfRun run = tapping(QStringLiteral("evaluate %1 --pitch-mm 1.25").arg(file));
        QCOMPARE(run.exitCode, 0);
        KERF_CLOSE(document(run)["saec_mm"].get<double>(), 219.91800605256228, 1e-9);
        QCOMPARE(document(run)["within_tolerance"].get<bool>(), false);
        const KerfRun wrong = tapping(QStringLiteral("evaluate %1 --pitch-mm 1").arg(file));
        QCOMPARE(wrong.exitCode, 3);
        QVERIFY(wrong.err.contains(QStringLiteral("does not fit a pitch")));
        QVERIFY(wrong.out.isEmpty());
    }

    void badInputEndsWithThreeAndOneSentence_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("says");
        const QString broken = scratchFile(QStringLiteral("broken.json"), QStringLiteral("{\"Kpz\": "));
        const QString unknown = scratchFile(QStringLiteral("unknown.json"), QStringLiteral("{\"Kq\": 1}"));
        const QString text = scratchFile(QStringLiteral("text.json"), QStringLiteral("{\"Kpz\": \"48\"}"));
        const QString range = scratchFile(QStringLiteral("range.json"), QStringLiteral("{\"sub\": 2.5}"));
        const QString column = scratchFile(QStringLiteral("column.csv"), QStringLiteral("t_s,spindle_rev\n0,0\n"));
        const QString cell = scratchFile(QStringLiteral("cell.csv"), QStringLiteral("t_s,spindle_rev,z_mm\n0,0,x\n"));
        QTest::newRow("no file") << "simulate --summary --drive none.json"
                                 << "cannot be read";
        QTest::newRow("no JSON") << "simulate --summary --drive " + broken << "no valid JSON";
        QTest::newRow("unknown key") << "simulate --summary --drive " + unknown << "Kq";
        QTest::newRow("no number") << "simulate --summary --drive " + text << "no number";
        QTest::newRow("range") << "simulate --summary --drive " + range << "whole number";
        QTest::newRow("unstable") << "simulate --summary --set Kpz=4000 --set amax_z=1e7"
                                  << "unstable";
        QTest::newRow("column") << "evaluate --pitch-mm 1.25 " + column << "z_mm";
        QTest::newRow("cell") << "evaluate --pitch-mm 1.25 " + cell << "line 2";
    }
    void badInputEndsWithThreeAndOneSentence() {
        QFETCH(QString, arguments);
        QFETCH(QString, says);
        const KerfRun run = tapping(arguments);
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains(says), qPrintable(run.err));
        QVERIFY(run.out.isEmpty());
        QCOMPARE(run.err.count(u'\n'), 1);
    }

    void wrongUsageEndsWithTwo() {
        QCOMPARE(tapping(QStringLiteral("simulate")).exitCode, 2);
        QCOMPARE(tapping(QStringLiteral("simulate --summary --set Kq=1")).exitCode, 2);
        QCOMPARE(tapping(QStringLiteral("tune --summary --tuner best")).exitCode, 2);
        QCOMPARE(tapping(QStringLiteral("simulate --help")).exitCode, 0);
    }
    /// The control's tap behind a rapid to the hole and before one away from it, with the spindle turning or not; and
    /// one that stands for a while in the hole, which is no rapid: it is bad, and stays bad.
    void rapidsAreNoTap() {
        struct Sample {
            double spindle_rev, z_mm;
        };
        std::vector<Sample> tap;
        QFile control(
            QString::fromStdString(kerf::test::fixture("cases/12-tapping-index-reset/control_from_sync.csv")));
        QVERIFY(control.open(QIODevice::ReadOnly));
        for (const QStringList& cells : csvRows(QString::fromUtf8(control.readAll())).mid(1)) {
            tap.push_back({cells[1].toDouble(), cells[2].toDouble()});
        }
        const KerfRun alone = runKerf({"tapping", "evaluate", control.fileName(), "--pitch-mm", "1.25"});
        QCOMPARE(alone.exitCode, 0);
        const double saec_mm = document(alone)["saec_mm"].get<double>();
        const auto evaluated = [](const std::vector<Sample>& samples) {
            QString text = QStringLiteral("t_s,spindle_rev,z_mm\n");
            for (std::size_t k = 0; k < samples.size(); ++k) {
                text += QString::number(0.001 * static_cast<double>(k), 'f', 3) + u',' +
                        QString::number(samples[k].spindle_rev, 'f', 6) + u',' +
                        QString::number(samples[k].z_mm, 'f', 6) + u'\n';
            }
            return runKerf(
                {"tapping", "evaluate", scratchFile(QStringLiteral("rapids.csv"), text), "--pitch-mm", "1.25"});
        };
        for (const double turning_rev : {0.0, 0.01}) {
            std::vector<Sample> record;
            for (int k = 0; k < 500; ++k) {
                record.push_back(
                    {tap.front().spindle_rev - turning_rev * (500 - k), 20.0 * std::max(0.0, 1.0 - k / 300.0)});
            }
            record.insert(record.end(), tap.begin(), tap.end());
            for (int k = 1; k <= 300; ++k) {
                record.push_back({tap.back().spindle_rev - turning_rev * k, tap.back().z_mm + 0.05 * k});
            }
            const KerfRun run = evaluated(record);
            QVERIFY2(run.exitCode == 0, qPrintable(run.err));
            KERF_CLOSE(document(run)["saec_mm"].get<double>(), saec_mm, 0.05);
            QVERIFY2(run.err.contains("begins here") && run.err.contains("back out"), qPrintable(run.err));
        }
        std::vector<Sample> hung(tap.begin(), tap.begin() + 500);
        const Sample at = hung.back();
        for (int k = 1; k <= 40; ++k) {
            hung.push_back({at.spindle_rev + 0.01 * k, at.z_mm});
        }
        for (std::size_t k = 500; k < tap.size(); ++k) {
            hung.push_back({tap[k].spindle_rev + 0.4, tap[k].z_mm});
        }
        const KerfRun bad = evaluated(hung);
        QVERIFY(bad.exitCode == 3 || !document(bad)["within_tolerance"].get<bool>());
    }
};

QTEST_GUILESS_MAIN(TestTappingCommands)
#include "tst_tapping_commands.moc"
