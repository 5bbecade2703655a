// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tapping_loop.h"

#include <algorithm>
#include <cmath>

#include "engine/cycle/event_sink.h"
#include "engine/process/tapping/tapping_alarms.h"

namespace kerf {
namespace {

constexpr std::int64_t kReplyPatience_ns = 1'000'000'000;
constexpr std::int64_t kAcceptedPatience_ns = 10'000'000'000;  ///< a control that has said "accepted" may take longer
constexpr double kInHole_rev = 0.2;                            ///< less is not inside the hole
constexpr double kPitchTolerance = 0.08;                       ///< while moving: lag is in the ratio too
constexpr double kReadBack = 1e-6;

bool sameGains(const ServoGains& a, const ServoGains& b) {
    const auto same = [](double x, double y) { return std::abs(x - y) <= kReadBack * std::max(1.0, std::abs(y)); };
    return same(a.spindleKp_perS, b.spindleKp_perS) && same(a.zKp_perS, b.zKp_perS) &&
           std::ranges::equal(a.zFeedForward, b.zFeedForward, same);
}

}  // namespace

bool TappingLoop::gainsInForce(const MachineInputs& inputs) const noexcept {
    return inputs.servoGainsQuality == Quality::Good && sameGains(inputs.servoGains, m_next.gains);
}

bool TappingLoop::refused(const MachineInputs& inputs) const noexcept {
    return inputs.reply.number == m_requestNumber && inputs.reply.state == RequestState::Refused;
}

void TappingLoop::request(LoopOutputs& outputs, const decltype(PortRequest::action)& action) noexcept {
    m_requestNumber = m_program.nextRequest();
    outputs.request.number = m_requestNumber;
    outputs.request.action = action;
}

LoopVerdict TappingLoop::step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                              EventSink& events) noexcept {
    m_now_ns = inputs.time_ns;
    m_tick_ns = capabilities.cycle_ns;
    followStop(inputs.stops[static_cast<std::size_t>(ProcessId::Tapping)]);
    const bool wasOnTheWayOut = m_status.phase == TapPhase::Retracting;
    m_status.drive = inputs.servoGainsQuality == Quality::Good ? inputs.servoGains : ServoGains{};
    if (m_startWanted) {
        m_startWanted = false;
        m_status.kind = m_status.airTapPassed ? m_wantedKind : TapKind::Air;
        m_status.problem = Sentence{};
        m_interrupted = false;
        m_tapAfterGains = true;
        m_gainsSent = false;
        m_startSent = false;
        m_phaseSince_ns = inputs.time_ns;
        m_status.phase = TapPhase::SettingGains;
        m_lastSequence = inputs.partSequence;
    }
    switch (m_status.phase) {
        case TapPhase::Idle:
            m_abortWanted = false;
            if (m_restoreWanted && m_mode == LoopMode::Control && inputs.program != ProgramState::Running) {
                beginRestore();
            }
            break;
        case TapPhase::SettingGains:
            setGains(inputs, outputs, events);
            break;
        case TapPhase::Starting:
            startProgram(inputs, outputs);
            if (m_status.phase == TapPhase::Tapping) record(inputs, outputs, events);
            break;
        case TapPhase::Tapping:
            record(inputs, outputs, events);
            break;
        case TapPhase::Retracting:
            record(inputs, outputs, events);
            break;
        case TapPhase::InHole:
            if (m_recoverWanted) recover(inputs, outputs, events);
            break;
    }
    if (m_status.phase == TapPhase::InHole) {
        outputs.stop = {StopKind::InWork, tapping_alarm::kInHole, inHole()};
    }
    outputs.outOfWork = wasOnTheWayOut && m_status.phase != TapPhase::Retracting && m_status.phase != TapPhase::InHole;
    m_status.spindle_rev = m_tap.spindle_rev();
    m_status.z_mm = m_tap.z_mm();
    m_status.error_um = m_tap.error_um();
    m_status.last = m_tap.figures();
    return describe();
}

