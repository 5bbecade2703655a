// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "engine/process/milling/force_bounds.h"
#include "engine/process/milling/milling_alarms.h"
#include "tests/support/milling_bench.h"

using namespace kerf;
using kerf::test::MillingBench;
using kerf::test::millingSetup;

namespace {

SimulatedMilling::Params piezo(double zero_N, double drift_NPerS = 0.0, double stated_NPerS = 0.0) {
    SimulatedMilling::Params params;
    params.piezo = true;
    params.zero_N = zero_N;
    params.drift_NPerS = drift_NPerS;
    params.statedDrift_NPerS = stated_NPerS;
    return params;
}

/// The true force while the second step of 2 mm is cut, its mean.
double trueForce_N(MillingBench& bench) {
    double sum_N = 0.0;
    int count = 0;
    (void)bench.runUntil([&](const Status& status) {
        const bool inside = status.milling.position_mm > 28.0 && status.milling.position_mm < 36.0;
        sum_N += inside ? bench.milling->trueForce_N() : 0.0;
        count += inside ? 1 : 0;
        return status.milling.position_mm >= 36.0;
    });
    return count > 0 ? sum_N / count : 0.0;
}

}  // namespace

/// Milling on a piezo dynamometer: zero in the air, drift, reset, and a signal that is slower than usual.
class TestMillingZero : public QObject {
    Q_OBJECT
 private slots:
    void theForceIsHeldWhereverTheZeroStands_data() {
        QTest::addColumn<double>("zero_N");
        QTest::newRow("180 N") << 180.0;
        QTest::newRow("-300 N") << -300.0;
    }
    void theForceIsHeldWhereverTheZeroStands() {
        QFETCH(double, zero_N);
        MillingBench bench(piezo(zero_N, 0.02, 0.02));
        QVERIFY(bench.start(LoopMode::Control));
        QVERIFY(bench.runUntil([](const Status& s) { return s.milling.zero == ForceZeroState::Known; }, 1000));
        QVERIFY(bench.status().milling.position_mm < 0.0);  // in the air, before the first tooth
        const double true_N = trueForce_N(bench);
        QVERIFY2(std::abs(true_N - 392.0) < 0.03 * 392.0, qPrintable(QString::number(true_N)));
        QVERIFY(std::abs(bench.status().milling.zero_N - zero_N) < 2.0);
        PartRecord part;
        QVERIFY(bench.finish(part));
        QVERIFY2(part.milling.waviness_um < 40.0, qPrintable(QString::number(part.milling.waviness_um)));
        QVERIFY(!bench.alarmRaised(milling_alarm::kForceUnknown));
    }
    void withoutAirBeforeTheCutItIsNoFasterThanPlanned() {
        MillingBench bench(piezo(180.0));
        MillingSetup setup = millingSetup();
        setup.from_mm = 45.0;  // in the work from the first tooth on
        setup.entryFeed_mmPerS = setup.plannedFeed_mmPerS;
        QVERIFY(bench.start(LoopMode::Control, setup));
        double fastest_mmPerS = 0.0;
        QVERIFY(bench.runUntil([&](const Status& status) {
            fastest_mmPerS = std::max(fastest_mmPerS, status.actualFeed_mmPerS.value);
            return status.milling.position_mm > 58.0;
        }));
        QVERIFY(bench.status().milling.zero == ForceZeroState::Missed);
        QVERIFY(!bench.status().milling.force_N.good());
        QVERIFY2(fastest_mmPerS < 1.02 * setup.plannedFeed_mmPerS, qPrintable(QString::number(fastest_mmPerS)));
        QVERIFY(bench.alarmRaised(milling_alarm::kZeroUnknown));
        QCOMPARE(bench.loop().state, LoopState::Limited);
    }
    void aDriftThatCannotBeBorneEndsTheForce() {
        MillingBench bench(piezo(180.0, 0.4, 0.4));  // 2 % of the reference after 20 s
        QVERIFY(bench.start(LoopMode::Control));
        QVERIFY(bench.runUntil([](const Status& s) { return s.milling.zero == ForceZeroState::Doubtful; }));
        bench.runRevolutions(2.0);
        QVERIFY(bench.status().milling.blind);
        QVERIFY(!bench.status().milling.force_N.good());
        double fastest_mmPerS = 0.0;
        QVERIFY(bench.runUntil([&](const Status& status) {
            fastest_mmPerS = std::max(fastest_mmPerS, status.actualFeed_mmPerS.value);
            return status.program == ProgramState::Finished;
        }));
        QVERIFY2(fastest_mmPerS < 1.02 * millingSetup().plannedFeed_mmPerS,
                 qPrintable(QString::number(fastest_mmPerS)));
        QVERIFY(bench.alarmRaised(milling_alarm::kZeroUnknown));
    }
    void aDriftNobodyStatedIsToldBehindTheCut() {
        MillingBench bench(piezo(0.0, 0.5));
        PartRecord part;
        QVERIFY(bench.start(LoopMode::Control) && bench.finish(part));
        QVERIFY(bench.alarmRaised(milling_alarm::kZeroDrifted));
        QVERIFY(bench.execute(StartPart{ProcessId::Milling}).done);  // the next cut knows it
        QVERIFY(bench.runUntil([](const Status& s) { return s.milling.zero == ForceZeroState::Doubtful; }));
        QVERIFY(bench.status().milling.cutting);
    }
    void theAmplifierIsResetOncePerCutAndUnderControlOnly_data() {
        QTest::addColumn<bool>("control");
        QTest::newRow("control") << true;
        QTest::newRow("advise") << false;
    }
    void theAmplifierIsResetOncePerCutAndUnderControlOnly() {
        QFETCH(bool, control);
        SimulatedMilling::Params params = piezo(700.0, 0.01, 0.02);
        params.resetLine = true;
        MillingBench bench(params);
        QVERIFY(bench.start(control ? LoopMode::Control : LoopMode::Advise));
        int held = 0;
        int times = 0;
        bool before = false;
        QVERIFY(bench.runUntil([&](const Status& status) {
            const bool now = bench.engine->cycle().outputs().forceReset;
            held += now ? 1 : 0;
            times += now && !before ? 1 : 0;
            before = now;
            return status.milling.position_mm >= 28.0;
        }));
        QCOMPARE(times, control ? 1 : 0);
        QVERIFY2(!control || (held >= 95 && held <= 105), qPrintable(QString::number(held)));  // .1 s
        QVERIFY(bench.status().milling.zero == ForceZeroState::Known);
        QVERIFY(std::abs(bench.status().milling.zero_N - (control ? 0.0 : 700.0)) < 3.0);
        if (control) {
            const double true_N = trueForce_N(bench);
            QVERIFY2(std::abs(true_N - 392.0) < 0.03 * 392.0, qPrintable(QString::number(true_N)));
        }
    }
    void theLoopIsNeverFasterThanItsSignal() {
        ForceSignal signal;
        signal.rate_Hz = 1000.0;
        signal.bandwidth_Hz = 300.0;
        QCOMPARE(milling::shortestPeriod_s(signal), 0.06);
        QVERIFY(milling::teethSeen(signal, 600.0, 4));
        signal.bandwidth_Hz = 2.0;
        QCOMPARE(milling::shortestPeriod_s(signal), 0.25);
        QVERIFY(!milling::teethSeen(signal, 600.0, 4));
        signal.bandwidth_Hz = 500.0;
        QVERIFY(milling::whyTooSlow(signal, 7500.0).empty());
        QVERIFY(!milling::whyTooSlow(signal, 7600.0).empty());
    }
    void aSlowSignalIsAveragedOverMoreRevolutions() {
        SimulatedMilling::Params params;
        params.sampleRate_Hz = 1000.0;
        params.sampleNoise_N = 1.0;
        MillingBench bench(params);
        QVERIFY(bench.start(LoopMode::Control));
        QVERIFY(bench.cutTo(30.0));
        QCOMPARE(bench.status().milling.signal.rate_Hz, 1000.0);
        QCOMPARE(bench.status().milling.signal.bandwidth_Hz, 500.0);
        QVERIFY(std::abs(bench.status().milling.decisions_Hz - 10.0) < 0.1);
        QVERIFY(bench.status().milling.teethSeen);
        QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 40.0);
    }
};
QTEST_APPLESS_MAIN(TestMillingZero)
#include "tst_milling_zero.moc"
