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
constexpr std::uint32_t kLostTicks = 20;
constexpr double kMaxMissing = 0.05;
constexpr double kInHole_rev = 0.2;       ///< less is not inside the hole
constexpr double kPitchCheck_rev = 1.5;   ///< the ratio of the axes tells a pitch after this
constexpr double kPitchTolerance = 0.08;  ///< while moving: lag is in the ratio too
constexpr double kPitchAtDepth = 0.01;    ///< at the bottom, where both stand …
constexpr double kPitchAtDepth_mm = 0.3;  ///< … or this far off, whichever is more
constexpr double kReadBack = 1e-6;

bool usable(const TappingJob& job) {
    const auto inRange = [](double value, double low, double high) { return value >= low && value <= high; };
    return job.revision > 0 && inRange(job.pitch_mm, 0.1, 10.0) && inRange(job.depth_rev, 1.0, 200.0) &&
           inRange(job.speed_rpm, 10.0, 20'000.0) && inRange(job.engage_rev, 0.0, 100.0) &&
           inRange(job.abortError_um, 10.0, 5000.0) && inRange(job.allowedPp_um, 1.0, 1000.0) && job.gear >= 1 &&
           job.gear <= 9;
}

bool usable(const TapGains& gains) {
    return gains.revision > 0 && gains.gains.spindleKp_perS > 0.0 && gains.gains.zKp_perS > 0.0 &&
           std::isfinite(gains.gains.spindleKp_perS + gains.gains.zKp_perS) &&
           std::ranges::all_of(gains.gains.zFeedForward, [](double value) { return std::isfinite(value); });
}

bool sameGains(const ServoGains& a, const ServoGains& b) {
    const auto same = [](double x, double y) { return std::abs(x - y) <= kReadBack * std::max(1.0, std::abs(y)); };
    return same(a.spindleKp_perS, b.spindleKp_perS) && same(a.zKp_perS, b.zKp_perS) &&
           std::ranges::equal(a.zFeedForward, b.zFeedForward, same);
}

}  // namespace

std::span<const AlarmSpec> TappingLoop::alarms() const noexcept {
    return tapping_alarm::kSpecs;
}

CommandResult TappingLoop::handle(const Command& command) noexcept {
    const bool idle = m_status.phase == TapPhase::Idle;
    if (const auto* load = std::get_if<LoadTappingJob>(&command.action)) {
        const bool fromBefore = m_status.phase == TapPhase::InHole && m_job.revision == 0;  // Kerf has been restarted
        if (!idle && !fromBefore)
            return CommandResult::refused(Sentence(KERF_TEXT("A tap is under way: the job stays.")));
        if (!usable(load->job)) {
            return CommandResult::refused(Sentence(KERF_TEXT("The tapping job has a value outside its range.")));
        }
        m_job = load->job;
        m_status.job = m_job.revision;
        m_status.airTapPassed = false;
        m_drift.reset();
        return CommandResult::ok();
    }
    if (const auto* load = std::get_if<LoadTapGains>(&command.action)) {
        if (!usable(load->gains)) {
            return CommandResult::refused(
                Sentence(KERF_TEXT("A gain is not a number above zero; the last ones stay.")));
        }
        m_next = load->gains;
        m_wantedKind = load->production ? TapKind::Production : TapKind::Trial;
        if (load->accept) {
            m_accepted = load->gains;
            m_drift.reset();
        }
        m_status.nextGains = m_next.revision;
        m_status.acceptedGains = m_accepted.revision;
        return CommandResult::ok();
    }
    if (std::holds_alternative<AbortTap>(command.action)) return abortTap();
    if (std::holds_alternative<RecoverTap>(command.action)) {
        if (m_status.phase != TapPhase::InHole) {
            return CommandResult::refused(Sentence(KERF_TEXT("No tap stands in a hole.")));
        }
        if (m_mode != LoopMode::Control) {
            return CommandResult::refused(
                Sentence(KERF_TEXT("Switch the tapping loop to control to turn the tap out.")));
        }
        m_recoverWanted = true;
        m_gainsSent = false;
        return CommandResult::ok();
    }
    if (std::holds_alternative<StartPart>(command.action)) return start();
    return CommandResult::refused(Sentence(KERF_TEXT("The tapping loop does not know this command.")));
}

