// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <functional>
#include <memory>
#include <thread>

#include "engine/machine/linuxcnc/linuxcnc_machine.h"
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
        LinuxCncMachine::Params params;
        params.rsh = this->params();
        m_machine = std::make_unique<LinuxCncMachine>(params);
        QVERIFY(m_machine->connect().has_value());
        QVERIFY(until([this] { return m_machine->commandsReady(); }));
    }
    /// One millisecond of the machine's time.
    void cycle(bool bridge = true, bool servo = true) {
        if (bridge) {
            m_bridge->beat(servo);
        }
        m_now_ns += kCycle_ns;
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
