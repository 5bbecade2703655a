// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "engine/api/part_results.h"
#include "engine/process/tapping/tapping_alarms.h"
#include "tests/support/cycle_guard.h"
#include "tests/support/golden.h"
#include "tests/support/tapping_bench.h"

using namespace kerf;
using kerf::test::initialGains;
using kerf::test::job;
using kerf::test::setup;
using kerf::test::TappingBench;

class TestTappingLoop : public QObject {
    Q_OBJECT
 private slots:
    void recordThroughThePortIsTheReferenceTap() {
        TappingBench bench;
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        QVERIFY(bench.execute(initialGains()).done);
        QVERIFY(bench.runTap());
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Trial);
        QCOMPARE(bench.tapping().outcome, TapOutcome::Counted);
        const auto golden = kerf::test::loadGolden("golden_tapping.json");
        const TapFigures& figures = bench.tapping().last;
        KERF_CLOSE(figures.saec_mm, golden["A"]["SAEC"].get<double>(), 1e-6);
        KERF_CLOSE(figures.peak_um, golden["A"]["stats"]["peak_um"].get<double>(), 1e-6);
        KERF_CLOSE(figures.engagedPp_um, golden["A"]["stats"]["eng_pp_um"].get<double>(), 1e-6);
        (void)bench.exchange->records.refresh();
        const TapRecord& record = bench.exchange->records.value();
        QCOMPARE(record.count, 1180U);
        for (std::size_t i = 0; i < 118; ++i) {
            KERF_CLOSE(static_cast<double>(record.z_mm[10 * i]), golden["A"]["z_every10"][i].get<double>(), 1e-6);
        }
    }

    void firstTapOfAJobIsMadeInTheAir() {
        TappingBench bench;
        QVERIFY(!bench.execute(StartPart{ProcessId::Tapping}).done);
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Air);
        QVERIFY(bench.tapping().airTapPassed);
        TappingJob second = job();
        second.revision = 2;
        QVERIFY(bench.execute(LoadTappingJob{second}).done);
        QVERIFY(!bench.tapping().airTapPassed);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Air);
    }

    void abortTurnsOutInSyncAndRestoresTheGains() {
        TappingBench bench;
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        QVERIFY(bench.execute(initialGains()).done);
        QVERIFY(bench.runTap());
        LoadTapGains trial = initialGains();
        trial.gains.revision = 2;
        trial.gains.gains.zKp_perS = 42.0;
        trial.accept = false;
        QVERIFY(bench.execute(trial).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Tapping}).done);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.spindle_rev > 10.0; }));
        KERF_CLOSE(bench.gains().zKp_perS, 42.0, 1e-9);
        QVERIFY(bench.execute(AbortTap{}).done);
        double worst_um = 0.0;
        QVERIFY(bench.runUntil([&](const TappingStatus& s) {
            worst_um = std::max(worst_um, std::abs(s.error_um));
            return s.phase == TapPhase::Idle;
        }));
        QCOMPARE(bench.tapping().outcome, TapOutcome::Aborted);
        QVERIFY2(worst_um < 400.0, qPrintable(QString::number(worst_um)));  // in sync all the way
        QVERIFY(std::abs(bench.tapping().spindle_rev) < 0.05);
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
    }

    void errorLimitEndsTheTap() {
        TappingBench bench;
        TappingJob tight = job();
        tight.abortError_um = 200.0;  // the untuned drive reaches 260
        QVERIFY(bench.execute(LoadTappingJob{tight}).done);
        QVERIFY(bench.execute(initialGains()).done);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().outcome, TapOutcome::Aborted);
        QVERIFY(!bench.tapping().airTapPassed);
        QVERIFY(bench.wasRaised(tapping_alarm::kErrorLimit));
    }

    void wrongPitchIsCaughtByTheAirTap_data() {
        QTest::addColumn<double>("pitch_mm");
        QTest::newRow("one step coarser") << 1.5;
        QTest::newRow("20 per inch") << 1.27;
    }
    void wrongPitchIsCaughtByTheAirTap() {
        QFETCH(double, pitch_mm);
        SimulatedTapping::Params params;
        params.programPitch_mm = pitch_mm;
        TappingBench bench(params);
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        QVERIFY(bench.runTap());
        QVERIFY(!bench.tapping().airTapPassed);
        QVERIFY(bench.wasRaised(tapping_alarm::kWrongPitch));
    }

    void emergencyStopInTheHoleIsRecovered() {
        TappingBench bench;
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        QVERIFY(bench.execute(initialGains()).done);
        QVERIFY(bench.runTap());
        QVERIFY(bench.execute(StartPart{ProcessId::Tapping}).done);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.spindle_rev > 12.0; }));
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.phase == TapPhase::InHole; }));
        QVERIFY(bench.tapping().stoppedSpindle_rev > 12.0);
        KERF_CLOSE(bench.tapping().stoppedZ_mm, 1.25 * bench.tapping().stoppedSpindle_rev, 0.02);
        QVERIFY(bench.wasRaised(tapping_alarm::kInHole));
        QVERIFY(!bench.execute(StartPart{ProcessId::Tapping}).done);
        QVERIFY(!bench.execute(RecoverTap{}).done);  // stopped: not in control
        bench.machine->inject({});
        bench.engine->runCycles(3);
        QVERIFY(!bench.execute(RecoverTap{}).done);  // nobody has looked
        QVERIFY(bench.execute(ReleaseHold{}).done);
        QVERIFY(bench.execute(RecoverTap{}).done);
        double worst_um = 0.0;
        QVERIFY(bench.runUntil([&](const TappingStatus& s) {
            worst_um = std::max(worst_um, std::abs(s.error_um));
            return s.phase == TapPhase::Idle;
        }));
        QVERIFY2(worst_um < 400.0, qPrintable(QString::number(worst_um)));
        QVERIFY(std::abs(bench.tapping().z_mm) < 0.1);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().outcome, TapOutcome::Counted);
    }

    void lostSpindleSignalEndsTheTap() {
        TappingBench bench;
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        QVERIFY(bench.runTap());
        QVERIFY(bench.execute(StartPart{ProcessId::Tapping}).done);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.spindle_rev > 8.0; }));
        InjectedFaults faults;
        faults.spindleAngle = SignalFault::Unplugged;
        bench.machine->inject(faults);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.phase == TapPhase::Retracting; }));
        bench.machine->inject({});
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.phase == TapPhase::Idle; }));
        QCOMPARE(bench.tapping().outcome, TapOutcome::Aborted);
        QVERIFY(bench.wasRaised(tapping_alarm::kSignalLost));
    }

    // Faults during a tap.
    void abortPressedTwiceStillRestoresTheGains() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        LoadTapGains trial = initialGains();
        trial.gains.revision = 2;
        trial.gains.gains.zKp_perS = 42.0;
        trial.accept = false;
        QVERIFY(bench.execute(trial).done);
        QVERIFY(bench.runInto(10.0));
        QVERIFY(bench.execute(AbortTap{}).done);
        bench.engine->runCycles(20);
        QVERIFY(bench.execute(AbortTap{}).done);
        QVERIFY(bench.runToIdle());
        bench.engine->runCycles(5);
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
    }
    void abortBeforeTheTapBeginsEndsWithTheTapOut_data() {
        QTest::addColumn<int>("cycles");
        for (const int cycles : {0, 1, 2, 3, 4, 5})
            QTest::addRow("%d cycles", cycles) << cycles;
    }
    void abortBeforeTheTapBeginsEndsWithTheTapOut() {
        QFETCH(int, cycles);
        TappingBench bench;
        QVERIFY(bench.makeReady());
        LoadTapGains other = initialGains();
        other.gains.revision = 2;
        other.gains.gains.zKp_perS = 42.0;
        other.accept = false;
        QVERIFY(bench.execute(other).done);
        Command start;
        start.action = StartPart{ProcessId::Tapping};
        QVERIFY(bench.engine->send(start).has_value());
        bench.engine->runCycles(static_cast<std::uint64_t>(cycles));
        QVERIFY(bench.execute(AbortTap{}).done);
        QVERIFY(bench.runToIdle());
        bench.engine->runCycles(3000);  // nothing starts later
        QCOMPARE(bench.tapping().phase, TapPhase::Idle);
        QVERIFY(std::abs(bench.tapping().spindle_rev) < 0.05);
        QVERIFY(bench.engine->status().program != ProgramState::Running);
    }
    void holdAllDuringATapLetsTheControlEndItAndItDoesNotCount() {
        TappingBench bench;
        QVERIFY(bench.makeReady(true));
        QVERIFY(bench.runInto(8.0));
        bench.engine->holdAll();
        QVERIFY(bench.runToIdle());
        QCOMPARE(bench.tapping().outcome, TapOutcome::NotCounted);
        QVERIFY(bench.wasRaised(tapping_alarm::kNotCounted));
        QCOMPARE(bench.tapping().productionTaps, 0U);
    }
    void holdAllBetweenStartAndTapKeepsTheSpindleStill() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        LoadTapGains other = initialGains();
        other.gains.revision = 2;
        other.gains.gains.zKp_perS = 42.0;
        QVERIFY(bench.execute(other).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Tapping}).done);
        QCOMPARE(bench.tapping().phase, TapPhase::SettingGains);
        bench.engine->holdAll();
        bench.engine->runCycles(2000);
        QCOMPARE(bench.tapping().phase, TapPhase::Idle);
        QVERIFY(!bench.tapping().problem.empty());
        QVERIFY(bench.engine->status().program != ProgramState::Running);
    }
    void moreThanFivePercentMissingDoesNotCount_data() {
        QTest::addColumn<int>("gaps");
        QTest::addColumn<bool>("counts");
        QTest::newRow("4.2 %") << 5 << true;  // of 1180 samples, ten each
        QTest::newRow("5.9 %") << 7 << false;
    }
    void moreThanFivePercentMissingDoesNotCount() {
        QFETCH(int, gaps);
        QFETCH(bool, counts);
        TappingBench bench;
        QVERIFY(bench.makeReady());
        const double clean_mm = bench.tapping().last.saec_mm;
        QVERIFY(bench.runInto(3.0));
        for (int gap = 0; gap < gaps; ++gap) {
            bench.inject(SignalFault::Unplugged, 10);
            bench.engine->runCycles(100);
        }
        QVERIFY(bench.runToIdle());
        QCOMPARE(bench.tapping().outcome, counts ? TapOutcome::Counted : TapOutcome::NotCounted);
        QCOMPARE(bench.wasRaised(tapping_alarm::kNotCounted), !counts);
        QVERIFY(bench.tapping().last.missing >= static_cast<std::uint32_t>(10 * gaps));
        QVERIFY(clean_mm > 0.0);
    }
    void cutCableLeavesPlacesInTheRecordAndEndsTheTap() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        QVERIFY(bench.runInto(8.0));
        InjectedFaults faults;
        faults.linkDown = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(100);
        bench.machine->inject({});
        QVERIFY(bench.runToIdle());
        // The loop was off while the link was down: the tap counts for nothing; every tick has its place.
        QVERIFY(bench.tapping().outcome != TapOutcome::Counted);
        QVERIFY(bench.tapping().last.missing >= 100U);
        QVERIFY(bench.wasRaised(tapping_alarm::kSignalLost));
        (void)bench.exchange->records.refresh();
        const TapRecord& record = bench.exchange->records.value();
        QCOMPARE(record.count, record.figures.samples + record.figures.missing);
        QVERIFY(std::abs(bench.tapping().spindle_rev) < 0.05);
    }
    void errorBeyondTheLimitInAnEngagedTapIsTurnedOutAndRolledBack() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        LoadTapGains bad = initialGains();
        bad.gains.revision = 2;
        bad.gains.gains.zKp_perS = 12.0;
        bad.accept = false;
        QVERIFY(bench.execute(bad).done);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().outcome, TapOutcome::Aborted);
        QVERIFY(bench.wasRaised(tapping_alarm::kErrorLimit));
        bench.engine->runCycles(5);
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().outcome, TapOutcome::Counted);
    }
    void advisingOnlySaysSoButAPersonMayStillTurnTheTapOut() {
        TappingBench bench;
        TappingJob tight = job();
        tight.abortError_um = 200.0;  // the untuned drive reaches 260
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Tapping, LoopMode::Advise}).done);
        QVERIFY(bench.execute(LoadTappingJob{tight}).done);
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().outcome, TapOutcome::Counted);  // it went on
        QVERIFY(bench.wasRaised(tapping_alarm::kErrorLimit));
        QVERIFY(bench.runInto(10.0));
        QVERIFY(bench.execute(AbortTap{}).done);
        double deepest_rev = 0.0;
        QVERIFY(bench.runUntil([&](const TappingStatus& s) {
            deepest_rev = std::max(deepest_rev, s.spindle_rev);
            return s.phase == TapPhase::Idle;
        }));
        QVERIFY(deepest_rev < 18.0);
        QCOMPARE(bench.tapping().outcome, TapOutcome::Aborted);
        QVERIFY(bench.runInto(5.0));
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Tapping, LoopMode::Off}).done);
        QVERIFY(!bench.execute(AbortTap{}).done);  // off: nothing of Kerf's acts
    }
    void recoverySetsTheAcceptedGainsBeforeItTurns() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        LoadTapGains trial = initialGains();
        trial.gains.revision = 2;
        trial.gains.gains.zKp_perS = 42.0;
        trial.accept = false;
        QVERIFY(bench.execute(trial).done);
        QVERIFY(bench.runInto(12.0));
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(10);
        bench.machine->inject({});
        bench.engine->runCycles(3);
        QCOMPARE(bench.tapping().phase, TapPhase::InHole);
        QVERIFY(!bench.execute(AbortTap{}).done);
        QVERIFY(bench.execute(ReleaseHold{}).done);
        QVERIFY(bench.execute(RecoverTap{}).done);
        QVERIFY(bench.runUntil([](const TappingStatus& s) { return s.phase == TapPhase::Retracting; }));
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
        QVERIFY(bench.runToIdle());
        QVERIFY(std::abs(bench.tapping().z_mm) < 0.1);
    }
    void recoveryAskedBeforeAHoldDoesNotBeginAfterIt() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        QVERIFY(bench.runInto(12.0));
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(10);
        bench.machine->inject({});
        bench.engine->runCycles(3);
        bench.engine->holdAll();
        (void)bench.execute(RecoverTap{});  // in the very cycle of the hold
        QVERIFY(!bench.execute(RecoverTap{}).done);
        QVERIFY(bench.execute(ReleaseHold{1}).done);
        bench.engine->runCycles(2000);
        QCOMPARE(bench.tapping().phase, TapPhase::InHole);
    }
    void learnedTrimThatIsNotLoadedRefusesTheTap() {
        TappingBench bench;
        QVERIFY(bench.makeReady());
        LoadTapGains trimmed = initialGains();
        trimmed.gains.revision = 2;
        trimmed.gains.trimRevision = 2;
        QVERIFY(bench.execute(trimmed).done);
        QVERIFY(!bench.execute(StartPart{ProcessId::Tapping}).done);
    }
    void productionTapsArePartsWithTheirFigures() {
        TappingBench bench;
        QVERIFY(bench.makeReady(true));
        QVERIFY(bench.runTap());
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        QCOMPARE(part.process, ProcessId::Tapping);
        QVERIFY(part.complete);
        QVERIFY(!part.tap.withinTolerance);  // the untuned drive: 520 µm
        QCOMPARE(part.tap.figures.saec_mm, bench.tapping().last.saec_mm);
        QVERIFY(!partResults(part).empty());
        QCOMPARE(bench.tapping().partsCut, 1U);
        QVERIFY(bench.runInto(10.0));
        QVERIFY(bench.execute(AbortTap{}).done);
        QVERIFY(bench.runToIdle());
        QVERIFY(bench.engine->partRecords().tryPop(part));
        QVERIFY(!part.complete);
        QVERIFY(!bench.engine->partRecords().tryPop(part));  // neither the air tap nor anything twice
        QCOMPARE(bench.tapping().partsCut, 1U);
    }

    void advisingLeavesTheMachinesGains() {
        TappingBench bench;
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Tapping, LoopMode::Advise}).done);
        QVERIFY(bench.execute(LoadTappingJob{job()}).done);
        LoadTapGains other = initialGains();
        other.gains.gains.zKp_perS = 42.0;
        QVERIFY(bench.execute(other).done);
        QVERIFY(bench.runTap());
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
        QCOMPARE(bench.tapping().outcome, TapOutcome::Counted);
    }

    void badJobsAndGainsAreRefused() {
        TappingBench bench;
        TappingJob bad = job();
        bad.pitch_mm = 0.0;
        QVERIFY(!bench.execute(LoadTappingJob{bad}).done);
        LoadTapGains gains = initialGains();
        gains.gains.gains.zKp_perS = std::nan("");
        QVERIFY(!bench.execute(gains).done);
        QVERIFY(!bench.execute(RecoverTap{}).done);
    }

    void driftWatchAsksForATuneOnlyWhenErrorsGrow() {
        DriftWatch watch;
        for (int tap = 0; tap < 200; ++tap)
            watch.add(2.0 + 0.15 * (tap % 2));
        QVERIFY(!watch.grown());
        int taps = 0;
        for (; !watch.grown() && taps < 50; ++taps)
            watch.add(2.0 * (1.1 + 0.02 * taps));
        QVERIFY(taps > 3 && taps < 20);
    }

    void cycleNeitherAllocatesLocksNorThrows() {
        if (!test::CycleGuard::available()) QSKIP("a sanitizer owns malloc in this build");
        TappingBench bench;
        std::uint64_t found = 0;
        {
            const test::CycleGuard guard;
            (void)bench.execute(LoadTappingJob{job()});
            (void)bench.execute(initialGains());
            (void)bench.runTap();
            (void)bench.execute(StartPart{ProcessId::Tapping});
            bench.engine->runCycles(300);
            (void)bench.execute(AbortTap{});
            bench.engine->runCycles(1500);
            found = guard.allocations() + guard.locks() + guard.throws();
        }
        QCOMPARE(bench.tapping().taps, 2U);
        QCOMPARE(found, 0U);
    }
};

QTEST_GUILESS_MAIN(TestTappingLoop)
#include "tst_tapping_loop.moc"
