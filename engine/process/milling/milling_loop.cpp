// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/milling_loop.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/cycle/event_sink.h"
#include "engine/process/milling/force_bounds.h"
#include "engine/process/milling/milling_alarms.h"
#include "engine/process/milling/milling_setup.h"

namespace kerf {
namespace {

using milling::FeedController;

constexpr double kStanding = 0.02;     // share of the planned feed below which the axis counts as standing
constexpr double kSpindleSlow = 0.5;   // share of the programmed speed
constexpr double kRunUp_s = 0.3;       // the axis may go on before the spindle has been up to speed
constexpr double kKnobAtRest = 0.005;  // deviation of the feed knob from 100 % that does not count
constexpr double kPatience_s = 2.0;    // at a feed limit before the operator is told
constexpr double kInWork = 0.5;        // share of the reference from which a collapse can be told
constexpr double kSpeedTolerance = 0.3;
constexpr double kPeakOverLimit = 2.0;  // a single sample this far over the limit stops at once

}  // namespace

MillingLoop::MillingLoop() noexcept : m_controller(FeedController::Params(), MillingLaw::Model) {}

LoopVerdict MillingLoop::step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                              EventSink& events) noexcept {
    m_forceFitted = capabilities.forceSensor.fitted;
    m_signal = capabilities.force;
    m_rise_perS = capabilities.limits.feedScaleRise_perS;
    followStop(inputs.stops[static_cast<std::size_t>(ProcessId::Milling)]);
    if (m_startWanted) {
        m_startWanted = false;
        requestStart(capabilities, outputs);
    }
    const ProgramTurn turn = m_program.follow(inputs);
    if (turn.cutOff) {
        endPart(inputs, false, events);
    }
    if (turn.begins) {
        beginPart(inputs, capabilities);
    }
    if (turn.ends) {
        endPart(inputs, turn.finished, events);
    }
    m_status.cutting = turn.running;
    if (!m_status.cutting) {
        for (const AlarmSpec& alarm : milling_alarm::kSpecs) {
            if (alarm.code != milling_alarm::kToolWorn && alarm.code != milling_alarm::kZeroDrifted) {
                events.clear(alarm.code);
            }
        }
        if (m_wear.parts() > 0 && m_wear.rise() > m_setup.wearWarning) {
            events.raise(milling_alarm::kToolWorn,
                         Sentence(KERF_TEXT("The cutting stiffness has risen by %1 % since the tool was new."),
                                  {100.0 * (std::exp(m_wear.rise()) - 1.0), 0}));
        } else {
            events.clear(milling_alarm::kToolWorn);
        }
        m_last_ns = inputs.time_ns;
        const bool control = m_mode == LoopMode::Control;
        return {control ? LoopState::Controlling : LoopState::Advising,
                control ? Sentence(KERF_TEXT("Ready: the next cut holds the reference force."))
                        : Sentence(KERF_TEXT("Ready: the next cut is made at its planned feed."))};
    }
    return control(inputs, outputs, events);
}

void MillingLoop::beginPart(const MachineInputs& inputs, const Capabilities& capabilities) noexcept {
    m_zero.begin(milling::zeroParams(capabilities, m_setup));
    m_part = beginRecord(inputs);
    m_paused = true;
    m_limitedSince_ns = -1;
    m_spindleWas = false;
    m_runUp_s = 0.0;
    m_last_ns = inputs.time_ns;
    m_travel_mm = 0.0;
    m_markTravel_mm = 0.0;
    m_revolution_s = 60.0 / m_setup.spindleSpeed_rpm;
    m_wanted_mmPerS = std::min(m_setup.entryFeed_mmPerS, m_setup.highestFeed_mmPerS);
    m_controller.beginCut();
    m_controller.follow(m_wanted_mmPerS);
    m_averager.reset();
    beginGroup();
    milling::ForceWatch::Params watch;
    watch.flutes = m_setup.flutes;
    watch.inWork_N = kInWork * m_setup.reference_N;
    m_watch = milling::ForceWatch(watch);
    m_chatter.begin(m_setup.flutes);
    m_decision = {};
    m_record = milling::CutRecord(milling::recordParams(m_setup), m_law, m_mode != LoopMode::Control);
    m_status.waviness_um = 0.0;
    m_status.wallDeviation_um = 0.0;
    m_status.force_N = {};
}

