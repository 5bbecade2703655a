// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/boring_loop.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/cycle/event_sink.h"
#include "engine/process/boring/boring_alarms.h"

namespace kerf {
namespace {

constexpr double kFollowTolerance = 0.05;                   // share of the wanted feed
constexpr std::int64_t kFollowPatience_ns = 2'000'000'000;  // machine time
constexpr double kUnseen_mm = 0.1;                          // way without a move of the position: ten steps of .01 mm
constexpr double kLongestLook_s = 0.05;                     // that one late cycle counts for

bool usable(const BoringSchedule& s) {
    const bool numbers = std::isfinite(s.lnC) && std::isfinite(s.beta) && s.alpha > 0.0 && std::isfinite(s.alpha);
    const bool law = s.constantFeed_mmPerRev > 0.0 || (numbers && s.targetDeflection_mm > 0.0);
    return law && s.minFeed_mmPerRev > 0.0 && s.maxFeed_mmPerRev >= s.minFeed_mmPerRev && s.overhangFrom_mm > 0.0 &&
           s.overhangTo_mm > s.overhangFrom_mm && s.spindleSpeed_rpm > 0.0;
}

}  // namespace

std::span<const AlarmSpec> BoringLoop::alarms() const noexcept {
    return boring_alarm::kSpecs;
}

CommandResult BoringLoop::handle(const Command& command) noexcept {
    if (const auto* load = std::get_if<LoadBoringSchedule>(&command.action)) {
        if (!usable(load->schedule)) {
            return CommandResult::refused(
                Sentence(KERF_TEXT("The feed schedule has a value outside its range; the last one stays.")));
        }
        m_next = load->schedule;
        return CommandResult::ok();
    }
    if (std::holds_alternative<StartPart>(command.action)) {
        if (m_next.revision == 0) {
            return CommandResult::refused(
                Sentence(KERF_TEXT("No feed schedule is loaded: choose a part type and a lot first.")));
        }
        m_startWanted = true;
        return CommandResult::ok();
    }
    return CommandResult::refused(Sentence(KERF_TEXT("The boring loop does not know this command.")));
}

LoopVerdict BoringLoop::step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                             EventSink& events) noexcept {
    if (m_startWanted) {
        m_startWanted = false;
        StartProgram program;
        program.process = ProcessId::Boring;
        program.programmedFeed_mmPerRev = m_next.highestFeed_mmPerRev();
        if (m_mode == LoopMode::Control) {
            program.plannedFeedScale = m_next.lowestFeed_mmPerRev() / m_next.highestFeed_mmPerRev();
        }
        program.spindleSpeed_rpm = m_next.spindleSpeed_rpm;
        program.from_mm = m_next.overhangFrom_mm;
        program.to_mm = m_next.overhangTo_mm;
        outputs.request.number = m_program.nextRequest();
        outputs.request.action = program;
    }

    const ProgramTurn turn = m_program.follow(inputs);
    if (turn.cutOff) {
        endPart(inputs, false, events);
    }
    if (turn.begins) {
        beginPart(inputs);
    }
    if (turn.ends) {
        endPart(inputs, turn.finished, events);
    }
    m_status.cutting = turn.running;
    m_status.overhang_mm = inputs.overhang_mm;
    m_status.nextSchedule = m_next.revision;
    if (!turn.running) {
        events.clear(boring_alarm::kOverhangLost);
        events.clear(boring_alarm::kSpindleSpeedLost);
        events.clear(boring_alarm::kFeedNotFollowing);
        const char* idle = m_mode == LoopMode::Control
                               ? KERF_TEXT("Ready: the next bore is cut with the schedule shown.")
                               : KERF_TEXT("Ready: the next bore is cut at its programmed feed.");
        return {m_mode == LoopMode::Control ? LoopState::Controlling : LoopState::Advising, Sentence(idle)};
    }
    return follow(inputs, capabilities, outputs, events);
}

