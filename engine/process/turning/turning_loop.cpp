// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/turning_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/cycle/event_sink.h"
#include "engine/process/turning/turning_alarms.h"

namespace kerf {
namespace {

static_assert(kTurningFilters == turning::BroadbandPredictor::kFilters);

constexpr std::int64_t kCycle_ns = 200'000;
constexpr double kDriftAlarm_N = 0.05;
constexpr double kTrustShare = 0.05;  // of the target force: error of the zero that can be borne
constexpr double kLeastBandwidth_Hz = 800.0;
constexpr double kTouchShare = 0.10;  // of the target force
constexpr int kTouchSamples = 4;
constexpr double kExitShare = 0.30;
constexpr int kExitSamples = 5;
constexpr double kMeanShare = 1.0 / 250.0;  // mean force over .05 s
constexpr double kChipRatio = 1.25;         // slower than the watch sees
constexpr double kGoneRatio = 0.75;         // below, the cut is being taken away
constexpr int kChipSamples = 50;
constexpr std::int64_t kGap_ns = 300'000;  // a sample and a half
constexpr double kTrimMeanShare = 1.0 / 5000.0;
constexpr double kTrimMeanMost_um = 0.1;
constexpr double kLimitAlarm = 0.2;  // share of the samples at the limit
constexpr double kLimitShare = 1.0 / 2500.0;
constexpr double kRampDown_um = 0.2;  // per sample, the machine's own limit: 2 µm in 2 ms
constexpr double kForgetting = 0.98;

}  // namespace

turning::DepthControlParams TurningLoop::controlParams(const TurningSetup& setup) const noexcept {
    turning::DepthControlParams params;
    params.plant = turning::PlantKind::B2;
    params.kind = kindOf(m_controller);
    params.process = m_process;
    params.onMachine = true;
    params.revolutionSamples = turning::samplesPerRevolution(setup.spindleSpeed_rpm / 60.0, turning::kSampleRate_Hz);
    params.knownTones_Hz = setup.knownTones_Hz;
    params.knownCount = setup.knownToneCount;
    return params;
}

TurningLoop::TurningLoop(TurningExchange* exchange) noexcept
    : m_exchange(exchange),
      m_control(controlParams(TurningSetup{})),
      m_identifier({kForgetting, turning::Forgetting::Robust, 1e4, 0.0}),
      m_trace(exchange) {}

LoopVerdict TurningLoop::step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                              EventSink& events) noexcept {
    if (m_stopWatch.released(inputs.stops[static_cast<std::size_t>(ProcessId::Turning)])) {
        m_outFaulted = false;  // a person has looked; the loop joins again with the next part
    }
    if (m_startWanted) {
        m_startWanted = false;
        startRequest(outputs);
    }
    const ProgramTurn turn = m_program.follow(inputs);
    if (turn.cutOff) {
        endPart(inputs, false, events);
    }
    if (turn.begins) {
        beginPart(inputs);
        m_zero.begin(zeroParams(capabilities));
    }
    m_status.signal = capabilities.force;
    if (turn.ends) {
        endPart(inputs, turn.finished, events);
    }
    if (m_program.inPart() && inputs.link != LinkState::Up) {  // the trim goes on without us, nobody knows how
        if (m_status.stage != TurningStage::Out) {
            leave(Sentence(KERF_TEXT("The connection was lost: no trim in the rest of this part.")), 0);
        }
        m_wanted_um = m_trim_um = 0.0;
        return {LoopState::Limited, m_outReason};
    }
    if (!turn.running) {
        m_status.stage = TurningStage::Idle;
        m_wanted_um = m_trim_um = 0.0;
        return {m_mode == LoopMode::Control ? LoopState::Controlling : LoopState::Advising,
                Sentence(m_mode == LoopMode::Advise
                             ? KERF_TEXT("Ready: force feedback would begin at the touch of the next part.")
                             : KERF_TEXT("Ready: force feedback begins at the touch of the next part."))};
    }
    if (capabilities.cycle_ns != kCycle_ns) {
        return {LoopState::Limited,
                Sentence(KERF_TEXT("Force feedback needs a cycle of 0.2 ms; this machine has %1 ms: no trim."),
                         SentenceArg(static_cast<double>(capabilities.cycle_ns) / 1e6, 2))};
    }

    if (capabilities.force.bandwidth_Hz < kLeastBandwidth_Hz) {
        return {LoopState::Limited,
                Sentence(KERF_TEXT("Force feedback needs a force of %1 Hz bandwidth; this one has %2 Hz: no trim."),
                         {kLeastBandwidth_Hz, 0}, {capabilities.force.bandwidth_Hz, 0})};
    }

    const double span_mm = m_setup.faceTo_mm - m_setup.faceFrom_mm;
    m_status.progress = std::clamp((inputs.position_mm[0].value - m_setup.faceFrom_mm) / span_mm, 0.0, 1.0);
    const FastSample none{};
    for (std::size_t i = 0; i < std::max<std::size_t>(inputs.fastCount, 1); ++i) {  // a late cycle brings several
        takeSample(inputs.fastCount > 0 ? inputs.fast[i] : none, inputs, events);
    }
    outputs.forceReset = m_zero.wantsReset();
    if (m_status.stage != TurningStage::Cutting) {
        m_wanted_um = 0.0;
    }

    const double authority_um = m_setup.trimAuthority_um;
    const double target_um = std::clamp(m_wanted_um, -authority_um, authority_um);
    // Into the loop the law ramps itself; out of it the trim runs to zero here.
    m_trim_um = m_status.stage == TurningStage::Cutting
                    ? target_um
                    : std::clamp(target_um, m_trim_um - kRampDown_um, m_trim_um + kRampDown_um);
    m_status.trim_um = m_trim_um;
    outputs.toolTrim_um = m_trim_um;
    m_part.turning.trimPeak_um = std::max(m_part.turning.trimPeak_um, std::abs(m_status.appliedTrim_um));
    const bool limited = m_wanted_um != target_um;
    m_atLimit += kLimitShare * ((limited ? 1.0 : 0.0) - m_atLimit);
    events.set(turning_alarm::kTrimAtLimit, m_atLimit > kLimitAlarm);

    if (m_outFaulted) {
        outputs.stop = {StopKind::LoopOut, m_outCause, m_outReason};
    }
    switch (m_status.stage) {
        case TurningStage::Out:
            return {m_outFaulted ? LoopState::Faulted : LoopState::Limited, m_outReason};
        case TurningStage::Cutting:
            if (m_atLimit > kLimitAlarm) {
                return {LoopState::Limited,
                        Sentence(KERF_TEXT("The disturbance is larger than the trim may correct."))};
            }
            return {LoopState::Controlling, cuttingReason()};
        case TurningStage::Entry:
            return {LoopState::Controlling, Sentence(KERF_TEXT("The tool has touched: first revolution."))};
        case TurningStage::Air:
        case TurningStage::Idle:
            break;
    }
    return {LoopState::Controlling, Sentence(KERF_TEXT("Out of the cut: the sensor's zero is taken."))};
}

