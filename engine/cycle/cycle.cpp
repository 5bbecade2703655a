// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/cycle.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/cycle/machine_alarms.h"

namespace kerf {
namespace {

constexpr int kCommandsPerCycle = 4;
constexpr std::int64_t kMissed_ns = 50'000'000;  // less than any machine waits for its console
constexpr double kMaxSimulationSpeed = 1000.0;

/// Whose work is named by the command that loads what it is cut with; null: it names none.
const WorkOrder* orderOf(const Command& command) noexcept {
    return std::visit(
        [](const auto& action) -> const WorkOrder* {
            if constexpr (requires { action.order->lot; }) {
                return action.order ? &*action.order : nullptr;
            } else {
                return nullptr;
            }
        },
        command.action);
}

/// What passes from a loop that does not control: only the start or end of its own part program.
bool isProgramRequest(const PortRequest& request) {
    return std::holds_alternative<StartProgram>(request.action) || std::holds_alternative<AbortProgram>(request.action);
}

}  // namespace

Cycle::Cycle(MachinePort& port, std::vector<std::unique_ptr<ProcessLoop>> loops, EngineRings& rings)
    : m_port(port),
      m_loops(std::move(loops)),
      m_rings(rings),
      m_events(rings.alarms, rings.parts),
      m_limiter(port.capabilities()) {
    for (const auto& loop : m_loops) {
        m_byProcess[static_cast<std::size_t>(loop->id())] = loop.get();
    }
}

void Cycle::step(std::int64_t now_ns) noexcept {
    if (const std::uint32_t asked = m_rings.holdsAsked.load(std::memory_order_acquire); asked != m_holdsTaken) {
        m_holdsTaken = asked;
        m_supervisor.hold(Sentence(KERF_TEXT("All loops are held by the operator; the last offset stays.")));
    }
    m_port.read(now_ns, m_inputs);
    m_events.now_ns = now_ns;
    m_events.flush();
    watchMachine();
    takeCommands();
    showStops();
    tellRefused();
    sayRefused();
    for (const auto& loop : m_loops) {
        runLoop(*loop);
    }

    const double dt_s = m_cycles == 0 ? 0.0 : static_cast<double>(now_ns - m_lastTime_ns) / kNanosecondPerSecond;
    m_outputs = m_limiter.apply(m_wishes, m_inputs, dt_s, m_limitReport);
    for (std::size_t i = 0; i < m_limitReport.refusedCount && m_refusedCount < m_refused.size(); ++i) {
        m_refused[m_refusedCount++] = m_limitReport.refused[i];
    }
    m_port.write(m_outputs);
    m_lastTime_ns = now_ns;
    ++m_cycles;
}

void Cycle::runLoop(ProcessLoop& loop) noexcept {
    const auto index = static_cast<std::size_t>(loop.id());
    const LoopMode mode = m_supervisor.effectiveMode(loop.id(), m_inputs, m_port.capabilities());
    if (mode != m_modes[index]) {
        loop.setMode(mode);
        m_modes[index] = mode;
    }
    LoopOutputs& wish = m_wishes[index];
    wish = LoopOutputs{};
    m_verdicts[index] = loop.step(m_inputs, m_port.capabilities(), wish, m_events);
    if (m_verdicts[index].state == LoopState::Faulted && wish.stop.kind == StopKind::None) {
        wish.stop = {StopKind::LoopOut, 0, m_verdicts[index].reason};
    }
    if (mode == LoopMode::Control) {
        return;
    }
    LoopOutputs passed;
    passed.stop = wish.stop;
    if (passed.stop.kind == StopKind::FeedHold) {
        passed.stop.kind = StopKind::NoStart;  // the feed is not ours to hold
    }
    passed.outOfWork = wish.outOfWork;
    const bool out =
        mode == LoopMode::Advise && std::holds_alternative<RetractInSync>(wish.request.action);  // asked by a person
    if (out || isProgramRequest(wish.request)) {
        passed.request = wish.request;
    }
    wish = passed;
}

void Cycle::watchMachine() noexcept {
    const bool linkUp = m_inputs.link == LinkState::Up;
    // A cycle that comes this late was missed: the machine may have let go, which is a reconnect.
    const bool missed = m_cycles > 0 && m_inputs.time_ns - m_lastTime_ns > kMissed_ns;
    if (linkUp && (!m_linkWasUp || missed)) {
        m_limiter.adopt(m_inputs,
                        m_port.capabilities());  // after every (re)connect: go on from what the machine really has
    }
    m_linkWasUp = linkUp;
    if (linkUp) {
        m_limiter.stops().join(m_inputs.stops, m_inputs.time_ns);
    }
    if (m_supervisor.watch(m_inputs)) {  // a release that was asked before does not count for this hold
        m_holdsTaken = m_rings.holdsAsked.fetch_add(1, std::memory_order_acq_rel) + 1;
    }
    m_events.set(machine_alarm::kLinkDown, !linkUp);
    m_events.set(machine_alarm::kEmergencyStop, linkUp && m_inputs.emergencyStop);
    m_events.set(machine_alarm::kPartStoreFull, partsBlocked());
    m_events.set(machine_alarm::kPartUnrecorded, m_events.unrecordedNow(),
                 Sentence(KERF_TEXT("%1 finished parts are not recorded."),
                          SentenceArg(static_cast<double>(m_events.partsUnrecorded()), 0)));
}

/// Stops as they stand now, to the loops and to the alarms that tell of them.
void Cycle::showStops() noexcept {
    const StopSlots before = m_events.stops;
    m_inputs.stops = m_events.stops = m_limiter.stops().all();
    for (const ProcessId id : allProcesses()) {
        const auto index = static_cast<std::size_t>(id);
        const StopSlot& slot = m_inputs.stops[index];
        if (slot.active() && slot.cause != 0) {
            m_events.raise(slot.cause, m_limiter.stops().status(id).reason);
        }
        if (before[index].active() && before[index].cause != 0 &&
            (!slot.active() || slot.cause != before[index].cause)) {
            m_events.clear(before[index].cause);
        }
    }
}

/// The machine answers one request at a time; what the limiter has refused is told in a cycle without a new answer.
void Cycle::tellRefused() noexcept {
    const bool news = m_inputs.reply.number != m_portReply.number || m_inputs.reply.state != m_portReply.state;
    m_portReply = m_inputs.reply;
    if (news || m_refusedCount == 0) {
        return;
    }
    m_inputs.reply = m_refused[0];
    std::move(m_refused.begin() + 1, m_refused.begin() + static_cast<std::ptrdiff_t>(m_refusedCount),
              m_refused.begin());
    --m_refusedCount;
}

/// What the machine or the limiter did not carry out is said, whichever loop has asked for it; until something is
/// taken.
void Cycle::sayRefused() noexcept {
    const RequestReply& reply = m_inputs.reply;
    if (reply.number == m_saidReply.number && reply.state == m_saidReply.state) {
        return;
    }
    m_saidReply = reply;
    if (m_cycles == 0) {  // an answer to a console before this one is none to us
        return;
    }
    // The machine repeats its last answer after the limiter has refused something: only what was asked later and is
    // taken ends the alarm.
    if (reply.state == RequestState::Refused) {
        m_refusedNumber = reply.number;
        m_events.clear(machine_alarm::kNotCarriedOut);
        m_events.raise(machine_alarm::kNotCarriedOut, reply.reason);
    } else if (static_cast<std::int32_t>(reply.number - m_refusedNumber) > 0) {
        m_events.clear(machine_alarm::kNotCarriedOut);
    }
}

void Cycle::takeCommands() noexcept {
    Command command;
    for (int i = 0; i < kCommandsPerCycle && m_rings.commands.tryPop(command); ++i) {
        CommandResult result = execute(command);
        result.number = command.number;
        std::move_backward(m_recentCommands.begin(), m_recentCommands.end() - 1, m_recentCommands.end());
        m_recentCommands[0] = result;
    }
}

CommandResult Cycle::execute(const Command& command) noexcept {
    if (const auto* mode = std::get_if<SetLoopMode>(&command.action)) {
        if (find(mode->process) == nullptr && mode->mode != LoopMode::Off) {
            return CommandResult::refused(Sentence(KERF_TEXT("Not fitted yet.")));
        }
        return m_supervisor.setMode(mode->process, mode->mode, m_port.capabilities());
    }
    if (const auto* release = std::get_if<ReleaseHold>(&command.action)) {
        if (release->holdsSeen != m_rings.holdsAsked.load(std::memory_order_acquire)) {
            return CommandResult::refused(Sentence(KERF_TEXT("Held again since the release was asked.")));
        }
        const Sentence why = m_supervisor.release(m_inputs);
        return why.empty() ? CommandResult::ok() : CommandResult::refused(why);
    }
    if (const auto* release = std::get_if<ReleaseStop>(&command.action)) {
        const Sentence why = m_limiter.stops().release(release->process, release->number, release->person.view());
        return why.empty() ? CommandResult::ok() : CommandResult::refused(why);
    }
    if (const auto* kept = std::get_if<RestoreStops>(&command.action)) {
        m_limiter.stops().join(kept->stops, m_inputs.time_ns);
        return CommandResult::ok();
    }
    if (const auto* speed = std::get_if<SetSimulationSpeed>(&command.action)) {
        if (!m_port.capabilities().simulated) {
            return CommandResult::refused(Sentence(KERF_TEXT("A real machine runs at its own speed.")));
        }
        const bool inRange = speed->factor == 0.0 || (speed->factor >= 1.0 && speed->factor <= kMaxSimulationSpeed);
        if (!inRange) {
            return CommandResult::refused(
                Sentence(KERF_TEXT("Simulation speed must be from 1 to 1000, or 0 for as fast as possible.")));
        }
        m_simulationSpeed = speed->factor;
        return CommandResult::ok();
    }
    if (const auto* start = std::get_if<StartPart>(&command.action)) {
        return startPart(command, *start);
    }
    ProcessLoop* loop = find(processOf(command));
    if (const auto* name = std::get_if<NameOrder>(&command.action); name != nullptr && loop != nullptr) {
        loop->nameOrder(name->order);
        return CommandResult::ok();
    }
    if (loop != nullptr) {
        const CommandResult result = loop->handle(command);
        if (const WorkOrder* order = orderOf(command); order != nullptr && result.done) {
            loop->nameOrder(*order);
        }
        return result;
    }
    return CommandResult::refused(Sentence(KERF_TEXT("Not fitted yet.")));
}

CommandResult Cycle::startPart(const Command& command, const StartPart& start) noexcept {
    ProcessLoop* loop = find(start.process);
    const Capability& cycleStart = m_port.capabilities().cycleStart;
    if (loop == nullptr) {
        return CommandResult::refused(Sentence(KERF_TEXT("Not fitted yet.")));
    }
    if (!cycleStart.fitted) {
        return CommandResult::refused(cycleStart.why);
    }
    if (partsBlocked()) {
        return CommandResult::refused(Sentence(KERF_TEXT("The last part is not stored yet: no new part until it is.")));
    }
    if (const Sentence stop = m_limiter.stops().whyNoStart(); !stop.empty()) {
        return CommandResult::refused(stop);
    }
    if (m_supervisor.held()) {
        return CommandResult::refused(Sentence(KERF_TEXT("All loops are held: release the hold first.")));
    }
    if (m_inputs.link != LinkState::Up || !m_inputs.machineOn || m_inputs.emergencyStop) {
        return CommandResult::refused(Sentence(KERF_TEXT("The machine is not ready.")));
    }
    if (m_inputs.program == ProgramState::Running || m_inputs.program == ProgramState::Paused) {
        return CommandResult::refused(Sentence(KERF_TEXT("A part is being cut.")));
    }
    if (start.order && *start.order != loop->order()) {
        return CommandResult::refused(Sentence(
            KERF_TEXT("Lot, recipe or schedule has changed since the start was asked: look, then start again.")));
    }
    return loop->handle(command);
}

LoopStatus Cycle::describe(ProcessId id) const noexcept {
    const auto index = static_cast<std::size_t>(id);
    return m_supervisor.describe(id, m_byProcess[index] != nullptr, m_verdicts[index], m_inputs, m_port.capabilities(),
                                 m_limiter.stops().status(id));
}

void Cycle::publish(const CycleStats& stats) noexcept {
    Status& status = m_rings.status.writeSlot();
    status.machineTime_ns = m_inputs.time_ns;
    status.cycle = m_cycles;
    status.link = m_inputs.link;
    status.machineOn = m_inputs.machineOn;
    status.emergencyStop = m_inputs.emergencyStop;
    status.feedHold = m_inputs.feedHold;
    status.held = m_supervisor.held();
    status.partsBlocked = partsBlocked();
    status.operatorOverride = m_inputs.operatorOverride;
    status.simulationSpeed = m_simulationSpeed;
    status.feedScale = m_outputs.feedScale;
    status.feedScaleLimited = m_limitReport.feedScale;
    status.actualFeed_mmPerS = m_inputs.actualFeed_mmPerS;
    status.spindleSpeed_rpm = m_inputs.spindleSpeed_rpm;
    status.position_mm = m_inputs.position_mm;
    status.workOffset_um = m_outputs.workOffset_um;
    status.program = m_inputs.program;
    status.programProcess = m_inputs.programProcess;
    status.partSequence = m_inputs.partSequence;
    status.lastCommand = m_recentCommands[0];
    status.recentCommands = m_recentCommands;
    for (const ProcessId id : allProcesses()) {
        const auto index = static_cast<std::size_t>(id);
        status.stops[index] = m_limiter.stops().status(id);
        status.loops[index] = describe(id);
        if (m_byProcess[index] != nullptr) {
            m_byProcess[index]->report(status);
            status.orders[index] = m_byProcess[index]->order();
        }
    }
    status.stats = stats;
    status.stats.droppedSamples = m_rings.samples.refused();
    m_rings.status.publish();
}

void Cycle::emitSample(std::int64_t wallTime_ns) noexcept {
    Sample sample;
    sample.machineTime_ns = m_inputs.time_ns;
    sample.wallTime_ns = wallTime_ns;
    sample.feed_mmPerS = static_cast<float>(m_inputs.actualFeed_mmPerS.value);
    sample.cutting = m_inputs.program == ProgramState::Running;
    for (const auto& loop : m_loops) {
        loop->sample(sample);
    }
    (void)m_rings.samples.tryPush(sample);  // refused ones are counted by the ring
}

}  // namespace kerf