void TappingLoop::setMode(LoopMode mode) noexcept {
    if (mode == m_mode) return;
    m_mode = mode;
    m_recoverWanted = false;  // nothing may begin to turn later than it was asked for
    m_abortWanted = m_abortWanted && mode != LoopMode::Off;
    const bool notYetStarted = m_status.phase == TapPhase::SettingGains && m_tapAfterGains;
    if (notYetStarted || (m_status.phase == TapPhase::Starting && !m_startSent)) {
        noTap(Sentence(KERF_TEXT("The loop was switched before the tap began.")));
    } else if (m_status.phase == TapPhase::Starting || m_status.phase == TapPhase::Tapping) {
        m_interrupted = true;
    }
}

void TappingLoop::noTap(const Sentence& why) noexcept {
    m_abortWanted = false;
    m_status.problem = why;
    m_status.phase = TapPhase::Idle;
}

CommandResult TappingLoop::abortTap() noexcept {
    switch (m_status.phase) {
        case TapPhase::InHole:
            return CommandResult::refused(Sentence(KERF_TEXT("A tap stands in the hole: turn it out first.")));
        case TapPhase::SettingGains:
            m_abortWanted = m_tapAfterGains;  // gains on their way back are not stopped
            return CommandResult::ok();
        case TapPhase::Starting:
        case TapPhase::Tapping:
            if (m_mode == LoopMode::Off) {
                return CommandResult::refused(
                    Sentence(KERF_TEXT("The tapping loop is off: switch it to advise or control to abort the tap.")));
            }
            m_abortWanted = true;
            return CommandResult::ok();
        case TapPhase::Idle:
        case TapPhase::Retracting:
            break;
    }
    return CommandResult::ok();
}

CommandResult TappingLoop::start() noexcept {
    if (m_status.phase == TapPhase::InHole) {
        return CommandResult::refused(Sentence(KERF_TEXT("A tap stands in the hole: turn it out first.")));
    }
    if (m_status.phase != TapPhase::Idle) return CommandResult::refused(Sentence(KERF_TEXT("A tap is under way.")));
    if (m_job.revision == 0) return CommandResult::refused(Sentence(KERF_TEXT("No tapping job is loaded.")));
    (void)m_exchange.trims.refresh();
    if (m_mode == LoopMode::Control && m_next.trimRevision != 0 &&
        m_exchange.trims.value().revision != m_next.trimRevision) {
        return CommandResult::refused(Sentence(KERF_TEXT("The learned trim of these gains is not loaded.")));
    }
    m_startWanted = true;
    return CommandResult::ok();
}

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

Sentence TappingLoop::inHole() const noexcept {
    if (m_status.stoppedSpindle_rev == 0.0) {
        return Sentence(KERF_TEXT("A tap stands in the hole, from before Kerf was started: turn it out in sync."));
    }
    return Sentence(KERF_TEXT("The tap stands %1 revolutions in the hole: turn it out in sync."),
                    {m_status.stoppedSpindle_rev, 2});
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
    m_recording = false;
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
        TapRecord& tap = m_exchange.records.writeSlot();
        tap.count = 0;
        tap.job = m_job.revision;
        tap.gains = m_next.revision;
        tap.kind = m_status.kind;
        tap.figures = {};
        m_status.last = {};
        m_status.outcome = TapOutcome::None;
        m_squares_um2 = 0.0;
        m_engaged = false;
        m_low_um = 0.0;
        m_high_um = 0.0;
        m_lostInARow = 0;
        m_signalLost = false;
        m_deepest_rev = 0.0;
        m_deepest_mm = 0.0;
        m_recording = true;
        m_tapBegin_ns = inputs.time_ns;
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
    const bool keeping = m_recording && !retracting;
    const Reading& z = inputs.position_mm[2];
    const bool good = inputs.spindleAngle_rev.good() && z.good();
    if (!inputs.servoRecord) fillGap(inputs.time_ns);
    m_signalLost = m_signalLost || m_lostInARow > kLostTicks;
    if (!inputs.servoRecord && good) follow(inputs.spindleAngle_rev.value, z.value);
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
        follow(inputs.servo[i].spindle_rev, inputs.servo[i].z_mm);
        if (keeping) keep(true);
    }
    if (!keeping) return;
    if (!inputs.servoRecord) keep(good);
    const TapRecord& tap = m_exchange.records.writeSlot();
    const TrimTable& trim = m_exchange.trims.value();
    if (m_next.trimRevision != 0 && trim.revision == m_next.trimRevision && m_next.revision == tap.gains &&
        !m_interrupted) {
        // What is sent now acts in the next tick: sample k has just been taken, command k is already with the drive.
        outputs.zTrim_um = tap.count < trim.count ? static_cast<double>(trim.trim_um[tap.count]) : 0.0;
    }
    watch(outputs, events);
}

