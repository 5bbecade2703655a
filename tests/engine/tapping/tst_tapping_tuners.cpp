// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/process/tapping/thread_table.h"
#include "engine/process/tapping/trial_machine.h"
#include "tests/support/golden.h"

using namespace kerf;
using namespace kerf::tapping;

namespace {

/// 2 µm noise, encoder steps, load ±20 %, friction ±10 %.
constexpr TrialScatter kShopFloor{2.0, 4096.0, 1.0, 0.2, 0.1};

TunerSetup setupFor(const DriveParams& drive, TunerKind kind, int maxTaps,
                    const DriveParams& assumed = middlingDrive()) {
    TunerSetup setup;
    setup.kind = kind;
    setup.assumed = knownTo(drive, assumed);
    setup.initial = settingsOf(drive);
    setup.maxTaps = maxTaps;
    return setup;
}

DriveParams torqueLimited() {
    DriveParams drive;
    drive.zKp_perS = 44.0;
    drive.spindleAccelMax_revPerS2 = 520.0;
    return drive;
}

/// Least clean SAEC over K_pz alone: scan in steps of .1 %.
double bestByGain_mm(const DriveParams& drive) {
    TapSettings settings = settingsOf(drive);
    const auto saec = [&](double gain_perS) {
        settings.zKp_perS = gain_perS;
        return cleanFigures(drive, settings).saec_mm;
    };
    double at_perS = drive.spindleKp_perS;
    double least_mm = saec(at_perS);
    for (const double step : {0.02, 0.001}) {
        const double middle_perS = at_perS;
        for (int i = -20; i <= 20; ++i) {
            const double gain_perS = middle_perS * std::pow(1.0 + step, i);
            const double sum_mm = saec(gain_perS);
            if (sum_mm < least_mm) {
                least_mm = sum_mm;
                at_perS = gain_perS;
            }
        }
    }
    return least_mm;
}

}  // namespace

