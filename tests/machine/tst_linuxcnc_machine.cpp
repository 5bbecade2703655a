// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string_view>
#include <thread>

#include "engine/cycle/engine.h"
#include "engine/limits/output_limiter.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/process/boring/boring_loop.h"
#include "tests/machine/port_conformance.h"
#include "tests/support/kerf_program.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"

namespace {
constexpr const char* kBeAConsole = "--be-a-console";
}

/// The suite of the port against LinuxCNC's own simulator, started here; skipped, with the reason, where it cannot run.
class TestLinuxCncMachine : public kerf::test::PortConformance {
    Q_OBJECT
 protected:
    kerf::MachinePort& machine() override { return *m_machine; }
    std::int64_t nextCycle() override {
        // A missed cycle is not made up for, as in the engine.
        m_deadline = std::max(m_deadline + std::chrono::milliseconds(1), std::chrono::steady_clock::now());
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
    kerf::StartProgram longProgram() const override {
        kerf::StartProgram program = shortProgram();
        program.to_mm = program.from_mm + 40.0;
        return program;
    }
    bool loseTheWay(bool lost) override { return kerf::test::LinuxCncControl::stopBridge(lost); }
    /// From motion itself: the bridge that would tell stands still.
    double trueFeedShare() override {
        const kerf::StartProgram program = shortProgram();
        return pinValue("motion.current-vel") / (program.programmedFeed_mmPerRev * program.spindleSpeed_rpm / 60.0);
    }

    /// What the dead bridge has left behind is no machine: for a console, and for every command that looks.
    bool aConsoleStartedNowHasNoLink() {
        kerf::linuxcnc::LinuxCncMachine another{kerf::linuxcnc::LinuxCncMachine::Params{}};
        another.onlyRead();
        kerf::MachineInputs inputs;
        if (!another.connect().has_value()) {
            return false;
        }
        for (int i = 0; i < 20; ++i) {
            another.read(kerf::test::monotonic_ns(), inputs);
            if (inputs.link != kerf::LinkState::Down) {
                return false;
            }
        }
        const kerf::test::KerfRun status = kerf::test::runKerf({QStringLiteral("machine"), QStringLiteral("status")});
        return status.exitCode == 3 && status.err.contains(QStringLiteral("the machine is not reached"));
    }

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
        (void)cycleUntil([this] { return answered(); }, abort);
        settle();
    }

