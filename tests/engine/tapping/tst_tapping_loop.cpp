// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <memory>
#include <set>
#include <vector>

#include "engine/loop/engine.h"
#include "engine/machine/simulated_machine.h"
#include "engine/machine/simulated_tapping.h"
#include "engine/tapping/session_desk.h"
#include "engine/tapping/tapping_alarms.h"
#include "engine/tapping/tapping_loop.h"
#include "engine/tapping/trial_machine.h"
#include "engine/tapping/tuning_session.h"
#include "tests/support/cycle_guard.h"
#include "tests/support/golden.h"

using namespace kerf;

namespace {

/// Simulated tapping machine, loop and engine, not started.
struct TappingBench {
    explicit TappingBench(const SimulatedTapping::Params& params = {}) : exchange(std::make_unique<TapExchange>()) {
        std::vector<std::unique_ptr<SimulatedProcess>> plants;
        plants.push_back(std::make_unique<SimulatedTapping>(params));
        machine = std::make_unique<SimulatedMachine>(SimulatedMachine::Params{}, std::move(plants));
        (void)machine->connect();
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<TappingLoop>(*exchange));
        engine = std::make_unique<Engine>(*machine, std::move(loops));
        engine->runCycles(1);
        (void)execute(SetLoopMode{ProcessId::Tapping, LoopMode::Control});
    }
    template <class Action>
    CommandResult execute(const Action& action) {
        Command command;
        command.action = action;
        (void)engine->send(command);
        engine->runCycles(1);
        return engine->status().lastCommand;
    }
    template <class Condition>
    bool runUntil(Condition condition, int most = 20'000) {
        for (int i = 0; i < most; ++i) {
            engine->runCycles(1);
            if (condition(engine->status().tapping)) return true;
        }
        return false;
    }
    bool runTap() {
        const std::uint32_t before = tapping().taps;
        return execute(StartPart{ProcessId::Tapping}).done &&
               runUntil([before](const TappingStatus& s) { return s.taps > before && s.phase == TapPhase::Idle; });
    }
    [[nodiscard]] const TappingStatus& tapping() { return engine->status().tapping; }
    [[nodiscard]] const ServoGains& gains() { return engine->cycle().inputs().servoGains; }
    void drainAlarms() {
        AlarmEvent event;
        while (engine->nextAlarm(event)) {
            if (event.raised) raised.insert(event.code);
            QVERIFY(engine->alarmSpec(event.code) != nullptr);
        }
    }
    [[nodiscard]] bool wasRaised(AlarmCode code) {
        drainAlarms();
        return raised.contains(code);
    }

    std::unique_ptr<TapExchange> exchange;
    std::unique_ptr<SimulatedMachine> machine;
    std::unique_ptr<Engine> engine;
    std::set<AlarmCode> raised;
};

TappingJob job() {
    TappingJob job;
    job.revision = 1;
    return job;
}

LoadTapGains initialGains() {
    LoadTapGains load;
    load.gains.revision = 1;
    load.gains.gains.spindleKp_perS = 40.0;
    load.gains.gains.zKp_perS = 48.0;
    load.accept = true;
    return load;
}

tapping::TunerSetup setup(const tapping::DriveParams& drive) {
    tapping::TunerSetup setup;
    setup.assumed = tapping::knownTo(drive, {});
    setup.initial = tapping::settingsOf(drive);
    setup.maxTaps = 6;
    return setup;
}

}  // namespace

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

    void sessionTunesWithinTolerance() {
        SimulatedTapping::Params params;
        params.noise_um = 2.0;
        params.loadSpread = 0.2;
        params.frictionSpread = 0.1;
        TappingBench bench(params);
        TuningSession session(*bench.engine, *bench.exchange, setup(params.drive), job(), true);
        for (int i = 0; i < 30'000 && session.state() != TuningSession::State::Done; ++i) {
            bench.engine->runCycles(1);
            session.poll();
            QVERIFY2(session.state() != TuningSession::State::Failed, session.reason().english().c_str());
        }
        QCOMPARE(session.state(), TuningSession::State::Done);
        QVERIFY(session.trials().size() <= 6);
        QVERIFY(session.trials().back().figures.saec_mm < 0.03 * session.trials().front().figures.saec_mm);
        bench.engine->runCycles(5);
        // Production with what was learned: the gains read back, the trim acts.
        QVERIFY(bench.runTap());
        QCOMPARE(bench.tapping().kind, TapKind::Production);
        QVERIFY(bench.tapping().last.engagedPp_um < 28.0);
        QCOMPARE(bench.tapping().productionTaps, 1U);
        KERF_CLOSE(bench.gains().zKp_perS, session.kept().zKp_perS, 1e-9);
        QVERIFY(bench.raised.empty());
    }

    void proposalWaitsForTheOperator() {
        TappingBench bench;
        TuningSession session(*bench.engine, *bench.exchange, setup({}), job(), false);
        const auto run = [&](TuningSession::State wanted) {
            for (int i = 0; i < 10'000 && session.state() != wanted; ++i) {
                bench.engine->runCycles(1);
                session.poll();
            }
            return session.state() == wanted;
        };
        QVERIFY(run(TuningSession::State::Proposed));
        const std::uint32_t taps = bench.tapping().taps;
        bench.engine->runCycles(2000);
        session.poll();
        QCOMPARE(bench.tapping().taps, taps);
        QVERIFY(!session.proposal().reason.empty());
        session.confirm();
        QVERIFY(run(TuningSession::State::Trial));
        QVERIFY(run(TuningSession::State::Proposed));
        session.rollBack();
        QCOMPARE(session.state(), TuningSession::State::Done);
        QVERIFY(bench.runTap());
        KERF_CLOSE(bench.gains().zKp_perS, 48.0, 1e-9);
    }

    void deskShowsTrialsCurvesAndSafeSet() {
        TappingBench bench;
        SessionTappingDesk desk(*bench.engine, *bench.exchange, tapping::DriveParams{});
        QVERIFY(!desk.begin("M7", 3000.0, 22.0).has_value());
        QVERIFY(desk.begin("M8", 3000.0, 22.0).has_value());
        QVERIFY(!desk.begin("M8", 3000.0, 22.0).has_value());  // one at a time
        for (int i = 0; i < 40'000 && desk.view().state != TuningState::Done; ++i) {
            bench.engine->runCycles(1);
            desk.poll();
            QVERIFY2(desk.view().state != TuningState::Failed, desk.view().reason.english().c_str());
            if (desk.view().state == TuningState::Proposed) {
                QVERIFY(desk.view().nextZKp_perS <= desk.view().highestZKp_perS);
                desk.oneMore();
            }
        }
        const TappingDeskView& view = desk.view();
        QCOMPARE(view.state, TuningState::Done);
        QVERIFY(view.trials.size() >= 2);
        QCOMPARE(view.first.error_um.size(), 1180U);
        QVERIFY(view.first.reversal > 500 && view.first.reversal < 600);
        QVERIFY(view.trials.back().figures.engagedPp_um < view.thread.allowedPpWornTap_um);
        QCOMPARE(view.speeds.size(), 1U);
        KERF_CLOSE(view.speeds.front().hole_s, 1.08, 1e-9);
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