/// The machine and the latch know of a tap in the hole over our restart; a person may say that it is gone.
void TappingLoop::followStop(const StopSlot& stop) noexcept {
    const bool stands = stop.active() && stop.kind == StopKind::InWork;
    if (m_stopWatch.released(stop) && m_status.phase == TapPhase::InHole) {
        m_recoverWanted = false;
        restoreAccepted();
        m_status.outcome = TapOutcome::Aborted;
        m_status.phase = TapPhase::Idle;
    } else if (stands && m_status.phase == TapPhase::Idle) {
        m_status.stoppedSpindle_rev = 0.0;
        m_status.stoppedZ_mm = 0.0;
        m_status.phase = TapPhase::InHole;
    }
}

void TappingLoop::setGains(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept {
    const bool needed = m_mode == LoopMode::Control && m_next.revision != 0 && !gainsInForce(inputs);
    if (!needed || m_abortWanted) {
        events.clear(tapping_alarm::kGainsNotTaken);
        if (!needed) m_restoreWanted = m_restoreWanted && m_mode != LoopMode::Control;
        m_phaseSince_ns = inputs.time_ns;
        if (m_abortWanted) {
            noTap(Sentence(KERF_TEXT("The tap was called off before it began.")));
        } else if (m_tapAfterGains) {
            m_status.phase = TapPhase::Starting;
            startProgram(inputs, outputs);
        } else {
            m_status.phase = TapPhase::Idle;
        }
        return;
    }
    if (!m_gainsSent) {
        request(outputs, SetServoGains{m_next.gains});
        m_gainsSent = true;
        return;
    }
    if (refused(inputs) || inputs.time_ns - m_phaseSince_ns > kReplyPatience_ns) {
        events.raise(tapping_alarm::kGainsNotTaken, refused(inputs) ? inputs.reply.reason : Sentence{});
        m_restoreWanted = false;  // the alarm stands; the next start tries again
        noTap(Sentence(KERF_TEXT("The drive did not take the gains.")));
    }
}

void TappingLoop::beginRestore() noexcept {
    m_tapAfterGains = false;
    m_gainsSent = false;
    m_phaseSince_ns = m_now_ns;
    m_status.phase = TapPhase::SettingGains;
}

// The accepted gains first: the ones of the trial may be what stopped the tap.
void TappingLoop::recover(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept {
    if (!m_gainsSent) {
        restoreAccepted();
        m_gainsSent = true;
        m_phaseSince_ns = inputs.time_ns;
        if (m_accepted.revision != 0 && !gainsInForce(inputs)) {
            request(outputs, SetServoGains{m_next.gains});
            return;
        }
    }
    if (m_accepted.revision != 0 && !gainsInForce(inputs)) {
        if (!refused(inputs) && inputs.time_ns - m_phaseSince_ns <= kReplyPatience_ns) return;
        events.raise(tapping_alarm::kGainsNotTaken, refused(inputs) ? inputs.reply.reason : Sentence{});
    }
    m_recoverWanted = false;
    m_tap.stopRecording();
    m_startSent = false;
    request(outputs, RetractInSync{});
    m_phaseSince_ns = inputs.time_ns;
    m_status.phase = TapPhase::Retracting;
}

void TappingLoop::startProgram(const MachineInputs& inputs, LoopOutputs& outputs) noexcept {
    if (!m_startSent) {
        StartProgram program;
        program.process = ProcessId::Tapping;
        program.spindleSpeed_rpm = m_job.speed_rpm;
        program.pitch_mm = m_job.pitch_mm;
        program.revolutions = m_job.depth_rev;
        program.air = m_status.kind == TapKind::Air;
        request(outputs, program);
        m_startSent = true;
        return;
    }
    if (inputs.programProcess == ProcessId::Tapping && inputs.program == ProgramState::Running &&
        inputs.partSequence != m_lastSequence) {
        (void)m_exchange.trims.refresh();
        m_tap.begin(m_next.revision, m_status.kind, inputs.time_ns);
        m_status.outcome = TapOutcome::None;
        beginOrder();
        m_lastSequence = inputs.partSequence;
        m_status.phase = TapPhase::Tapping;
        return;
    }
    // Once asked, the control may start at any moment: an abort waits for the tap and then turns it out.
    const bool accepted = inputs.reply.number == m_requestNumber && inputs.reply.state == RequestState::Accepted;
    const std::int64_t patience_ns = accepted ? kAcceptedPatience_ns : kReplyPatience_ns;
    if (refused(inputs)) {
        noTap(inputs.reply.reason);
    } else if (inputs.time_ns - m_phaseSince_ns > patience_ns) {
        noTap(Sentence(KERF_TEXT("The control did not start the tapping program.")));
    }
}

void TappingLoop::record(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept {
    if (inputs.link != LinkState::Up) return;  // the control goes on by itself; nothing can be told or learned
    const bool retracting = m_status.phase == TapPhase::Retracting;
    const bool keeping = m_tap.recording() && !retracting;
    const Reading& z = inputs.position_mm[2];
    const bool good = inputs.spindleAngle_rev.good() && z.good();
    if (!inputs.servoRecord && keeping) m_tap.fillGap(inputs.time_ns, m_tick_ns);
    m_tap.watchSignal();
    if (!inputs.servoRecord && good) m_tap.follow(inputs.spindleAngle_rev.value, z.value);
    const bool running = m_program.runs(inputs);
    if (!running && inputs.program == ProgramState::Finished) {
        endTap(retracting ? TapOutcome::Aborted : TapOutcome::Counted, events);
        return;
    }
    if (!running) {
        const bool waiting = retracting && inputs.time_ns - m_phaseSince_ns < kReplyPatience_ns && !refused(inputs);
        if (!waiting) stopInHole(events);  // a recovery takes a cycle to begin
        return;
    }
    for (std::size_t i = 0; i < inputs.servoCount; ++i) {
        m_tap.follow(inputs.servo[i].spindle_rev, inputs.servo[i].z_mm);
        if (keeping) m_tap.keep(true);
    }
    if (!keeping) return;
    if (!inputs.servoRecord) m_tap.keep(good);
    const TrimTable& trim = m_exchange.trims.value();
    if (m_next.trimRevision != 0 && trim.revision == m_next.trimRevision && m_next.revision == m_tap.gainsRevision() &&
        !m_interrupted) {
        // What is sent now acts in the next tick: sample k has just been taken, command k is already with the drive.
        const std::uint32_t k = m_tap.count();
        outputs.zTrim_um = k < trim.count ? static_cast<double>(trim.trim_um[k]) : 0.0;
    }
    watch(outputs, events);
}

// Only a controlling loop ends a tap by itself; an advising one says what it sees.
void TappingLoop::watch(LoopOutputs& outputs, EventSink& events) noexcept {
    if (m_abortWanted) {
        abortInSync(outputs);
        return;
    }
    m_tap.watchSignal();
    if (m_tap.signalLost()) {
        events.raise(tapping_alarm::kSignalLost);
        if (m_mode == LoopMode::Control) abortInSync(outputs);
        return;
    }
    if (std::abs(m_tap.error_um()) <= m_job.abortError_um) return;
    const double found_mm = m_tap.pitchMoving_mm().value_or(m_job.pitch_mm);
    if (std::abs(found_mm / m_job.pitch_mm - 1.0) > kPitchTolerance && m_status.kind == TapKind::Air) {
        events.raise(tapping_alarm::kWrongPitch,
                     Sentence(KERF_TEXT("Z moves %1 mm per revolution, the pitch entered is %2 mm."), {found_mm, 3},
                              {m_job.pitch_mm, 3}));
    } else {
        events.raise(tapping_alarm::kErrorLimit,
                     Sentence(KERF_TEXT("%1 µm at %2 revolutions; the limit is %3 µm."), {m_tap.error_um(), 0},
                              {m_tap.spindle_rev(), 1}, {m_job.abortError_um, 0}));
    }
    if (m_mode == LoopMode::Control) abortInSync(outputs);
}

void TappingLoop::abortInSync(LoopOutputs& outputs) noexcept {
    m_abortWanted = false;
    request(outputs, RetractInSync{});
    outputs.zTrim_um.reset();
    m_phaseSince_ns = m_now_ns;
    m_status.phase = TapPhase::Retracting;
}

void TappingLoop::endTap(TapOutcome outcome, EventSink& events) noexcept {
    events.clear(tapping_alarm::kInHole);
    const bool enoughSeen = m_tap.sumUp(outcome == TapOutcome::Counted);
    if (outcome == TapOutcome::Counted && (m_interrupted || !enoughSeen)) outcome = TapOutcome::NotCounted;
    m_status.outcome = outcome;
    events.set(tapping_alarm::kNotCounted, outcome == TapOutcome::NotCounted);
    if (outcome == TapOutcome::Counted) {
        events.clear(tapping_alarm::kErrorLimit);
        events.clear(tapping_alarm::kSignalLost);
        if (m_status.kind == TapKind::Air) {
            m_status.airTapPassed = m_tap.pitchFits();
            events.set(tapping_alarm::kWrongPitch, !m_status.airTapPassed,
                       Sentence(KERF_TEXT("Z moves %1 mm per revolution, the pitch entered is %2 mm."),
                                {m_tap.pitchAtDepth_mm(), 3}, {m_job.pitch_mm, 3}));
        }
        if (m_status.kind == TapKind::Production) {
            ++m_status.productionTaps;
            if (m_mode == LoopMode::Control)
                m_drift.add(m_tap.figures().saec_mm);  // else the gains are not the watched ones
        }
        m_status.driftShare = m_drift.excess();
        m_status.wantsTuning = m_drift.grown();
        events.set(tapping_alarm::kDrift, m_drift.grown());
    }
    ++m_status.taps;
    m_tap.publish(m_status.taps, outcome);
    if (m_status.kind == TapKind::Production) finishPart(outcome, events);
    m_status.phase = TapPhase::Idle;
    m_abortWanted = false;
    if (outcome == TapOutcome::Aborted) {
        restoreAccepted();
        if (m_restoreWanted && m_mode == LoopMode::Control) beginRestore();
    }
}

void TappingLoop::restoreAccepted() noexcept {
    if (m_accepted.revision == 0) return;
    m_next = m_accepted;
    m_status.nextGains = m_next.revision;
    m_restoreWanted = true;
}

void TappingLoop::finishPart(TapOutcome outcome, EventSink& events) noexcept {
    PartRecord part;
    part.process = ProcessId::Tapping;
    part.partSequence = m_lastSequence;
    part.begin_ns = m_tap.begin_ns();
    part.tap.job = m_job;
    part.tap.figures = m_tap.figures();
    part.tap.withinTolerance = outcome == TapOutcome::Counted && m_tap.figures().engagedPp_um <= m_job.allowedPp_um;
    const bool complete = outcome != TapOutcome::Aborted;
    m_status.partsCut += complete ? 1U : 0U;
    finishRecord(part, m_now_ns, complete, events);
}

void TappingLoop::stopInHole(EventSink& events) noexcept {
    if (m_tap.spindle_rev() < kInHole_rev) {
        endTap(TapOutcome::Aborted, events);
        return;
    }
    m_status.stoppedSpindle_rev = m_tap.spindle_rev();
    m_status.stoppedZ_mm = m_tap.z_mm();
    m_status.phase = TapPhase::InHole;
    m_recoverWanted = false;
    m_abortWanted = false;
    events.raise(tapping_alarm::kInHole,
                 Sentence(KERF_TEXT("%1 revolutions in, at %2 mm."), {m_tap.spindle_rev(), 2}, {m_tap.z_mm(), 3}));
}

}  // namespace kerf
