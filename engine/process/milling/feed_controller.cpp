// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/feed_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kerf::milling {
namespace {
constexpr double kThinnest_mm = 0.02;  // a depth the preview may take the logarithm of
constexpr double kTurning = 0.03;      // slope of ln(C b) per revolution that counts as a step
constexpr double kTurnMemory = 1.0 - 1.0 / 60.0;
constexpr int kEntry = 30;  // revolutions: what the estimate does then is no step of the blank
constexpr double kFewTurns = 2.5, kManyTurns = 5.0;
constexpr double kFewTurnsTrim = 1.0, kManyTurnsTrim = 3.0;
constexpr double kSteppingTrim = 2.0;  // a step half likely stops the trim
constexpr double kFewTurnsLate = 1.5, kManyTurnsLate = 3.0;
constexpr double kMostBelow = 0.04;
constexpr int kTrimFrom = 50;  // revolutions in the work from which the aim is trimmed
constexpr int kAimEarly = 60;  // revolutions in which the aim is taken, before the wall that is judged
constexpr double kAimFast_rev = 20.0, kAimSlow_rev = 200.0;
constexpr double kUnknownNoise = 0.0253;  // of the reference: of a force about which nothing was learnt yet
constexpr int kDoubted = 50;              // revolutions in the work in which the lateness may be in doubt
constexpr double kDoubt = 2.0;            // log-likelihood by which another lateness explains the forces better
constexpr double kNearly = 0.5;           // of the aim
constexpr double kAbove = 1.02;           // of the reference: from here on a change of law does not feed faster

StiffnessEstimator::Params stiffnessParams(const FeedController::Params& params) {
    StiffnessEstimator::Params stiffness = params.stiffness;
    stiffness.reference_N = params.reference_N;
    stiffness.assume.forceNoise_N = kUnknownNoise * params.reference_N;
    return stiffness;
}
}  // namespace

FeedController::FeedController(const Params& params, LawKind law) noexcept
    : m_params(params), m_law(law), m_estimator(stiffnessParams(params)), m_pi(params.pi) {}

void FeedController::select(LawKind law) noexcept {
    m_changed = m_changed || law != m_law;
    m_law = law;
}

void FeedController::setReference(double reference_N) noexcept {
    m_params.reference_N = reference_N;
    m_estimator.setReference(reference_N, stiffnessParams(m_params).assume.forceNoise_N);
}

void FeedController::follow(double feed_mmPerS) noexcept {
    m_axis.forget();
    m_feed_mmPerS = feed_mmPerS;
    m_changed = true;
}

void FeedController::resumeAfterPause() noexcept {
    m_estimator.leaveWork();
    m_revolutionsInWork = 0;
    follow(std::min(m_feed_mmPerS, m_params.entryFeed_mmPerS));
}

void FeedController::setPeriod(int revolutions) noexcept {
    if (revolutions != m_period) {
        m_estimator.setPeriod(-m_params.stiffness.assume.exponent *
                              std::log(static_cast<double>(revolutions) / m_period));
        m_axis.reset();
        m_period = revolutions;
    }
}

void FeedController::beginCut() noexcept {
    m_estimator.leaveWork();
    m_pi.resume(0.0, 0.0);
    m_feed_mmPerS = 0.0;
    m_blend_mmPerS = 0.0;
    m_changed = false;
    m_revolutionsInWork = 0;
    m_below = 0.0;
    m_trim_N = 0.0;
    m_turns = 0.0;
    m_slopeSign = 0;
}

void FeedController::newTool() noexcept {
    m_estimator.newTool(stiffnessParams(m_params));
}

double FeedController::lnDepthAt(double position_mm) const noexcept {
    // The cut is at the tool's tip, which its deflection holds back behind the axis.
    const double theta = m_params.stiffness.assume.forceAngle_deg * std::numbers::pi / 180.0;
    const StiffnessEstimate& now = m_estimator.estimate();
    const double behind_mm = now.valid ? now.force_N * std::cos(theta) / (std::sin(theta) * now.kx_NPerMm) : 0.0;
    return std::log(std::max(m_blank.engagedDepth_mm(position_mm - behind_mm, m_params.toolRadius_mm), kThinnest_mm));
}