void TurningLoop::takeSample(const FastSample& fast, const MachineInputs& inputs, EventSink& events) noexcept {
    // While its amplifier is reset the signal stands still, and that is no fault.
    const turning::ForceState force = m_zero.resetting() ? turning::ForceState::Good : m_health.judge(fast);
    const bool gap = inputs.fastCount > 0 && fast.stamp_ns - std::exchange(m_lastSample_ns, fast.stamp_ns) > kGap_ns;
    if (inputs.fastCount > 0) {
        (void)m_zero.take(fast);
    }
    noteZero(events);
    const bool zeroKnown = m_zero.state() == ForceZeroState::Known || m_zero.state() == ForceZeroState::Own;
    events.set(turning_alarm::kForceLost, force == turning::ForceState::Lost);
    events.set(turning_alarm::kForceSaturated, force == turning::ForceState::Saturated);
    m_status.force_N = {fast.force_N - m_zero.zero_N(), fast.stamp_ns,
                        m_status.zero == ForceZeroState::Doubtful ? Quality::Bad : fast.quality};
    if (inputs.toolTrim_um.good()) {
        m_status.appliedTrim_um = inputs.toolTrim_um.value;
        m_control.setApplied(inputs.toolTrim_um.value);
    } else {
        m_control.setApplied(m_trim_um);
    }
    const bool cuts = m_status.stage == TurningStage::Entry || m_status.stage == TurningStage::Cutting;
    const bool inLoop = m_status.stage != TurningStage::Out;
    if (force == turning::ForceState::Lost && inLoop) {
        leave(Sentence(KERF_TEXT("Force signal lost: the trim is zero.")), turning_alarm::kForceLost);
    } else if (force == turning::ForceState::Saturated && inLoop) {
        leave(Sentence(KERF_TEXT("Force sensor at the end of its range: no trim in this part.")), 0);
    } else if (cuts && gap) {  // revolutions and tones have gone on unseen: what comes next would look like a chip
        leave(Sentence(KERF_TEXT("Samples of the force are missing: no trim in the rest of this part.")), 0);
    } else if (inLoop && m_status.stage != TurningStage::Air && m_zero.state() == ForceZeroState::Doubtful) {
        leave(Sentence(KERF_TEXT("The zero of the force may have drifted: no trim in the rest of this part.")), 0);
    } else if (inLoop && force == turning::ForceState::Good) {
        const double zeroed_N = fast.force_N - m_zero.zero_N();
        if (m_status.stage == TurningStage::Air) {
            m_control.idle(zeroed_N);
            m_above = zeroKnown && zeroed_N > kTouchShare * m_status.forceTarget_N ? m_above + 1 : 0;
            if (m_above >= kTouchSamples) {
                touch(inputs);
            }
        }
        noteForce(zeroed_N);
        if (m_status.stage == TurningStage::Entry || m_status.stage == TurningStage::Cutting) {
            cut(zeroed_N, inputs, events);
        }
    }
}

