// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "engine/process/thermal/warm_up.h"
#include "tests/support/cycle_guard.h"
#include "tests/support/thermal_bench.h"

using namespace kerf;
using test::ThermalBench;

namespace {

std::uint16_t channelOf(std::size_t sensor) {
    const auto names = test::channelNames();
    const auto found = std::ranges::find(names, test::machineModel().sensors.at(sensor).name);
    return static_cast<std::uint16_t>(found - names.begin());
}

InjectedFaults coupleFault(std::size_t sensor, CoupleFaultKind kind) {
    InjectedFaults faults;
    faults.couples[0] = {channelOf(sensor), kind};
    return faults;
}

bool wholeMicrons(const ThermalStatus& status) {
    return std::ranges::all_of(status.target_um, [](double um) { return um == std::round(um); });
}

double largestShift_um(const ThermalStatus& status) {
    double largest = 0.0;
    for (const Reading& shifted : status.shifted_um) {
        largest = std::max(largest, std::abs(shifted.value));
    }
    return largest;
}

}  // namespace

/// The loop on the simulated machine's heat, without threads.
class TestThermalLoop : public QObject {
    Q_OBJECT
 private slots:
    void theOriginFollowsTheDriftInWholeMicrons() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QCOMPARE(bench.thermal().stage, ThermalStage::Following);
        QVERIFY(bench.warmUp(4000.0, 90.0));
        const auto drift_um = bench.plant->plant().drift_um();
        QVERIFY2(std::abs(drift_um[1]) > 10.0, "the machine must have drifted for this to mean anything");
        QVERIFY2(bench.worstResidual_um() < 4.0, qPrintable(QString::number(bench.worstResidual_um())));
        QVERIFY(wholeMicrons(bench.thermal()));
        QCOMPARE(bench.loop().state, LoopState::Controlling);
    }
    void adviceComputesAndDoesNotAct() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        (void)bench.execute(SetLoopMode{ProcessId::Thermal, LoopMode::Advise});
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 60.0));
        QVERIFY(std::abs(bench.thermal().target_um[1]) > 3.0);
        QCOMPARE(largestShift_um(bench.thermal()), 0.0);
        QCOMPARE(bench.loop().state, LoopState::Advising);
    }
    void withoutAModelNothingMovesAndTheReasonIsSaid() {
        ThermalBench bench;
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 20.0));
        QCOMPARE(bench.thermal().stage, ThermalStage::NoModel);
        QVERIFY(!bench.loop().reason.empty());
        QCOMPARE(largestShift_um(bench.thermal()), 0.0);
    }
    void aNewModelIsWhereTheOldOneIsBeforeItTakesOver() {
        ThermalBench early;
        early.offer(test::machineModel());
        ThermalBench late;
        for (ThermalBench* bench : {&early, &late}) {
            bench->runMinutes(3);
            (void)bench->warmUp(4000.0, 40.0);
        }
        late.offer(test::machineModel(), 7);
        for (ThermalBench* bench : {&early, &late}) {
            bench->runMinutes(3);
        }
        QCOMPARE(late.thermal().model, 7U);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            QVERIFY(std::abs(early.thermal().drift_um[axis] - late.thermal().drift_um[axis]) < 0.5);
        }
        QVERIFY(std::abs(late.thermal().drift_um[1]) > 5.0);
    }
    void aModelIsSwappedWhileTheOldOneGoesOn() {
        ThermalBench bench;
        bench.offer(test::machineModel(), 1);
        bench.runMinutes(3);
        (void)bench.warmUp(4000.0, 30.0);
        bench.offer(test::machineModel(), 2);
        QCOMPARE(bench.thermal().model, 1U);  // catching up
        QCOMPARE(bench.thermal().stage, ThermalStage::Following);
        bench.engine->runCycles(60);
        QCOMPARE(bench.thermal().model, 2U);
        bench.exchange->collect();
        bench.offer(test::machineModel(), 3);
        bench.engine->runCycles(60);
        QCOMPARE(bench.thermal().model, 3U);
    }
    void aRestartReadsTheShiftBackAndDoesNotJump() {
        SimulatedThermal::Memory memory;
        std::array<double, kAxisCount> before_um{};
        {
            ThermalBench bench;
            bench.offer(test::machineModel());
            bench.runMinutes(3);
            QVERIFY(bench.warmUp(4000.0, 60.0));
            const auto kept = bench.plant->newMemory();
            QVERIFY(kept.has_value());
            memory = *kept;
            before_um = kept->workOffset_um;
            QVERIFY(std::abs(before_um[1]) > 8.0);
        }
        ThermalBench bench({}, &memory);
        bench.offer(test::machineModel());
        double jump_um = 0.0;
        for (int i = 0; i < 6 * ThermalBench::kCyclesPerMinute; ++i) {
            bench.engine->runCycles(1);
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                jump_um = std::max(jump_um, std::abs(bench.thermal().shifted_um[axis].value - before_um[axis]));
            }
        }
        QCOMPARE(bench.thermal().stage, ThermalStage::Following);
        QVERIFY2(jump_um <= 3.0, qPrintable(QString::number(jump_um)));
        QVERIFY(bench.worstResidual_um() < 5.0);
    }
    void aReferenceWithTheOriginSetAnewTakesTheShiftBack() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 40.0));
        QVERIFY(largestShift_um(bench.thermal()) > 5.0);
        QVERIFY(bench.execute(TakeThermalReference{true}).done);
        bench.runMinutes(3);
        QVERIFY(largestShift_um(bench.thermal()) <= 2.0);
    }

    // Sensors.
    void aFailedThermocoupleIsNamedAndLeftOut_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("open") << static_cast<int>(CoupleFaultKind::Open);
        QTest::newRow("short") << static_cast<int>(CoupleFaultKind::Short);
        QTest::newRow("stuck") << static_cast<int>(CoupleFaultKind::Stuck);
        QTest::newRow("offset") << static_cast<int>(CoupleFaultKind::Offset);
        QTest::newRow("noisy") << static_cast<int>(CoupleFaultKind::Noisy);
    }
    void aFailedThermocoupleIsNamedAndLeftOut() {
        QFETCH(int, kind);
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 40.0));
        const double half_um = bench.thermal().half_um[2];
        bench.machine->inject(coupleFault(0, static_cast<CoupleFaultKind>(kind)));
        bench.runMinutes(25);
        QCOMPARE(bench.thermal().lostSensors, 1);
        QVERIFY(isSick(bench.thermal().couple[channelOf(0)]));
        QVERIFY(bench.wasRaised(thermal_alarm::kSensorLeftOut));
        const std::string& name = test::machineModel().sensors[0].name;
        QVERIFY(std::ranges::any_of(bench.details,
                                    [&](const std::string& d) { return d.find(name) != std::string::npos; }));
        QVERIFY(bench.thermal().half_um[2] >= half_um);
        QCOMPARE(bench.thermal().stage, ThermalStage::Following);
        QVERIFY2(bench.worstResidual_um() < 5.0, qPrintable(QString::number(bench.worstResidual_um())));
    }
    void withThreeLostTheLastShiftStays() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 40.0));
        const auto before = bench.thermal().shifted_um;
        InjectedFaults faults;
        for (std::size_t i = 0; i < 3; ++i) {
            faults.couples[i] = {channelOf(i), CoupleFaultKind::Open};
        }
        bench.machine->inject(faults);
        bench.runMinutes(10);
        QCOMPARE(bench.thermal().stage, ThermalStage::Holding);
        QCOMPARE(bench.loop().state, LoopState::Held);
        QVERIFY(bench.wasRaised(thermal_alarm::kTooManyLost));
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            QVERIFY(std::abs(bench.thermal().shifted_um[axis].value - before[axis].value) <= 2.0);
        }
    }
    void aCutTemperatureCableHoldsTheShift() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 40.0));
        const double before_um = bench.thermal().shifted_um[1].value;
        InjectedFaults faults;
        faults.temperatures = SignalFault::Unplugged;
        bench.machine->inject(faults);
        bench.runMinutes(10);
        QVERIFY(std::abs(bench.thermal().shifted_um[1].value - before_um) <= 1.0);
        QVERIFY(bench.wasRaised(thermal_alarm::kTooManyLost));
        bench.machine->inject({});
        bench.runMinutes(10);
    }

    // Outputs.
    void theLinkCutHoldsAndGoesOnWithoutAJump() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 40.0));
        const double before_um = bench.thermal().shifted_um[1].value;
        InjectedFaults faults;
        faults.linkDown = true;
        bench.machine->inject(faults);
        bench.runMinutes(3);
        bench.machine->inject({});
        bench.engine->runCycles(5);
        QVERIFY(std::abs(bench.thermal().shifted_um[1].value - before_um) <= 1.0);
        bench.runMinutes(3);
        QCOMPARE(bench.thermal().stage, ThermalStage::Following);
    }
    void aControlThatTakesNoShiftIsNoticed() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        InjectedFaults faults;
        faults.workOffsetIgnored = true;
        bench.machine->inject(faults);
        QVERIFY(bench.warmUp(4000.0, 40.0));
        QVERIFY(bench.wasRaised(thermal_alarm::kShiftNotTaken));
    }
    void theShiftIsLimitedInSize() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        ThermalSetup setup;
        setup.revision = 9;
        setup.maxShift_um = 5.0;
        setup.warmUpSpeed_rpm = 4000.0;
        setup.warmUp_min = 60.0;
        QVERIFY(bench.execute(LoadThermalSetup{setup}).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Thermal}).done);
        bench.runMinutes(60);
        QVERIFY(largestShift_um(bench.thermal()) <= 5.0);
        QVERIFY(bench.wasRaised(thermal_alarm::kShiftAtLimit));
        QCOMPARE(bench.loop().state, LoopState::Limited);
    }
    void aSetupOutsideItsRangeIsRefused() {
        ThermalBench bench;
        ThermalSetup setup;
        setup.revision = 1;
        setup.period_min = 0.0;
        QVERIFY(!bench.execute(LoadThermalSetup{setup}).done);
        setup.period_min = 1.0;
        setup.allowed_um = std::nan("");
        QVERIFY(!bench.execute(LoadThermalSetup{setup}).done);
    }

    // Gap sensors.
    void aMeasurementChecksThePrediction() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        QVERIFY(bench.warmUp(4000.0, 60.0));
        QVERIFY(bench.execute(MeasureOrigin{}).done);
        bench.runMinutes(0.5);
        const GapMeasurement gap = bench.thermal().gap;
        QCOMPARE(gap.phase, GapPhase::Done);
        const auto truth = bench.plant->plant().drift_um();
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            QVERIFY(std::abs(gap.measured_um[axis] - truth[axis]) < 1.5);
            QVERIFY(std::abs(gap.measured_um[axis] - gap.predicted_um[axis]) < 4.0);
        }
        QVERIFY(bench.execute(AdoptMeasurement{}).done);
        QVERIFY(!bench.execute(AdoptMeasurement{}).done);
        bench.runMinutes(3);
        QVERIFY(bench.worstResidual_um() < 2.5);
    }
    void aMeasurementIsLearntFromAtTheNextMinute() {
        static const thermal::ThermalModel model =
            std::move(*thermal::trainHierarchical(thermal::trainingDays(SimulatedThermal::kMachiningCentre), {}));
        test::ThermalBench bench;
        bench.offer(model);
        QVERIFY(bench.warmUp(3000.0, 40.0));
        bench.runMinutes(1.0);
        QVERIFY(bench.thermal().learns);
        const auto before_um = bench.thermal().half_um;
        QVERIFY(bench.execute(MeasureOrigin{}).done);
        bench.runMinutes(0.2);
        QCOMPARE(bench.thermal().gap.phase, GapPhase::Done);
        thermal::DayMeasurement learnt;
        QVERIFY(bench.exchange->learnt.tryPop(learnt));
        QCOMPARE(learnt.drift_um[2], static_cast<double>(static_cast<float>(bench.thermal().gap.measured_um[2])));
        bench.runMinutes(1.5);
        QVERIFY(std::abs(bench.thermal().drift_um[2] - bench.thermal().gap.measured_um[2]) < 2.0);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            QVERIFY2(
                bench.thermal().half_um[axis] < before_um[axis],
                qPrintable(
                    QStringLiteral("%1: %2 %3").arg(axis).arg(before_um[axis]).arg(bench.thermal().half_um[axis])));
        }
        // It acts by itself: nothing is left to take over.
        QVERIFY(!bench.execute(AdoptMeasurement{}).done);
        // A restart goes on with what the day taught.
        const std::vector<std::string> names = test::channelNames();
        auto live = LiveModel::make(model, names, 2);
        (*live)->estimator.recall(learnt);
        QCOMPARE((*live)->estimator.day().count(), std::size_t{1});
        bench.exchange->offer(std::move(*live));
        bench.runMinutes(2.0);
        QCOMPARE(bench.thermal().model, 2U);
        QVERIFY(std::abs(bench.thermal().drift_um[2] - bench.thermal().gap.measured_um[2]) < 3.0);
    }
    void gapSensorsThatReadNothingAreSaid() {
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(3);
        InjectedFaults faults;
        faults.gaps = SignalFault::Unplugged;
        bench.machine->inject(faults);
        bench.runMinutes(0.1);
        const CommandResult refused = bench.execute(MeasureOrigin{});
        QVERIFY(!refused.done);
        QVERIFY(!refused.reason.empty());
        bench.machine->inject({});
        bench.runMinutes(0.1);
        QVERIFY(bench.execute(MeasureOrigin{}).done);
        bench.machine->inject(faults);
        bench.runMinutes(1);
        QCOMPARE(bench.thermal().gap.phase, GapPhase::Failed);
    }
    void aRecordedSessionTrainsAModel() {
        ThermalBench bench;
        QVERIFY(bench.execute(RecordGaps{true}).done);
        bench.runMinutes(2);
        QVERIFY(bench.warmUp(3000.0, 20.0));
        ThermalMinute minute;
        int measured = 0;
        int baseline = 0;
        while (bench.exchange->minutes.tryPop(minute)) {
            baseline += minute.minutes < 0.0 ? 1 : 0;
            measured += minute.measured ? 1 : 0;
        }
        QCOMPARE(baseline, 5);
        QVERIFY(measured >= 19);
    }

    // Warm-up.
    void theCountdownTellsWhenTheMachineIsReady() {
        const auto axis = [](double d0, double d1, double d2) { return thermal::WarmUpAxis{{d0, d1, d2}, 1.0}; };
        const auto only = [&](const thermal::WarmUpAxis& one) {
            return std::array<thermal::WarmUpAxis, kAxisCount>{axis(0, 0, 0), axis(0, 0, 0), one};
        };
        // d = 20·(1 − e^(−t/20)), at 0, 10, 20 min; ±4 µm of the end are reached at 20·ln(5) = 32.2 min.
        const auto d = [](double t) { return 20.0 * (1.0 - std::exp(-t / 20.0)); };
        const auto out = thermal::warmUpForecast(only(axis(d(0), d(10), d(20))), 10.0, 4.0, 0.0);
        QCOMPARE(out.state, WarmUpState::Waiting);
        QVERIFY(std::abs(out.ready_min - (20.0 * std::log(5.0) - 20.0)) < 0.01);
        QCOMPARE(thermal::warmUpForecast(only(axis(19.0, 19.1, 19.1)), 10.0, 4.0, 0.0).state, WarmUpState::Ready);
        QCOMPARE(thermal::warmUpForecast(only(axis(0.0, 10.0, 25.0)), 10.0, 4.0, 0.0).state, WarmUpState::Unknown);
        QCOMPARE(thermal::warmUpForecast(only(axis(0.0, 10.0, 15.0)), 10.0, 0.5, 1.0).state, WarmUpState::TooWide);
        QCOMPARE(thermal::warmUpForecast(only(axis(0.0, 10.0, 15.0)), 10.0, 4.0, 1.0).state, WarmUpState::Ready);
    }
    void measureNowWhenTheIntervalIsWiderThanThePartAllows() {
        ThermalBench bench;
        bench.allowed_um = 0.2;
        bench.offer(test::machineModel());
        QVERIFY(bench.warmUp(1000.0, 3.0));
        bench.runMinutes(2);
        QVERIFY(bench.thermal().measureNow);
        QVERIFY(bench.wasRaised(thermal_alarm::kMeasureNow));
    }
    void theCycleNeitherAllocatesLocksNorThrows() {
        if (!test::CycleGuard::available()) QSKIP("a sanitizer owns malloc in this build");
        ThermalBench bench;
        bench.offer(test::machineModel());
        bench.runMinutes(2);
        const auto names = test::channelNames();
        std::unique_ptr<LiveModel> second = std::move(*LiveModel::make(test::machineModel(), names, 2));
        bench.exchange->offer(std::move(second));
        const InjectedFaults faults = coupleFault(0, CoupleFaultKind::Open);
        std::uint64_t found = 0;
        {
            const test::CycleGuard guard;
            (void)bench.warmUp(4000.0, 20.0);
            bench.machine->inject(faults);
            (void)bench.execute(MeasureOrigin{});
            (void)bench.warmUp(2000.0, 10.0);
            (void)bench.execute(TakeThermalReference{false});
            bench.runMinutes(3);
            found = guard.allocations() + guard.locks() + guard.throws();
        }
        QCOMPARE(found, 0U);
        QCOMPARE(bench.thermal().model, 2U);
    }
};
QTEST_APPLESS_MAIN(TestThermalLoop)
#include "tst_thermal_loop.moc"