void FeedController::estimate(const RevolutionInput& input) noexcept {
    if (!input.force_N) {
        m_estimator.coast(input.feed_mmPerRev);
    } else if (*input.force_N < m_estimator.airForce_N()) {
        m_estimator.air(*input.force_N, input.feed_mmPerRev);
        m_revolutionsInWork = 0;
    } else {
        m_estimator.update(*input.force_N, input.feed_mmPerRev, knownChange(),
                           m_law == LawKind::Model || m_law == LawKind::Preview);
        ++m_revolutionsInWork;
    }
    if (m_blank.size() > 0) {
        const double lnDepth = lnDepthAt(input.position_mm);
        m_lnDepthBefore = m_depthKnown ? m_lnDepthNow : lnDepth;
        m_lnDepthNow = lnDepth;
        m_depthKnown = true;
    }
}

double FeedController::knownChange() const noexcept {
    return m_law == LawKind::Preview && m_blank.size() > 0 ? m_lnDepthNow - m_lnDepthBefore : 0.0;
}

void FeedController::takeAim() noexcept {
    const double turning = std::clamp((m_turns - kFewTurnsLate) / (kManyTurnsLate - kFewTurnsLate), 0.0, 1.0);
    const auto late_periods = static_cast<double>(late());
    const ModelLawParams& model = m_params.model;
    const double noisy = 1.0 - m_estimator.estimate().quiet;
    const double below =
        std::min(model.below + model.belowNoisy * noisy + model.belowLate * late_periods * turning, kMostBelow);
    m_below += (below - m_below) / (m_revolutionsInWork < kAimEarly ? kAimFast_rev : kAimSlow_rev);
}

void FeedController::trimAim(const RevolutionInput& input) noexcept {
    const ModelLawParams& model = m_params.model;
    if (m_revolutionsInWork <= kTrimFrom || input.overridden || input.advised) {
        return;
    }
    const StiffnessEstimate& now = m_estimator.estimate();
    const double turning = std::clamp((m_turns - kFewTurnsTrim) / (kManyTurnsTrim - kFewTurnsTrim), 0.0, 1.0);
    const double trust = (1.0 - turning) * std::max(0.0, 1.0 - kSteppingTrim * now.stepping) * now.quiet * now.quiet;
    const double clip_N = model.trimClip * m_params.reference_N;
    const double most_N = model.trimMost * m_params.reference_N;
    m_trim_N += trust * model.trimGain * std::clamp(aim_N() - *input.force_N, -clip_N, clip_N);
    m_trim_N = (1.0 - model.trimLeak) * std::clamp(m_trim_N, -most_N, most_N);
}

void FeedController::watchTurns() noexcept {
    const double slope = m_estimator.estimate().slope;
    m_turns *= kTurnMemory;
    const int sign = slope > 0.0 ? 1 : -1;
    if (m_revolutionsInWork > kEntry && std::abs(slope) > kTurning && sign != m_slopeSign) {
        m_slopeSign = sign;
        m_turns += 1.0;
    }
}

double FeedController::modelShare(const RevolutionInput& input, double noisyShare) const noexcept {
    if (input.overridden || input.advised) {  // feedback from a feed that somebody else made would wind up
        return 1.0;
    }
    const ModelLawParams& model = m_params.model;
    const double share = 1.0 - (1.0 - m_estimator.estimate().quiet) * (1.0 - noisyShare);
    const double turning = std::clamp((m_turns - kFewTurns) / (kManyTurns - kFewTurns), 0.0, 1.0);
    const double most = late() > 0 ? model.shareTurningLate : model.shareTurning;
    return share + turning * (std::min(share, most) - share);
}

double FeedController::mostDoubted_mm(const RevolutionInput& input, double error_N) const noexcept {
    if (m_revolutionsInWork >= kDoubted || m_estimator.lead() > -kDoubt || *input.force_N <= kNearly * aim_N()) {
        return std::numeric_limits<double>::max();
    }
    const PiLaw::Params& pi = m_params.pi;
    const double rise_mm =
        pi.nominalRevolution_s * (pi.kp_mmPerSPerN * (error_N - m_lastError_N) + pi.ki_mmPerSPerN * m_lastError_N);
    return m_feed_mmPerS * input.revolution_s + std::max(0.0, rise_mm);
}