LoopVerdict BoringLoop::follow(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                               EventSink& events) noexcept {
    const BoringSchedule& schedule = m_part.schedule;
    const bool advises = m_mode == LoopMode::Advise;
    const bool stuck = standsStill(inputs);
    const bool overhangKnown = inputs.overhang_mm.good() && inputs.overhang_mm.value > 0.0 && !stuck;
    const bool speedKnown = inputs.spindleSpeed_rpm.good() && inputs.spindleSpeed_rpm.value > 0.0;
    events.set(boring_alarm::kOverhangLost, !overhangKnown);
    events.set(boring_alarm::kSpindleSpeedLost, !inputs.spindleSpeed_rpm.good());
    m_status.feed_mmPerRev = {};
    if (schedule.revision == 0) {
        return {LoopState::Limited,
                Sentence(KERF_TEXT("No feed schedule is loaded: this bore is cut at its programmed feed."))};
    }
    if (inputs.programmedFeed_mmPerS.good() && inputs.programmedFeed_mmPerS.value > 0.0) {
        const double lowest_mmPerS = m_lowestFeed_mmPerRev * schedule.spindleSpeed_rpm / 60.0;
        outputs.plannedFeedScale = lowest_mmPerS / inputs.programmedFeed_mmPerS.value;
    }
    if (!overhangKnown) {
        return {
            LoopState::Limited,
            Sentence(
                advises
                    ? KERF_TEXT("Spindle overhang unknown: control would go no faster than the schedule's lowest feed.")
                    : KERF_TEXT("Spindle overhang unknown: no faster than the schedule's lowest feed."))};
    }
    const double overhang_mm = inputs.overhang_mm.value;
    const double best_mmPerRev = schedule.unclampedFeed_mmPerRev(overhang_mm, m_lnTarget);
    const double wanted_mmPerRev = schedule.clamped_mmPerRev(best_mmPerRev);
    m_status.wantedFeed_mmPerRev = wanted_mmPerRev;
    const double length_mm = schedule.overhangTo_mm - schedule.overhangFrom_mm;
    m_status.progress = std::clamp((overhang_mm - schedule.overhangFrom_mm) / length_mm, 0.0, 1.0);
    if (!speedKnown) {
        return {
            LoopState::Limited,
            Sentence(
                advises
                    ? KERF_TEXT(
                          "Spindle speed unknown or zero: control would go no faster than the schedule's lowest feed.")
                    : KERF_TEXT("Spindle speed unknown or zero: no faster than the schedule's lowest feed."))};
    }
    const double perRev = 60.0 / inputs.spindleSpeed_rpm.value;
    if (inputs.actualFeed_mmPerS.good()) {
        const double actual_mmPerRev = inputs.actualFeed_mmPerS.value * perRev;
        m_status.feed_mmPerRev = {actual_mmPerRev, inputs.actualFeed_mmPerS.stamp_ns, Quality::Good};
        const double remaining_mm = std::max(schedule.overhangTo_mm - overhang_mm, 0.0);
        m_status.remaining_s =
            inputs.actualFeed_mmPerS.value > 0.0 ? remaining_mm / inputs.actualFeed_mmPerS.value : 0.0;
        trace(overhang_mm, actual_mmPerRev);
        const bool off = m_mode == LoopMode::Control && !inputs.feedHold &&
                         std::abs(actual_mmPerRev - wanted_mmPerRev) > kFollowTolerance * wanted_mmPerRev;
        m_offScheduleSince_ns = !off ? -1 : m_offScheduleSince_ns < 0 ? inputs.time_ns : m_offScheduleSince_ns;
        events.set(boring_alarm::kFeedNotFollowing, off && inputs.time_ns - m_offScheduleSince_ns > kFollowPatience_ns);
    }
    if (!inputs.programmedFeed_mmPerS.good() || inputs.programmedFeed_mmPerS.value <= 0.0) {
        return {
            LoopState::Limited,
            Sentence(
                advises
                    ? KERF_TEXT("Programmed feed unknown: control would go no faster than the schedule's lowest feed.")
                    : KERF_TEXT("Programmed feed unknown: no faster than the schedule's lowest feed."))};
    }
    const double scale = wanted_mmPerRev / (inputs.programmedFeed_mmPerS.value * perRev);
    outputs.feedScale = scale;
    if (scale > capabilities.maxFeedScale * (1.0 + 1e-9)) {
        return {LoopState::Limited,
                Sentence(KERF_TEXT("The schedule wants %1 of the programmed feed; this control allows %2."), {scale, 2},
                         {capabilities.maxFeedScale, 2})};
    }
    if (wanted_mmPerRev != best_mmPerRev) {
        return {
            LoopState::Limited,
            Sentence(advises ? KERF_TEXT("The best feed lies outside %1 to %2 mm/rev: the feed would sit at the limit.")
                             : KERF_TEXT("The best feed lies outside %1 to %2 mm/rev: the feed sits at the limit."),
                     {schedule.minFeed_mmPerRev, 3}, {schedule.maxFeed_mmPerRev, 3})};
    }
    return {LoopState::Controlling, Sentence(advises ? KERF_TEXT("The feed would follow the schedule along the bore.")
                                                     : KERF_TEXT("The feed follows the schedule along the bore."))};
}

