// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QProcess>
#include <QTcpSocket>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include "engine/boring/boring_loop.h"
#include "engine/loop/engine.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "tests/machine/port_conformance.h"

namespace {

std::int64_t monotonic_ns() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

bool portAnswers() {
    QTcpSocket socket;
    socket.connectToHost(QStringLiteral("127.0.0.1"), 5007);
    return socket.waitForConnected(200);
}

}  // namespace

/// The suite of the port against LinuxCNC's own simulator, started here; skipped, with the reason, where it cannot run.
class TestLinuxCncMachine : public kerf::test::PortConformance {
    Q_OBJECT
   protected:
    kerf::MachinePort& machine() override { return *m_machine; }
    std::int64_t nextCycle() override {
        m_deadline += std::chrono::milliseconds(1);
        std::this_thread::sleep_until(m_deadline);
        return monotonic_ns();
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
    bool startControl() {
        m_control.setProgram(QStringLiteral(KERF_SOURCE_DIR "/scripts/linuxcnc-sim"));
        m_control.setArguments({QString::fromLocal8Bit(qgetenv("KERF_BIN"))});
        m_control.setStandardOutputFile(QStringLiteral("linuxcnc.log"));
        m_control.setStandardErrorFile(QStringLiteral("linuxcnc.log"), QIODevice::Append);
        m_control.start();
        for (int i = 0; i < 300 && m_control.state() != QProcess::NotRunning; ++i) {
            if (portAnswers() && makeMachine()) {
                return true;
            }
            QTest::qWait(100);
        }
        return false;
    }
    bool makeMachine() {
        kerf::linuxcnc::LinuxCncMachine::Params params;
        params.rsh.prepareMachine = true;
        m_machine = std::make_unique<kerf::linuxcnc::LinuxCncMachine>(params);
        return m_machine->connect().has_value();
    }
    void stopControl() {
        QProcess::execute(QStringLiteral("pkill"), {QStringLiteral("-x"), QStringLiteral("linuxcncrsh")});
        if (!m_control.waitForFinished(20'000)) {
            m_control.kill();
            m_control.waitForFinished();
        }
    }
    bool linkIs(kerf::LinkState state) {
        return cycleUntil([this, state] { return m_inputs.link == state; }, neutral());
    }

   private slots:
    void initTestCase() {
        if (!QFile::exists(QString::fromLocal8Bit(qgetenv("KERF_BIN")) + QStringLiteral("/kerf-hal")) ||
            QProcess::execute(QStringLiteral("sh"), {QStringLiteral("-c"), QStringLiteral("command -v linuxcnc >/dev/null")}) != 0) {
            QSKIP("LinuxCNC is not installed here (packages linuxcnc-uspace and linuxcnc-uspace-dev)");
        }
        if (portAnswers()) {
            QSKIP("another LinuxCNC answers on port 5007: stop it first");
        }
        if (!startControl()) {
            QFile log(QStringLiteral("linuxcnc.log"));
            (void)log.open(QIODevice::ReadOnly);
            QFAIL(("LinuxCNC did not start: " + log.readAll().right(800)).constData());
        }
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(cycleUntil([this] { return m_inputs.machineOn && !m_inputs.emergencyStop && homed(); }, neutral()));
    }
    void cleanupTestCase() {
        m_machine.reset();
        if (m_control.state() != QProcess::NotRunning) {
            stopControl();
        }
    }
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
        const std::int64_t silentFrom_ns = monotonic_ns();
        std::int64_t reacted_ns = 0;
        while (monotonic_ns() - silentFrom_ns < 1'000'000'000 && reacted_ns == 0) {
            machine().read(nextCycle(), m_inputs);  // looks, but says nothing: hung
            QVERIFY(m_inputs.actualFeed_mmPerS.value <= programmed() * 1.001);
            if (m_inputs.appliedFeedScale.value == 1.0) {
                reacted_ns = monotonic_ns();
            }
        }
        QVERIFY(reacted_ns != 0);
        const double reaction_ms = static_cast<double>(reacted_ns - silentFrom_ns) * 1e-6;
        qInfo("console silent: back at programmed feed after %.0f ms", reaction_ms);
    }
    void controlKilledIsNoticedAndComesBack() {
        const std::int64_t killed_ns = monotonic_ns();
        QProcess::execute(QStringLiteral("pkill"), {QStringLiteral("-9"), QStringLiteral("-x"), QStringLiteral("kerf-hal")});
        std::int64_t noticed_ns = 0;
        m_deadline = std::chrono::steady_clock::now();
        while (monotonic_ns() - killed_ns < 2'000'000'000 && noticed_ns == 0) {
            cycle(neutral());
            if (m_inputs.link == kerf::LinkState::Down) {
                noticed_ns = monotonic_ns();
            }
        }
        QVERIFY(noticed_ns != 0);
        qInfo("link lost noticed %.0f ms after the kill was asked", static_cast<double>(noticed_ns - killed_ns) * 1e-6);
        // The test cannot load the bridge into a running control as an ordinary user would; a new control is the same to the port.
        m_machine->disconnect();
        stopControl();
        QVERIFY(startControl());
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(linkIs(kerf::LinkState::Up));
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

    QProcess m_control;
    std::unique_ptr<kerf::linuxcnc::LinuxCncMachine> m_machine;
    std::chrono::steady_clock::time_point m_deadline{};
};
QTEST_GUILESS_MAIN(TestLinuxCncMachine)
#include "tst_linuxcnc_machine.moc"
