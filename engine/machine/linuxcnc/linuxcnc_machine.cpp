// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/linuxcnc_machine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>
#include <variant>

#include "engine/machine/described_machine.h"
#include "engine/machine/linuxcnc/fitted.h"
#include "engine/machine/linuxcnc/programs.h"

namespace kerf::linuxcnc {
namespace {

constexpr std::int64_t kSilence_ns = 100'000'000;
constexpr std::int64_t kGainsPatience_ns = 500'000'000;
constexpr std::int64_t kOldForce_ns = 1'000'000'000;  // of a link that was down: nobody looks at it any more
constexpr std::int64_t kShiftEvery_ns = 1'000'000'000;
constexpr std::int64_t kStartPatience_ns = 5'000'000'000;  // from the acknowledgement until something runs
constexpr std::int64_t kStartOver_ns = 1'000'000'000;      // it ran and ended, and no part has begun
constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;
constexpr double kMicrometrePerMillimetre = 1000.0;
constexpr double kSameGain = 1e-9;

bool sameGains(const ZGains& a, const ZGains& b) {
    return std::abs(a.pGain_perS - b.pGain_perS) < kSameGain && std::abs(a.ff1 - b.ff1) < kSameGain &&
           std::abs(a.ff2_s - b.ff2_s) < kSameGain;
}

/// What the machine file says against what the control's own ini says; empty when they agree or one is silent.
std::optional<Sentence> otherUnits(DescribedUnits described, MachineUnits control) {
    const bool differ = (described == DescribedUnits::Millimetre && control == MachineUnits::Inch) ||
                        (described == DescribedUnits::Inch && control == MachineUnits::Millimetre);
    return differ ? std::optional(Sentence(KERF_TEXT("units: the machine file says %1, [TRAJ]LINEAR_UNITS of the "
                                                     "control says %2. Nothing is commanded before they agree."),
                                           SentenceArg(described == DescribedUnits::Inch ? "inch" : "mm"),
                                           SentenceArg(control == MachineUnits::Inch ? "inch" : "mm")))
                  : std::nullopt;
}

}  // namespace

LinuxCncMachine::LinuxCncMachine(const Params& params) : m_params(params), m_forcePin(params.described.force) {
    m_capabilities[0] = capabilitiesOf(std::nullopt, params.described.force);
    describe(m_capabilities[0], params.described);
}

LinuxCncMachine::~LinuxCncMachine() {
    disconnect();
}

Result<void> LinuxCncMachine::connect() {
    m_link = std::make_unique<SharedLink>(m_params.rsh.memory);
    const char* file = std::getenv("KERF_LINUXCNC_PASSWORDS");
    const std::string& described = m_params.described.passwordFile;
    const auto password = readRshPassword(!described.empty() ? described : file != nullptr ? file : "");
    if (!password) {
        return tl::unexpected(password.error());
    }
    m_params.rsh.password = *password;
    m_own = ownClaim();
    m_rsh = std::make_unique<RshLink>(m_params.rsh);
    meet(m_link->take());
    if (m_memory != nullptr && !m_onlyRead) {
        (void)claim(m_memory->owner);
    }
    watchOwner();
    FromControl seen;
    if (m_memory != nullptr && m_memory->fromControl.latest(seen)) {
        adoptFitted(seen.fitted);
        waitForBeat();
    }
    return {};
}

/// A bridge that was killed leaves its memory behind: what stands in it is no sign of life, only what moves from now
/// on.
void LinuxCncMachine::meet(LinkMemory* memory) noexcept {
    m_memory = memory;
    m_seen = FromControl{};
    FromControl stands;
    const bool shown = memory != nullptr && memory->fromControl.latest(stands);
    m_beat = shown ? stands.beat : 0;
    m_periods = shown ? stands.servoPeriods : 0;
    m_lastBeat_ns.reset();
    m_lastPeriod_ns.reset();
    m_nextPeriod = memory != nullptr ? memory->servo.written() : 0;
}

/// So that the first cycle beside a bridge that lives has its link; nobody waits longer than a silence lasts.
void LinuxCncMachine::waitForBeat() const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::nanoseconds(kSilence_ns);
    FromControl seen;
    while (m_memory->fromControl.latest(seen) && (seen.beat == m_beat || seen.servoPeriods == m_periods) &&
           std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

void LinuxCncMachine::disconnect() noexcept {
    m_rsh.reset();
    if (m_memory != nullptr && !m_onlyRead) {  // a reader has none, and may stand beside the owner in one program
        giveUp(m_memory->owner);
    }
    m_mine = false;
    m_memory = nullptr;
    m_link.reset();
}

Result<void> LinuxCncMachine::endOtherClaim() {
    LinkMemory* memory = m_link != nullptr ? m_link->take() : nullptr;
    if (memory == nullptr) {
        return fail(KERF_TEXT("LinuxCNC is not reached: there is nobody to take it over from."));
    }
    memory->owner.store(0);
    return {};
}

void LinuxCncMachine::watchOwner() noexcept {
    m_owner = m_memory != nullptr ? m_memory->owner.load() : 0;
    m_mine = !m_onlyRead && m_own != 0 && m_owner == m_own;
    if (m_rsh != nullptr && m_owner == m_rsh->deadOwner()) {
        m_owner = 0;
    }
}

void LinuxCncMachine::adoptFitted(const Fitted& fitted) noexcept {
    const std::uint64_t commands = m_onlyRead ? m_own : m_owner;
    if (m_fittedKnown && fitted == m_fitted && commands == m_said) {
        return;
    }
    const std::size_t next = (m_current.load(std::memory_order_relaxed) + 1) % kMachinesSeen;
    Capabilities& capabilities = m_capabilities[next];
    capabilities = capabilitiesOf(fitted, m_params.described.force);
    m_forcePin.fit(fitted.servoPeriod_s, capabilities.force.bandwidth_Hz);
    if (commands != m_own) {
        refuseAll(capabilities, whyNotOurs());
    }
    describe(capabilities, m_params.described);
    if (const auto why = otherUnits(m_params.described.units, fitted.units)) {
        refuseAll(capabilities, *why);
    }
    m_current.store(next, std::memory_order_release);
    m_fitted = fitted;
    m_said = commands;
    m_fittedKnown.store(true, std::memory_order_release);
}

bool LinuxCncMachine::watchLink(std::int64_t now_ns) noexcept {
    LinkMemory* memory = m_link != nullptr ? m_link->take() : nullptr;
    if (memory != m_memory) {                             // another bridge: its counts begin anew
        const bool ours = m_memory == nullptr || m_mine;  // what another program commanded does not fall to us
        meet(memory);
        if (memory != nullptr && !m_onlyRead && ours) {
            (void)claimIfFree(memory->owner, m_own);
        }
    }
    if (m_memory == nullptr || m_memory->magic.load(std::memory_order_acquire) != LinkMemory::kMagic) {
        return false;
    }
    FromControl seen;
    if (m_memory->fromControl.latest(seen)) {
        m_seen = seen;
    }
    if (m_seen.beat != m_beat) {
        m_beat = m_seen.beat;
        m_lastBeat_ns = now_ns;
    }
    if (m_seen.servoPeriods != m_periods) {
        m_periods = m_seen.servoPeriods;
        m_lastPeriod_ns = now_ns;
    }
    return m_lastBeat_ns && m_lastPeriod_ns && now_ns - *m_lastBeat_ns < kSilence_ns &&
           now_ns - *m_lastPeriod_ns < kSilence_ns;
}

/// A value that has come since the last program, not one an aborted program has left behind.
void LinuxCncMachine::followDeclaration() noexcept {
    if (m_seen.declared != m_declared) {
        m_declared = m_seen.declared;
        m_declaredFresh = m_declared != 0;
    }
}

/// What begins belongs to the process that the program declares. An operator's own program is nobody's: no loop sees a
/// part in it, whatever was asked of the control last.
void LinuxCncMachine::begin(ProgramState state) noexcept {
    const auto is = [this](ProcessId id) { return m_declared % kDeclaredStarts == declaration(id, 0); };
    bool asked = m_startRequest != 0;
    if (m_fitted.programDeclared) {
        asked = asked && m_declared == declaration(m_process, m_startRequest);
        if (!asked && m_declaredFresh && (is(ProcessId::Boring) || is(ProcessId::Milling))) {
            m_process = is(ProcessId::Boring) ? ProcessId::Boring : ProcessId::Milling;
        } else if (!asked) {
            return;
        }
    } else if (!asked) {
        return;
    }
    ++m_partSequence;
    m_program = state;
    m_startPosition_mm = m_seen.position_mm[kZ];
    m_startOverhang_mm = asked ? std::optional(m_startFrom_mm) : std::nullopt;
    // One that begins after it was given up is still the one that was planned; 0: a person has started it.
    const bool planned = asked || (m_fitted.programDeclared && m_declared == m_startDeclared);
    m_plannedScale = planned ? m_startScale : m_seen.plannedScale;
    if (asked) {
        answer(m_startRequest, RequestState::Done);
        m_startRequest = 0;
    }
    m_force.begin(m_seen.position_mm[kX], m_seen.spindleAngle_rev, m_now_ns);
}

void LinuxCncMachine::followProgram(MachineInputs& inputs) noexcept {
    const bool cutting = m_seen.cutting && m_seen.programRunning;
    ServoPeriod period;
    while (inputs.fastCount < kMaxFastSamples && m_memory->servo.read(m_nextPeriod, period)) {
        m_outputFell = m_outputFell || !period.cutting;  // an aborted program leaves it on, the next one puts it off
        if (m_fitted.force && m_now_ns - period.stamp_ns < kOldForce_ns) {
            inputs.fast[inputs.fastCount++] = m_forcePin.next(period, m_now_ns);
        }
    }
    m_outputFell = m_outputFell || !m_seen.cutting;
    if (cutting && m_outputFell && !running()) {
        m_outputFell = false;
        begin(ProgramState::Running);
    }
    if (!running()) {
        return;
    }
    m_declaredFresh = false;
    if (m_seen.cutting && m_seen.programPaused) {
        m_program = ProgramState::Paused;
    } else if (cutting) {
        m_program = ProgramState::Running;
    } else {
        m_program = m_seen.finished ? ProgramState::Finished : ProgramState::Aborted;
    }
}

void LinuxCncMachine::followTap(MachineInputs& inputs) noexcept {
    inputs.servoRecord = true;
    if (m_tapEnds) {  // the cycle after the last samples
        m_tapEnds = false;
        m_declaredFresh = false;
        m_program = m_tapFinished ? ProgramState::Finished : ProgramState::Aborted;
        return;
    }
    ServoPeriod period;
    while (inputs.servoCount < kMaxServoSamples && m_memory->servo.read(m_nextPeriod, period)) {
        m_outputFell = m_outputFell || !period.cutting;
        if (period.cutting && m_outputFell && !running()) {
            m_outputFell = false;
            begin(ProgramState::Running);
        }
        if (period.cutting && running()) {
            inputs.servoCount += m_tap.next(period, inputs.servo[inputs.servoCount]) ? 1 : 0;
        } else if (running()) {
            m_tapEnds = true;
            m_tapFinished = period.finished;
            return;
        }
    }
    // Switched off or stopped: outputs stay as they were, motion does not go on.
    if (running() && (!m_seen.machineOn || m_seen.emergencyStop || (!m_seen.programRunning && !m_seen.programPaused))) {
        m_tapEnds = true;
        m_tapFinished = false;
    }
}

Sentence LinuxCncMachine::whyNotOurs() const noexcept {
    if (m_owner == 0) {
        return Sentence(
            KERF_TEXT("Nobody commands this machine: the program that did has ended. This one only reads; end it and "
                      "start it anew, then it commands."));
    }
    return Sentence(
        KERF_TEXT("Another program (process %1) commands this machine, this one only reads: end it, or take the "
                  "machine over, and start this one anew."),
        SentenceArg(static_cast<double>(processOf(m_owner)), 0));
}

/// An acknowledgement says that the line has arrived, not that anything is cut: a part has begun, or it has not.
void LinuxCncMachine::watchStart(std::int64_t now_ns) noexcept {
    if (m_startRequest == 0 || m_startTaken_ns < 0) {
        return;
    }
    if (m_seen.programRunning) {
        m_startRan = true;
        m_startIdle_ns = now_ns;
    }
    const std::int64_t since_ns = m_startRan ? m_startIdle_ns : m_startTaken_ns;
    if (now_ns - since_ns > (m_startRan ? kStartOver_ns : kStartPatience_ns)) {
        answer(m_startRequest, RequestState::Refused,
               Sentence(KERF_TEXT("The control took the command, but no part began: see its own message (soft limit, "
                                  "tool, spindle).")));
        m_startRequest = 0;
    }
}

void LinuxCncMachine::answer(std::uint32_t number, RequestState state, const Sentence& reason) noexcept {
    m_reply = {number, state, reason};
}

void LinuxCncMachine::takeReplies(std::int64_t now_ns) noexcept {
    RequestReply reply;
    while (m_rsh != nullptr && m_rsh->tryReply(reply)) {
        if (reply.number == RshLink::kOwnRequest) {
            m_shiftUnderWay = false;
        } else {
            m_reply = reply;
            if (reply.number == m_startRequest && reply.state == RequestState::Done) {
                m_reply.state = RequestState::Accepted;  // done when the part begins
                m_startTaken_ns = now_ns;
                m_startRan = false;
            } else if (reply.number == m_startRequest && reply.state == RequestState::Refused) {
                m_startRequest = 0;
            }
        }
    }
    if (m_gainsRequest == 0) {
        return;
    }
    if (sameGains(m_seen.gains, m_gains)) {
        answer(m_gainsRequest, RequestState::Done);
        m_gainsRequest = 0;
    } else if (now_ns - m_gainsSince_ns > kGainsPatience_ns) {
        answer(m_gainsRequest, RequestState::Refused,
               Sentence(KERF_TEXT("The gains do not read back from the control.")));
        m_gainsRequest = 0;
    }
}

void LinuxCncMachine::fillGains(MachineInputs& inputs, Quality quality) const noexcept {
    if (!m_fitted.servoGains) {
        inputs.servoGainsQuality = Quality::Missing;
        return;
    }
    // FF2 is seconds of command speed per acceleration; the tapping room counts shares of the acceleration.
    inputs.servoGains.spindleKp_perS = m_params.spindleKp_perS;
    inputs.servoGains.zKp_perS = m_seen.gains.pGain_perS;
    inputs.servoGains.zFeedForward = {m_seen.gains.ff1, m_seen.gains.ff2_s * m_seen.driveBandwidth_perS};
    inputs.servoGainsQuality = quality;
}

/// By the described geometry; else counted from where a program of Kerf's has begun, and of any other not known.
Reading LinuxCncMachine::overhang_mm(Quality quality) const noexcept {
    const double z_mm = m_seen.position_mm[kZ];
    if (m_params.described.overhangAtZ0_mm) {
        return {*m_params.described.overhangAtZ0_mm - z_mm, m_now_ns, quality};
    }
    return m_startOverhang_mm ? Reading{*m_startOverhang_mm + (m_startPosition_mm - z_mm), m_now_ns, quality}
                              : Reading{0.0, m_now_ns, Quality::Missing};
}

void LinuxCncMachine::read(std::int64_t now_ns, MachineInputs& inputs) noexcept {
    m_now_ns = now_ns;
    const bool up = watchLink(now_ns);
    const Quality quality = up ? Quality::Good : Quality::Stale;
    inputs.servoRecord = false;
    inputs.servoCount = 0;
    inputs.fastCount = 0;
    watchOwner();
    if (up) {
        adoptFitted(m_seen.fitted);
        followDeclaration();
        if (m_process == ProcessId::Tapping) {
            followTap(inputs);
        } else {
            followProgram(inputs);
        }
        takeReplies(now_ns);
        watchStart(now_ns);
    }
    inputs.time_ns = now_ns;
    inputs.link = up ? LinkState::Up : LinkState::Down;
    inputs.emergencyStop = m_seen.emergencyStop;
    inputs.machineOn = m_seen.machineOn;
    inputs.feedHold = m_seen.programPaused || (m_program == ProgramState::Running && m_process != ProcessId::Tapping &&
                                               m_seen.currentVelocity_mmPerS == 0.0);
    inputs.operatorOverride = m_seen.feedOverride;
    inputs.program = m_program;
    inputs.programProcess = m_process;
    inputs.partSequence = m_partSequence;
    inputs.programmedFeed_mmPerS = {m_seen.requestedVelocity_mmPerS, now_ns, quality};
    inputs.actualFeed_mmPerS = {m_seen.currentVelocity_mmPerS, now_ns, quality};
    inputs.spindleSpeed_rpm = {m_seen.spindleSpeed_rps * 60.0, now_ns, quality};
    inputs.spindleAngle_rev = {m_seen.spindleAngle_rev, now_ns, quality};
    inputs.appliedFeedScale = {m_seen.appliedFeedScale, now_ns, quality};
    // Declared with the program that runs, not measured: a lost link does not make it unknown.
    inputs.plannedFeedScale = {m_plannedScale, now_ns,
                               running() && m_plannedScale > 0.0 ? Quality::Good : Quality::Missing};
    inputs.stops = m_seen.stops;
    const bool byOrigin = !m_fitted.externalOffsets && m_fitted.originShift;
    const bool offsetKnown =
        up && m_seen.machineOn && (byOrigin ? m_seen.originKnown : m_seen.offsetEpoch == m_offsetEpoch);
    m_offsetEpoch = m_seen.offsetEpoch;  // known from the next cycle on: so it is taken over and not overwritten
    m_wishEpoch = offsetKnown ? m_seen.offsetEpoch : 0;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        inputs.position_mm[axis] = {m_seen.position_mm[axis], now_ns, quality};
        const double shift_um =
            byOrigin ? m_seen.originShift_um[axis] : m_seen.externalOffset_mm[axis] * kMicrometrePerMillimetre;
        inputs.workOffset_um[axis] = {shift_um, now_ns, offsetKnown ? Quality::Good : Quality::Stale};
    }
    inputs.overhang_mm = overhang_mm(quality);
    inputs.temperatures = nullptr;
    fillGains(inputs, quality);
    if (up && m_fitted.simulator && !m_fitted.forceLinked && m_process == ProcessId::Milling) {
        m_force.step(m_seen.position_mm[kX], m_seen.spindleAngle_rev, m_program == ProgramState::Running, now_ns,
                     inputs);
    }
    inputs.reply = m_reply;
}

void LinuxCncMachine::setGains(const PortRequest& request, const ServoGains& gains) noexcept {
    if (!m_fitted.servoGains) {
        answer(request.number, RequestState::Refused, capabilities().servoGains.why);
    } else if (running()) {
        answer(request.number, RequestState::Refused, Sentence(KERF_TEXT("Gains change only between taps.")));
    } else if (std::abs(gains.spindleKp_perS - m_params.spindleKp_perS) > kSameGain) {
        answer(request.number, RequestState::Refused,
               Sentence(KERF_TEXT("The spindle's gain cannot be set on this control, only Z's.")));
    } else {
        const double bandwidth_perS = std::max(m_seen.driveBandwidth_perS, 1.0);
        m_gains = {gains.zKp_perS, gains.zFeedForward[0], gains.zFeedForward[1] / bandwidth_perS};
        ++m_gainsRevision;
        m_gainsRequest = request.number;
        m_gainsSince_ns = m_now_ns;
        answer(request.number, RequestState::Accepted);
    }
}

void LinuxCncMachine::carryOut(const PortRequest& request) noexcept {
    if (!m_mine) {
        answer(request.number, RequestState::Refused, whyNotOurs());
        return;
    }
    if (const auto* gains = std::get_if<SetServoGains>(&request.action)) {
        setGains(request, gains->gains);
        return;
    }
    if (std::holds_alternative<RetractInSync>(request.action)) {
        // G33.1 turns round at its depth and comes out in sync by itself, whatever happens to its gains and its
        // console.
        const bool tapping = m_process == ProcessId::Tapping && running();
        answer(request.number, tapping ? RequestState::Done : RequestState::Refused,
               tapping
                   ? Sentence{}
                   : Sentence(KERF_TEXT("This control cannot turn a standing tap out in sync: turn spindle and Z back "
                                        "by hand at the control, one pitch per revolution.")));
        return;
    }
    if (const auto* start = std::get_if<StartProgram>(&request.action); start != nullptr && !running()) {
        if (const auto why = whyOutside(*start, m_params.described)) {
            answer(request.number, RequestState::Refused, *why);
            return;
        }
        m_process = start->process;
        m_startFrom_mm = start->from_mm;
        m_tap.arm(std::max(start->pitch_mm, 1e-3), kTapRunUp_rev * start->pitch_mm);
        m_tapEnds = false;
        m_startRequest = request.number;
        m_startTaken_ns = -1;
        m_startScale = start->plannedFeedScale;
        m_startDeclared = declaration(start->process, request.number);
        if (m_memory != nullptr) {
            m_nextPeriod = m_memory->servo.written();
        }
    }
    const bool asked = m_rsh != nullptr && m_rsh->tryAsk(request);
    answer(request.number, asked ? RequestState::Accepted : RequestState::Refused,
           asked ? Sentence{} : Sentence(KERF_TEXT("The control is still busy with earlier commands.")));
}

void LinuxCncMachine::shiftOrigin(const MachineOutputs& outputs) noexcept {
    if (m_fitted.externalOffsets || !m_fitted.originShift || m_shiftUnderWay || running() || m_rsh == nullptr ||
        !m_rsh->connected() || !m_seen.machineOn || m_seen.programRunning || m_seen.programPaused) {
        return;
    }
    if (!m_seen.originKnown) {
        m_shiftUnderWay = m_rsh->tryReportOrigin();
        return;
    }
    std::array<double, 3> wanted_um{};
    bool differs = false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        wanted_um[axis] = std::round(outputs.workOffset_um[axis]);
        differs = differs || wanted_um[axis] != m_seen.originShift_um[axis];
    }
    if (differs && m_now_ns - m_lastShift_ns > kShiftEvery_ns) {
        m_lastShift_ns = m_now_ns;
        m_shiftUnderWay = m_rsh->tryShiftOrigin(wanted_um);
    }
}

void LinuxCncMachine::write(const MachineOutputs& outputs) noexcept {
    if (m_memory == nullptr) {
        return;
    }
    if (outputs.request.number != 0 && outputs.request.number != m_lastRequest) {
        m_lastRequest = outputs.request.number;
        carryOut(outputs.request);
    }
    if (!m_mine) {
        return;
    }
    shiftOrigin(outputs);
    ToControl wish;
    wish.beat = ++m_outBeat;
    wish.beatAgain = wish.beat;
    wish.feedScale = outputs.feedScale;
    wish.feedHold = outputs.feedHold;
    wish.lossScale = outputs.lossScale;
    wish.plannedScale = running() ? m_plannedScale : 0.0;
    wish.feedEpoch = m_seen.feedEpoch;
    wish.stops = outputs.stops;
    wish.externalOffset_um = outputs.workOffset_um;
    wish.offsetEpoch = m_wishEpoch;
    wish.gainsRevision = m_gainsRevision;
    wish.gains = m_gains;
    wish.forceReset = outputs.forceReset;
    wish.shiftWord = m_word.answer(m_seen.requestWord, outputs.workOffset_um);
    m_memory->toControl.publish(wish);
}

}  // namespace kerf::linuxcnc
