// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "engine/boring/boring_loop.h"
#include "engine/loop/engine.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "tests/machine/port_conformance.h"
#include "tests/support/linuxcnc_control.h"

/// The suite of the port against LinuxCNC's own simulator, started here; skipped, with the reason, where it cannot run.
class TestLinuxCncMachine : public kerf::test::PortConformance {
    Q_OBJECT
   protected:
    kerf::MachinePort& machine() override { return *m_machine; }
    std::int64_t nextCycle() override {
        m_deadline += std::chrono::milliseconds(1);
        std::this_thread::sleep_until(m_deadline);
        return kerf::test::monotonic_ns();
    }
    kerf::StartProgram shortProgram() const override {
        kerf::StartProgram program;
        program.process = kerf::ProcessId::Boring;
        program.programmedFeed_mmPerRev = 0.5;
        program.spindleSpeed_rpm = 1200.0;
        program.from_mm = 40.0;
        program.to_mm = 44.0;
        return program;
    }
    int patience() const override { return 10'000; }

   private:
    bool linkIs(kerf::LinkState state) {
        return cycleUntil([this, state] { return m_inputs.link == state; }, neutral());
    }

   private slots:
    void initTestCase() {
        if (const QString why = kerf::test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        m_machine = std::make_unique<kerf::linuxcnc::LinuxCncMachine>(kerf::linuxcnc::LinuxCncMachine::Params{});
        QVERIFY(m_machine->connect().has_value());  // before LinuxCNC: the console starts without it
        cycle(neutral());
        QCOMPARE(m_inputs.link, kerf::LinkState::Down);
        QVERIFY2(m_control.start(), m_control.log());
    }
    void cleanupTestCase() { m_machine.reset(); }
    void init() {
        m_inputs = kerf::MachineInputs{};
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(linkIs(kerf::LinkState::Up));
        QVERIFY(cycleUntil([this] { return m_inputs.program != kerf::ProgramState::Running; }, neutral()));
        settle();
    }
    void cleanup() {
        kerf::MachineOutputs abort = neutral();
        abort.request.number = ++m_request;
        abort.request.action = kerf::AbortProgram{};
        (void)cycleUntil([this] { return m_inputs.reply.number == m_request; }, abort);
        settle();
    }

    void boreReallyFollowsTheSchedule() {
        std::vector<std::unique_ptr<kerf::ProcessLoop>> loops;
        loops.push_back(std::make_unique<kerf::BoringLoop>());
        kerf::Engine engine(*m_machine, std::move(loops));
        engine.start();
        kerf::BoringSchedule schedule;
        schedule.revision = 1;
        schedule.lnC = std::log(0.0871);
        schedule.alpha = 0.5025;
        schedule.beta = 0.2676;
        schedule.targetDeflection_mm = 0.1165;
        schedule.overhangTo_mm = 60.0;
        schedule.spindleSpeed_rpm = 1500.0;
        const auto send = [&engine](auto action) {
            kerf::Command command;
            command.action = action;
            return engine.send(command).has_value();
        };
        QVERIFY(send(kerf::LoadBoringSchedule{schedule}));
        QVERIFY(send(kerf::SetLoopMode{kerf::ProcessId::Boring, kerf::LoopMode::Control}));
        QTRY_VERIFY(engine.status().link == kerf::LinkState::Up);
        QVERIFY(send(kerf::StartPart{kerf::ProcessId::Boring}));
        QTRY_VERIFY_WITH_TIMEOUT(engine.status().boring.partsCut == 1, 30'000);
        engine.stop();
        kerf::PartRecord part;
        QVERIFY(engine.partRecords().tryPop(part));
        QVERIFY(part.complete);
        QVERIFY(part.feed.count > 50);
        // The first millimetre is the axis's acceleration. Without a real-time kernel a few points may be late: most must fit.
        std::vector<double> deviations;
        for (std::size_t i = 4; i + 1 < part.feed.count; ++i) {
            const double wanted = schedule.feed_mmPerRev(static_cast<double>(part.feed.overhang_mm[i]));
            deviations.push_back(std::abs(static_cast<double>(part.feed.feed_mmPerRev[i]) / wanted - 1.0));
        }
        std::ranges::sort(deviations);
        qInfo("deviation of the feed really cut: median %.2f %%, largest %.2f %%", 100.0 * deviations[deviations.size() / 2],
              100.0 * deviations.back());
        QVERIFY(deviations[deviations.size() * 9 / 10] < 0.02);
    }
    void silentConsoleLeavesTheProgrammedFeed() {
        QVERIFY(startShortProgram());
        kerf::MachineOutputs slow = neutral();
        slow.feedScale = 0.2;
        QVERIFY(cycleUntil(
            [this] { return m_inputs.actualFeed_mmPerS.value > 0.0 && m_inputs.actualFeed_mmPerS.value < 0.25 * programmed(); }, slow));
        const std::int64_t silentFrom_ns = kerf::test::monotonic_ns();
        std::int64_t reacted_ns = 0;
        while (kerf::test::monotonic_ns() - silentFrom_ns < 1'000'000'000 && reacted_ns == 0) {
            machine().read(nextCycle(), m_inputs);  // looks, but says nothing: hung
            QVERIFY(m_inputs.actualFeed_mmPerS.value <= programmed() * 1.001);
            if (m_inputs.appliedFeedScale.value == 1.0) {
                reacted_ns = kerf::test::monotonic_ns();
            }
        }
        QVERIFY(reacted_ns != 0);
        const double reaction_ms = static_cast<double>(reacted_ns - silentFrom_ns) * 1e-6;
        qInfo("console silent: back at programmed feed after %.0f ms", reaction_ms);
    }
    void controlKilledIsNoticedAndComesBack() {
        const std::int64_t killed_ns = kerf::test::monotonic_ns();
        m_control.killBridge();
        std::int64_t noticed_ns = 0;
        m_deadline = std::chrono::steady_clock::now();
        while (kerf::test::monotonic_ns() - killed_ns < 2'000'000'000 && noticed_ns == 0) {
            cycle(neutral());
            if (m_inputs.link == kerf::LinkState::Down) {
                noticed_ns = kerf::test::monotonic_ns();
            }
        }
        QVERIFY(noticed_ns != 0);
        qInfo("link lost noticed %.0f ms after the kill was asked", static_cast<double>(noticed_ns - killed_ns) * 1e-6);
        m_control.stop();
        QVERIFY2(m_control.start(), m_control.log());
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(linkIs(kerf::LinkState::Up));  // by itself
        QVERIFY(cycleUntil([this] { return m_inputs.machineOn && homed(); }, neutral()));
    }

   private:
    [[nodiscard]] double programmed() const { return m_inputs.programmedFeed_mmPerS.value; }
    /// A program can be started: asked once per call of cycleUntil's condition, answered by the control itself.
    [[nodiscard]] bool homed() const { return m_machine->commandsReady(); }
    void settle() {
        for (int i = 0; i < 300; ++i) {
            cycle(neutral());
        }
    }

    kerf::test::LinuxCncControl m_control;
    std::unique_ptr<kerf::linuxcnc::LinuxCncMachine> m_machine;
    std::chrono::steady_clock::time_point m_deadline{};
};
QTEST_GUILESS_MAIN(TestLinuxCncMachine)
#include "tst_linuxcnc_machine.moc"