double FeedController::lawFeed_mmPerS(const RevolutionInput& input, double knownChange) noexcept {
    switch (m_law) {
        case LawKind::Constant:
            return m_params.programmedFeed_mmPerS;
        case LawKind::Pi:
            if (input.overridden && *input.force_N < m_params.reference_N) {  // more feed would not arrive
                m_pi.resume(m_feed_mmPerS, m_params.reference_N - *input.force_N);
                return m_feed_mmPerS;
            }
            return m_pi.update(m_params.reference_N - *input.force_N, input.revolution_s, m_params.range);
        case LawKind::Model:
        case LawKind::Preview:
            break;
    }
    const InversionModel model{m_params.stiffness.assume.exponent, m_params.stiffness.assume.forceAngle_deg,
                               m_estimator.estimate().kx_NPerMm};
    takeAim();
    trimAim(input);
    const double wanted_mm =
        modelFeed_mmPerRev(m_params.model, model, m_estimator.after(m_axis.pending_mm()),
                           knownChange + m_estimator.pendingChange(), aim_N() + m_trim_N, m_revolutionsInWork);
    const double error_N = aim_N() - *input.force_N;
    const double b0_NPerMm = forcePerFeed_NPerMm(model, aim_N(), input.feed_mmPerRev);
    const ModelLawParams::Feedback gains =
        feedbackAt(m_params.model, m_estimator.estimate().noise_N / m_params.reference_N, m_revolutionsInWork);
    const double feedback_mm = feedbackFeed_mmPerRev(gains, std::max(b0_NPerMm, m_params.model.leastB0_NPerMm),
                                                     m_feed_mmPerS * input.revolution_s, error_N, m_lastError_N);
    if (input.overridden && error_N > 0.0) {  // more feed would not arrive
        return invert(model, m_estimator.estimate().lnCb, *input.force_N, m_params.reference_N).steady_mmPerRev /
               input.revolution_s;
    }
    watchTurns();
    const double share = modelShare(input, gains.modelShare);
    const double feed_mm = share * m_axis.toMake_mm(wanted_mm) + (1.0 - share) * feedback_mm;
    return std::min(feed_mm, mostDoubted_mm(input, error_N)) / input.revolution_s;
}

FeedDecision FeedController::update(const RevolutionInput& input) noexcept {
    if (!input.force_N || input.overridden || input.advised) {
        m_axis.forget();
    }
    m_axis.measured(input.feed_mmPerRev);
    const FeedDecision decision = decide(input);
    m_lastError_N = aim_N() - input.force_N.value_or(aim_N());
    m_axis.decided(decision.feed_mmPerS * input.revolution_s);
    return decision;
}

FeedDecision FeedController::decide(const RevolutionInput& input) noexcept {
    FeedDecision decision;
    estimate(input);
    const FeedRange& range = m_params.range;
    if (m_changed && m_law == LawKind::Pi && input.force_N) {
        m_pi.resume(m_feed_mmPerS, m_params.reference_N - *input.force_N);
    }
    if (!input.force_N) {
        decision.blind = true;
        m_feed_mmPerS = std::min(m_feed_mmPerS, m_params.programmedFeed_mmPerS);
        m_changed = true;  // come back bumpless from the feed the blind loop held
        decision.feed_mmPerS = m_feed_mmPerS;
        return decision;
    }
    decision.inAir = !m_estimator.estimate().valid;
    const bool model = m_law == LawKind::Model || m_law == LawKind::Preview;
    if (decision.inAir && (model || (m_law == LawKind::Pi && m_params.entryGuard))) {
        m_blend_mmPerS = 0.0;
        m_changed = false;
        m_feed_mmPerS = std::clamp(m_params.entryFeed_mmPerS, range.min_mmPerS, range.max_mmPerS);
        m_pi.resume(m_feed_mmPerS, m_params.reference_N - *input.force_N);
        decision.feed_mmPerS = m_feed_mmPerS;
        return decision;
    }
    const double wanted_mmPerS = lawFeed_mmPerS(input, knownChange());
    m_blend_mmPerS = m_changed ? m_feed_mmPerS - wanted_mmPerS : m_params.blendMemory * m_blend_mmPerS;
    m_changed = false;
    if (m_blend_mmPerS > 0.0 && *input.force_N > kAbove * m_params.reference_N) {
        m_blend_mmPerS = 0.0;
    }
    const double blended_mmPerS = wanted_mmPerS + m_blend_mmPerS;
    m_feed_mmPerS = std::clamp(blended_mmPerS, range.min_mmPerS, range.max_mmPerS);
    decision.feed_mmPerS = m_feed_mmPerS;
    decision.limited = m_feed_mmPerS != blended_mmPerS;
    decision.blend_mmPerS = m_blend_mmPerS;
    return decision;
}

}  // namespace kerf::milling