void MillingLoop::endPart(const MachineInputs& inputs, bool complete, EventSink& events) noexcept {
    m_part.milling = m_record.cut();
    m_part.forceMean_N = m_part.milling.meanForce_N;
    m_part.forcePeak_N = m_part.milling.peakForce_N;
    if (complete && m_part.milling.stiffnessMean != 0.0) {
        m_wear.addPart(m_part.milling.stiffnessMean);
    }
    m_wear.save(m_part.millingTool);
    m_part.millingTool.kxLogWeight = m_controller.kxLogWeights();
    finishRecord(m_part, inputs.time_ns, complete, events);
    m_zero.end(complete);
    const double moved_N = m_zero.moved_N().value_or(0.0);
    events.set(milling_alarm::kZeroDrifted, std::abs(moved_N) > m_zero.trust_N(),
               Sentence(KERF_TEXT("The zero has moved by %1 N in the last cut."), SentenceArg(moved_N, 1)));
    m_status.partsCut += complete ? 1U : 0U;
}

void MillingLoop::takeSamples(const MachineInputs& inputs) noexcept {
    m_cyclePeak_N = 0.0;
    for (std::size_t i = 0; i < inputs.fastCount && i < kMaxFastSamples; ++i) {
        const bool waited = m_zero.state() == ForceZeroState::Taking;
        const FastSample sample = m_zero.take(inputs.fast[i]);
        if (m_zero.state() == ForceZeroState::Taking) {
            continue;  // no force yet, and nothing wrong with it
        }
        m_markTravel_mm = waited ? m_travel_mm : m_markTravel_mm;
        m_watch.add(sample);
        m_chatter.add(sample);
        if (sample.quality == Quality::Good && std::isfinite(sample.force_N)) {
            const auto force_N = static_cast<float>(sample.force_N);
            m_rawLow_N = m_rawTaken ? force_N : std::min(m_rawLow_N, force_N);
            m_rawHigh_N = m_rawTaken ? force_N : std::max(m_rawHigh_N, force_N);
            m_rawTaken = false;
            m_cyclePeak_N = std::max(m_cyclePeak_N, sample.force_N);
        }
        if (const auto revolution = m_averager.add(sample)) {
            takeRevolution(*revolution, inputs);
        }
    }
}

void MillingLoop::takeRevolution(const milling::RevolutionForce& revolution, const MachineInputs& inputs) noexcept {
    // Times come with the samples; what does not fit the spindle's speed is not believed.
    const double bySpeed_s = inputs.spindleSpeed_rpm.good() && inputs.spindleSpeed_rpm.value > 1.0
                                 ? 60.0 / inputs.spindleSpeed_rpm.value
                                 : m_revolution_s;
    const bool fits = std::abs(revolution.duration_s() / bySpeed_s - 1.0) < kSpeedTolerance;
    m_revolution_s = fits ? revolution.duration_s() : bySpeed_s;
    const bool trusted = revolution.quality == Quality::Good && m_feedKnown;
    m_status.force_N = {revolution.mean_N, revolution.end_ns, revolution.quality};
    m_status.forceLow_N = revolution.low_N;
    m_status.forceHigh_N = revolution.peak_N;
    const double force_N = std::max(0.0, revolution.mean_N);
    if (m_paused) {
        m_watch.disarm();
        return;
    }
    if (trusted) {
        m_status.wallDeviation_um = force_N / m_setup.ky_NPerMm * 1e3;
    }
    m_groupForce_N += force_N;
    m_group_s += m_revolution_s;
    m_groupTrusted = m_groupTrusted && trusted;
    ++m_groupCount;
    if (m_groupCount < m_controller.period() && trusted) {
        return;
    }
    const double since_s = trusted ? static_cast<double>(inputs.time_ns - revolution.end_ns) * 1e-9 : 0.0;
    const double atMark_mm = m_travel_mm - (trusted ? inputs.actualFeed_mmPerS.value * since_s : 0.0);
    const double feed_mm = std::max(0.0, atMark_mm - m_markTravel_mm);
    m_markTravel_mm = atMark_mm;
    takePeriod(feed_mm, inputs);
    beginGroup();
    // Faster than drive and control can follow there is nothing to gain: average over more whole revolutions.
    m_controller.setPeriod(
        std::max(1, static_cast<int>(std::ceil(milling::shortestPeriod_s(m_signal) / m_revolution_s - 1e-6))));
}

