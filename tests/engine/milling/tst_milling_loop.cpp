// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <limits>

#include "engine/cycle/machine_alarms.h"
#include "engine/process/milling/cut_simulation.h"
#include "engine/process/milling/milling_alarms.h"
#include "engine/process/milling/milling_setup.h"
#include "tests/support/milling_bench.h"
#include "tests/support/release_stop.h"

using namespace kerf;
using test::MillingBench;

/// Milling loop, cycle and simulated machine together, on the caller's thread; faults are injected in the port.
class TestMillingLoop : public QObject {
    Q_OBJECT

 private slots:
    void controlHoldsTheForce() {
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control));
        QVERIFY(bench.cutTo(30.0));
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 40.0);
        PartRecord part;
        QVERIFY(bench.finish(part));
        QVERIFY(part.complete);
        QVERIFY(!part.milling.advised);
        QVERIFY2(part.milling.waviness_um > 0.0 && part.milling.waviness_um < 40.0,
                 qPrintable(QString::number(part.milling.waviness_um)));
        QVERIFY2(part.milling.peakForce_N < 45.0 * 9.80665, qPrintable(QString::number(part.milling.peakForce_N)));
        QCOMPARE(part.milling.stops, 0U);
    }
    void adviceSaysWhatControlWouldDo() {
        MillingBench advised;
        QVERIFY(advised.start(LoopMode::Advise));
        QVERIFY(advised.cutTo(50.0));
        QCOMPARE(advised.loop().state, LoopState::Advising);
        QCOMPARE(advised.status().feedScale, 1.0);
        PartRecord plan;
        QVERIFY(advised.finish(plan));
        QVERIFY(plan.milling.advised);
        MillingBench controlled;
        PartRecord real;
        QVERIFY(controlled.start(LoopMode::Control) && controlled.finish(real));
        QVERIFY(plan.milling.peakForce_N > 1.4 * real.milling.peakForce_N);
        QVERIFY(plan.milling.overReference_s > 5.0 && real.milling.overReference_s < 1.0);
        QVERIFY(plan.milling.waviness_um > 5.0 * real.milling.waviness_um);
        // The promise is kept within a few per cent.
        QVERIFY2(std::abs(plan.milling.controlledTime_s / real.milling.cutTime_s - 1.0) < 0.1,
                 qPrintable(QString("%1 %2").arg(plan.milling.controlledTime_s).arg(real.milling.cutTime_s)));
    }
    void untrustedForceNeverMeansFaster_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<double>("at_mm");
        for (int fault = 1; fault <= 5; ++fault) {
            for (const double at_mm : {14.0, 30.0, 58.0}) {  // before a step up, in a steady cut, before a step down
                QTest::addRow("fault %d at %g mm", fault, at_mm) << fault << at_mm;
            }
        }
    }
    void untrustedForceNeverMeansFaster() {
        QFETCH(int, fault);
        QFETCH(double, at_mm);
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control));
        QVERIFY(bench.cutTo(at_mm));
        const double before_mmPerS = bench.status().milling.wantedFeed_mmPerS;
        InjectedFaults faults;
        faults.force = static_cast<SignalFault>(fault);
        bench.machine->inject(faults);
        bench.runRevolutions(1.0);
        QVERIFY(bench.status().milling.blind);
        QVERIFY(bench.alarmRaised(milling_alarm::kForceUnknown));
        QCOMPARE(bench.loop().state, LoopState::Limited);
        // The law may have moved the feed within the half revolution that had still been good.
        const double blind_mmPerS = bench.status().milling.wantedFeed_mmPerS;
        QVERIFY(blind_mmPerS <= 1.5 + 1e-9);
        QVERIFY(blind_mmPerS <= before_mmPerS * 1.3);
        double last_mmPerS = blind_mmPerS;
        for (int i = 0; i < 2000; ++i) {
            bench.engine->runCycles(1);
            QVERIFY(bench.status().milling.wantedFeed_mmPerS <= last_mmPerS);
            QVERIFY(bench.status().feedScale * 4.0 <= blind_mmPerS + 1e-9);
            last_mmPerS = bench.status().milling.wantedFeed_mmPerS;
        }
        bench.machine->inject(InjectedFaults{});
        bench.runRevolutions(3.0);
        QVERIFY(!bench.status().milling.blind);
    }
    void brokenToolHoldsTheFeedWithinOneRevolution() {
        for (const double at_mm : {10.0, 30.3, 50.0}) {
            MillingBench bench;
            QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(at_mm));
            InjectedFaults faults;
            faults.toolBroken = true;
            bench.machine->inject(faults);
            bench.runRevolutions(1.0);
            QVERIFY(bench.status().milling.stopped);
            QVERIFY(bench.status().feedHold);
            QVERIFY(bench.alarmRaised(milling_alarm::kToolBroken));
            QCOMPARE(bench.loop().state, LoopState::Held);
            bench.engine->runCycles(500);
            QVERIFY(bench.status().actualFeed_mmPerS.value < 0.01);  // and stays held
        }
    }
    void breakageIsSeenWhereverInTheRevolutionItHappens() {
        for (int i = 0; i < 40; ++i) {  // the last revolutions before it differ in place and in angle
            MillingBench bench;
            QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(26.0 + 0.8 * (i % 4)));
            bench.runRevolutions(1.0 + i / 40.0);
            InjectedFaults faults;
            faults.toolBroken = true;
            bench.machine->inject(faults);
            bench.runRevolutions(1.0);
            QVERIFY2(bench.status().milling.stopped, qPrintable(QString::number(i)));
            QVERIFY(bench.alarmRaised(milling_alarm::kToolBroken));
        }
    }
    void stepsAndExitAreNotBreakage_data() {
        QTest::addColumn<std::vector<double>>("heights_mm");
        QTest::newRow("highest steps") << std::vector<double>{3, 1, 3, 0.5, 3, 1};
        Random random(31);
        for (int i = 0; i < 12; ++i) {
            std::vector<double> heights_mm(6);
            for (double& height_mm : heights_mm) {
                height_mm = 0.5 + 2.5 * random.uniform();
            }
            QTest::addRow("random %d", i) << heights_mm;
        }
    }
    void stepsAndExitAreNotBreakage() {
        QFETCH(std::vector<double>, heights_mm);
        SimulatedMilling::Params params;
        params.blanks.push_back(*milling::BlankProfile::ofSegments(heights_mm, 12.0));
        MillingBench bench(params);
        PartRecord part;
        MillingSetup setup = test::millingSetup();
        setup.to_mm = 85.0;
        QVERIFY(bench.start(LoopMode::Control, setup) && bench.finish(part));
        QCOMPARE(part.milling.stops, 0U);
    }
    void overloadHoldsTheFeedWithinOneRevolution() {
        MillingBench bench;
        MillingSetup setup = test::millingSetup();
        setup.overload_N = 1.11 * setup.reference_N;
        setup.law = MillingLaw::Constant;  // does not back off
        QVERIFY(bench.start(LoopMode::Control, setup));
        QVERIFY(bench.runUntil([&](const Status& s) { return s.milling.force_N.value > 0.98 * setup.overload_N; }));
        QVERIFY(bench.runUntil([](const Status& s) { return s.milling.stopped; }, 300));
        QVERIFY(bench.milling->trueForce_N() < 1.5 * setup.overload_N);
        QVERIFY(bench.alarmRaised(milling_alarm::kOverload));
        QVERIFY(bench.status().milling.stopped);
    }
    void overloadIsKnownWithinOneRevolution() {
        const milling::ForceShape shape;
        for (const double at_rev : {10.0, 10.1, 10.37, 10.62, 10.9}) {  // where the force leaps
            milling::ForceWatch watch;
            double known_rev = 0.0;
            for (int i = 0; i < 10000 && known_rev == 0.0; ++i) {
                FastSample sample;
                sample.spindleAngle_rev = i / 500.0;
                sample.stamp_ns = static_cast<std::int64_t>(i) * 200'000;
                sample.quality = Quality::Good;
                sample.force_N = milling::sampledForce_N(shape, sample.spindleAngle_rev < at_rev ? 400.0 : 900.0,
                                                         sample.spindleAngle_rev);
                watch.add(sample);
                known_rev = watch.revolutionMean_N() > 650.0 ? sample.spindleAngle_rev : 0.0;
            }
            QVERIFY2(known_rev > at_rev && known_rev - at_rev <= 1.0, qPrintable(QString::number(known_rev)));
        }
    }
    void faultReactionsKeepTheirRevolutionAtEverySpeed() {
        for (const double speed_rpm : {120.0, 3000.0}) {
            MillingSetup setup = test::millingSetup();
            const double faster = speed_rpm / 600.0;
            setup.spindleSpeed_rpm = speed_rpm;
            setup.plannedFeed_mmPerS *= faster;
            setup.highestFeed_mmPerS *= faster;
            setup.lowestFeed_mmPerS *= faster;
            setup.entryFeed_mmPerS *= faster;
            setup.overload_N = 1500.0;  // the drive lags by several revolutions at 3000 rpm
            for (const bool broken : {false, true}) {
                MillingBench bench;
                QVERIFY(bench.start(LoopMode::Control, setup) && bench.cutTo(12.0));
                InjectedFaults faults;
                faults.toolBroken = broken;
                faults.force = broken ? SignalFault::None : SignalFault::Unplugged;
                bench.machine->inject(faults);
                bench.runRevolutions(1.0);
                QCOMPARE(bench.status().milling.stopped, broken);
                QVERIFY(broken || bench.status().milling.blind);
                QVERIFY(broken || bench.status().milling.wantedFeed_mmPerS <= setup.plannedFeed_mmPerS + 1e-9);
            }
        }
    }
    void constantLawTellsThatNothingIsWatched() {
        MillingBench bench;
        MillingSetup setup = test::millingSetup();
        setup.law = MillingLaw::Constant;
        QVERIFY(bench.start(LoopMode::Control, setup) && bench.cutTo(12.0));
        InjectedFaults faults;
        faults.force = SignalFault::Unplugged;
        bench.machine->inject(faults);
        bench.runRevolutions(2.0);
        QVERIFY(bench.alarmRaised(milling_alarm::kForceUnknown));
        QVERIFY(bench.status().actualFeed_mmPerS.value <= 1.5 + 1e-3);
    }
    void controlTakesOverFromAdviceWithoutABump() {
        for (const MillingLaw law : {MillingLaw::Pi, MillingLaw::Model}) {
            for (const double at_mm : {14.0, 50.0}) {  // planned feed too slow, too fast for the reference
                MillingBench bench({}, 3.0);
                MillingSetup setup = test::millingSetup();
                setup.law = law;
                QVERIFY(bench.start(LoopMode::Advise, setup) && bench.cutTo(at_mm));
                const double before_mmPerS = bench.status().actualFeed_mmPerS.value;
                QVERIFY(bench.execute(SetLoopMode{ProcessId::Milling, LoopMode::Control}).done);
                QVERIFY(std::abs(bench.status().milling.wantedFeed_mmPerS - before_mmPerS) < 1e-6);
                double highest_N = 0.0;
                for (int i = 0; i < 4000; ++i) {
                    const double feed_mmPerS = bench.status().actualFeed_mmPerS.value;
                    bench.engine->runCycles(1);
                    QVERIFY(std::abs(bench.status().actualFeed_mmPerS.value - feed_mmPerS) < 0.05);
                    highest_N = i < 1000 ? 0.0 : std::max(highest_N, bench.milling->trueForce_N());
                }
                QVERIFY2(highest_N < 470.0, qPrintable(QString::number(highest_N)));
                QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 60.0);
            }
        }
    }
    void stoppedFeedGoesOnOnlyWhenReleased() {
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(30.0));
        InjectedFaults faults;
        faults.toolBroken = true;
        bench.machine->inject(faults);
        bench.runRevolutions(1.0);
        bench.machine->inject(InjectedFaults{});
        bench.engine->runCycles(3000);
        QVERIFY(bench.status().milling.stopped);
        QVERIFY(bench.execute(test::releaseOf(bench.status(), ProcessId::Milling)).done);
        double highest_N = 0.0;
        for (int i = 0; i < 4000; ++i) {
            bench.engine->runCycles(1);
            highest_N = std::max(highest_N, bench.milling->trueForce_N());
        }
        QVERIFY(!bench.status().milling.stopped);
        QVERIFY2(highest_N < 45.0 * 9.80665, qPrintable(QString::number(highest_N)));
        QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 60.0);
    }
    void spindleStopHoldsTheFeed() {
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(30.0));
        InjectedFaults faults;
        faults.spindleOverride = 0.3;
        bench.machine->inject(faults);
        bench.runRevolutions(1.0);
        QVERIFY(bench.status().milling.stopped);
        QVERIFY(bench.alarmRaised(milling_alarm::kSpindleStopped));
        for (int fault = 1; fault <= 3; ++fault) {
            MillingBench other;
            QVERIFY(other.start(LoopMode::Control) && other.cutTo(30.0));
            InjectedFaults unknown;
            unknown.spindleSpeed = static_cast<SignalFault>(fault);
            other.machine->inject(unknown);
            other.runRevolutions(1.0);
            QVERIFY(other.status().milling.stopped);
        }
    }
    void aSpindleThatRunsUpIsNotStopped() {
        InjectedFaults slow;
        slow.spindleOverride = 0.1;
        MillingBench bench;
        bench.machine->inject(slow);
        QVERIFY(bench.start(LoopMode::Control));
        bench.engine->runCycles(150);
        QVERIFY(!bench.status().milling.stopped);
        bench.machine->inject(InjectedFaults{});
        PartRecord part;
        QVERIFY(bench.finish(part));
        QCOMPARE(part.milling.stops, 0U);
        MillingBench never;
        never.machine->inject(slow);
        QVERIFY(never.start(LoopMode::Control));
        never.engine->runCycles(400);
        QVERIFY(never.status().milling.stopped);
        QVERIFY(never.status().milling.position_mm < -4.0);  // still in the air
    }
    void unknownFeedNeverMeansFaster() {
        for (int fault = 1; fault <= 3; ++fault) {
            MillingBench bench;
            QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(58.0));
            const double before_mmPerS = bench.status().milling.wantedFeed_mmPerS;
            InjectedFaults faults;
            faults.actualFeed = static_cast<SignalFault>(fault);
            bench.machine->inject(faults);
            bench.engine->runCycles(4000);
            QVERIFY(bench.status().milling.wantedFeed_mmPerS <= before_mmPerS);
            QVERIFY(bench.alarmRaised(milling_alarm::kFeedUnknown));
        }
    }
    void lostLinkNeverMeansFaster() {
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(58.0));
        const double before_mmPerS = bench.status().actualFeed_mmPerS.value;
        InjectedFaults faults;
        faults.linkDown = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(1);
        QCOMPARE(bench.loop().state, LoopState::Held);
        QVERIFY(bench.alarmRaised(machine_alarm::kLinkDown));
        for (int i = 0; i < 3000; ++i) {
            bench.engine->runCycles(1);
            QVERIFY(bench.status().actualFeed_mmPerS.value <= before_mmPerS * 1.001);
        }
    }
    void holdAllIsBumpless() {
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(50.0));
        const double scale = bench.status().feedScale;
        bench.engine->holdAll();
        bench.engine->runCycles(1);
        QCOMPARE(bench.status().feedScale, scale);
        QCOMPARE(bench.loop().state, LoopState::Held);
        bench.engine->runCycles(500);
        QVERIFY(bench.status().feedScale <= scale);
    }
    void changeOfLawWhileCuttingIsBumpless() {
        MillingBench bench;
        MillingBlank blank;
        blank.count = 5;
        for (std::size_t i = 0; i < 5; ++i) {
            blank.begin_mm[i] = 20.0 * static_cast<double>(i);
            blank.height_mm[i] = i < 3 ? static_cast<double>(i + 1) : static_cast<double>(5 - i);
        }
        blank.end_mm = 100.0;
        QVERIFY(bench.execute(LoadMillingBlank{blank}).done);
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(24.0));
        for (const MillingLaw law :
             {MillingLaw::Pi, MillingLaw::Preview, MillingLaw::Model, MillingLaw::Pi, MillingLaw::Model}) {
            const double before_mmPerS = bench.status().milling.wantedFeed_mmPerS;
            QVERIFY(bench.execute(SetMillingLaw{law}).done);
            bench.runRevolutions(1.0);
            QVERIFY(std::abs(bench.status().milling.wantedFeed_mmPerS - before_mmPerS) < 0.25);
            bench.runRevolutions(6.0);
            QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 60.0);
        }
    }
    void previewNeedsAProfile() {
        MillingBench bench;
        const CommandResult result = bench.execute(SetMillingLaw{MillingLaw::Preview});
        QVERIFY(!result.done && !result.reason.empty());
        QVERIFY(!bench.status().milling.lawUnavailable[static_cast<std::size_t>(MillingLaw::Preview)].empty());
        QVERIFY(bench.status().milling.lawUnavailable[static_cast<std::size_t>(MillingLaw::Model)].empty());
    }
    void knobDownAndUpDoesNotWindUp() {
        for (const MillingLaw law : {MillingLaw::Pi, MillingLaw::Model}) {
            MillingBench bench;
            MillingSetup setup = test::millingSetup();
            setup.law = law;
            QVERIFY(bench.start(LoopMode::Control, setup) && bench.cutTo(22.0));
            InjectedFaults faults;
            faults.operatorOverride = 0.4;
            bench.machine->inject(faults);
            bench.runRevolutions(25.0);
            QVERIFY(bench.status().milling.force_N.value < 300.0);  // the operator's will is done
            bench.machine->inject(InjectedFaults{});
            double highest_N = 0.0;
            for (int i = 0; i < 2500; ++i) {
                bench.engine->runCycles(1);
                highest_N = std::max(highest_N, bench.milling->trueForce_N());
            }
            QVERIFY2(highest_N < 460.0, qPrintable(QString("law %1: %2 N").arg(static_cast<int>(law)).arg(highest_N)));
        }
    }
    void pauseAndResumeDoesNotOvershoot() {
        for (const MillingLaw law : {MillingLaw::Pi, MillingLaw::Model}) {
            MillingBench bench;
            MillingSetup setup = test::millingSetup();
            setup.law = law;
            QVERIFY(bench.start(LoopMode::Control, setup) && bench.cutTo(30.0));
            InjectedFaults faults;
            faults.operatorFeedHold = true;
            bench.machine->inject(faults);
            bench.engine->runCycles(3000);
            QVERIFY(!bench.status().milling.stopped);  // a pause is no breakage
            bench.machine->inject(InjectedFaults{});
            double highest_N = 0.0;
            for (int i = 0; i < 5000; ++i) {
                bench.engine->runCycles(1);
                highest_N = std::max(highest_N, bench.milling->trueForce_N());
            }
            QVERIFY2(highest_N < 470.0, qPrintable(QString("law %1: %2 N").arg(static_cast<int>(law)).arg(highest_N)));
            QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 60.0);
        }
    }
    void speedChangeKeepsTheForce() {
        for (const MillingLaw law : {MillingLaw::Pi, MillingLaw::Model}) {
            MillingBench bench;
            MillingSetup setup = test::millingSetup();
            setup.law = law;
            QVERIFY(bench.start(LoopMode::Control, setup) && bench.cutTo(42.0));
            InjectedFaults faults;
            faults.spindleOverride = 1.5;
            bench.machine->inject(faults);
            bench.engine->runCycles(4000);
            QVERIFY(std::abs(bench.status().milling.revolution_s - 1.0 / 15.0) < 1e-3);
            QVERIFY(std::abs(bench.status().milling.force_N.value - 392.0) < 60.0);
        }
    }
    void worksFromSixtyToTwelveThousandRpm() {
        for (const double speed_rpm : {60.0, 12000.0}) {
            SimulatedMilling::Params params;
            const double heights_mm[] = {1, 2, 1};
            params.blanks.push_back(*milling::BlankProfile::ofSegments(heights_mm, 10.0));
            MillingBench bench(params);
            MillingSetup setup = test::millingSetup();
            // Fast spindles cut thin chips: at 12,000 rpm a quarter of the feed per revolution.
            const double faster = speed_rpm > 600.0 ? 0.25 * speed_rpm / 600.0 : speed_rpm / 600.0;
            const double reference_N = speed_rpm > 600.0 ? 120.0 : 392.0;
            setup.spindleSpeed_rpm = speed_rpm;
            setup.reference_N = reference_N;
            setup.plannedFeed_mmPerS *= faster;
            setup.highestFeed_mmPerS *= faster;
            setup.lowestFeed_mmPerS *= faster;
            setup.entryFeed_mmPerS *= faster;
            setup.from_mm = -1.0;
            setup.to_mm = 32.0;
            PartRecord part;
            QVERIFY(bench.start(LoopMode::Control, setup) && bench.cutTo(15.0));
            QVERIFY2(std::abs(bench.status().milling.force_N.value / reference_N - 1.0) < 0.1,
                     qPrintable(QString::number(bench.status().milling.force_N.value)));
            QVERIFY(bench.runUntil([](const Status& s) { return s.program == ProgramState::Finished; }));
            bench.engine->runCycles(2);
            QVERIFY(bench.engine->partRecords().tryPop(part));
            QCOMPARE(part.milling.stops, 0U);
            QVERIFY2(part.milling.peakForce_N < (speed_rpm > 600.0 ? 1.7 : 1.3) * reference_N,
                     qPrintable(QString::number(part.milling.peakForce_N)));
        }
    }
    void controlThatMaySpeedUpKeepsThePlannedProgram() {
        MillingBench bench({}, 3.0);
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(10.0));
        QVERIFY(bench.status().feedScale > 1.5);  // thin blank: faster than planned
        InjectedFaults faults;
        faults.force = SignalFault::Unplugged;
        bench.machine->inject(faults);
        bench.engine->runCycles(500);
        QVERIFY(bench.status().feedScale <= 1.0);
    }
    void referenceIsTaughtFromACut() {
        MillingBench bench;
        QVERIFY(!bench.execute(TeachMillingReference{}).done);
        MillingSetup setup = test::millingSetup();
        setup.law = MillingLaw::Constant;
        PartRecord part;
        QVERIFY(bench.start(LoopMode::Advise, setup) && bench.finish(part));
        QVERIFY(bench.execute(TeachMillingReference{}).done);
        QVERIFY(std::abs(bench.status().milling.reference_N - part.milling.meanForce_N) < 1e-9);
    }
    void wearShowsAsATrendAndWarns() {
        SimulatedMilling::Params params;
        params.wearPerPart = 0.08;
        MillingBench bench(params);
        QVERIFY(bench.execute(LoadMillingSetup{test::millingSetup()}).done);
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Milling, LoopMode::Control}).done);
        bool warned = false;
        for (int i = 0; i < 6; ++i) {
            PartRecord part;
            QVERIFY(bench.execute(StartPart{ProcessId::Milling}).done);
            QVERIFY(bench.runUntil([](const Status& s) { return s.milling.cutting; }, 100) && bench.finish(part));
            QVERIFY(part.milling.stiffnessHalf95 > 0.0);
            warned = warned || bench.alarmRaised(milling_alarm::kToolWorn);
            QCOMPARE(warned, i >= 4);  // 0.32 > 0.3 with the fifth part
        }
        QVERIFY(std::abs(bench.status().milling.wearPerPart - 0.08) < 0.02);
        QVERIFY(bench.execute(NewMillingTool{}).done);
        QCOMPARE(bench.status().milling.partsWithTool, 0U);
    }
    void newToolEndsTheWarning() {
        SimulatedMilling::Params params;
        params.wearPerPart = 0.4;
        MillingBench bench(params);
        for (int i = 0; i < 2; ++i) {
            PartRecord part;
            QVERIFY(bench.start(LoopMode::Control) && bench.finish(part));
        }
        QVERIFY(bench.alarmRaised(milling_alarm::kToolWorn));
        QVERIFY(bench.execute(NewMillingTool{}).done);
        bench.engine->runCycles(2);
        AlarmEvent event;
        bool ended = false;
        while (bench.engine->nextAlarm(event)) {
            ended = ended || (event.code == milling_alarm::kToolWorn && !event.raised);
        }
        QVERIFY(ended);
    }
    void restoredToolGoesOnWhereItWas() {
        SimulatedMilling::Params params;
        params.wearPerPart = 0.08;
        MillingBench before(params);
        PartRecord part;
        for (int i = 0; i < 4; ++i) {
            QVERIFY(before.start(LoopMode::Control) && before.finish(part));
        }
        const MillingStatus then = before.status().milling;
        MillingBench after(params);
        QVERIFY(after.execute(RestoreMillingTool{then.tool}).done);
        QVERIFY(after.execute(LoadMillingSetup{test::millingSetup()}).done);  // k_x is the tool's, not the setup's
        const MillingStatus now = after.status().milling;
        QCOMPARE(now.tool, then.tool);
        QCOMPARE(now.wear, then.wear);
        QCOMPARE(now.wearPerPart, then.wearPerPart);
        QCOMPARE(now.partsWithTool, 4U);
        MillingToolState bad = then.tool;
        bad.kxLogWeight[2] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!after.execute(RestoreMillingTool{bad}).done);
        QCOMPARE(after.status().milling.tool, then.tool);
    }
    void unusableSetupsAreRefusedWithAReason() {
        MillingBench bench;
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const auto refused = [&](auto change) {
            MillingSetup setup = test::millingSetup();
            change(setup);
            const CommandResult result = bench.execute(LoadMillingSetup{setup});
            return !result.done && !result.reason.empty();
        };
        QVERIFY(refused([&](MillingSetup& s) { s.reference_N = nan; }));
        QVERIFY(refused([](MillingSetup& s) { s.reference_N = 0.0; }));
        QVERIFY(refused([](MillingSetup& s) { s.overload_N = s.reference_N; }));
        QVERIFY(refused([](MillingSetup& s) { s.highestFeed_mmPerS = 0.5 * s.plannedFeed_mmPerS; }));
        QVERIFY(refused([](MillingSetup& s) { s.spindleSpeed_rpm = 13000.0; }));
        QVERIFY(refused([](MillingSetup& s) { s.to_mm = s.from_mm; }));
        QVERIFY(refused([](MillingSetup& s) { s.ki_mmPerSPerN = 2.0 * s.kp_mmPerSPerN; }));
        QVERIFY(refused([](MillingSetup& s) { s.law = MillingLaw::Preview; }));  // no blank profile
        for (const MillingField& field : milling::setupFields()) {
            QVERIFY(refused([&](MillingSetup& s) { field.set(s, field.spec.max * 1.1 + 1.0); }));
            QCOMPARE(field.get(MillingSetup{}), field.spec.fallback);
        }
        QVERIFY(!bench.execute(StartPart{ProcessId::Milling}).done);
        MillingBlank blank;
        blank.count = 2;
        QVERIFY(!bench.execute(LoadMillingBlank{blank}).done);
        QVERIFY(bench.start(LoopMode::Control));
        QVERIFY(!bench.execute(LoadMillingSetup{test::millingSetup()}).done);  // a part is being cut
        QVERIFY(!bench.execute(SetMillingReference{nan}).done);
        QVERIFY(bench.execute(SetMillingReference{300.0}).done);
    }
    void marginIsWhereTheLoopBeginsToRing() {
        MillingSetup setup = test::millingSetup();
        milling::StiffnessEstimate known;
        known.valid = true;
        known.lnCb = std::log(milling::PlantParams().cuttingCoefficient * 2.0);
        known.kx_NPerMm = milling::PlantParams().kx_NPerMm;
        const double margin = milling::gainMargin(setup, MillingLaw::Pi, known, 0.1);
        QVERIFY2(std::abs(margin - 3.65) < 0.05, qPrintable(QString::number(margin)));  // 2·1.873/(.75·.761·1.8)
        const auto unrest = [&](double factor) {
            milling::CutCase cut;
            const double heights_mm[] = {2.0};
            cut.blank = *milling::BlankProfile::ofSegments(heights_mm, 60.0);
            cut.law = MillingLaw::Pi;
            cut.controller.entryGuard = false;
            cut.controller.pi.kp_mmPerSPerN = 0.01905 * factor;
            cut.controller.pi.ki_mmPerSPerN = 0.00381 * factor;
            cut.controller.range.max_mmPerS = 100.0;
            return milling::simulateCut(cut).summary.feedUnrest_mmPerS;
        };
        QVERIFY(unrest(0.9 * margin) < 0.1);
        QVERIFY(unrest(1.1 * margin) > 1.0);
        MillingBench bench;
        QVERIFY(bench.start(LoopMode::Control) && bench.cutTo(30.0));
        QVERIFY(bench.status().milling.gainMargin > 1.5);
    }
};

QTEST_APPLESS_MAIN(TestMillingLoop)
#include "tst_milling_loop.moc"