/// A position that does not move while the spindle feeds is none: the schedule would stay where it was.
bool BoringLoop::standsStill(const MachineInputs& inputs) noexcept {
    const double dt_s = static_cast<double>(inputs.time_ns - m_lookedAt_ns) / kNanosecondPerSecond;
    m_lookedAt_ns = inputs.time_ns;
    if (!inputs.overhang_mm.good() || inputs.overhang_mm.value != m_stands_mm) {
        m_stands_mm = inputs.overhang_mm.value;
        m_unseen_mm = 0.0;
        return false;
    }
    double feed_mmPerS = inputs.actualFeed_mmPerS.value;
    if (!inputs.actualFeed_mmPerS.good()) {
        const bool asked = inputs.programmedFeed_mmPerS.good() && inputs.appliedFeedScale.good() && !inputs.feedHold;
        feed_mmPerS = asked ? inputs.programmedFeed_mmPerS.value * inputs.appliedFeedScale.value : 0.0;
    }
    m_unseen_mm += std::abs(feed_mmPerS) * std::clamp(dt_s, 0.0, kLongestLook_s);
    return m_unseen_mm > kUnseen_mm;
}

void BoringLoop::beginPart(const MachineInputs& inputs) noexcept {
    m_part = beginRecord(inputs);
    m_part.schedule = m_next;
    m_lowestFeed_mmPerRev = m_next.lowestFeed_mmPerRev();
    m_lnTarget = std::log(m_next.targetDeflection_mm);
    m_offScheduleSince_ns = -1;
    m_lookedAt_ns = inputs.time_ns;
    m_unseen_mm = 0.0;
    m_status.activeSchedule = m_next.revision;
    m_status.progress = 0.0;
}

void BoringLoop::endPart(const MachineInputs& inputs, bool complete, EventSink& events) noexcept {
    finishRecord(m_part, inputs.time_ns, complete, events);
    m_status.partsCut += complete ? 1U : 0U;
}

void BoringLoop::trace(double overhang_mm, double feed_mmPerRev) noexcept {
    FeedTrace& feed = m_part.feed;
    const BoringSchedule& schedule = m_part.schedule;
    const double spacing_mm =
        (schedule.overhangTo_mm - schedule.overhangFrom_mm) / static_cast<double>(kFeedTracePoints - 1);
    // Points missed by a late cycle are made up for on the way, not at one place.
    const bool moved =
        feed.count == 0 || overhang_mm >= static_cast<double>(feed.overhang_mm[feed.count - 1U]) + 0.5 * spacing_mm;
    if (feed.count < kFeedTracePoints && moved &&
        overhang_mm >= schedule.overhangFrom_mm + spacing_mm * feed.count - 1e-9) {
        feed.overhang_mm[feed.count] = static_cast<float>(overhang_mm);
        feed.feed_mmPerRev[feed.count] = static_cast<float>(feed_mmPerRev);
        ++feed.count;
    }
}

void BoringLoop::report(Status& status) const noexcept {
    status.boring = m_status;
}

void BoringLoop::sample(Sample& sample) const noexcept {
    sample.feed_mmPerRev = static_cast<float>(m_status.feed_mmPerRev.value);
    sample.wantedFeed_mmPerRev = static_cast<float>(m_status.wantedFeed_mmPerRev);
    sample.overhang_mm = static_cast<float>(m_status.overhang_mm.value);
}

}  // namespace kerf
