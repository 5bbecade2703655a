// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "engine/cycle/machine_alarms.h"
#include "engine/process/boring/boring_alarms.h"
#include "tests/support/boring_bench.h"

using namespace kerf;

/// Supervisor, cycle and boring loop together, on the caller's thread.
class TestSupervision : public QObject {
    Q_OBJECT

    static bool startCutting(test::BoringBench& bench, LoopMode mode) {
        return bench.execute(LoadBoringSchedule{test::shortSchedule()}).done &&
               bench.execute(SetLoopMode{ProcessId::Boring, mode}).done &&
               bench.execute(StartPart{ProcessId::Boring}).done &&
               bench.runUntil([](const Status& s) { return s.boring.cutting && s.boring.progress > 0.3; });
    }
    static bool alarmRaised(test::BoringBench& bench, AlarmCode code) {
        AlarmEvent event;
        bool raised = false;
        while (bench.engine->nextAlarm(event)) {
            raised = raised || (event.code == code && event.raised);
        }
        return raised;
    }

 private slots:
    void feedReallyCutFollowsTheSchedule() {
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Control));
        QCOMPARE(bench.loop().state, LoopState::Controlling);
        QVERIFY(bench.runUntil([](const Status& s) { return s.program == ProgramState::Finished; }));
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        QVERIFY(part.complete);
        QVERIFY(part.feed.count > 60);
        for (std::size_t i = 1; i < part.feed.count; ++i) {
            const double wanted = part.schedule.feed_mmPerRev(static_cast<double>(part.feed.overhang_mm[i]));
            QVERIFY(std::abs(static_cast<double>(part.feed.feed_mmPerRev[i]) - wanted) < 0.01 * wanted);
        }
    }
    void whatTheMachineDoesNotCarryOutIsAnAlarmUntilSomethingIs() {
        test::BoringBench bench;
        QVERIFY(bench.execute(LoadBoringSchedule{test::shortSchedule()}).done);
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Boring, LoopMode::Control}).done);
        (void)bench.send(StartPart{ProcessId::Boring});
        bench.engine->runCycles(1);
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(5);
        AlarmEvent event;
        bool said = false;
        while (bench.engine->nextAlarm(event)) {
            said = said || (event.code == machine_alarm::kNotCarriedOut && event.raised && !event.detail.empty());
        }
        QVERIFY(said);
        bench.machine->inject({});
        bench.engine->runCycles(5);
        QVERIFY(bench.execute(ReleaseHold{}).done);
        (void)bench.send(StartPart{ProcessId::Boring});
        QVERIFY(bench.runUntil([](const Status& s) { return s.boring.cutting; }));
        bool cleared = false;
        while (bench.engine->nextAlarm(event)) {
            cleared = cleared || (event.code == machine_alarm::kNotCarriedOut && !event.raised);
        }
        QVERIFY(cleared);
    }
    void adviseCutsAtProgrammedFeed() {
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Advise));
        QCOMPARE(bench.loop().state, LoopState::Advising);
        QCOMPARE(bench.engine->status().feedScale, 1.0);
        QVERIFY(bench.engine->status().boring.wantedFeed_mmPerRev <
                0.95 * test::shortSchedule().highestFeed_mmPerRev());
    }
    void partKeepsTheScheduleItBeganWith() {
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Control));
        BoringSchedule later = test::shortSchedule(2);
        later.lnC += 0.1;
        QVERIFY(bench.execute(LoadBoringSchedule{later}).done);
        QCOMPARE(bench.engine->status().boring.activeSchedule, 1U);
        QCOMPARE(bench.engine->status().boring.nextSchedule, 2U);
    }
    void holdWorksWithinOneCycleFromEveryState() {
        for (const LoopMode mode : {LoopMode::Off, LoopMode::Advise, LoopMode::Control}) {
            test::BoringBench bench;
            QVERIFY(startCutting(bench, mode));
            const double before = bench.engine->status().feedScale;
            bench.engine->holdAll();
            bench.engine->runCycles(1);
            QVERIFY(bench.engine->status().held);
            QCOMPARE(bench.loop().state, mode == LoopMode::Off ? LoopState::Off : LoopState::Held);
            QVERIFY(!bench.loop().reason.empty());
            QVERIFY(bench.engine->status().feedScale <= before);  // never a bump upwards
            bench.engine->runCycles(500);
            QVERIFY(bench.engine->status().feedScale <= before);
            QVERIFY(bench.execute(ReleaseHold{}).done);
            QVERIFY(!bench.engine->status().held);
            QCOMPARE(bench.engine->status().loops[0].mode, mode);
        }
    }
    void holdPressedAfterTheReleaseWasAskedWins() {
        test::BoringBench bench;
        bench.engine->holdAll();
        bench.engine->runCycles(1);
        (void)bench.send(ReleaseHold{});
        bench.engine->holdAll();
        bench.engine->runCycles(1);
        QVERIFY(bench.engine->status().held);
        QVERIFY(!bench.engine->status().lastCommand.done);
    }
    void holdWorksWithAFullCommandRing() {
        test::BoringBench bench;
        while (bench.send(StartPart{ProcessId::Boring}) != 0) {
        }
        bench.engine->holdAll();
        bench.engine->runCycles(1);
        QVERIFY(bench.engine->status().held);
    }
    void lostSignalNeverMeansFaster_data() {
        QTest::addColumn<int>("fault");
        QTest::addColumn<bool>("overhang");
        for (int fault = 1; fault <= 5; ++fault) {
            QTest::addRow("overhang fault %d", fault) << fault << true;
            QTest::addRow("spindle speed fault %d", fault) << fault << false;
        }
    }
    void lostSignalNeverMeansFaster() {
        QFETCH(int, fault);
        QFETCH(bool, overhang);
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Control));
        const double before = bench.engine->status().feedScale;
        InjectedFaults faults;
        (overhang ? faults.overhang : faults.spindleSpeed) = static_cast<SignalFault>(fault);
        bench.machine->inject(faults);
        bench.engine->runCycles(1000);
        QVERIFY(bench.engine->status().feedScale <= before + 1e-12);
        if (static_cast<SignalFault>(fault) !=
            SignalFault::Stuck) {  // a stuck signal looks healthy; it is held, not raised
            QCOMPARE(bench.loop().state, LoopState::Limited);
            QVERIFY(alarmRaised(bench, overhang ? boring_alarm::kOverhangLost : boring_alarm::kSpindleSpeedLost));
        }
    }
    void aLostMachineHoldsTheLoopsUntilSomebodyHasLooked() {
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Control));
        InjectedFaults faults;
        faults.linkDown = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(1);
        QCOMPARE(bench.loop().state, LoopState::Held);
        QVERIFY(alarmRaised(bench, machine_alarm::kLinkDown));
        QVERIFY(!bench.execute(ReleaseHold{}).done);  // there is nothing to look at yet
        bench.machine->inject({});
        bench.engine->runCycles(20);
        QCOMPARE(bench.loop().state, LoopState::Held);
        QVERIFY(bench.engine->status().held);
        QVERIFY(!bench.loop().reason.empty());
        QVERIFY(bench.execute(ReleaseHold{}).done);
        bench.engine->runCycles(2);
        QCOMPARE(bench.loop().state, LoopState::Controlling);
    }
    void whatWasAskedBeforeAnEmergencyStopDoesNotBeginAfterIt() {
        test::BoringBench bench;
        QVERIFY(bench.execute(LoadBoringSchedule{test::shortSchedule()}).done);
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Boring, LoopMode::Control}).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Boring}).done);
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(5000);
        bench.machine->inject({});
        bench.engine->runCycles(5000);
        QCOMPARE(bench.engine->status().partSequence, 0U);
        QVERIFY(!bench.execute(StartPart{ProcessId::Boring}).done);  // nobody has looked
        QVERIFY(bench.execute(ReleaseHold{}).done);
        bench.engine->runCycles(100);
        QCOMPARE(bench.engine->status().partSequence, 0U);
        QVERIFY(bench.execute(StartPart{ProcessId::Boring}).done);
    }
    void linkLossDoesNotEndThePart() {
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Control));
        InjectedFaults faults;
        faults.linkDown = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(50);
        bench.machine->inject({});
        QVERIFY(bench.runUntil([](const Status& s) { return s.program == ProgramState::Finished; }));
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        QVERIFY(part.complete);
        QVERIFY(!bench.engine->partRecords().tryPop(part));
    }
    void emergencyStopRecordsTheAbortedPart() {
        test::BoringBench bench;
        QVERIFY(startCutting(bench, LoopMode::Control));
        InjectedFaults faults;
        faults.emergencyStop = true;
        bench.machine->inject(faults);
        bench.engine->runCycles(2);
        PartRecord part;
        QVERIFY(bench.engine->partRecords().tryPop(part));
        QVERIFY(!part.complete);
        QCOMPARE(bench.loop().state, LoopState::Held);
        QVERIFY(!bench.execute(StartPart{ProcessId::Boring}).done);
    }
    void fullPartRingBlocksNewPartsAndLosesNone() {
        test::BoringBench bench;
        QVERIFY(bench.execute(LoadBoringSchedule{test::shortSchedule()}).done);
        std::uint32_t made = 0;
        while (bench.runPart()) {
            ++made;
            QVERIFY(made < 1000);
        }
        QVERIFY(bench.engine->status().partsBlocked);
        QVERIFY(alarmRaised(bench, machine_alarm::kPartStoreFull));
        std::uint32_t stored = 0;
        PartRecord part;
        for (int round = 0; round < 3; ++round) {
            while (bench.engine->partRecords().tryPop(part)) {
                QCOMPARE(part.partSequence, ++stored);
            }
            bench.engine->runCycles(1);
        }
        QCOMPARE(stored, made);
        QVERIFY(bench.runPart());
    }
    void unfittedLoopSaysSo() {
        test::BoringBench bench;
        const CommandResult result = bench.execute(SetLoopMode{ProcessId::Milling, LoopMode::Control});
        QVERIFY(!result.done);
        QVERIFY(!result.reason.empty());
        QVERIFY(!bench.engine->status().loops[1].fitted);
        QVERIFY(!bench.engine->status().loops[1].reason.empty());
    }
    void badScheduleIsRefusedAndTheLastOneStays() {
        test::BoringBench bench;
        QVERIFY(bench.execute(LoadBoringSchedule{test::shortSchedule(4)}).done);
        for (const double bad : {0.0, -1.0, std::nan("")}) {
            BoringSchedule schedule = test::shortSchedule(5);
            schedule.alpha = bad;
            QVERIFY(!bench.execute(LoadBoringSchedule{schedule}).done);
        }
        QCOMPARE(bench.engine->status().boring.nextSchedule, 4U);
    }
    void scheduleBeyondTheControlIsLimitedAndSaysSo() {
        test::BoringBench bench;
        BoringSchedule schedule = test::shortSchedule();
        schedule.maxFeed_mmPerRev = 0.2;  // the top of this bore wants more
        QVERIFY(bench.execute(LoadBoringSchedule{schedule}).done);
        QVERIFY(bench.execute(SetLoopMode{ProcessId::Boring, LoopMode::Control}).done);
        QVERIFY(bench.execute(StartPart{ProcessId::Boring}).done);
        QVERIFY(bench.runUntil([](const Status& s) { return s.boring.cutting; }));
        bench.engine->runCycles(2);
        QCOMPARE(bench.loop().state, LoopState::Limited);
    }
    void everyAlarmHasCauseConsequenceAction() {
        test::BoringBench bench;
        int known = 0;
        for (AlarmCode code = 1; code < 600; ++code) {
            if (const AlarmSpec* spec = bench.engine->alarmSpec(code)) {
                ++known;
                QVERIFY(spec->priority >= 1 && spec->priority <= 3);
                for (const char* text : {spec->title, spec->cause, spec->consequence, spec->action}) {
                    QVERIFY(std::string_view(text).size() > 8);
                }
            }
        }
        QVERIFY(known >= 7);
    }
};
QTEST_APPLESS_MAIN(TestSupervision)
#include "tst_supervision.moc"
