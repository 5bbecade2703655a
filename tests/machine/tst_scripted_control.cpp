// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QProcess>
#include <QTest>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <thread>

#include "engine/limits/output_limiter.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/machine/linuxcnc/period_clock.h"
#include "engine/machine/linuxcnc/programs.h"
#include "tests/support/scripted_control.h"

using namespace kerf;
using namespace kerf::linuxcnc;

namespace {

StartProgram bore() {
    StartProgram program;
    program.process = ProcessId::Boring;
    program.programmedFeed_mmPerRev = 0.17;
    program.spindleSpeed_rpm = 1200.0;
    program.from_mm = 40.0;
    program.to_mm = 60.0;
    return program;
}

/// Waits for what another thread does; nothing is measured by it.
bool until(const std::function<bool()>& condition) {
    for (int i = 0; i < 20'000; ++i) {
        if (condition()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

constexpr std::int64_t kCycle_ns = 1'000'000;

}  // namespace

/// LinuxCNC's two doors against a scripted counterpart: the commands' line protocol, and the memory shared with the
/// bridge. Machine time is counted, so nothing here depends on how busy the computer is.
class TestScriptedControl : public QObject {
    Q_OBJECT
 private:
    RshLink::Params params() const { return {"127.0.0.1", m_rsh->port(), {}, test::ownMemory()}; }

    RequestReply replyOf(RshLink& link) {
        RequestReply reply;
        return until([&] { return link.tryReply(reply); }) ? reply : RequestReply{};
    }
    void makeMachine() {
        makeMachineOnly();
        QVERIFY(until([this] { return m_machine->commandsReady(); }));
    }
    void makeMachineOnly() {
        LinuxCncMachine::Params params;
        params.rsh = this->params();
        m_machine = std::make_unique<LinuxCncMachine>(params);
        QVERIFY(m_machine->connect().has_value());
    }
    /// A force sensor on its pin, as the machine file describes it.
    void makeMachineWithForce(const DescribedForce& described) {
        m_bridge->seen.fitted.simulator = false;
        m_bridge->seen.fitted.force = m_bridge->seen.fitted.forceLinked = true;
        LinuxCncMachine::Params params;
        params.rsh = this->params();
        params.described.force = described;
        m_machine = std::make_unique<LinuxCncMachine>(params);
        QVERIFY(m_machine->connect().has_value());
        cycles(3);
    }
    static DescribedForce piezo() {
        DescribedForce described;
        described.bandwidth_Hz = 300.0;
        described.scale_NPerUnit = -200.0;
        described.range_N = 1900.0;
        return described;
    }
    /// One millisecond of the machine's time.
    void cycle(bool bridge = true, bool servo = true) {
        m_now_ns += kCycle_ns;
        m_bridge->now_ns = m_now_ns;
        if (bridge) {
            m_bridge->beat(servo);
        }
        m_machine->read(m_now_ns, m_inputs);
        m_outputs.heartbeat += 1;
        m_machine->write(m_outputs);
    }
    void cycles(int count, bool bridge = true, bool servo = true) {
        for (int i = 0; i < count; ++i) {
            cycle(bridge, servo);
        }
    }
    bool cyclesUntil(const std::function<bool()>& condition) {
        return until([&] { return cycle(), condition(); });
    }
    bool cyclesStillUntil(const std::function<bool()>& condition) {  // the bridge stands still
        return until([&] { return cycle(false), condition(); });
    }
    void ask(std::uint32_t number, const decltype(PortRequest::action)& action) {
        m_outputs.request.number = number;
        m_outputs.request.action = action;
    }

    std::unique_ptr<test::ScriptedRsh> m_rsh{};
    std::unique_ptr<test::ScriptedBridge> m_bridge{};
    std::unique_ptr<LinuxCncMachine> m_machine{};
    MachineInputs m_inputs{};
    MachineOutputs m_outputs{};
    std::int64_t m_now_ns{0};

 private slots:
    void init() {
        qputenv("KERF_LINUXCNC_PASSWORDS", QByteArray());
        m_rsh = std::make_unique<test::ScriptedRsh>();
        m_bridge = std::make_unique<test::ScriptedBridge>();
        QVERIFY(m_bridge->memory != nullptr);
        m_bridge->ready();
        m_bridge->beat();
        m_inputs = {};
        m_outputs = {};
        m_now_ns = 1'000'000'000;
    }
    void cleanup() {
        m_machine.reset();
        m_bridge.reset();
        m_rsh.reset();
    }

    // The commands' line.
    void itGreetsWithItsPasswordAndTurnsTheEchoOff() {
        RshLink::Params own = params();
        own.password = {"door", "key"};
        RshLink link(own);
        QVERIFY(until([&] { return link.connected(); }));
        const auto heard = m_rsh->heard();
        QCOMPARE(heard.size(), std::size_t{3});
        QVERIFY(heard[0].starts_with("hello door "));
        QCOMPARE(heard[1], std::string("set echo off"));
        PortRequest request;
        request.number = 7;
        request.action = bore();
        QVERIFY(link.tryAsk(request));
        QCOMPARE(replyOf(link).state, RequestState::Done);
        QVERIFY(m_rsh->hasHeard("set enable key"));
        QVERIFY(m_rsh->hasHeard("set mode mdi"));
        QVERIFY(m_rsh->hasHeard("set mdi o<"));
    }
    void aWrongPasswordNeverCounts() {
        m_rsh->script("hello", {"HELLO NAK", false, {}});
        RshLink link(params());
        QVERIFY(until([&] { return m_rsh->connections() >= 2; }));  // it tries again
        QVERIFY(!link.connected());
        PortRequest request;
        request.number = 3;
        request.action = bore();
        QVERIFY(link.tryAsk(request));
        const RequestReply reply = replyOf(link);
        QCOMPARE(reply.number, 3U);
        QCOMPARE(reply.state, RequestState::Refused);
    }
    void whatIsRefusedIsNeverDone_data() {
        QTest::addColumn<QString>("line");
        for (const char* line : {"set enable", "set mode", "set mdi"}) {
            QTest::newRow(line) << line;
        }
    }
    void whatIsRefusedIsNeverDone() {
        QFETCH(QString, line);
        m_rsh->script(line.toStdString(), {"SET NAK", false, {}});
        RshLink link(params());
        QVERIFY(until([&] { return link.connected(); }));
        PortRequest request;
        request.number = 11;
        request.action = bore();
        QVERIFY(link.tryAsk(request));
        const RequestReply reply = replyOf(link);
        QCOMPARE(reply.number, 11U);
        QCOMPARE(reply.state, RequestState::Refused);
        QVERIFY(!reply.reason.empty());
    }
    void aLineThatIsCutIsNeverDoneAndComesBack() {
        m_rsh->script("set mdi", {"", true, {}});
        RshLink link(params());
        QVERIFY(until([&] { return link.connected(); }));
        PortRequest request;
        request.number = 12;
        request.action = bore();
        QVERIFY(link.tryAsk(request));
        QCOMPARE(replyOf(link).state, RequestState::Refused);
        m_rsh->forget();
        QVERIFY(until([&] { return m_rsh->connections() >= 2 && link.connected(); }));
        request.number = 13;
        QVERIFY(link.tryAsk(request));
        const RequestReply reply = replyOf(link);
        QCOMPARE(reply.number, 13U);
        QCOMPARE(reply.state, RequestState::Done);
    }
    void aLateAnswerNeverCountsForAnotherCommand() {
        RshLink link(params());
        QVERIFY(until([&] { return link.connected(); }));
        m_rsh->script("set mode", {"SET ACK", false, "SET ACK"});  // one more, unasked, before the next answer
        m_rsh->script("set mdi", {"SET NAK", false, {}});
        PortRequest request;
        request.number = 21;
        request.action = bore();
        QVERIFY(link.tryAsk(request));
        const RequestReply first = replyOf(link);
        QCOMPARE(first.number, 21U);
        m_rsh->forget();
        m_rsh->script("set mdi", {"SET NAK", false, {}});
        request.number = 22;
        QVERIFY(link.tryAsk(request));
        const RequestReply second = replyOf(link);
        QCOMPARE(second.number, 22U);
        QCOMPARE(second.state, RequestState::Refused);  // the late one did not make it done
    }
    void abortOvertakesWhatNobodyAnswers() {
        m_rsh->script("set mdi", {"", false, {}});  // taken, never answered
        RshLink link(params());
        QVERIFY(until([&] { return link.connected(); }));
        PortRequest start;
        start.action = bore();
        for (const std::uint32_t number : {31U, 32U, 33U}) {
            start.number = number;
            QVERIFY(link.tryAsk(start));
        }
        QVERIFY(until([&] { return m_rsh->hasHeard("set mdi"); }));
        PortRequest abort;
        abort.number = 34;
        abort.action = AbortProgram{};
        QVERIFY(link.tryAsk(abort));
        std::vector<RequestReply> replies;
        for (int i = 0; i < 4; ++i) {
            replies.push_back(replyOf(link));
        }
        for (const RequestReply& reply : replies) {
            QCOMPARE(reply.state, reply.number == 34 ? RequestState::Done : RequestState::Refused);
        }
        const auto heard = m_rsh->heard();
        QCOMPARE(std::ranges::count_if(heard, [](const auto& line) { return line.starts_with("set mdi"); }), 1);
        QVERIFY(m_rsh->hasHeard("set abort"));
    }

    // The bridge's memory, in machine time.
    void aBeatThatStandsStillIsALostLink_data() {
        QTest::addColumn<bool>("bridge");
        QTest::newRow("bridge") << false;
        QTest::newRow("servo thread") << true;
    }
    void aBeatThatStandsStillIsALostLink() {
        QFETCH(bool, bridge);
        makeMachine();
        cycles(3);
        QCOMPARE(m_inputs.link, LinkState::Up);
        cycles(99, bridge, false);
        QCOMPARE(m_inputs.link, LinkState::Up);
        cycles(2, bridge, false);
        QCOMPARE(m_inputs.link, LinkState::Down);
        QVERIFY(!m_inputs.actualFeed_mmPerS.good());
        cycles(1);
        QCOMPARE(m_inputs.link, LinkState::Up);
    }
    void aNewBridgeIsFoundAndItsCountsBeginAnew() {
        makeMachine();
        m_bridge->seen.beat = 5000;
        cycles(3);
        QCOMPARE(m_inputs.link, LinkState::Up);
        m_bridge.reset();  // gone, as after a restart of the control
        m_bridge = std::make_unique<test::ScriptedBridge>();
        m_bridge->ready();
        QVERIFY(cyclesUntil([this] { return m_machine->commands() && m_bridge->wish().beat > 0; }));
        cycles(2);
        QCOMPARE(m_inputs.link, LinkState::Up);
    }
    void whatAnotherProgramCommandsDoesNotFallToUsWithANewBridge() {
        makeMachine();
        cycles(3);
        QVERIFY(m_machine->commands());
        m_bridge->memory->owner.store(1);  // a person has taken it over
        cycles(1);
        QVERIFY(!m_machine->commands());
        m_bridge.reset();
        m_bridge = std::make_unique<test::ScriptedBridge>();
        m_bridge->ready();
        QVERIFY(cyclesUntil([this] { return m_inputs.link == LinkState::Up && m_bridge->seen.beat > 200; }));
        QCOMPARE(m_bridge->memory->owner.load(), std::uint64_t{0});
        QVERIFY(!m_machine->commands());
    }
    void aBridgeThatHasShownNothingYetIsNoLink() {
        makeMachine();
        cycles(3);
        m_bridge.reset();
        m_bridge = std::make_unique<test::ScriptedBridge>();
        m_bridge->ready();
        QVERIFY(until([this] {  // found, but not a round of it
            cycle(false);
            return m_machine->commands() && m_bridge->memory->owner.load() != 0;
        }));
        QCOMPARE(m_inputs.link, LinkState::Down);
        m_bridge->seen.feedEpoch = 12;
        cycles(2);
        QCOMPARE(m_inputs.link, LinkState::Up);
        QCOMPARE(m_bridge->wish().feedEpoch, 12U);
    }
    void whatAKilledBridgeHasLeftBehindIsNoLink_data() {
        QTest::addColumn<bool>("another");
        QTest::newRow("at the start") << false;
        QTest::newRow("found later") << true;
    }
    void whatAKilledBridgeHasLeftBehindIsNoLink() {
        QFETCH(bool, another);
        m_bridge->seen.emergencyStop = true;
        m_bridge->seen.programRunning = true;
        for (int i = 0; i < 700; ++i) {
            m_bridge->beat();
        }
        if (another) {  // nothing was there when the console came
            const auto memory = std::exchange(m_bridge, nullptr);
            (void)shm_unlink(test::ownMemory().c_str());
        }
        makeMachineOnly();
        if (another) {
            m_bridge = std::make_unique<test::ScriptedBridge>();
            m_bridge->seen.beat = m_bridge->seen.servoPeriods = 700;
            m_bridge->beat();
            m_bridge->ready();
            QVERIFY(cyclesStillUntil([this] { return m_bridge->memory->owner.load() != 0; }));
        }
        for (int i = 0; i < 300; ++i) {
            cycle(false);
            QCOMPARE(m_inputs.link, LinkState::Down);
            QVERIFY(!m_inputs.actualFeed_mmPerS.good());
        }
        cycles(3, true, false);  // the bridge lives, the control does not
        QCOMPARE(m_inputs.link, LinkState::Down);
        cycles(2);
        QCOMPARE(m_inputs.link, LinkState::Up);
    }
    void aWishFollowsOnWhatTheBridgeHasShown() {
        makeMachine();
        m_bridge->seen.feedEpoch = 3;
        cycles(3);
        QCOMPARE(m_bridge->wish().feedEpoch, 3U);
        m_bridge->seen.feedEpoch = 4;  // let go, but this console has not seen it
        cycles(5, false);
        QCOMPARE(m_bridge->wish().feedEpoch, 3U);
        cycles(1);
        QCOMPARE(m_bridge->wish().feedEpoch, 4U);
    }
    void whereNothingIsLeftWithoutTheBridgeNoFeedIsScaled() {
        m_bridge->seen.fitted.lossScale = false;  // a kerf.hal of before
        makeMachine();
        cycles(3);
        const Capabilities& capabilities = m_machine->capabilities();
        QVERIFY(!capabilities.feedScale.fitted);
        QVERIFY(capabilities.feedScale.why.english().starts_with("kerf.loss-scale"));
        for (const ProcessId id : {ProcessId::Boring, ProcessId::Milling}) {
            const Capability& host = capabilities.process[static_cast<std::size_t>(id)];
            QVERIFY(!host.fitted && !host.why.empty());
        }
    }
    /// The servo thread has died, the bridge has not: what it hears must be at most the planned feed, not a hold.
    void aLostLinkLeavesThePlannedFeedOfTheProgramThatRuns() {
        makeMachine();
        cycles(3);
        StartProgram program = bore();
        program.plannedFeedScale = 0.4;
        ask(48, program);
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.number == 48 && m_rsh->hasHeard("set mdi"); }));
        m_bridge->seen.declared = declaration(ProcessId::Boring, 48);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        cycles(3);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        OutputLimiter limiter(m_machine->capabilities());
        limiter.adopt(m_inputs, m_machine->capabilities());
        std::array<LoopOutputs, kProcessPlaces> wishes{};
        wishes[0].feedScale = 0.9;
        LimitReport report;
        for (int i = 0; i < 500; ++i) {
            (void)limiter.apply(wishes, m_inputs, 1e-3, report);
        }
        QCOMPARE(limiter.apply(wishes, m_inputs, 1e-3, report).feedScale, 0.9);
        for (int i = 0; i < 200; ++i) {
            cycle(true, false);
            m_outputs = limiter.apply({}, m_inputs, 1e-3, report);
        }
        QCOMPARE(m_inputs.link, LinkState::Down);
        QCOMPARE(m_bridge->wish().feedScale, 0.4);
        QCOMPARE(m_bridge->wish().lossScale, 0.4);
        QCOMPARE(m_bridge->wish().plannedScale, 0.4);
    }
    void aStartThatBeginsAfterItWasGivenUpHasItsPlannedFeed() {
        makeMachine();
        cycles(3);
        StartProgram program = bore();
        program.plannedFeedScale = 0.4;
        ask(47, program);
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.state == RequestState::Refused; }));
        m_bridge->seen.declared = declaration(ProcessId::Boring, 47);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        cycles(3);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        QVERIFY(m_inputs.plannedFeedScale.good());
        QCOMPARE(m_inputs.plannedFeedScale.value, 0.4);
    }
    void anAcknowledgedStartIsDoneOnlyWhenAPartBegins() {
        makeMachine();
        cycles(3);
        ask(41, bore());
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.number == 41 && m_rsh->hasHeard("set mdi"); }));
        cycles(200);
        QCOMPARE(m_inputs.reply.state, RequestState::Accepted);
        QCOMPARE(m_inputs.program, ProgramState::Idle);
        m_bridge->seen.programRunning = true;
        cycles(5);
        QCOMPARE(m_inputs.reply.state, RequestState::Accepted);
        m_bridge->seen.declared = declaration(ProcessId::Boring, 41);
        m_bridge->seen.cutting = true;
        cycles(2);
        QCOMPARE(m_inputs.reply.state, RequestState::Done);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        QCOMPARE(m_inputs.partSequence, 1U);
        m_bridge->seen.cutting = false;
        m_bridge->seen.finished = true;
        cycles(2);
        QCOMPARE(m_inputs.program, ProgramState::Finished);
    }
    void anOperatorsOwnProgramIsNobodys_data() {
        QTest::addColumn<bool>("declares");
        QTest::newRow("a control whose programs declare") << true;
        QTest::newRow("an older kerf.hal") << false;
    }
    void anOperatorsOwnProgramIsNobodys() {
        QFETCH(bool, declares);
        m_bridge->seen.fitted.programDeclared = declares;
        makeMachine();
        cycles(3);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        cycles(50);
        QCOMPARE(m_inputs.program, ProgramState::Idle);
        QCOMPARE(m_inputs.partSequence, 0U);
        QVERIFY(!m_inputs.overhang_mm.good());  // nobody knows where it began
    }
    void itIsNotTakenForTheStartThatWasAskedFor() {
        makeMachine();
        cycles(3);
        ask(44, bore());
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.number == 44 && m_rsh->hasHeard("set mdi"); }));
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;  // the operator was quicker
        cycles(50);
        QCOMPARE(m_inputs.partSequence, 0U);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = false;
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.state == RequestState::Refused; }));
        QCOMPARE(m_inputs.reply.number, 44U);
    }
    void whatAProgramDeclaresCounts() {
        makeMachine();
        cycles(3);
        m_bridge->seen.declared = declaration(ProcessId::Milling, 0);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        cycles(2);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        QVERIFY(m_inputs.programProcess == ProcessId::Milling);
        QVERIFY(!m_inputs.plannedFeedScale.good());
        m_bridge->seen.programRunning = false;  // aborted: what it has declared stays behind in the control
        cycles(2);
        QCOMPARE(m_inputs.program, ProgramState::Aborted);
        m_bridge->seen.cutting = false;
        cycles(2);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;  // the next one declares nothing
        cycles(5);
        QCOMPARE(m_inputs.partSequence, 1U);
        QCOMPARE(m_inputs.program, ProgramState::Aborted);
    }
    void theOverhangIsTheRecipesOrTheDescribedOne_data() {
        QTest::addColumn<bool>("described");
        QTest::newRow("recipe") << false;
        QTest::newRow("machine file") << true;
    }
    void theOverhangIsTheRecipesOrTheDescribedOne() {
        QFETCH(bool, described);
        LinuxCncMachine::Params withFile;
        withFile.rsh = params();
        if (described) {
            withFile.described.overhangAtZ0_mm = 55.0;
        }
        m_machine = std::make_unique<LinuxCncMachine>(withFile);
        QVERIFY(m_machine->connect().has_value() && until([this] { return m_machine->commandsReady(); }));
        m_bridge->seen.position_mm[2] = 10.0;
        cycles(3);
        QCOMPARE(m_inputs.overhang_mm.good(), described);
        ask(45, bore());
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.number == 45 && m_rsh->hasHeard("set mdi"); }));
        m_bridge->seen.declared = declaration(ProcessId::Boring, 45);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        cycles(2);
        m_bridge->seen.position_mm[2] = 4.0;
        cycles(1);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        QVERIFY(m_inputs.overhang_mm.good());
        QCOMPARE(m_inputs.overhang_mm.value, described ? 51.0 : 46.0);
    }
    void describedUnitsTravelAndHostsAreKept() {
        LinuxCncMachine::Params described;
        described.rsh = params();
        described.described.hosts = {true, false, false, false, false};
        described.described.limits.workOffsetMax_um = 30.0;
        described.described.axes[2] = AxisTravel{-10.0, 5.0};
        m_machine = std::make_unique<LinuxCncMachine>(described);
        QVERIFY(m_machine->connect().has_value() && until([this] { return m_machine->commandsReady(); }));
        cycles(3);
        QCOMPARE(m_machine->capabilities().limits.workOffsetMax_um, 30.0);
        QVERIFY(m_machine->capabilities().process[0].fitted);
        QVERIFY(!m_machine->capabilities().process[1].fitted);
        ask(46, bore());  // 20 mm
        cycles(2);
        QCOMPARE(m_inputs.reply.number, 46U);
        QCOMPARE(m_inputs.reply.state, RequestState::Refused);
        QVERIFY(!m_rsh->hasHeard("set mdi"));
        described.described.units = DescribedUnits::Inch;
        m_machine = std::make_unique<LinuxCncMachine>(described);
        QVERIFY(m_machine->connect().has_value());
        cycles(3);
        QVERIFY(!m_machine->capabilities().cycleStart.fitted);
        QVERIFY(m_machine->capabilities().cycleStart.why.english().starts_with("units:"));
    }
    void aStartThatVanishesIsRefused() {
        makeMachine();
        cycles(3);
        ask(42, bore());
        QVERIFY(cyclesUntil([this] { return m_rsh->hasHeard("set mdi"); }));
        QVERIFY(cyclesUntil([this] { return m_inputs.reply.state == RequestState::Refused; }));
        QCOMPARE(m_inputs.reply.number, 42U);
        QVERIFY(!m_inputs.reply.reason.empty());
        QCOMPARE(m_inputs.partSequence, 0U);
    }
    void aReaderSaysWhenWhoeverCommandedHasDied() {
        QProcess other;
        other.start(QStringLiteral("sleep"), {QStringLiteral("600")});
        QVERIFY(other.waitForStarted());
        QFile stat(QStringLiteral("/proc/%1/stat").arg(other.processId()));
        QVERIFY(stat.open(QIODevice::ReadOnly));
        const QByteArray text = stat.readAll();
        const auto begun = text.mid(text.lastIndexOf(')') + 2).split(' ').at(19).toULongLong();
        const std::uint64_t theirs = (static_cast<std::uint64_t>(other.processId()) << 32U) | (begun & 0xFFFFFFFF);
        m_bridge->memory->owner.store(theirs);
        makeMachine();
        const auto why = [this] { return std::string(m_machine->capabilities().cycleStart.why.english()); };
        cycles(3);
        QVERIFY(!m_machine->commands());
        QVERIFY2(why().find("process " + std::to_string(other.processId())) != std::string::npos, why().c_str());
        other.kill();
        QVERIFY(other.waitForFinished());
        QVERIFY(cyclesUntil([&] { return why().starts_with("Nobody commands"); }));
        QVERIFY(!m_machine->commands());  // and does not step in by itself
        QCOMPARE(m_bridge->memory->owner.load(), theirs);
        m_bridge->memory->owner.store(0);  // given back at a clean end
        QVERIFY(cyclesUntil([&] { return why().starts_with("Nobody commands"); }));
    }
    void aReaderInTheSameProgramGivesNothingBack() {
        makeMachine();
        cycles(3);
        QVERIFY(m_machine->commands());
        LinuxCncMachine::Params params;
        params.rsh = this->params();
        auto reader = std::make_unique<LinuxCncMachine>(params);
        reader->onlyRead();
        QVERIFY(reader->connect().has_value());
        MachineInputs seen;
        reader->read(m_now_ns, seen);
        QVERIFY(!reader->commands());
        reader.reset();
        cycles(3);
        QVERIFY(m_machine->commands());
    }
    void aNumberGivenOutAgainIsNobodysClaim() {
        m_bridge->memory->owner.store((static_cast<std::uint64_t>(::getppid()) << 32U) | 1U);
        LinuxCncMachine::Params params;
        params.rsh = this->params();
        m_machine = std::make_unique<LinuxCncMachine>(params);
        QVERIFY(m_machine->connect().has_value());
        cycles(3);
        // A living process, but not with that start time: the program that claimed has died.
        QVERIFY(m_machine->commands());
    }
    // The force on its pin.
    void theForceOfEveryPeriodArrivesHoweverLateTheCycle() {
        makeMachineWithForce(piezo());
        QVERIFY(m_machine->capabilities().forceSensor.fitted);
        QVERIFY(m_machine->capabilities().process[static_cast<std::size_t>(ProcessId::Milling)].fitted);
        QCOMPARE(m_machine->capabilities().force.bandwidth_Hz, 300.0);
        QCOMPARE(m_machine->capabilities().force.rate_Hz, 1000.0);
        constexpr int kPeriods = 200;  // the engine's cycle stands still for .2 s, the servo thread does not
        const std::int64_t from_ns = m_now_ns;
        for (int i = 1; i <= kPeriods; ++i) {
            m_bridge->now_ns = m_now_ns += kCycle_ns;
            m_bridge->force = -0.01 * i;
            m_bridge->seen.spindleAngle_rev = 0.01 * i;
            m_bridge->beat();
        }
        int seen = 0;
        for (int late = 0; late < 8 && seen < kPeriods; ++late) {
            m_machine->read(m_now_ns, m_inputs);
            QVERIFY(m_inputs.fastCount <= kMaxFastSamples);
            for (std::size_t i = 0; i < m_inputs.fastCount; ++i) {
                const FastSample& sample = m_inputs.fast[i];
                ++seen;
                QVERIFY(sample.quality == Quality::Good);
                QVERIFY(std::abs(sample.force_N - 2.0 * seen) < 1e-9);  // newtons, into the work positive
                QVERIFY(std::abs(sample.spindleAngle_rev - 0.01 * seen) < 1e-12);
                QCOMPARE(sample.stamp_ns, from_ns + seen * kCycle_ns);
            }
        }
        QCOMPARE(seen, kPeriods);
        m_machine->read(m_now_ns, m_inputs);
        QCOMPARE(m_inputs.fastCount, std::uint16_t{0});
    }
    void whatIsNoForceIsNoNumber() {
        makeMachineWithForce(piezo());
        const auto next = [this](double pin) {
            m_bridge->force = pin;
            cycle();
            return m_inputs.fastCount == 1 ? m_inputs.fast[0] : FastSample{};
        };
        QVERIFY(next(-1.0).quality == Quality::Good);
        m_bridge->forceFault = true;  // the amplifier's own status
        QVERIFY(next(-1.1).quality == Quality::Bad);
        m_bridge->forceFault = false;
        QVERIFY(next(-1.2).quality == Quality::Good);
        const FastSample none = next(std::numeric_limits<double>::quiet_NaN());
        QVERIFY(none.quality == Quality::Bad && none.force_N == 0.0);
        QVERIFY(next(-9.5).quality == Quality::Saturated);
        QVERIFY(next(9.6).quality == Quality::Saturated);
        FastSample still = next(-2.0);
        int good = 0;
        for (int i = 0; i < 300; ++i) {  // a frozen driver: .1 s and no longer
            good += still.quality == Quality::Good ? 1 : 0;
            still = next(-2.0);
        }
        QCOMPARE(good, 100);
        QVERIFY(still.quality == Quality::Bad && still.force_N == 0.0);
        QVERIFY(next(-2.1).quality == Quality::Good);
        cycles(200, true, false);  // no periods: no samples, and at last no link
        QCOMPARE(m_inputs.fastCount, std::uint16_t{0});
        QCOMPARE(m_inputs.link, LinkState::Down);
    }
    void aForceIsUsedOnlyWithItsBandwidth_data() {
        QTest::addColumn<bool>("sampled");
        QTest::addColumn<double>("inHal_Hz");
        QTest::addColumn<double>("described_Hz");
        QTest::addColumn<double>("counts_Hz");
        QTest::newRow("nobody says it") << true << 0.0 << 0.0 << 0.0;
        QTest::newRow("HAL") << true << 120.0 << 0.0 << 120.0;
        QTest::newRow("machine file") << true << 0.0 << 80.0 << 80.0;
        QTest::newRow("the lower one") << true << 120.0 << 80.0 << 80.0;
        QTest::newRow("half the rate at most") << true << 5000.0 << 0.0 << 500.0;
        QTest::newRow("linked but not sampled") << false << 120.0 << 80.0 << 0.0;
    }
    void aForceIsUsedOnlyWithItsBandwidth() {
        QFETCH(bool, sampled);
        QFETCH(double, inHal_Hz);
        QFETCH(double, described_Hz);
        QFETCH(double, counts_Hz);
        DescribedForce described;
        if (described_Hz > 0.0) {
            described.bandwidth_Hz = described_Hz;
        }
        m_bridge->seen.fitted.forceBandwidth_Hz = inHal_Hz;
        makeMachineWithForce(described);
        m_bridge->seen.fitted.force = sampled;
        cycles(3);
        const Capabilities& capabilities = m_machine->capabilities();
        QCOMPARE(capabilities.forceSensor.fitted, counts_Hz > 0.0);
        QVERIFY(capabilities.forceSensor.fitted || !capabilities.forceSensor.why.empty());
        QCOMPARE(m_inputs.fastCount > 0, sampled);
        if (counts_Hz > 0.0) {
            QCOMPARE(capabilities.force.bandwidth_Hz, counts_Hz);
        }
    }
    void theResetLineGoesOut() {
        m_bridge->seen.fitted.forceReset = true;
        makeMachineWithForce(piezo());
        QVERIFY(m_machine->capabilities().forceReset.fitted);
        QVERIFY(!m_bridge->wish().forceReset);
        m_outputs.forceReset = true;
        cycle();
        QVERIFY(m_bridge->wish().forceReset);
    }
    void servoPeriodsKeepTheirTimes() {
        PeriodClock clock(0.001);
        std::int64_t now_ns = 5'000'000'000;
        std::int64_t last_ns = clock.next(10, 0, now_ns);
        QCOMPARE(last_ns, now_ns);
        for (std::uint32_t number = 11; number < 50; ++number) {  // read late all at once: 1 ms apart all the same
            const std::int64_t stamp_ns = clock.next(number, 0, now_ns + 39'000'000);
            QCOMPARE(stamp_ns - last_ns, 1'000'000);
            last_ns = stamp_ns;
        }
        now_ns += 39'000'000;
        clock.drained(now_ns);
        QCOMPARE(clock.next(52, 250'000, now_ns + 3'300'000) - last_ns, 3'250'000);  // two are missing, one was late
        QCOMPARE(clock.next(53, 0, now_ns + 3'400'000), now_ns + 3'400'000);         // never in the future
        clock.drained(now_ns + 100'000'000);                                         // the thread stood still
        QCOMPARE(clock.next(54, 0, now_ns + 101'000'000), now_ns + 101'000'000);
    }

    void offsetsOfAnotherEpochAreNotOverwritten() {
        makeMachine();
        m_bridge->seen.externalOffset_mm = {0.0, 0.0, 0.020};
        m_bridge->seen.offsetEpoch = 1;
        cycles(1);
        QVERIFY(!m_inputs.workOffset_um[2].good());  // seen for the first time: taken over first
        QCOMPARE(m_bridge->wish().offsetEpoch, 0U);
        cycles(1);
        QVERIFY(m_inputs.workOffset_um[2].good());
        QCOMPARE(m_inputs.workOffset_um[2].value, 20.0);
        QCOMPARE(m_bridge->wish().offsetEpoch, 1U);
        m_bridge->seen.offsetEpoch = 2;  // machine on: the control has zeroed them
        m_bridge->seen.externalOffset_mm = {};
        cycles(1);
        QVERIFY(!m_inputs.workOffset_um[2].good());
        QCOMPARE(m_bridge->wish().offsetEpoch, 0U);
    }
    void anOperatorsPauseIsAPauseAndAStopEndsThePart() {
        makeMachine();
        cycles(3);
        m_bridge->seen.declared = declaration(ProcessId::Boring, 0);
        m_bridge->seen.programRunning = m_bridge->seen.cutting = true;
        m_bridge->seen.currentVelocity_mmPerS = 3.0;
        cycles(2);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        QVERIFY(!m_inputs.plannedFeedScale.good());  // nobody of ours has declared it
        m_bridge->seen.programPaused = true;
        cycles(1);
        QCOMPARE(m_inputs.program, ProgramState::Paused);
        QVERIFY(m_inputs.feedHold);
        m_bridge->seen.programPaused = false;
        cycles(1);
        QCOMPARE(m_inputs.program, ProgramState::Running);
        m_bridge->seen.programRunning = false;  // aborted: the output stays on
        cycles(1);
        QCOMPARE(m_inputs.program, ProgramState::Aborted);
    }
};
QTEST_GUILESS_MAIN(TestScriptedControl)
#include "tst_scripted_control.moc"