void MillingLoop::beginGroup() noexcept {
    m_groupForce_N = 0.0;
    m_group_s = 0.0;
    m_groupCount = 0;
    m_groupTrusted = true;
}

void MillingLoop::takePeriod(double feed_mm, const MachineInputs& inputs) noexcept {
    const double force_N = m_groupForce_N / m_groupCount;
    if (m_mode != LoopMode::Control && m_law == MillingLaw::Pi) {
        m_controller.follow(feed_mm / m_group_s);  // its integral must not run away on a feed it does not make
    }
    const bool overridden = std::abs(inputs.operatorOverride - 1.0) > kKnobAtRest;
    const bool advised = m_mode != LoopMode::Control;
    m_controller.setRange(reach(inputs));
    m_decision = m_controller.update({m_groupTrusted ? std::optional(force_N) : std::nullopt, feed_mm,
                                      m_status.position_mm, m_group_s, overridden, advised});
    m_wanted_mmPerS = m_decision.feed_mmPerS;
    m_decision.limited = m_decision.limited && (m_wanted_mmPerS <= m_setup.lowestFeed_mmPerS ||
                                                m_wanted_mmPerS >= m_setup.highestFeed_mmPerS);
    if (!m_groupTrusted) {
        return;
    }
    milling::StiffnessEstimate stiffness = m_controller.stiffness();
    const double steady_mmPerS =
        milling::invert(milling::inversionModel(m_setup, stiffness), stiffness.lnCb, force_N, m_setup.reference_N)
            .steady_mmPerRev /
        m_group_s;
    const double controlled_mmPerS =
        stiffness.valid ? std::clamp(steady_mmPerS, m_setup.lowestFeed_mmPerS, m_setup.highestFeed_mmPerS) : 0.0;
    stiffness.lnCb = lnCb();
    m_record.add({m_status.position_mm, force_N, m_group_s, feed_mm / m_group_s, controlled_mmPerS, stiffness});
}

/// What the feed can rise to within one period: a law that counted on more would take the rest for still to come.
milling::FeedRange MillingLoop::reach(const MachineInputs& inputs) const noexcept {
    milling::FeedRange range{m_setup.lowestFeed_mmPerS, m_setup.highestFeed_mmPerS};
    if (m_mode == LoopMode::Control && inputs.appliedFeedScale.good() && inputs.programmedFeed_mmPerS.good()) {
        const double scale = inputs.appliedFeedScale.value + m_rise_perS * m_group_s;
        range.max_mmPerS = std::clamp(scale * inputs.programmedFeed_mmPerS.value, range.min_mmPerS, range.max_mmPerS);
    }
    return range;
}

double MillingLoop::lnCb() const noexcept {
    return m_controller.stiffness().lnCb + m_setup.exponent * std::log(static_cast<double>(m_controller.period()));
}

/// Who keeps the stop says when it ends; one from before a restart is this loop's as well.
void MillingLoop::followStop(const StopSlot& stop) noexcept {
    if (m_stopWatch.released(stop)) {
        m_releaseWanted = m_stopAlarm != 0 && m_program.inPart();
        m_stopAlarm = m_releaseWanted ? m_stopAlarm : AlarmCode{0};
    }
    if (stop.active() && m_stopAlarm == 0) {
        m_stopAlarm = stop.cause;
        m_stopReason = Sentence{};
    }
}

void MillingLoop::stop(AlarmCode code, const Sentence& detail, EventSink& events) noexcept {
    if (m_stopAlarm == 0) {
        m_stopAlarm = code;
        m_stopReason = detail;
        m_record.countStop();
        events.raise(code, detail);
    }
}

