// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "engine/process/milling/milling_alarms.h"
#include "tests/support/milling_bench.h"

using namespace kerf;
using test::MillingBench;

namespace {

struct Driven {
    PartRecord part{};
    double lowest_N{1e9}, highest_N{0.0};  ///< true force from 10 mm to 90 mm, a revolution's mean
    double stiffness{0.0};                 ///< ln(C b) as learnt at 35 mm
    bool done{false}, chatter{false};
};

/// One controlled cut of the published blank, or of `params`'.
Driven drive(const SimulatedMilling::Params& params) {
    MillingBench bench(params);
    Driven driven;
    if (!bench.start(LoopMode::Control)) {
        return driven;
    }
    double sum_N = 0.0;
    int cycles = 0;
    while (bench.status().program == ProgramState::Running && cycles < 400'000) {
        bench.engine->runCycles(1);
        sum_N += bench.milling->trueForce_N();
        if (++cycles % 100 != 0) {  // 600 rpm
            continue;
        }
        const double at_mm = bench.status().milling.position_mm;
        if (at_mm > 10.0 && at_mm < 90.0) {
            driven.lowest_N = std::min(driven.lowest_N, sum_N / 100.0);
            driven.highest_N = std::max(driven.highest_N, sum_N / 100.0);
        }
        driven.stiffness = at_mm < 35.0 ? bench.status().milling.stiffness : driven.stiffness;
        sum_N = 0.0;
    }
    bench.engine->runCycles(2);
    driven.done = bench.engine->partRecords().tryPop(driven.part) && driven.part.complete;
    driven.chatter = bench.alarmRaised(milling_alarm::kChatter);
    return driven;
}

}  // namespace

/// What a real tool, dynamometer and axis do to the signal, through the whole loop.
class TestMillingSignals : public QObject {
    Q_OBJECT

 private slots:
    void runOutAndAMissingFluteDoNotPassForDepth() {
        SimulatedMilling::Params plain;
        plain.shape.runOut = 0.0;
        const Driven even = drive(plain);
        QVERIFY(even.done && !even.chatter);
        for (const double markAt_rev : {0.0, 0.1, 0.37}) {
            for (const bool missing : {false, true}) {
                SimulatedMilling::Params params;
                params.shape.runOut = 0.2;
                params.shape.missing = missing;
                params.shape.markAt_rev = markAt_rev;
                const Driven driven = drive(params);
                QVERIFY(driven.done);
                QCOMPARE(driven.part.milling.stops, 0U);
                QVERIFY(!driven.chatter);
                QVERIFY2(std::abs(driven.stiffness - even.stiffness) < 0.02,
                         qPrintable(QStringLiteral("%1, %2").arg(driven.stiffness).arg(even.stiffness)));
                QVERIFY2(driven.highest_N - driven.lowest_N < even.highest_N - even.lowest_N + 8.0,
                         qPrintable(QStringLiteral("%1 N").arg(driven.highest_N - driven.lowest_N)));
            }
        }
    }
    void aDynamometerThatDriftsAndPasses100HzIsFollowedNoFurtherThanItDrifts() {
        const Driven still = drive({});
        for (const double drift_NPerS : {-1.0, 1.0}) {
            SimulatedMilling::Params params;
            params.corner_Hz = 100.0;
            params.drift_NPerS = drift_NPerS;
            const Driven driven = drive(params);
            QVERIFY(driven.done && !driven.chatter);
            QCOMPARE(driven.part.milling.stops, 0U);
            const double drifted_N = 80.0;  // in the time of the cut
            QVERIFY2(driven.highest_N < still.highest_N + (drift_NPerS < 0.0 ? drifted_N : 10.0) &&
                         driven.lowest_N > still.lowest_N - (drift_NPerS > 0.0 ? drifted_N : 10.0),
                     qPrintable(QStringLiteral("%1 to %2 N").arg(driven.lowest_N).arg(driven.highest_N)));
        }
    }
    void anAxisThatFollowsSlowlyIsNoHarm() {
        for (const double lag_s : {0.05, 0.1, 0.3}) {
            SimulatedMilling::Params params;
            params.driveLag_s = lag_s;
            const Driven driven = drive(params);
            QVERIFY(driven.done);
            QCOMPARE(driven.part.milling.stops, 0U);
            QVERIFY2(driven.highest_N < 50.0 * kNewtonPerKilogramForce,
                     qPrintable(QStringLiteral("%1 s: %2 N").arg(lag_s).arg(driven.highest_N)));
        }
    }
    void noiseAndLatenessOfTheSimulatorReachTheLoop() {
        SimulatedMilling::Params params;
        const Driven plain = drive(params);
        params.revolutionNoise_N = 20.0;
        const Driven noisy = drive(params);
        params.revolutionNoise_N = 0.0;
        params.late = true;
        const Driven late = drive(params);
        const auto spread_N = [](const Driven& driven) { return driven.highest_N - driven.lowest_N; };
        QVERIFY(plain.done && noisy.done && late.done);
        QVERIFY2(spread_N(noisy) > 1.3 * spread_N(plain) && spread_N(late) > 1.3 * spread_N(plain),
                 qPrintable(QStringLiteral("%1 %2 %3").arg(spread_N(plain)).arg(spread_N(noisy)).arg(spread_N(late))));
    }
    void aFluteThatChipsStopsTheFeedWhereverTheMarkLies() {
        for (int mark = 0; mark < 12; ++mark) {
            SimulatedMilling::Params params;
            params.shape.markAt_rev = mark / 12.0;
            MillingBench bench(params);
            QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(30.0));
            bench.runRevolutions(0.09 * mark);
            InjectedFaults faults;
            faults.fluteChipped = true;
            bench.machine->inject(faults);
            bench.runRevolutions(2.2);
            QVERIFY2(bench.status().milling.stopped, qPrintable(QString::number(mark)));
            QVERIFY(bench.alarmRaised(milling_alarm::kToolBroken));
        }
    }
    void chatterIsSaidAndOnlyThen() {
        SimulatedMilling::Params params;
        params.chattersFrom_mm = 2.5;
        const Driven driven = drive(params);
        QVERIFY(driven.done && driven.chatter);
        QCOMPARE(driven.part.milling.stops, 0U);
        MillingBench bench(params);
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(36.0));
        QVERIFY(!bench.alarmRaised(milling_alarm::kChatter));
        QVERIFY(bench.cutTo(55.0));
        QVERIFY(bench.alarmRaised(milling_alarm::kChatter));
        AlarmEvent event;
        bool over = false;
        QVERIFY(bench.cutTo(75.0));
        while (bench.engine->nextAlarm(event)) {
            over = over || (event.code == milling_alarm::kChatter && !event.raised);
        }
        QVERIFY(over);
    }
    void combsAndStairsAreNoChatter() {
        for (const int steps : {5, 20, 100}) {
            std::vector<double> heights_mm;
            for (int i = 0; i < steps; ++i) {
                heights_mm.push_back(i % 2 == 0 ? 1.0 : 3.0);
            }
            SimulatedMilling::Params params;
            params.blanks.push_back(*milling::BlankProfile::ofSegments(heights_mm, 100.0 / steps));
            const Driven driven = drive(params);
            QVERIFY(driven.done);
            QVERIFY2(!driven.chatter, qPrintable(QString::number(steps)));
        }
    }
};
QTEST_APPLESS_MAIN(TestMillingSignals)
#include "tst_milling_signals.moc"