class TestTappingTuners : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() { m_golden = kerf::test::loadGolden("golden_tapping.json"); }

    void paperFollowsTheReferenceSequence_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("probe");
        QTest::newRow("S(-1) = 0") << "literal eta=.03 S(-1)=0" << false;
        QTest::newRow("probe") << "literal eta=.03 probe -3%" << true;
    }
    void paperFollowsTheReferenceSequence() {
        QFETCH(QString, name);
        QFETCH(bool, probe);
        const auto& expected = m_golden["sequences_A_noise_free"][name.toStdString()];
        TunerSetup setup = setupFor({}, TunerKind::Paper, static_cast<int>(expected.size()));
        setup.probe = probe;
        const Tuning tuning = runTuning(setup, {}, {}, 1);
        QCOMPARE(tuning.trials.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            KERF_CLOSE(tuning.trials[i].settings.zKp_perS, expected[i]["Kpz"].get<double>(), 1e-9);
            KERF_CLOSE(tuning.trials[i].measured.saec_mm, expected[i]["SAEC"].get<double>(), 1e-9);
        }
    }

    void signedRuleFollowsTheReferenceSequence() {
        const auto& expected = m_golden["sequences_A_noise_free"]["signed eta=.06"];
        TunerSetup setup = setupFor({}, TunerKind::Signed, static_cast<int>(expected.size()));
        setup.eta = 0.06;
        const Tuning tuning = runTuning(setup, {}, {}, 1);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            KERF_CLOSE(tuning.trials[i].settings.zKp_perS, expected[i]["Kpz"].get<double>(), 1e-9);
        }
    }

    void paperFailsAsPrinted() {
        // Its end depends on η: far from the optimum at .03, at its clamp with SAEC × 20 and more at .1.
        TunerSetup setup = setupFor({}, TunerKind::Paper, 20);
        const Tuning mild = runTuning(setup, {}, {}, 1);
        QVERIFY(mild.reduction() < 0.5);
        setup.eta = 0.1;
        const Tuning wild = runTuning(setup, {}, {}, 1);
        double worst_mm = 0.0;
        for (const Trial& trial : wild.trials)
            worst_mm = std::max(worst_mm, trial.measured.saec_mm);
        QVERIFY(worst_mm > 20.0 * wild.before.saec_mm);
    }

    void gainReachesTheKnownOptimum() {
        const Tuning a = runTuning(setupFor({}, TunerKind::Gain, 8), {}, {}, 1);
        QVERIFY(std::abs(100.0 * a.reduction() - 87.9) < 0.3);
        const Tuning b = runTuning(setupFor(torqueLimited(), TunerKind::Gain, 8), torqueLimited(), {}, 1);
        QVERIFY(std::abs(100.0 * b.reduction() - 76.9) < 0.3);
    }

    void gainFindsTheOptimumOnRandomMachines() {
        Random random(4711);
        int near = 0;
        for (std::uint64_t i = 0; i < 12; ++i) {
            const DriveParams drive = randomDrive(random);
            const Tuning tuning = runTuning(setupFor(drive, TunerKind::Gain, 8), drive, kShopFloor, i);
            QVERIFY(tuning.trials.size() <= 8);
            near += tuning.after.saec_mm < 1.05 * bestByGain_mm(drive) ? 1 : 0;
        }
        QVERIFY2(near >= 11, qPrintable(QString::number(near)));
    }

    void defaultMeetsToleranceOverSpeedDepthAndLoad_data() {
        QTest::addColumn<double>("speed_rpm");
        QTest::addColumn<double>("depth_rev");
        QTest::addColumn<double>("load");
        for (const double speed_rpm : {1500.0, 3000.0, 4500.0, 6000.0}) {
            for (const double depth_rev : {12.0, 22.0, 30.0}) {
                for (const double load : {1.0, 2.0}) {
                    QTest::addRow("%g rpm %g rev load %g", speed_rpm, depth_rev, load)
                        << speed_rpm << depth_rev << load;
                }
            }
        }
    }
    void defaultMeetsToleranceOverSpeedDepthAndLoad() {
        QFETCH(double, speed_rpm);
        QFETCH(double, depth_rev);
        QFETCH(double, load);
        DriveParams drive;
        drive.speed_rpm = speed_rpm;
        drive.depth_rev = depth_rev;
        drive.load_revPerS2 *= load;
        drive.loadOut_revPerS2 *= load;
        const Tuning four = runTuning(setupFor(drive, TunerKind::Default, 4), drive, kShopFloor, 3);
        QVERIFY2(four.reduction() > 0.98, qPrintable(QString::number(four.reduction())));
        QVERIFY2(four.after.engagedPp_um < 28.0, qPrintable(QString::number(four.after.engagedPp_um)));
    }

    void defaultRefinesWithinSixTaps() {
        const Tuning a = runTuning(setupFor({}, TunerKind::Default, 6), {}, kShopFloor, 5);
        QVERIFY(a.reduction() > 0.99);
        QVERIFY(a.after.engagedPp_um < 10.0);
        const DriveParams drive = torqueLimited();
        const Tuning b = runTuning(setupFor(drive, TunerKind::Default, 4), drive, kShopFloor, 5);
        QVERIFY2(b.reduction() > 0.95, qPrintable(QString::number(b.reduction())));
    }

    void defaultKeepsToleranceOnRandomMachines() {
        const double allowed_um = findThread("M8")->allowedPpWornTap_um();
        Random random(815);
        for (std::uint64_t i = 0; i < 24; ++i) {
            const DriveParams drive = randomDrive(random);
            const Tuning tuning = runTuning(setupFor(drive, TunerKind::Default, 6), drive, kShopFloor, 100 + i);
            QVERIFY2(tuning.after.engagedPp_um < 0.7 * allowed_um,
                     qPrintable(QString::number(tuning.after.engagedPp_um)));
            QVERIFY2(tuning.reduction() > 0.9, qPrintable(QString::number(tuning.reduction())));
        }
    }

    void defaultSurvivesAWrongModel() {
        for (const double delay_s : {0.0, 0.001, 0.002, 0.003}) {
            for (const double bandwidth : {0.7, 1.3}) {
                for (const double lag : {0.7, 1.3, 3.75}) {
                    DriveParams drive;
                    drive.zDelay_s = delay_s;
                    DriveParams assumed;
                    assumed.zBandwidth_perS *= bandwidth;
                    assumed.zIntegral_perS *= 2.0 - bandwidth;
                    assumed.zTorqueLag_s *= lag;
                    const Tuning tuning =
                        runTuning(setupFor(drive, TunerKind::Default, 4, assumed), drive, kShopFloor, 11);
                    QVERIFY2(tuning.reduction() > 0.96, qPrintable(QString::number(tuning.reduction())));
                }
            }
        }
    }

    void defaultHandlesASlavedAxis() {
        DriveParams drive;
        drive.slaved = 1.0;
        const Tuning tuning = runTuning(setupFor(drive, TunerKind::Default, 4), drive, kShopFloor, 2);
        QVERIFY(tuning.reduction() > 0.99);
        QVERIFY(std::abs(tuning.final.zVelocityFf - 1.0) < 0.05);
    }

    void noProposalLeavesTheSafeSet() {
        Random random(99);
        for (const TunerKind kind : {TunerKind::Signed, TunerKind::Gain, TunerKind::Default}) {
            for (std::uint64_t i = 0; i < 6; ++i) {
                DriveParams drive = randomDrive(random);
                drive.zKp_perS = drive.spindleKp_perS * 2.4;  // the match lies outside: 42 % of the initial gain
                const Tuning tuning = runTuning(setupFor(drive, kind, 8), drive, kShopFloor, i);
                for (const Trial& trial : tuning.trials) {
                    QVERIFY(trial.step.next.zKp_perS >= trial.step.safe.lowest_perS * (1.0 - 1e-12));
                    QVERIFY(trial.step.next.zKp_perS <= trial.step.safe.highest_perS * (1.0 + 1e-12));
                    QVERIFY(trial.step.safe.highest_perS <= trial.step.safe.critical_perS / 2.0);
                    for (const double trim_mm : trial.step.next.zTrim_mm) {
                        QVERIFY(std::abs(trim_mm) <= trial.step.safe.highestTrim_mm);
                    }
                }
            }
        }
    }

    void stabilityEstimateBracketsThePlant() {
        // Below the estimate the clean drive settles, well above it the drive oscillates.
        for (const double lag_s : {0.0008, 0.003}) {
            DriveParams drive;
            drive.zTorqueLag_s = lag_s;
            drive.zCoulomb_mmPerS2 = 0.0;
            drive.zAccelMax_mmPerS2 = 1e7;
            const double critical_perS = criticalZKp_perS(drive);
            const auto tailError_um = [&](double gain_perS) {
                drive.zKp_perS = gain_perS;
                TrialMachine machine(drive, {}, 0);
                const TapSignals tap = machine.tap(settingsOf(drive));
                double worst_mm = 0.0;
                for (std::size_t k = tap.z_mm.size() - 20; k < tap.z_mm.size(); ++k) {
                    worst_mm = std::max(worst_mm, std::abs(tap.z_mm[k]));
                }
                return 1000.0 * worst_mm;
            };
            QVERIFY(tailError_um(0.7 * critical_perS) < 200.0);
            QVERIFY(!(tailError_um(1.4 * critical_perS) < 2000.0));
        }
    }

    void aSpindleThatCannotFollowIsSaidAndARampIsProposed_data() {
        QTest::addColumn<double>("limit_revPerS2");
        QTest::addColumn<double>("speed_rpm");
        QTest::addColumn<double>("depth_rev");
        QTest::addColumn<double>("load");
        QTest::newRow("300") << 300.0 << 3000.0 << 22.0 << 1.0;
        QTest::newRow("300, double load") << 300.0 << 3000.0 << 22.0 << 2.0;
        QTest::newRow("300, 6000 rpm") << 300.0 << 6000.0 << 30.0 << 1.0;
        QTest::newRow("300, 6 rev") << 300.0 << 3000.0 << 6.0 << 1.0;
        QTest::newRow("200, half load") << 200.0 << 3000.0 << 22.0 << 0.5;
    }
    void aSpindleThatCannotFollowIsSaidAndARampIsProposed() {
        QFETCH(double, limit_revPerS2);
        QFETCH(double, speed_rpm);
        QFETCH(double, depth_rev);
        QFETCH(double, load);
        const double allowed_um = findThread("M8")->allowedPp_um();
        DriveParams drive;
        drive.spindleAccelMax_revPerS2 = limit_revPerS2;
        drive.speed_rpm = speed_rpm;
        drive.depth_rev = depth_rev;
        drive.load_revPerS2 *= load;
        drive.loadOut_revPerS2 *= load;
        for (const std::uint64_t seed : {1, 2, 3}) {
            const TunerSetup setup = setupFor(drive, TunerKind::Default, 8);
            const Tuning tuning = runTuning(setup, drive, kShopFloor, seed);
            const TuningVerdict verdict = judgeTuning(tuning, allowed_um);
            QVERIFY(!verdict.within);
            QCOMPARE(verdict.limitedBy, LimitedBy::Torque);
            QVERIFY(!verdict.why.empty() && !verdict.help.empty());
            QVERIFY(verdict.proposedRamp_revPerS2.has_value());
            QVERIFY(*verdict.proposedRamp_revPerS2 < limit_revPerS2);
            QVERIFY(*verdict.proposedHole_s > verdict.programmedHole_s);
            DriveParams eased = drive;
            eased.ramp_revPerS2 = *verdict.proposedRamp_revPerS2;
            const TunerSetup again = setupFor(eased, TunerKind::Default, 8);
            const Tuning mended = runTuning(again, eased, kShopFloor, seed);
            const TuningVerdict now = judgeTuning(mended, allowed_um);
            QVERIFY2(mended.after.engagedPp_um < 20.0, qPrintable(QString::number(mended.after.engagedPp_um)));
            QVERIFY(now.within && !now.proposedRamp_revPerS2);
            QCOMPARE(now.programmedHole_s, *verdict.proposedHole_s);
        }
    }

    void noTuningEndsOutsideToleranceWithoutAReason_data() {
        QTest::addColumn<QString>("limit");
        QTest::addColumn<int>("taps");
        QTest::addColumn<double>("zLimit_mmPerS2");
        QTest::addColumn<double>("lag_s");
        QTest::addColumn<double>("ramp_revPerS2");
        QTest::newRow("one tap") << "taps" << 1 << 6000.0 << 0.0008 << 500.0;
        QTest::newRow("Z too weak") << "z_torque" << 8 << 500.0 << 0.0008 << 500.0;
        QTest::newRow("Z too slow") << "lag" << 8 << 6000.0 << 0.02 << 500.0;
        QTest::newRow("a ramp of 2000") << "torque" << 8 << 6000.0 << 0.0008 << 2000.0;
        QTest::newRow("nothing") << "none" << 8 << 6000.0 << 0.0008 << 500.0;
    }
    void noTuningEndsOutsideToleranceWithoutAReason() {
        QFETCH(QString, limit);
        QFETCH(int, taps);
        QFETCH(double, zLimit_mmPerS2);
        QFETCH(double, lag_s);
        QFETCH(double, ramp_revPerS2);
        DriveParams drive;
        drive.zAccelMax_mmPerS2 = zLimit_mmPerS2;
        drive.zTorqueLag_s = lag_s;
        drive.ramp_revPerS2 = ramp_revPerS2;
        const TunerSetup setup = setupFor(drive, TunerKind::Default, taps);
        const TuningVerdict verdict =
            judgeTuning(runTuning(setup, drive, kShopFloor, 4), findThread("M8")->allowedPp_um());
        QCOMPARE(QString(limitKey(verdict.limitedBy)), limit);
        QCOMPARE(verdict.within, limit == QStringLiteral("none"));
        QCOMPARE(verdict.why.empty(), verdict.within);
        QCOMPARE(verdict.help.empty(), verdict.within);
    }

    void aTuningNeverEndsWorseThanItBegan() {
        DriveParams drive;
        drive.zAccelMax_mmPerS2 = 500.0;  // the learned trim asks for what Z cannot give
        for (const std::uint64_t seed : {1, 2, 3}) {
            const Tuning tuning = runTuning(setupFor(drive, TunerKind::Default, 8), drive, kShopFloor, seed);
            QVERIFY2(tuning.after.saec_mm <= tuning.before.saec_mm, qPrintable(QString::number(tuning.after.saec_mm)));
            QVERIFY2(tuning.after.engagedPp_um <= tuning.before.engagedPp_um,
                     qPrintable(QString::number(tuning.after.engagedPp_um)));
        }
    }

    void theProbeMeasuresTheCriticalGain_data() {
        QTest::addColumn<double>("resonance_Hz");
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("delay_s");
        QTest::addColumn<bool>("noisy");
        QTest::newRow("rigid") << 0.0 << 0.05 << 0.2 << 0.0 << false;
        QTest::newRow("dead time") << 0.0 << 0.05 << 0.2 << 0.003 << false;
        for (const bool noisy : {false, true}) {
            QTest::addRow("30 Hz, noisy %d", noisy) << 30.0 << 0.02 << 0.05 << 0.0 << noisy;
            QTest::addRow("60 Hz, noisy %d", noisy) << 60.0 << 0.03 << 0.2 << 0.0 << noisy;
            QTest::addRow("120 Hz, noisy %d", noisy) << 120.0 << 0.02 << 0.3 << 0.001 << noisy;
        }
    }
    void theProbeMeasuresTheCriticalGain() {
        QFETCH(double, resonance_Hz);
        QFETCH(double, damping);
        QFETCH(double, share);
        QFETCH(double, delay_s);
        QFETCH(bool, noisy);
        DriveParams drive;
        drive.zResonance_Hz = resonance_Hz;
        drive.zResonanceDamping = damping;
        drive.zResonanceShare = share;
        drive.zDelay_s = delay_s;
        const Tuning tuning =
            runTuning(setupFor(drive, TunerKind::Default, 8), drive, noisy ? kShopFloor : TrialScatter{}, 3);
        QVERIFY(tuning.setup.measured.has_value());
        const double found = tuning.setup.measured->critical_perS / criticalZKp_perS(drive);
        QVERIFY2(found > (noisy ? 0.4 : 0.7) && found < 1.2,
                 qPrintable(QString::number(found)));  // noise counts against
        if (resonance_Hz > 0.0) {
            QVERIFY(std::abs(tuning.setup.measured->resonance_Hz / resonance_Hz - 1.0) < 0.02);
        }
        QVERIFY2(tuning.after.engagedPp_um < 10.0, qPrintable(QString::number(tuning.after.engagedPp_um)));
    }

    void hardMachinesAreNeverMadeWorseNorUnstable() {
        for (std::uint64_t seed = 1; seed <= 24; ++seed) {
            const DriveParams drive = hardDrive(seed);
            QVERIFY(!oscillates(drive, settingsOf(drive)));
            const Tuning tuning = runTuning(setupFor(drive, TunerKind::Default, 8), drive, kShopFloor, seed);
            const TuningVerdict verdict = judgeTuning(tuning, findThread("M8")->allowedPp_um());
            QVERIFY2(!oscillates(drive, tuning.final), qPrintable(QString::number(seed)));
            for (const Trial& trial : tuning.trials)
                QVERIFY2(trial.settings.zKp_perS < criticalZKp_perS(drive), qPrintable(QString::number(seed)));
            QVERIFY2(tuning.after.engagedPp_um <= tuning.before.engagedPp_um, qPrintable(QString::number(seed)));
            QVERIFY2(verdict.within || !verdict.help.empty(), qPrintable(QString::number(seed)));
        }
    }

    void tapWithGapsDoesNotCount() {
        const DriveParams drive;
        const std::unique_ptr<Tuner> tuner = makeTuner(setupFor(drive, TunerKind::Default, 4));
        TrialMachine machine(drive, kShopFloor, 1);
        TapSignals tap = machine.tap(tuner->settings());
        std::vector<std::uint8_t> valid(tap.z_mm.size(), 1);
        for (std::size_t k = 100; k < 170; ++k)
            valid[k] = 0;  // 5.9 %
        tap.valid = valid;
        const TunerStep refused = tuner->observe(tap);
        QVERIFY(!refused.counted && !refused.accepted && !refused.finished);
        QCOMPARE(refused.next.zKp_perS, drive.zKp_perS);
        std::fill(valid.begin(), valid.end(), std::uint8_t{1});
        for (std::size_t k = 100; k < 140; ++k)
            valid[k] = 0;  // 3.4 %
        const TunerStep counted = tuner->observe(tap);
        QVERIFY(counted.counted && counted.accepted);
        QVERIFY(cleanFigures(drive, counted.next).saec_mm < 0.1 * cleanFigures(drive, settingsOf(drive)).saec_mm);
    }

    void rollBackReturnsToTheAcceptedSettings() {
        const DriveParams drive;
        const std::unique_ptr<Tuner> tuner = makeTuner(setupFor(drive, TunerKind::Gain, 8));
        TrialMachine machine(drive, {}, 1);
        const TunerStep step = tuner->observe(machine.tap(tuner->settings()));
        QVERIFY(std::abs(step.next.zKp_perS - drive.zKp_perS) > 1.0);
        tuner->rollBack();
        QCOMPARE(tuner->settings().zKp_perS, drive.zKp_perS);
    }

 private:
    nlohmann::json m_golden;
};

QTEST_GUILESS_MAIN(TestTappingTuners)
#include "tst_tapping_tuners.moc"