void MillingLoop::watchForStops(const MachineInputs& inputs, EventSink& events) noexcept {
    if (m_releaseWanted) {
        m_releaseWanted = false;
        events.clear(m_stopAlarm);
        m_stopAlarm = 0;
        m_watch.disarm();
        m_status.force_N = {};
    }
    const bool turns =
        inputs.spindleSpeed_rpm.good() && inputs.spindleSpeed_rpm.value >= kSpindleSlow * m_setup.spindleSpeed_rpm;
    // A spindle that has not been up to speed in this cut may be running up; but not while the axis goes on.
    m_spindleWas = m_spindleWas || turns;
    m_runUp_s = turns || m_paused ? 0.0 : m_runUp_s + m_cycle_s;
    if (!turns && (m_spindleWas || m_runUp_s > kRunUp_s)) {
        stop(milling_alarm::kSpindleStopped, {}, events);
    }
    if (m_paused) {
        return;
    }
    if (m_watch.collapsed() || m_watch.chipped()) {
        stop(milling_alarm::kToolBroken, {}, events);
    }
    const double force_N = std::max(m_status.force_N.good() ? m_status.force_N.value : 0.0, m_watch.revolutionMean_N());
    if (force_N > m_setup.overload_N || m_cyclePeak_N > kPeakOverLimit * m_setup.overload_N) {
        stop(milling_alarm::kOverload,
             Sentence(KERF_TEXT("%1 N at %2 mm; the limit is %3 N."), {std::max(force_N, m_cyclePeak_N), 0},
                      {m_status.position_mm, 1}, {m_setup.overload_N, 0}),
             events);
    }
}