    void commandsNeedNoNetwork() {
        QVERIFY(cycleUntil([this] { return m_machine->commandsOverBridge(); }, neutral()));
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
        const std::uint64_t overruns = engine.status().stats.overruns;
        engine.stop();
        kerf::PartRecord part;
        QVERIFY(engine.partRecords().tryPop(part));
        QVERIFY(part.complete);
        QVERIFY(part.feed.count > 50);
        // The first millimetre is the axis's acceleration.
        std::vector<double> deviations;
        for (std::size_t i = 4; i + 1 < part.feed.count; ++i) {
            const double wanted = schedule.feed_mmPerRev(static_cast<double>(part.feed.overhang_mm[i]));
            deviations.push_back(std::abs(static_cast<double>(part.feed.feed_mmPerRev[i]) / wanted - 1.0));
        }
        std::ranges::sort(deviations);
        qInfo("deviation of the feed really cut: median %.2f %%, largest %.2f %%, %llu late cycles",
              100.0 * deviations[deviations.size() / 2], 100.0 * deviations.back(),
              static_cast<unsigned long long>(overruns));
        // A computer that keeps its deadlines: every point but one. One that does not: nine of ten.
        const std::size_t count = deviations.size();
        QVERIFY(deviations[overruns == 0 ? count - 2 : count * 9 / 10] < 0.02);
    }
    void operatorsPauseIsSeenAndGoesOn() {
        kerf::test::AtTheControl control;
        QVERIFY(startShortProgram());
        control.say("set pause");
        QVERIFY(cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Paused && m_inputs.feedHold; },
                           neutral()));
        control.say("set resume");
        QVERIFY(cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Running; }, neutral()));
        QVERIFY(cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Finished; }, neutral()));
    }
    void operatorsFeedOverrideIsSeenAndMultiplies() {
        kerf::test::AtTheControl control;
        control.say("set feed_override 50");
        QVERIFY(cycleUntil([this] { return std::abs(m_inputs.operatorOverride - 0.5) < 0.01; }, neutral()));
        QVERIFY(startShortProgram());
        const auto request = shortProgram();
        const double asked_mmPerS = request.programmedFeed_mmPerRev * request.spindleSpeed_rpm / 60.0;
        const bool halved = cycleUntil(
            [&] { return std::abs(m_inputs.actualFeed_mmPerS.value - 0.5 * asked_mmPerS) < 0.02 * asked_mmPerS; },
            neutral());
        control.say("set feed_override 100");
        QVERIFY(halved);
        QVERIFY(cycleUntil([this] { return m_inputs.operatorOverride > 0.99; }, neutral()));
    }
    void softLimitRefusesTheBoreBeforeItBegins() {
        kerf::MachineOutputs outputs = neutral();
        kerf::StartProgram tooDeep = shortProgram();
        tooDeep.to_mm = tooDeep.from_mm + 900.0;
        outputs.request.number = ++m_request;
        outputs.request.action = tooDeep;
        const std::uint32_t before = m_inputs.partSequence;
        QVERIFY(cycleUntil([this] { return answered(); }, outputs));
        kerf::test::AtTheControl control;  // answers only once the control has read the program
        QVERIFY(cycleUntil([&] { return control.ask("get program_status").contains("IDLE"); }, neutral()));
        settle();
        QCOMPARE(m_inputs.partSequence, before);
        QVERIFY(m_inputs.program != kerf::ProgramState::Running);
    }
    void abortWhileTappingIsAnAbortedTap() {
        kerf::MachineOutputs outputs = neutral();
        kerf::StartProgram tap;
        tap.process = kerf::ProcessId::Tapping;
        tap.pitch_mm = 1.25;
        tap.revolutions = 22.0;
        tap.spindleSpeed_rpm = 600.0;
        outputs.request.number = ++m_request;
        outputs.request.action = tap;
        QVERIFY(cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Running; }, outputs));
        QCOMPARE(m_inputs.reply.state, kerf::RequestState::Done);
        double deepest_rev = 0.0;
        QVERIFY(cycleUntil(
            [&] {
                if (m_inputs.servoCount > 0) {
                    deepest_rev = m_inputs.servo[0].spindle_rev;
                }
                return deepest_rev > 6.0;
            },
            neutral()));
        kerf::test::AtTheControl control;
        control.say("set abort");
        QVERIFY(cycleUntil([this] { return m_inputs.program != kerf::ProgramState::Running; }, neutral()));
        QCOMPARE(m_inputs.program, kerf::ProgramState::Aborted);
        kerf::MachineOutputs recover = neutral();
        recover.request.number = ++m_request;
        recover.request.action = kerf::RetractInSync{};
        QVERIFY(cycleUntil([this] { return answered(); }, recover));
        QCOMPARE(m_inputs.reply.state, kerf::RequestState::Refused);
        QVERIFY(!m_inputs.reply.reason.empty());
        control.say("set mode mdi");
        control.say("set mdi G0 Z5");  // free again for the next tests
        control.say("set mdi M5");
    }
    void emergencyStopAbortsAndMachineOnZeroesTheOffsetsWithoutAJumpOfOurs() {
        kerf::Capabilities quick = m_machine->capabilities();
        quick.limits.workOffsetRate_umPerS = 100.0;
        kerf::OutputLimiter limiter(quick);
        std::array<kerf::LoopOutputs, kerf::kProcessPlaces> wishes{};
        wishes[static_cast<std::size_t>(kerf::ProcessId::Thermal)].workOffset_um[2] = 12.0;
        kerf::LimitReport report;
        limiter.adopt(m_inputs, quick);
        double largestStep_um = 0.0;
        double last_um = 0.0;
        const auto limitedUntil = [&](const std::function<bool()>& condition) {
            for (int i = 0; i < patience(); ++i) {
                machine().read(nextCycle(), m_inputs);
                kerf::MachineOutputs outputs = limiter.apply(wishes, m_inputs, 0.001, report);
                outputs.heartbeat = ++m_heartbeat;
                machine().write(outputs);
                if (m_inputs.workOffset_um[2].good()) {
                    largestStep_um = std::max(largestStep_um, m_inputs.workOffset_um[2].value - last_um);
                    last_um = m_inputs.workOffset_um[2].value;
                }
                if (condition()) {
                    return true;
                }
            }
            return false;
        };
        QVERIFY(limitedUntil([&] { return std::abs(m_inputs.workOffset_um[2].value - 12.0) < 0.5; }));
        QVERIFY(startShortProgram());
        kerf::test::AtTheControl control;
        control.say("set estop on");
        QVERIFY(
            limitedUntil([&] { return m_inputs.emergencyStop && m_inputs.program == kerf::ProgramState::Aborted; }));
        QVERIFY(!m_inputs.machineOn);
        control.say("set estop off");
        control.say("set machine on");
        largestStep_um = 0.0;
        QVERIFY(limitedUntil([&] { return m_inputs.machineOn && m_inputs.workOffset_um[2].good(); }));
        QVERIFY2(std::abs(m_inputs.workOffset_um[2].value) < 1.0,
                 qPrintable(QString::number(m_inputs.workOffset_um[2].value)));  // the control has zeroed it
        QVERIFY(limitedUntil([&] { return std::abs(m_inputs.workOffset_um[2].value - 12.0) < 0.5; }));
        QVERIFY2(largestStep_um < 8.0,
                 qPrintable(QString::number(largestStep_um)));  // and we lead it back, not throw it
    }
    void digitalWordAnswersTheControlsRequest() {
        QCOMPARE(setPin("kerf.request-4", "1"), 0);  // start, axis Z
        QCOMPARE(setPin("kerf.request-1", "1"), 0);
        kerf::MachineOutputs outputs = neutral();
        outputs.workOffset_um = {0.0, 0.0, 9.0};
        QVERIFY(cycleUntil([this] { return std::abs(m_inputs.workOffset_um[2].value - 9.0) < 0.5; }, outputs));
        // alive 15, axis Z 14, shift 9: bits 3 and 0
        QVERIFY(cycleUntil([] { return wordOf(getPins("kerf.word-")) == 0xC009; }, outputs));
        setPin("kerf.request-4", "0");
        setPin("kerf.request-1", "0");
        QVERIFY(cycleUntil([this] { return std::abs(m_inputs.workOffset_um[2].value) < 0.5; }, neutral()));
    }
    void silentConsoleHoldsTheFeedWhereThatIsAsked() {
        QCOMPARE(setPin("kerf.hold-on-loss", "1"), 0);
        QVERIFY(startShortProgram());
        QVERIFY(cycleUntil([this] { return m_inputs.actualFeed_mmPerS.value > 0.0; }, neutral()));
        const std::int64_t silentFrom_ns = kerf::test::monotonic_ns();
        std::int64_t stopped_ns = 0;
        while (kerf::test::monotonic_ns() - silentFrom_ns < 2'000'000'000 && stopped_ns == 0) {
            machine().read(nextCycle(), m_inputs);
            if (m_inputs.actualFeed_mmPerS.value < 1e-6) {
                stopped_ns = kerf::test::monotonic_ns();
            }
        }
        setPin("kerf.hold-on-loss", "0");
        QVERIFY(stopped_ns != 0);
        qInfo("console silent, hold asked: feed stands after %.0f ms",
              static_cast<double>(stopped_ns - silentFrom_ns) * 1e-6);
        QVERIFY(
            cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Finished; }, neutral()));  // and goes on
    }
    void killedConsoleIsNoticedByTheControl() {
        m_machine->disconnect();
        QProcess console;  // this program again, as a console; killed as kill -9 does
        console.start(QCoreApplication::applicationFilePath(), {QLatin1String(kBeAConsole)});
        kerf::linuxcnc::SharedLink link;
        kerf::linuxcnc::LinkMemory* memory = link.take();
        QVERIFY(memory != nullptr);
        kerf::linuxcnc::FromControl seen;
        const auto lost = [&] { return memory->fromControl.latest(seen) && seen.consoleLost; };
        QTRY_VERIFY_WITH_TIMEOUT(!lost(), 10'000);
        console.kill();
        const std::int64_t killed_ns = kerf::test::monotonic_ns();
        while (!lost() && kerf::test::monotonic_ns() - killed_ns < 2'000'000'000) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        const double noticed_ms = static_cast<double>(kerf::test::monotonic_ns() - killed_ns) * 1e-6;
        console.waitForFinished();
        QVERIFY(lost());
        QCOMPARE(seen.appliedFeedScale, 1.0);
        qInfo("console killed: noticed after %.0f ms", noticed_ms);
        QVERIFY(m_machine->connect().has_value());
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(linkIs(kerf::LinkState::Up));
        QVERIFY(cycleUntil([this] { return homed(); }, neutral()));
    }
    void silentConsoleNeverMakesTheFeedFaster() {
        QVERIFY(startShortProgram());
        kerf::MachineOutputs slow = neutral();
        slow.feedScale = 0.2;
        QVERIFY(cycleUntil(
            [this] {
                const bool taken = m_inputs.appliedFeedScale.good() && m_inputs.appliedFeedScale.value < 0.21;
                return taken && m_inputs.actualFeed_mmPerS.value > 0.0 &&
                       m_inputs.actualFeed_mmPerS.value < 0.25 * programmed();
            },
            slow));
        double fastest = 0.0;
        QVERIFY(silentUntil([&] {  // looks, but says nothing: hung
            const bool runs = m_inputs.program == kerf::ProgramState::Running;
            fastest = std::max(fastest, runs ? m_inputs.actualFeed_mmPerS.value / programmed() : 0.0);
            return !runs;
        }));
        QCOMPARE(m_inputs.program, kerf::ProgramState::Finished);  // the part goes on to its end, as slow as it was
        QVERIFY2(fastest < 0.25, qPrintable(QString::number(fastest)));
    }
    void aPausedProgramGoesOnAtItsPlannedFeedWithoutItsConsole() {
        kerf::test::AtTheControl control;
        kerf::StartProgram program = longProgram();
        program.plannedFeedScale = 0.5;
        kerf::MachineOutputs outputs = neutral();
        outputs.request = {++m_request, program};
        QVERIFY(
            cycleUntil([&] { return m_inputs.program == kerf::ProgramState::Running && feedShare() > 0.9; }, outputs));
        control.say("set pause");
        QVERIFY(cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Paused; }, neutral()));
        const std::int64_t silentFrom_ns = m_inputs.time_ns;
        QVERIFY(silentUntil([&] { return m_inputs.time_ns - silentFrom_ns > 200'000'000; }));
        control.say("set resume");
        double highest = 0.0;
        QVERIFY(silentUntil([&] {
            highest = std::max(highest, feedShare());
            return m_inputs.time_ns - silentFrom_ns > 1'500'000'000;
        }));
        QCOMPARE(m_inputs.program, kerf::ProgramState::Running);
        QVERIFY2(highest < 0.53, qPrintable(QString::number(highest)));
        QVERIFY(std::abs(feedShare() - 0.5) < 0.02);
    }
    void aStopOutlivesBridgeAndConsole() {
        kerf::StartProgram program = longProgram();
        program.plannedFeedScale = 0.5;
        kerf::MachineOutputs outputs = neutral();
        outputs.request = {++m_request, program};
        QVERIFY(
            cycleUntil([&] { return m_inputs.program == kerf::ProgramState::Running && feedShare() > 0.9; }, outputs));
        constexpr auto kMilling = static_cast<std::size_t>(kerf::ProcessId::Milling);
        kerf::MachineOutputs stopped = neutral();
        (void)kerf::latch(stopped.stops[kMilling], kerf::StopKind::FeedHold, 201);
        const auto stands = [&] {
            return m_inputs.link == kerf::LinkState::Up && m_inputs.stops[kMilling] == stopped.stops[kMilling];
        };
        const auto rests = [&] { return std::abs(pinValue("motion.current-vel")) < 1e-9; };
        QVERIFY(cycleUntil([&] { return stands() && m_inputs.actualFeed_mmPerS.value == 0.0; }, stopped));

        for (int round = 0; round < 2; ++round) {  // the one that took the place of a dead one may die as well
            QVERIFY(kerf::test::LinuxCncControl::killBridge() != 0);
            m_deadline = std::chrono::steady_clock::now();
            QVERIFY(linkIs(kerf::LinkState::Down));
            QVERIFY(rests());
            QVERIFY(aConsoleStartedNowHasNoLink());
            QVERIFY(kerf::test::LinuxCncControl::startBridge());
            m_deadline = std::chrono::steady_clock::now();
            // A console that has forgotten its stop lowers none.
            QVERIFY(cycleUntil(stands, neutral()));
            settle();
            QVERIFY(rests());
            QVERIFY(cycleUntil(stands, neutral()));
            QCOMPARE(m_inputs.program, kerf::ProgramState::Running);
        }
        // Beside a console that commands nobody looks at the punctuality; without one, what stands still stays so.
        const auto jitter = [] {
            return kerf::test::runKerf({QStringLiteral("machine"), QStringLiteral("jitter"),
                                        QStringLiteral("--seconds"), QStringLiteral("3")});
        };
        const double z_mm = pinValue("joint.2.pos-cmd");
        const kerf::test::KerfRun refused = jitter();
        QCOMPARE(refused.exitCode, 3);
        QVERIFY2(refused.err.contains(QStringLiteral("Another program (process %1)").arg(::getpid())),
                 qPrintable(refused.err));
        m_machine.reset();  // and the console
        const kerf::test::KerfRun run = jitter();
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(kerf::test::csvRows(run.out).size(), 4);
        QVERIFY(rests());
        QVERIFY(std::abs(pinValue("joint.2.pos-cmd") - z_mm) < 1e-9);
        m_machine = std::make_unique<kerf::linuxcnc::LinuxCncMachine>(kerf::linuxcnc::LinuxCncMachine::Params{});
        QVERIFY(m_machine->connect().has_value());
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(cycleUntil(stands, neutral()));
        settle();
        QVERIFY(rests());
        QVERIFY(cycleUntil(stands, neutral()));

        kerf::MachineOutputs released = neutral();  // a person's release of this stop
        released.stops[kMilling] = stopped.stops[kMilling];
        released.stops[kMilling].released = released.stops[kMilling].number;
        QVERIFY(cycleUntil([this] { return m_inputs.actualFeed_mmPerS.value > 0.0; }, released));
        QVERIFY(!m_inputs.stops[kMilling].active());
        QVERIFY(cycleUntil([this] { return homed(); }, neutral()));  // commands go out again
    }
    void controlKilledIsNoticedAndComesBack() {
        kerf::StartProgram program = longProgram();
        program.plannedFeedScale = 0.5;
        kerf::MachineOutputs outputs = neutral();
        outputs.request = {++m_request, program};
        QVERIFY(
            cycleUntil([&] { return m_inputs.program == kerf::ProgramState::Running && feedShare() > 0.9; }, outputs));
        const std::int64_t killed_ns = kerf::test::LinuxCncControl::killBridge();
        QVERIFY(killed_ns != 0);
        std::int64_t noticed_ns = 0;
        m_deadline = std::chrono::steady_clock::now();
        while (kerf::test::monotonic_ns() - killed_ns < 2'000'000'000 && noticed_ns == 0) {
            cycle(neutral());
            if (m_inputs.link == kerf::LinkState::Down) {
                noticed_ns = kerf::test::monotonic_ns();
            }
        }
        QVERIFY(noticed_ns != 0);
        qInfo("bridge killed: link down after %.0f ms", static_cast<double>(noticed_ns - killed_ns) * 1e-6);
        QVERIFY2(std::abs(trueFeedShare() - 0.5) < 0.02, qPrintable(QString::number(trueFeedShare())));
        m_control.stop();
        QVERIFY2(m_control.start(), m_control.log());
        m_deadline = std::chrono::steady_clock::now();
        QVERIFY(linkIs(kerf::LinkState::Up));  // by itself
        QVERIFY(cycleUntil([this] { return m_inputs.machineOn && homed(); }, neutral()));
    }

 private:
    /// As an ordinary user, like everything that touches LinuxCNC's HAL.
    static QProcess& halcmd(const QStringList& arguments) {
        static QProcess process;
        QStringList all{QStringLiteral("halcmd")};
        if (::geteuid() == 0) {
            all = QStringList{QStringLiteral("setpriv"), QStringLiteral("--reuid=nobody"),
                              QStringLiteral("--regid=nogroup"), QStringLiteral("--clear-groups"),
                              QStringLiteral("halcmd")};
        }
        all += arguments;
        process.start(all.takeFirst(), all);
        process.waitForFinished();
        return process;
    }
    static int setPin(const char* pin, const char* value) {
        return halcmd({QStringLiteral("setp"), QLatin1String(pin), QLatin1String(value)}).exitCode();
    }
    static double pinValue(const char* pin) {
        return halcmd({QStringLiteral("getp"), QLatin1String(pin)}).readAllStandardOutput().trimmed().toDouble();
    }
    static QByteArray getPins(const char* pattern) {
        return halcmd({QStringLiteral("-s"), QStringLiteral("show"), QStringLiteral("pin"), QLatin1String(pattern)})
            .readAllStandardOutput();
    }
    /// From halcmd's lines "owner type direction value name".
    static int wordOf(const QByteArray& lines) {
        int word = 0;
        for (const QByteArray& line : lines.split('\n')) {
            const QList<QByteArray> cells = line.simplified().split(' ');
            if (cells.size() >= 5 && cells[3] == "TRUE") {
                word |= 1 << cells[4].mid(static_cast<int>(qstrlen("kerf.word-"))).toInt();
            }
        }
        return word;
    }
    [[nodiscard]] double programmed() const { return m_inputs.programmedFeed_mmPerS.value; }
    /// A program can be started: asked once per call of cycleUntil's condition, answered by the control itself.
    [[nodiscard]] bool answered() const {
        return m_inputs.reply.number == m_request && m_inputs.reply.state != kerf::RequestState::Accepted;
    }
    [[nodiscard]] bool homed() const { return m_machine->commandsReady(); }
    void settle() {
        for (int i = 0; i < 100; ++i) {
            cycle(neutral());
        }
    }

    kerf::test::LinuxCncControl m_control;
    std::unique_ptr<kerf::linuxcnc::LinuxCncMachine> m_machine;
    std::chrono::steady_clock::time_point m_deadline{};
};
/// A console that only lives: reads, and writes what changes nothing, until it is killed.
int beAConsole() {
    kerf::linuxcnc::LinuxCncMachine machine(kerf::linuxcnc::LinuxCncMachine::Params{});
    (void)machine.connect();
    for (;;) {
        kerf::MachineInputs inputs;
        machine.read(kerf::test::monotonic_ns(), inputs);
        machine.write(kerf::MachineOutputs{});
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == kBeAConsole) {
        return beAConsole();
    }
    QCoreApplication application(argc, argv);
    TestLinuxCncMachine test;
    return kerf::test::runInTime([&] { return QTest::qExec(&test, argc, argv); });
}
#include "tst_linuxcnc_machine.moc"