/// The touch is told from a tenth of the target; the laws leave the mean of the force alone, so its zero may be 5 %
/// off.
ForceZeroParams TurningLoop::zeroParams(const Capabilities& capabilities) const noexcept {
    return {capabilities.force, capabilities.forceReset.fitted, kTouchShare * m_status.forceTarget_N,
            kTrustShare * m_status.forceTarget_N};
}

void TurningLoop::noteZero(EventSink& events) noexcept {
    const ForceZeroState zero = m_zero.state();
    m_status.zero = zero;
    m_status.forceZero_N = m_zero.zero_N();
    m_status.zeroDoubt_N = m_zero.doubt_N();
    const bool missed = zero == ForceZeroState::Missed;
    events.set(turning_alarm::kZeroUnknown, missed || (zero == ForceZeroState::Doubtful),
               missed ? Sentence(KERF_TEXT("The tool was not in the air for long enough before the cut."))
                      : Sentence(KERF_TEXT("It may be wrong by %1 N."), SentenceArg(m_zero.doubt_N(), 3)));
    if (const std::optional<double> moved = m_zero.moved_N()) {
        events.set(turning_alarm::kZeroDrifted, std::abs(*moved) > kDriftAlarm_N,
                   Sentence(KERF_TEXT("The zero has moved by %1 N."), SentenceArg(*moved, 3)));
    }
}

void TurningLoop::touch(const MachineInputs& inputs) noexcept {
    m_status.stage = TurningStage::Entry;
    m_status.touchOff_mm = inputs.position_mm[0];
    m_part.turning.touchOff_mm = inputs.position_mm[0].value;
    m_part.turning.forceZero_N = m_zero.zero_N();
    m_part.turning.controlled = true;
    m_control.beginCut();
    m_motion.clear();
    startCount();
}

