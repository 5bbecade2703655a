// SPDX-License-Identifier: GPL-3.0-or-later
// What the tapping loop is told, and what it says of itself.
#include <algorithm>
#include <cmath>

#include "engine/process/tapping/tapping_alarms.h"
#include "engine/process/tapping/tapping_loop.h"

namespace kerf {
namespace {

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
        m_tap.setJob(m_job);
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

Sentence TappingLoop::inHole() const noexcept {
    if (m_status.stoppedSpindle_rev == 0.0) {
        return Sentence(KERF_TEXT("A tap stands in the hole, from before Kerf was started: turn it out in sync."));
    }
    return Sentence(KERF_TEXT("The tap stands %1 revolutions in the hole: turn it out in sync."),
                    {m_status.stoppedSpindle_rev, 2});
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
