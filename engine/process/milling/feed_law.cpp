// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/feed_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::milling {

double PiLaw::update(double error_N, double revolution_s, const FeedRange& range) noexcept {
    const double alpha = (m_params.kp_mmPerSPerN - m_params.ki_mmPerSPerN) / m_params.kp_mmPerSPerN;
    const double k0_mmPerSPerN = m_params.kp_mmPerSPerN * (m_params.nominalRevolution_s / revolution_s);
    m_feed_mmPerS += k0_mmPerSPerN * (error_N - alpha * m_lastError_N);
    m_feed_mmPerS = std::clamp(m_feed_mmPerS, range.min_mmPerS, range.max_mmPerS);
    m_lastError_N = error_N;
    return m_feed_mmPerS;
}

Inversion invert(const InversionModel& model, double lnCb, double force_N, double reference_N) noexcept {
    const double theta = model.forceAngle_deg * std::numbers::pi / 180.0;
    const double perNewton_mm = std::cos(theta) / (std::sin(theta) * model.kx_NPerMm);  // δ_x per newton of F_y
    Inversion plan;
    plan.steady_mmPerRev = std::exp((std::log(reference_N / std::sin(theta)) - lnCb) / model.exponent);
    plan.deadbeat_mmPerRev = plan.steady_mmPerRev + (reference_N - force_N) * perNewton_mm;
    return plan;
}

double forcePerFeed_NPerMm(const InversionModel& model, double reference_N, double feed_mmPerRev) noexcept {
    constexpr double kSmallestFeed_mm = 1e-4;
    const double tangent_NPerMm = model.exponent * reference_N / std::max(feed_mmPerRev, kSmallestFeed_mm);
    const double cot = 1.0 / std::tan(model.forceAngle_deg * std::numbers::pi / 180.0);
    return 1.0 / (1.0 / tangent_NPerMm + cot / model.kx_NPerMm);
}

double modelFeed_mmPerRev(const ModelLawParams& params, const InversionModel& model, const StiffnessEstimate& estimate,
                          double knownChange, double reference_N, int revolutionsInWork) noexcept {
    constexpr double k95 = 1.96;
    const auto by = [&](double noisy, double quiet) { return noisy + estimate.quiet * (quiet - noisy); };
    const bool entry = revolutionsInWork < params.entryRevolutions;
    double lead = estimate.slope > 0.0 ? by(params.leadHarderNoisy, params.leadHarder)
                                       : by(params.leadEasierNoisy, params.leadEasier);
    lead *= std::pow(by(params.aheadLeadNoisy, params.aheadLead), estimate.ahead);
    lead += entry ? params.entryLead : 0.0;
    const double doubt = params.caution * std::max(0.0, estimate.half95 / k95 - params.sure);
    const Inversion plan =
        invert(model, estimate.lnCb + lead * estimate.slope + doubt + knownChange, estimate.force_N, reference_N);
    double share =
        plan.deadbeat_mmPerRev > plan.steady_mmPerRev ? by(params.recoverNoisy, params.recover) : params.backOff;
    share *= entry ? params.entryShare : 1.0;
    share *= std::pow(by(params.aheadShareNoisy, params.aheadShare), estimate.ahead);
    return plan.steady_mmPerRev + share * (plan.deadbeat_mmPerRev - plan.steady_mmPerRev);
}

ModelLawParams::Feedback feedbackAt(const ModelLawParams& params, double noiseShare, int revolutionsInWork) noexcept {
    constexpr double kNoisy = 0.04, kVeryNoisy = 0.125;  // of the reference
    const double way =
        std::clamp(std::log(std::max(noiseShare, kNoisy) / kNoisy) / std::log(kVeryNoisy / kNoisy), 0.0, 1.0);
    const auto between = [way](double noisy, double veryNoisy) { return noisy + way * (veryNoisy - noisy); };
    ModelLawParams::Feedback gains{between(params.noisy.modelShare, params.veryNoisy.modelShare),
                                   between(params.noisy.proportional, params.veryNoisy.proportional),
                                   between(params.noisy.integral, params.veryNoisy.integral)};
    if (revolutionsInWork < params.settledFrom) {  // or the sum of the entry's errors would overshoot
        gains.proportional = params.entryProportional;
        gains.integral = params.entryIntegral;
    }
    return gains;
}

double feedbackFeed_mmPerRev(const ModelLawParams::Feedback& gains, double b0_NPerMm, double lastFeed_mmPerRev,
                             double error_N, double lastError_N) noexcept {
    return lastFeed_mmPerRev +
           (gains.proportional * (error_N - lastError_N) + gains.integral * lastError_N) / b0_NPerMm;
}

}  // namespace kerf::milling