void TappingLoop::follow(double spindle_rev, double z_mm) noexcept {
    if (m_recording && m_exchange.records.writeSlot().count == 0) {
        m_spindleZero_rev = spindle_rev;
        m_zZero_mm = z_mm;
    }
    m_status.spindle_rev = spindle_rev - m_spindleZero_rev;
    m_status.z_mm = m_zZero_mm - z_mm;
    m_status.error_um = 1000.0 * (m_job.pitch_mm * m_status.spindle_rev - m_status.z_mm);
}

void TappingLoop::keep(bool good) noexcept {
    TapRecord& tap = m_exchange.records.writeSlot();
    if (tap.count < kMaxTapTicks) {
        const std::uint32_t k = tap.count++;
        tap.spindle_rev[k] = static_cast<float>(m_status.spindle_rev);
        tap.z_mm[k] = static_cast<float>(m_status.z_mm);
        tap.valid[k] = good ? 1 : 0;
    }
    m_lostInARow = good ? 0 : m_lostInARow + 1;
    TapFigures& figures = m_status.last;
    if (!good) {
        ++figures.missing;
        return;
    }
    const double error_um = m_status.error_um;
    ++figures.samples;
    m_deepest_rev = std::max(m_deepest_rev, m_status.spindle_rev);
    m_deepest_mm = std::max(m_deepest_mm, m_status.z_mm);
    figures.saec_mm += std::abs(error_um) / 1000.0;
    figures.peak_um = std::max(figures.peak_um, std::abs(error_um));
    m_squares_um2 += error_um * error_um;
    if (m_status.spindle_rev >= m_job.engage_rev) {
        m_low_um = m_engaged ? std::min(m_low_um, error_um) : error_um;
        m_high_um = m_engaged ? std::max(m_high_um, error_um) : error_um;
        m_engaged = true;
    }
}

// Cycles that did not happen (link down, overrun) leave places in the record: sample k is always at tick k.
void TappingLoop::fillGap(std::int64_t now_ns) noexcept {
    if (m_status.phase != TapPhase::Tapping || !m_recording) return;
    TapRecord& tap = m_exchange.records.writeSlot();
    const auto due =
        static_cast<std::uint64_t>((now_ns - m_tapBegin_ns + m_tick_ns / 10) / std::max<std::int64_t>(1, m_tick_ns));
    while (tap.count > 0 && tap.count < due && tap.count < kMaxTapTicks) {
        const std::uint32_t k = tap.count++;
        tap.spindle_rev[k] = tap.spindle_rev[k - 1];
        tap.z_mm[k] = tap.z_mm[k - 1];
        tap.valid[k] = 0;
        ++m_status.last.missing;
        ++m_lostInARow;
    }
}

// Only a controlling loop ends a tap by itself; an advising one says what it sees.
void TappingLoop::watch(LoopOutputs& outputs, EventSink& events) noexcept {
    if (m_abortWanted) {
        abortInSync(outputs);
        return;
    }
    m_signalLost = m_signalLost || m_lostInARow > kLostTicks;
    if (m_signalLost) {
        events.raise(tapping_alarm::kSignalLost);
        if (m_mode == LoopMode::Control) abortInSync(outputs);
        return;
    }
    if (std::abs(m_status.error_um) <= m_job.abortError_um) return;
    const double found_mm =
        m_status.spindle_rev > kPitchCheck_rev ? m_status.z_mm / m_status.spindle_rev : m_job.pitch_mm;
    if (std::abs(found_mm / m_job.pitch_mm - 1.0) > kPitchTolerance && m_status.kind == TapKind::Air) {
        events.raise(tapping_alarm::kWrongPitch,
                     Sentence(KERF_TEXT("Z moves %1 mm per revolution, the pitch entered is %2 mm."), {found_mm, 3},
                              {m_job.pitch_mm, 3}));
    } else {
        events.raise(tapping_alarm::kErrorLimit,
                     Sentence(KERF_TEXT("%1 µm at %2 revolutions; the limit is %3 µm."), {m_status.error_um, 0},
                              {m_status.spindle_rev, 1}, {m_job.abortError_um, 0}));
    }
    if (m_mode == LoopMode::Control) abortInSync(outputs);
}