void TurningLoop::startCount() noexcept {
    m_cutSamples = 0;
    m_below = m_jumped = m_moved = 0;
    m_mean_N = m_reference_N = m_trimMean_um = 0.0;
    m_watch.reset(m_process);
    m_surface.clear(m_motion.samples());
}

void TurningLoop::cut(double force_N, const MachineInputs& inputs, EventSink& events) noexcept {
    ++m_cutSamples;
    m_mean_N += std::max(kMeanShare, 1.0 / static_cast<double>(m_cutSamples)) * (force_N - m_mean_N);
    m_status.forceMean_N = m_mean_N;
    m_status.forcePeak_N = std::max(m_status.forcePeak_N, force_N);
    m_forceSum_N += force_N;
    m_trace.force(m_status.progress, force_N);
    identify(force_N, inputs);
    const bool control = m_mode == LoopMode::Control;
    m_control.setSilent(!control);
    m_part.turning.controlled = m_part.turning.controlled && control;
    m_wanted_um = m_control.update({force_N, 0.0});
    if (m_control.ready()) {
        m_status.stage = TurningStage::Cutting;
    }

    m_below = force_N < kExitShare * m_status.forceTarget_N ? m_below + 1 : 0;
    if (m_below >= kExitSamples) {
        m_status.stage = TurningStage::Air;  // the end of the cut; the zero is taken again
        m_status.acting = false;
        m_zero.leave();
        m_above = 0;
        return;
    }
    if (chipped(force_N, events) || losesTheCut(events)) {
        return;
    }
    m_status.acting = m_control.acting();
    m_status.depthEstimate_um += std::max(kMeanShare, 1.0 / static_cast<double>(m_cutSamples)) *
                                 (m_control.chip_um() - m_status.depthEstimate_um);
    if (m_status.stage == TurningStage::Cutting) {
        watchSurface(force_N);
    }
    showTones(events);
}

/// The edge has chipped: û jumps at once, or the mean force has grown by a quarter since the start of the cut.
bool TurningLoop::chipped(double force_N, EventSink& events) noexcept {
    if (m_cutSamples == kReferenceAfter) {
        m_reference_N = m_mean_N;
    }
    double ratio = 1.0;
    if (m_reference_N > 0.0) {
        ratio = m_status.gainRatio = m_mean_N / m_reference_N;
        m_jumped = ratio > kChipRatio ? m_jumped + 1 : 0;
    }
    // At the very end the force falls to nothing: no jump is looked for there.
    bool jump = m_jumped >= kChipSamples;
    if (!m_control.tones().acting()) {
        m_watch.reset(m_process);  // what is usual is not known yet
    } else if (force_N > kExitShare * m_status.forceTarget_N &&
               m_watch.update(force_N, m_control.chip_um(), m_control.innovation_um())) {
        jump = true;
        ratio = m_status.gainRatio = m_watch.ratio();
    }
    events.set(turning_alarm::kToolChipped, jump,
               Sentence(KERF_TEXT("%1 times the force at the start of the cut."), SentenceArg(ratio, 2)));
    if (jump) {
        leave(Sentence(KERF_TEXT("The cutting force has jumped: the trim is zero, look at the tool.")),
              turning_alarm::kToolChipped);
    }
    return jump;
}

/// Mean-force check: whatever the law, the cut stays.
bool TurningLoop::losesTheCut(EventSink& events) noexcept {
    m_trimMean_um += kTrimMeanShare * (m_status.appliedTrim_um - m_trimMean_um);
    const bool leaning = std::abs(m_trimMean_um) > kTrimMeanMost_um;
    const bool gone = m_reference_N > 0.0 && m_status.gainRatio < kGoneRatio;
    events.set(
        turning_alarm::kMeanForceOff, leaning || gone,
        gone ? Sentence(KERF_TEXT("%1 times the force at the start of the cut."), SentenceArg(m_status.gainRatio, 2))
             : Sentence(KERF_TEXT("The mean of the trim is %1 um."), SentenceArg(m_trimMean_um, 2)));
    if (gone) {
        leave(Sentence(KERF_TEXT("The mean force has fallen: no trim in this part.")), 0);
    } else if (leaning) {
        leave(Sentence(KERF_TEXT("The trim leans to one side: no trim in this part.")), 0);
    }
    return gone || leaning;
}