LoopVerdict MillingLoop::control(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept {
    const double dt_s = static_cast<double>(inputs.time_ns - m_last_ns) / kNanosecondPerSecond;
    m_last_ns = inputs.time_ns;
    m_cycle_s = dt_s;
    m_feedKnown = inputs.actualFeed_mmPerS.good();
    if (m_feedKnown) {
        m_made_mmPerS = inputs.actualFeed_mmPerS.value;
        m_travel_mm += m_made_mmPerS * dt_s;
    }
    m_status.position_mm = inputs.position_mm[0].good() ? inputs.position_mm[0].value : m_setup.from_mm + m_travel_mm;
    const bool standing =
        inputs.feedHold || (m_feedKnown && inputs.actualFeed_mmPerS.value < kStanding * m_setup.plannedFeed_mmPerS);
    if (m_paused && !standing) {
        m_watch.disarm();
        m_controller.resumeAfterPause();
        m_wanted_mmPerS = std::min(m_wanted_mmPerS, m_setup.entryFeed_mmPerS);
        m_averager.reset();
        m_markTravel_mm = m_travel_mm;
        beginGroup();
    }
    m_paused = standing;
    m_watch.setFeed(m_feedKnown ? std::optional(m_made_mmPerS) : std::nullopt);
    takeSamples(inputs);
    const bool lastSpoiled = m_status.force_N.stamp_ns != 0 && m_status.force_N.quality != Quality::Good;
    const bool blind = m_watch.blind(inputs.time_ns, m_revolution_s) || !m_feedKnown || lastSpoiled;
    m_status.blind = blind;
    if (blind) {  // at once, not only when the revolution is over
        m_wanted_mmPerS = std::min(m_wanted_mmPerS, m_setup.plannedFeed_mmPerS);
    }
    // With the constant law nothing is controlled, but breakage and overload are watched: that must not end in silence.
    const bool watched = m_law != MillingLaw::Constant || m_forceFitted;
    const ForceZeroState zero = m_zero.state();
    const bool zeroUnknown = zero == ForceZeroState::Missed || zero == ForceZeroState::Doubtful;
    const bool zeroWaits = zero == ForceZeroState::Taking;
    const bool forceBlind = blind && m_feedKnown && watched && !m_paused && !zeroWaits;
    const Sentence slow = milling::whyTooSlow(m_signal, m_setup.spindleSpeed_rpm);
    events.set(milling_alarm::kForceUnknown, forceBlind && !zeroUnknown,
               slow.empty() ? milling::forceDetail(m_watch.quality()) : slow);
    events.set(milling_alarm::kZeroUnknown, zeroUnknown && watched, milling::zeroDetail(m_zero));
    outputs.forceReset = m_zero.wantsReset();
    events.set(milling_alarm::kFeedUnknown, !m_feedKnown);
    events.set(milling_alarm::kChatter, m_chatter.chatters(),
               Sentence(KERF_TEXT("The force swings by %1 N at about %2 Hz."), {m_chatter.amplitude_N(), 0},
                        {m_chatter.frequency_Hz(), 0}));
    watchForStops(inputs, events);
    m_limitedSince_ns = !m_decision.limited || m_paused ? -1
                        : m_limitedSince_ns < 0         ? inputs.time_ns
                                                        : m_limitedSince_ns;
    events.set(milling_alarm::kReferenceOutOfReach,
               m_limitedSince_ns >= 0 &&
                   static_cast<double>(inputs.time_ns - m_limitedSince_ns) > kPatience_s * kNanosecondPerSecond);
    wish(inputs, outputs);

    const bool advises = m_mode == LoopMode::Advise;
    if (m_stopAlarm != 0 && m_mode != LoopMode::Control) {
        return {LoopState::Advising, Sentence(KERF_TEXT("Control would have held the feed: see the alarm."))};
    }
    if (m_stopAlarm != 0) {
        return {LoopState::Held, Sentence(KERF_TEXT("The feed is held: see the alarm, then release the feed here."))};
    }
    if (!m_feedKnown) {
        return {LoopState::Limited,
                Sentence(advises ? KERF_TEXT("Feed really made is unknown: control would go no faster than planned.")
                                 : KERF_TEXT("Feed really made is unknown: no faster than planned."))};
    }
    if (forceBlind) {
        return {LoopState::Limited,
                Sentence(advises ? KERF_TEXT("Cutting force unknown: control would go no faster than planned.")
                                 : KERF_TEXT("Cutting force unknown: no faster than planned."))};
    }
    if (zeroWaits && watched) {
        return {LoopState::Controlling, Sentence(KERF_TEXT("In air: the zero of the force is taken."))};
    }
    if (m_paused) {
        return {LoopState::Controlling, Sentence(advises ? KERF_TEXT("The feed stands; control would go on with it.")
                                                         : KERF_TEXT("The feed stands; control goes on with it."))};
    }
    if (m_law == MillingLaw::Constant) {
        return {LoopState::Controlling, Sentence(KERF_TEXT("The planned feed is kept."))};
    }
    if (m_decision.inAir) {
        return {LoopState::Controlling,
                Sentence(advises ? KERF_TEXT("In air: control would take the entry feed until the tool meets the work.")
                                 : KERF_TEXT("In air: entry feed until the tool meets the work."))};
    }
    if (m_decision.limited) {
        return {LoopState::Limited,
                Sentence(advises ? KERF_TEXT("The reference force would need a feed outside %1 to %2 mm/s.")
                                 : KERF_TEXT("The reference force needs a feed outside %1 to %2 mm/s."),
                         {m_setup.lowestFeed_mmPerS, 2}, {m_setup.highestFeed_mmPerS, 2})};
    }
    return {LoopState::Controlling, Sentence(advises ? KERF_TEXT("The feed would hold the reference force.")
                                                     : KERF_TEXT("The feed holds the reference force."))};
}

void MillingLoop::wish(const MachineInputs& inputs, LoopOutputs& outputs) const noexcept {
    if (m_stopAlarm != 0) {
        outputs.stop = {StopKind::FeedHold, m_stopAlarm, m_stopReason};
    }
    if (m_setup.revision == 0) {
        return;  // what the cut may be is not known
    }
    const Reading& programmed = inputs.programmedFeed_mmPerS;
    if (!programmed.good() || programmed.value <= 0.0) {
        return;  // engine/limits keeps the last scale
    }
    // A knob above 100 % does not lift the force over the reference; below, it is the operator's will.
    const double knob = std::isfinite(inputs.operatorOverride) ? std::max(inputs.operatorOverride, 1.0) : 1.0;
    outputs.feedScale = m_wanted_mmPerS / (programmed.value * knob);
    outputs.plannedFeedScale = m_setup.plannedFeed_mmPerS / programmed.value;
}

}  // namespace kerf