bool TappingLoop::pitchFits() const noexcept {
    const double programmed_mm = m_job.pitch_mm * m_deepest_rev;
    return std::abs(m_deepest_mm - programmed_mm) <= std::max(kPitchAtDepth * programmed_mm, kPitchAtDepth_mm);
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
    TapFigures& figures = m_status.last;
    const double total = std::max(1.0, static_cast<double>(figures.samples + figures.missing));
    if (figures.samples > 0) {
        figures.rms_um = std::sqrt(m_squares_um2 / static_cast<double>(figures.samples));
        figures.engagedPp_um = m_high_um - m_low_um;
        if (outcome == TapOutcome::Counted) figures.saec_mm *= total / static_cast<double>(figures.samples);
    }
    if (outcome == TapOutcome::Counted &&
        (m_interrupted || figures.samples == 0 || static_cast<double>(figures.missing) > kMaxMissing * total)) {
        outcome = TapOutcome::NotCounted;
    }
    m_status.outcome = outcome;
    events.set(tapping_alarm::kNotCounted, outcome == TapOutcome::NotCounted);
    if (outcome == TapOutcome::Counted) {
        events.clear(tapping_alarm::kErrorLimit);
        events.clear(tapping_alarm::kSignalLost);
        if (m_status.kind == TapKind::Air) {
            m_status.airTapPassed = pitchFits();
            events.set(tapping_alarm::kWrongPitch, !m_status.airTapPassed,
                       Sentence(KERF_TEXT("Z moves %1 mm per revolution, the pitch entered is %2 mm."),
                                {m_deepest_mm / std::max(m_deepest_rev, 1e-9), 3}, {m_job.pitch_mm, 3}));
        }
        if (m_status.kind == TapKind::Production) {
            ++m_status.productionTaps;
            if (m_mode == LoopMode::Control) m_drift.add(figures.saec_mm);  // else the gains are not the watched ones
        }
        m_status.driftShare = m_drift.excess();
        m_status.wantsTuning = m_drift.grown();
        events.set(tapping_alarm::kDrift, m_drift.grown());
    }
    ++m_status.taps;
    if (m_recording) {
        m_recording = false;
        TapRecord& tap = m_exchange.records.writeSlot();
        tap.number = m_status.taps;
        tap.outcome = outcome;
        tap.figures = figures;
        m_exchange.records.publish();
    }
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
    part.begin_ns = m_tapBegin_ns;
    part.tap.job = m_job;
    part.tap.figures = m_status.last;
    part.tap.withinTolerance = outcome == TapOutcome::Counted && m_status.last.engagedPp_um <= m_job.allowedPp_um;
    const bool complete = outcome != TapOutcome::Aborted;
    m_status.partsCut += complete ? 1U : 0U;
    finishRecord(part, m_now_ns, complete, events);
}

void TappingLoop::stopInHole(EventSink& events) noexcept {
    if (m_status.spindle_rev < kInHole_rev) {
        endTap(TapOutcome::Aborted, events);
        return;
    }
    m_status.stoppedSpindle_rev = m_status.spindle_rev;
    m_status.stoppedZ_mm = m_status.z_mm;
    m_status.phase = TapPhase::InHole;
    m_recoverWanted = false;
    m_abortWanted = false;
    events.raise(tapping_alarm::kInHole,
                 Sentence(KERF_TEXT("%1 revolutions in, at %2 mm."), {m_status.spindle_rev, 2}, {m_status.z_mm, 3}));
}

LoopVerdict TappingLoop::describe() const noexcept {
    const bool control = m_mode == LoopMode::Control;
    const LoopState state = control ? LoopState::Controlling : LoopState::Advising;
    switch (m_status.phase) {
        case TapPhase::SettingGains:
            return {state, Sentence(KERF_TEXT("Gains are being set; nothing turns."))};
        case TapPhase::Starting:
        case TapPhase::Tapping:
            return {state, m_status.kind == TapKind::Air ? Sentence(KERF_TEXT("Air tap: Z and spindle move, no work."))
                                                         : Sentence(KERF_TEXT("Tapping and recording."))};
        case TapPhase::Retracting:
            return {LoopState::Limited, Sentence(KERF_TEXT("The tap is turned out in sync."))};
        case TapPhase::InHole:
            return {LoopState::Limited, inHole()};
        case TapPhase::Idle:
            break;
    }
    if (m_job.revision == 0) return {state, Sentence(KERF_TEXT("No tapping job is loaded."))};
    if (!m_status.airTapPassed) return {state, Sentence(KERF_TEXT("Ready: the first tap of the job is an air tap."))};
    return {state, control ? Sentence(KERF_TEXT("Ready: the next tap uses the gains shown."))
                           : Sentence(KERF_TEXT("Ready: the next tap uses the machine's own gains."))};
}

}  // namespace kerf