void TurningLoop::showTones(EventSink& events) noexcept {
    const turning::ToneCanceller& law = m_control.tones();
    const turning::ToneTracker& tracker = law.tracker();
    m_status.toneCount = 0;
    bool blind = false;
    for (std::size_t j = 0; j < tracker.count() && law.acting(); ++j) {
        const turning::Tone& tone = tracker.tone(j);
        TurningTone& shown = m_status.tones[m_status.toneCount++];
        shown.frequency_Hz = tone.frequency_Hz(turning::kSampleRate_Hz);
        shown.amplitude_um = tone.amplitude_um();
        shown.visibility = turning::visibility(shown.frequency_Hz, m_motion.samples(), turning::kSampleRate_Hz);
        shown.blind = shown.visibility < turning::kBlindBelow;
        const double variance_um2 = tracker.amplitudeVariance_um2(j);
        shown.share = variance_um2 / (variance_um2 + tracker.noise_um2());
        blind = blind || shown.blind;
    }
    if (blind) {  // once a part: a tone that comes and goes in the tracker is no news
        events.set(turning_alarm::kBlindTone, true);
    }
    m_status.toneShare = law.toneShare();
    m_status.plainWeights = law.plain().weights();
    m_status.underToneWeights = law.underTones().weights();
}

Sentence TurningLoop::cuttingReason() const noexcept {
    const bool advises = m_mode == LoopMode::Advise;
    switch (m_controller) {
        case TurningController::Open:
            return Sentence(KERF_TEXT("Open: the disturbance is watched, the tool is not trimmed."));
        case TurningController::Paper:
        case TurningController::Pi:
            return Sentence(advises ? KERF_TEXT("The trim would follow the depth error.")
                                    : KERF_TEXT("The trim follows the depth error."));
        case TurningController::Tones:
            break;
    }
    if (m_status.acting && (m_status.toneCount == 0 || m_status.toneShare < 0.5)) {
        return Sentence(advises ? KERF_TEXT("The trim would follow what can be foreseen of the disturbance.")
                                : KERF_TEXT("The trim follows what can be foreseen of the disturbance."));
    }
    return m_status.acting ? Sentence(advises ? KERF_TEXT("The trim would cancel %1 tones of the disturbance.")
                                              : KERF_TEXT("The trim cancels %1 tones of the disturbance."),
                                      SentenceArg(static_cast<double>(m_status.toneCount), 0))
                           : Sentence(KERF_TEXT("Listening to the disturbance: no trim yet."));
}

void TurningLoop::leave(const Sentence& reason, AlarmCode cause) noexcept {
    m_status.stage = TurningStage::Out;
    m_status.acting = false;
    m_outReason = reason;
    m_outFaulted = cause != 0;
    m_outCause = cause;
    m_part.turning.leftLoop = true;
}

void TurningLoop::watchSurface(double force_N) noexcept {
    turning::SurfaceSample sample;
    sample.error_um = m_control.error_um();
    sample.untreated_um = m_control.untreated_um();
    sample.force_N = force_N;
    sample.progress = m_status.progress;
    sample.counts = m_cutSamples > kReferenceAfter && m_below == 0;
    m_surface.take(sample);
    m_surface.show(m_status);
    if (sample.counts) {
        m_trace.surface(sample.error_um, sample.untreated_um, m_status.acting && m_mode == LoopMode::Control);
    }
}

void TurningLoop::noteForce(double force_N) noexcept {
    m_forceLow_N = m_forceTaken ? force_N : std::min(m_forceLow_N, force_N);
    m_forceHigh_N = m_forceTaken ? force_N : std::max(m_forceHigh_N, force_N);
    m_forceTaken = false;
}

}  // namespace kerf
