// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "engine/process/turning/turning_alarms.h"
#include "tests/support/cycle_guard.h"
#include "tests/support/release_stop.h"
#include "tests/support/turning_bench.h"

using namespace kerf;

namespace {

/// Largest size and largest step of the trim the machine gets, over the next cycles.
struct TrimWatch {
    double size_um{0.0};
    double step_um{0.0};
    double last_um{0.0};
};
TrimWatch watchTrim(test::TurningBench& bench, int cycles) {
    TrimWatch watch;
    watch.last_um = bench.engine->cycle().outputs().toolTrim_um;
    for (int i = 0; i < cycles; ++i) {
        bench.engine->runCycles(1);
        const double trim_um = bench.engine->cycle().outputs().toolTrim_um;
        watch.size_um = std::max(watch.size_um, std::abs(trim_um));
        watch.step_um = std::max(watch.step_um, std::abs(trim_um - watch.last_um));
        watch.last_um = trim_um;
    }
    return watch;
}
constexpr int kFiveMilliseconds = 25;

}  // namespace

/// The turning loop on the simulated machine through the real cycle, with every fault it promises to meet.
class TestTurningLoop : public QObject {
    Q_OBJECT
 private slots:
    void cancelsTheDisturbanceAndLeavesTheCut() {
        test::TurningBench open;
        QVERIFY(open.start(LoopMode::Advise));
        open.run(2.0);
        const double untreated_um = open.motionRms_um(1.0);
        const double openForce_N = open.status().forceMean_N;

        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(2.0);
        const double treated_um = bench.motionRms_um(1.0);
        QVERIFY2(treated_um < 0.15 * untreated_um, qPrintable(QString::number(treated_um / untreated_um)));
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        QVERIFY(bench.status().acting);
        QVERIFY(std::abs(bench.status().forceMean_N - bench.status().forceTarget_N) < 0.03);
        QVERIFY(std::abs(openForce_N - bench.status().forceMean_N) < 0.1);
        QVERIFY2(std::abs(bench.status().surfaceRms_um / treated_um - 1.0) < 0.3,
                 qPrintable(QStringLiteral("%1 %2").arg(bench.status().surfaceRms_um).arg(treated_um)));
        QVERIFY(std::abs(bench.status().untreatedRms_um / untreated_um - 1.0) < 0.3);
        QVERIFY(bench.status().toneCount >= 5);
        const auto raised = bench.alarms();
        QVERIFY(!raised.empty());
        for (const AlarmCode code : raised) {
            QCOMPARE(code, turning_alarm::kBlindTone);
        }
    }
    void findsZeroTouchAndEnd() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(0.25);
        QCOMPARE(bench.status().stage, TurningStage::Air);
        QVERIFY(std::abs(bench.status().forceZero_N - 0.08) < 0.003);
        QVERIFY(std::abs(bench.engine->cycle().outputs().toolTrim_um) == 0.0);
        bench.run(0.06);
        QCOMPARE(bench.status().stage, TurningStage::Entry);
        QVERIFY(std::abs(bench.status().touchOff_mm.value) < 0.001);
        bench.run(5.1);
        QCOMPARE(bench.status().stage, TurningStage::Air);
        QCOMPARE(bench.engine->cycle().outputs().toolTrim_um, 0.0);
        bench.run(0.5);
        QCOMPARE(bench.engine->status().program, ProgramState::Finished);
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        QVERIFY(part.complete && part.turning.valid && !part.turning.leftLoop);
        QVERIFY(std::abs(part.forceMean_N - 1.44) < 0.03);
        QVERIFY2(part.turning.surfaceRms_um < 0.6 * part.turning.untreatedRms_um,
                 qPrintable(QStringLiteral("%1 %2").arg(part.turning.surfaceRms_um).arg(part.turning.untreatedRms_um)));
    }
    void trimStaysInsideItsAuthority() {
        test::TurningBench bench;
        bench.turning->shake(1.2);  // four times would throw the tool out of the cut again and again
        TurningSetup setup = test::shortCut();
        setup.trimAuthority_um = 0.8;
        QVERIFY(bench.start(LoopMode::Control, setup));
        const TrimWatch watch = watchTrim(bench, 15000);
        QVERIFY(watch.size_um > 0.7);
        QVERIFY(watch.size_um <= 0.8 + 1e-12);
        QVERIFY(watch.step_um <= 0.2 + 1e-12);  // 1000 µm/s
        QVERIFY(bench.raised(turning_alarm::kTrimAtLimit));
    }
    void adviceNeverMovesTheTool() {
        test::TurningBench bench;
        QVERIFY(bench.start(LoopMode::Advise));
        QCOMPARE(watchTrim(bench, 15000).size_um, 0.0);
        QCOMPARE(bench.loop().state, LoopState::Advising);
    }
    void lostForceEndsTheTrimWithinFiveMilliseconds_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("alarm");
        QTest::addColumn<int>("state");
        const auto row = [](const char* name, SignalFault fault, AlarmCode alarm, LoopState state) {
            QTest::newRow(name) << static_cast<int>(fault) << static_cast<int>(alarm) << static_cast<int>(state);
        };
        row("unplugged", SignalFault::Unplugged, turning_alarm::kForceLost, LoopState::Faulted);
        row("stale", SignalFault::Stale, turning_alarm::kForceLost, LoopState::Faulted);
        row("not a number", SignalFault::NotANumber, turning_alarm::kForceLost, LoopState::Faulted);
        row("saturated", SignalFault::Saturated, turning_alarm::kForceSaturated, LoopState::Limited);
    }
    void lostForceEndsTheTrimWithinFiveMilliseconds() {
        QFETCH(int, fault);
        QFETCH(int, alarm);
        QFETCH(int, state);
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(2.0);
        QVERIFY(std::abs(watchTrim(bench, 300).size_um) > 0.5);
        InjectedFaults faults;
        faults.force = static_cast<SignalFault>(fault);
        bench.machine->inject(faults);
        const TrimWatch watch = watchTrim(bench, kFiveMilliseconds);
        QCOMPARE(watch.last_um, 0.0);
        QVERIFY2(watch.step_um <= 0.2 + 1e-12, qPrintable(QString::number(watch.step_um)));
        QVERIFY(bench.raised(static_cast<AlarmCode>(alarm)));
        QCOMPARE(static_cast<int>(bench.loop().state), state);
        QVERIFY(!bench.loop().reason.empty());
        bench.machine->inject({});
        QCOMPARE(watchTrim(bench, 2000).size_um, 0.0);  // not again in this part
    }
    void stuckForceEndsTheTrimWithinFiveMilliseconds() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(2.0);
        QVERIFY(std::abs(watchTrim(bench, 300).size_um) > 0.5);
        InjectedFaults faults;
        faults.force = SignalFault::Stuck;
        bench.machine->inject(faults);
        const TrimWatch watch = watchTrim(bench, kFiveMilliseconds);
        QCOMPARE(watch.last_um, 0.0);
        QVERIFY(watch.step_um <= 0.2 + 1e-12);
        QVERIFY(bench.raised(turning_alarm::kForceLost));
    }
    void faultWantsAPersonThenTheNextPartIsControlled() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(1.0);
        InjectedFaults faults;
        faults.force = SignalFault::Unplugged;
        bench.machine->inject(faults);
        bench.run(0.1);
        QCOMPARE(bench.loop().state, LoopState::Faulted);
        bench.machine->inject({});
        bench.run(0.1);
        QCOMPARE(bench.loop().state, LoopState::Faulted);
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Turning, LoopMode::Off}).done);
        bench.engine->holdAll();
        bench.run(0.01);
        QVERIFY(bench.execute(ReleaseHold{}).done);
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Turning, LoopMode::Control}).done);
        bench.run(0.01);
        QCOMPARE(bench.loop().state, LoopState::Faulted);  // neither mode nor hold ends a stop
        QVERIFY(!bench.execute(StartPart{ProcessId::Turning}).done);
        QVERIFY(bench.execute(test::releaseOf(bench.engine->status(), ProcessId::Turning)).done);
        QCOMPARE(bench.loop().state, LoopState::Limited);
        bench.run(6.0);
        QVERIFY(bench.execute(StartPart{ProcessId::Turning}).done);
        bench.run(2.0);
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        QVERIFY(bench.status().acting);
    }
    void chippedToolEndsTheTrimWithinFiveMilliseconds_data() {
        QTest::addColumn<int>("controller");
        QTest::addColumn<double>("gain");
        for (const double gain : {1.4, 1.6, 2.5}) {
            QTest::addRow("tones, %.1f times the force", gain) << static_cast<int>(TurningController::Tones) << gain;
        }
        QTest::newRow("pi") << static_cast<int>(TurningController::Pi) << 1.6;
        QTest::newRow("paper") << static_cast<int>(TurningController::Paper) << 1.6;
    }
    void chippedToolEndsTheTrimWithinFiveMilliseconds() {
        QFETCH(int, controller);
        QFETCH(double, gain);
        for (const double when_s : {2.0, 2.013, 2.4}) {
            test::TurningBench bench;
            QVERIFY(bench.execute(SetTurningController{static_cast<TurningController>(controller)}).done);
            QVERIFY(bench.start());
            bench.run(when_s);
            (void)bench.alarms();
            bench.turning->chipTool(gain);
            const TrimWatch watch = watchTrim(bench, kFiveMilliseconds);
            QCOMPARE(watch.last_um, 0.0);
            QVERIFY2(watch.step_um <= 0.2 + 1e-12, qPrintable(QString::number(watch.step_um)));
            QVERIFY(bench.raised(turning_alarm::kToolChipped));
            QCOMPARE(bench.loop().state, LoopState::Faulted);
        }
    }
    void aLateCycleTakesEverySampleThatHasComeMeanwhile() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(1.5);
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        std::int64_t now_ns = bench.engine->cycle().inputs().time_ns;
        double largest_um = 0.0;
        for (int i = 0; i < 7000; ++i) {  // every fiftieth comes a millisecond late
            now_ns += i % 50 == 0 ? 1'200'000 : 200'000;
            bench.engine->cycle().step(now_ns);
            QCOMPARE(bench.engine->cycle().inputs().fastCount, i % 50 == 0 ? std::size_t{6} : std::size_t{1});
            largest_um = std::max(largest_um, std::abs(bench.engine->cycle().outputs().toolTrim_um));
        }
        QVERIFY(!bench.raised(turning_alarm::kToolChipped));
        QCOMPARE(bench.engine->cycle().describe(ProcessId::Turning).state, LoopState::Controlling);
        QVERIFY2(largest_um > 0.5, qPrintable(QString::number(largest_um)));  // and goes on
    }
    void missingSamplesAreNoChip() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(1.5);
        std::int64_t now_ns = bench.engine->cycle().inputs().time_ns;
        MachineInputs unheard;
        for (int i = 0; i < 3; ++i) {  // the machine goes on, the console does not
            bench.machine->read(now_ns += 200'000, unheard);
        }
        bench.engine->cycle().step(now_ns += 200'000);
        for (int i = 0; i < 2000; ++i) {
            bench.engine->cycle().step(now_ns += 200'000);
        }
        const LoopStatus loop = bench.engine->cycle().describe(ProcessId::Turning);
        QCOMPARE(loop.state, LoopState::Limited);
        QVERIFY(loop.reason.english().starts_with("Samples of the force are missing"));
        QCOMPARE(bench.engine->cycle().outputs().toolTrim_um, 0.0);
        QVERIFY(!bench.raised(turning_alarm::kToolChipped));
    }
    void slowWearIsNoChip() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(1.0);
        for (int i = 0; i < 100; ++i) {
            bench.turning->chipTool(1.0 + 0.002 * i);  // 20 % within 3 s
            bench.run(0.03);
        }
        const auto raised = bench.alarms();
        QVERIFY(std::find(raised.begin(), raised.end(), turning_alarm::kToolChipped) == raised.end());
        QVERIFY2(bench.loop().state == LoopState::Controlling, bench.loop().reason.english().c_str());
    }
    void aForceThatFallsEndsTheTrimWithTheMeanForceAlarm() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(2.0);
        bench.turning->chipTool(0.6);
        bench.run(0.3);
        QVERIFY(bench.raised(turning_alarm::kMeanForceOff));
        QCOMPARE(bench.loop().state, LoopState::Limited);
        QCOMPARE(bench.engine->cycle().outputs().toolTrim_um, 0.0);
    }
    void aForceBeyondTheSensorsRangeIsSaturated() {
        SimulatedTurning::Params params;
        params.forceRange_N = 1.9;
        test::TurningBench bench(params);
        QVERIFY(bench.start());
        bench.run(2.0);
        bench.turning->chipTool(1.35);
        bench.run(0.2);
        QVERIFY(bench.raised(turning_alarm::kForceSaturated) || bench.raised(turning_alarm::kToolChipped));
        QCOMPARE(bench.engine->cycle().outputs().toolTrim_um, 0.0);
    }
    void driftIsTakenOutBetweenParts() {
        SimulatedTurning::Params params;
        params.drift_NPerS = 0.02;
        test::TurningBench bench(params);
        QVERIFY(bench.start());
        bench.run(7.0);
        QVERIFY(bench.execute(StartPart{ProcessId::Turning}).done);
        bench.run(2.0);
        QVERIFY(bench.raised(turning_alarm::kZeroDrifted));
        QVERIFY(bench.status().acting);
        QVERIFY(std::abs(bench.status().forceMean_N - 1.44) < 0.08);
    }
    void holdAndOffAreBumplessWithinFiveMilliseconds() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(2.0);
        bench.engine->holdAll();
        TrimWatch watch = watchTrim(bench, kFiveMilliseconds);
        QCOMPARE(watch.last_um, 0.0);
        QVERIFY(watch.step_um <= 0.2 + 1e-12);
        QVERIFY(bench.execute(ReleaseHold{}).done);
        watch = watchTrim(bench, 3000);
        QVERIFY(watch.size_um > 0.5);           // back in the loop
        QVERIFY(watch.step_um <= 0.2 + 1e-12);  // and as softly
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Turning, LoopMode::Off}).done);
        QCOMPARE(watchTrim(bench, kFiveMilliseconds).last_um, 0.0);
    }
    void slowMachineIsToldWhy() {
        test::TurningBench bench({}, 1'000'000);
        QVERIFY(bench.start());
        bench.engine->runCycles(2000);
        QCOMPARE(bench.loop().state, LoopState::Limited);
        QCOMPARE(bench.engine->cycle().outputs().toolTrim_um, 0.0);
    }
    void withAMotionSensorTheProcessIsIdentified() {
        SimulatedTurning::Params params;
        params.motionSensorNoise_um = 0.005;
        test::TurningBench bench(params);
        QVERIFY(bench.start(LoopMode::Advise));
        bench.run(3.0);
        const TurningIdentification& found = bench.status().identification;
        QVERIFY(found.available);
        QVERIFY2(std::abs(found.value[1] - 0.747) < 0.04, qPrintable(QString::number(found.value[1])));
        QVERIFY(found.excitation > 3.0);
        QVERIFY(found.half95[1] > 0.0 && found.half95[1] < 0.05);
    }
    void aMovedProcessIsFollowedByTheLaw() {
        SimulatedTurning::Params params;
        params.motionSensorNoise_um = 0.005;
        params.process.b0 *= 0.85;  // duller material than the law assumes
        params.process.b1 *= 0.85;
        test::TurningBench bench(params);
        QVERIFY(bench.start());
        bench.run(1.5);
        QCOMPARE(bench.status().retuned, 1U);
        const TrimWatch quiet = watchTrim(bench, 5000);
        QVERIFY(quiet.step_um <= 0.2 + 1e-12);
        const TurningProcess& law = bench.status().lawProcess;
        QVERIFY2(std::abs(law.b0 - 0.85 * 0.747) < 0.05 * 0.747, qPrintable(QString::number(law.b0)));
        QVERIFY(std::abs(bench.status().forceTarget_N - 0.85 * 1.44) < 0.05);
        QVERIFY(std::abs(bench.status().depthEstimate_um - 6.0) < 0.3);
        QVERIFY(bench.status().acting);
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        bench.run(6.0);
        QVERIFY(bench.execute(StartPart{ProcessId::Turning}).done);  // the next part begins with what was learnt
        bench.run(1.0);
        QVERIFY(std::abs(bench.status().lawProcess.b0 - 0.85 * 0.747) < 0.05 * 0.747);
    }
    void everyControllerKeepsTheCutAndIsBumpless_data() {
        QTest::addColumn<int>("controller");
        QTest::addColumn<double>("most");  // RMS over that of open loop
        QTest::newRow("open") << static_cast<int>(TurningController::Open) << 1.02;
        QTest::newRow("paper") << static_cast<int>(TurningController::Paper) << 0.75;
        QTest::newRow("pi") << static_cast<int>(TurningController::Pi) << 0.55;
        QTest::newRow("tones") << static_cast<int>(TurningController::Tones) << 0.15;
    }
    void everyControllerKeepsTheCutAndIsBumpless() {
        QFETCH(int, controller);
        QFETCH(double, most);
        test::TurningBench open;
        QVERIFY(open.start(LoopMode::Advise));
        open.run(2.0);
        const double untreated_um = open.motionRms_um(1.0);
        test::TurningBench bench;
        QVERIFY(bench.execute(SetTurningController{static_cast<TurningController>(controller)}).done);
        QVERIFY(bench.start());
        const TrimWatch entry = watchTrim(bench, 10000);
        QVERIFY2(entry.step_um <= 0.2 + 1e-12, qPrintable(QString::number(entry.step_um)));
        QCOMPARE(static_cast<int>(bench.status().controller), controller);
        const double treated_um = bench.motionRms_um(1.0);
        QVERIFY2(treated_um < most * untreated_um, qPrintable(QString::number(treated_um / untreated_um)));
        QVERIFY(std::abs(bench.status().forceMean_N - bench.status().forceTarget_N) < 0.08);
        QVERIFY(std::abs(bench.status().untreatedRms_um / untreated_um - 1.0) < 0.15);
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        QVERIFY(bench.status().toneCount >= 4);  // named whatever law acts
    }
    void changingTheControllerWhileCuttingIsBumpless() {
        test::TurningBench bench;
        QVERIFY(bench.start());
        bench.run(2.0);
        for (const TurningController next :
             {TurningController::Pi, TurningController::Open, TurningController::Paper, TurningController::Tones}) {
            QVERIFY(bench.execute(SetTurningController{next}).done);
            const TrimWatch watch = watchTrim(bench, 2000);
            QVERIFY2(watch.step_um <= 0.2 + 1e-12, qPrintable(QString::number(watch.step_um)));
            QCOMPARE(bench.loop().state, LoopState::Controlling);
        }
        QVERIFY(bench.motionRms_um(0.4) < 0.2);
        QVERIFY(!bench.execute(SetTurningController{static_cast<TurningController>(9)}).done);
    }
    /// RMS of the motion in the .3 s after the first revolution of the cut.
    static double earlyRms_um(const SimulatedTurning::Params& params, const TurningRecall& recall,
                              TurningProcess* law = nullptr) {
        TurningExchange exchange;
        exchange.recall.publish(recall);
        test::TurningBench bench(params, 200'000, &exchange);
        if (!bench.start()) {
            return -1.0;
        }
        while (bench.status().stage != TurningStage::Cutting) {
            bench.engine->runCycles(1);
        }
        bench.run(0.15);
        if (law != nullptr) {
            *law = bench.status().lawProcess;
        }
        return bench.motionRms_um(0.3);
    }
    void afterARestartTheLawBeginsWithTheProcessOfTheStoredParts() {
        SimulatedTurning::Params params;
        params.motionSensorNoise_um = 0.005;
        params.process.b0 *= 0.85;
        params.process.b1 *= 0.85;
        test::TurningBench first(params);
        QVERIFY(first.start());
        first.run(8.0);
        PartRecord part;
        QVERIFY(first.engine->partRecords().tryPop(part));
        TurningRecall recall;
        recall.processKnown = true;
        recall.process = part.turning.lawProcess;
        params.seed = 2;  // another part: other noise, other phases
        TurningProcess law;
        const double anew_um = earlyRms_um(params, {}, &law);
        QVERIFY(std::abs(law.b0 - 0.747) < 1e-9);
        const double from_um = earlyRms_um(params, recall, &law);
        QVERIFY(std::abs(law.b0 - 0.85 * 0.747) < 0.05 * 0.747);
        QVERIFY2(from_um < anew_um, qPrintable(QStringLiteral("%1 %2").arg(anew_um).arg(from_um)));
        qInfo("first .3 s after the first revolution: %.4f um anew, %.4f um from the part before", anew_um, from_um);
        // A process out of all reason is not taken.
        recall.process.b0 *= 50.0;
        QCOMPARE(earlyRms_um(params, recall, &law), anew_um);
        QVERIFY(std::abs(law.b0 - 0.747) < 1e-9);
    }
    void theServiceGetsSurfaceForceAndRecord() {
        TurningExchange exchange;
        test::TurningBench bench({}, 200'000, &exchange);
        QVERIFY(bench.start());
        bench.run(2.6);
        QVERIFY(exchange.surfaces.refresh());
        const TurningSurface& surface = exchange.surfaces.value();
        QCOMPARE(static_cast<std::size_t>(surface.count), TurningSurface::kPoints);
        QCOMPARE(surface.number, 1U);
        double treated = 0.0;
        double untreated = 0.0;
        for (std::size_t i = TurningSurface::kPoints / 2; i < TurningSurface::kPoints; ++i) {
            treated += std::pow(surface.treated_um[i], 2);
            untreated += std::pow(surface.untreated_um[i], 2);
        }
        QVERIFY(treated < 0.03 * untreated);
        bench.run(4.0);
        QVERIFY(exchange.traces.refresh());
        const TurningForceTrace& trace = exchange.traces.value();
        QCOMPARE(trace.partSequence, surface.partSequence);
        const auto middle = TurningForceTrace::kPieces / 2;
        QVERIFY(std::abs(trace.mean_N[middle] - 1.44F) < 0.2F);
        QVERIFY(trace.low_N[middle] < trace.mean_N[middle] && trace.mean_N[middle] < trace.high_N[middle]);
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        const TurningRecord& record = part.turning;
        QVERIFY(record.controlled);
        QVERIFY(record.steadyRms_um > 0.0 && record.steadyRms_um < 0.15 * record.openSteadyRms_um);
        QVERIFY(record.steadyPv_um > 0.0 && record.steadyPv_um < 0.3 * record.openSteadyPv_um);
        QVERIFY(std::abs(record.steadyForce_N - 1.44) < 0.02 * 1.44);
        QVERIFY(record.toneCount >= 5);
        QVERIFY(std::abs(record.forceZero_N - 0.08) < 0.005);
    }
    void unusableSetupsAreRefused() {
        test::TurningBench bench;
        QVERIFY(!bench.execute(StartPart{ProcessId::Turning}).done);
        const auto refused = [&](auto change) {
            TurningSetup setup = test::shortCut();
            change(setup);
            const CommandResult result = bench.execute(LoadTurningSetup{setup});
            return !result.done && !result.reason.empty();
        };
        QVERIFY(refused([](TurningSetup& s) { s.depth_um = 0.0; }));
        QVERIFY(refused([](TurningSetup& s) { s.depth_um = std::nan(""); }));
        QVERIFY(refused([](TurningSetup& s) { s.spindleSpeed_rpm = 10.0; }));
        QVERIFY(refused([](TurningSetup& s) { s.feed_umPerRev = -1.0; }));
        QVERIFY(refused([](TurningSetup& s) { s.trimAuthority_um = 5.0; }));
        QVERIFY(refused([](TurningSetup& s) { s.faceTo_mm = s.faceFrom_mm; }));
        QVERIFY(refused([](TurningSetup& s) { s.toolRadius_um = 1.0; }));
        QVERIFY(refused([](TurningSetup& s) { s.knownTones_Hz[0] = 1.0, s.knownToneCount = 1; }));
        QVERIFY(bench.execute(LoadTurningSetup{test::shortCut()}).done);
    }
    void cycleNeitherAllocatesLocksNorThrows() {
        if (!test::CycleGuard::available()) {
            QSKIP("a sanitizer owns malloc in this build");
        }
        test::TurningBench bench;
        std::uint64_t sins = 0;
        {
            const test::CycleGuard guard;
            (void)bench.start();
            bench.run(2.0);
            InjectedFaults faults;
            faults.force = SignalFault::NotANumber;
            bench.machine->inject(faults);
            bench.run(0.5);
            bench.machine->inject({});
            (void)bench.execute(test::releaseOf(bench.engine->status(), ProcessId::Turning));
            bench.run(4.0);
            sins = guard.allocations() + guard.locks() + guard.throws();
        }
        QCOMPARE(sins, std::uint64_t{0});
    }
};
QTEST_APPLESS_MAIN(TestTurningLoop)
#include "tst_turning_loop.moc"
