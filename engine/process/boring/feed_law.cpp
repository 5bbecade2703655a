// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/feed_law.h"

#include <algorithm>
#include <cmath>

namespace kerf::boring {
namespace {

constexpr double kPaperMinAlpha = 1e-3;
constexpr double kPaperMaxAlpha = 1e3;
constexpr double kTwoSided95 = 1.959963984540054;
constexpr double kRoomSpreads = 3.0;  // standard deviations that shall fit between the aim and the nearer limit

bool atLimit(const BoringSchedule& schedule, double overhang_mm) noexcept {
    const double wanted = schedule.unclampedFeed_mmPerRev(overhang_mm);
    return !(wanted >= schedule.minFeed_mmPerRev && wanted <= schedule.maxFeed_mmPerRev);
}

/// Standard deviation of ln d where the bore is known worse: at its top or at its bottom.
double spreadAlong(const Estimate& estimate, const BoringSchedule& schedule) noexcept {
    double widest = 0.0;
    for (const double overhang_mm : {schedule.overhangFrom_mm, schedule.overhangTo_mm}) {
        const Eigen::Vector3d x(1.0, std::log(schedule.feed_mmPerRev(overhang_mm)), std::log(overhang_mm));
        widest = std::max(widest, x.dot(matrixOf(estimate.covariance) * x));
    }
    return std::sqrt(widest);
}

}  // namespace

double aimedDeflection_mm(const FeedLawParams& params, double spreadLn) noexcept {
    if (!(params.allowedFrom_mm > 0.0 && params.allowedTo_mm > params.allowedFrom_mm)) {
        return params.targetDeflection_mm;
    }
    const double target = std::log(params.targetDeflection_mm);
    const double least = std::log(params.allowedFrom_mm);
    const double most = std::log(params.allowedTo_mm);
    const double middle = 0.5 * (least + most);
    const double room = kRoomSpreads * spreadLn;
    return std::exp(target > middle ? std::max(middle, std::min(target, most - room))
                                    : std::min(middle, std::max(target, least + room)));
}

FeedLawParams feedLawParams(EstimatorKind kind, double targetDeflection_mm, double firstFeed_mmPerRev) {
    FeedLawParams params;
    params.targetDeflection_mm = targetDeflection_mm;
    params.firstFeed_mmPerRev = firstFeed_mmPerRev;
    if (kind == EstimatorKind::Perturbation) {
        params.minAlpha = kPaperMinAlpha;
        params.maxAlpha = kPaperMaxAlpha;
        params.clipKeepsMeasured = false;
    }
    return params;
}

LawConstants clippedLaw(const Estimate& estimate, const FeedLawParams& params) noexcept {
    LawConstants law = estimate.law;
    law.alpha = std::clamp(law.alpha, params.minAlpha, params.maxAlpha);
    const double moved = law.alpha - estimate.law.alpha;
    const Eigen::Matrix3d p = matrixOf(estimate.covariance);
    if (moved != 0.0 && params.clipKeepsMeasured && p(1, 1) > 0.0) {
        law.lnC += moved * p(0, 1) / p(1, 1);
        law.beta += moved * p(1, 2) / p(1, 1);
    }
    return law;
}

FeedAdvice adviseFeed(const EstimatorState& state, const FeedLawParams& params) noexcept {
    return adviseFeed(estimateOf(state), params);
}

FeedAdvice adviseFeed(const Estimate& estimate, const FeedLawParams& params) noexcept {
    FeedAdvice advice;
    BoringSchedule& schedule = advice.schedule;
    schedule.targetDeflection_mm = params.targetDeflection_mm;
    schedule.minFeed_mmPerRev = params.minFeed_mmPerRev;
    schedule.maxFeed_mmPerRev = params.maxFeed_mmPerRev;
    schedule.overhangFrom_mm = params.overhangFrom_mm;
    schedule.overhangTo_mm = params.overhangTo_mm;
    schedule.spindleSpeed_rpm = params.spindleSpeed_rpm;
    if (!estimate.ready) {
        schedule.constantFeed_mmPerRev = params.firstFeed_mmPerRev;
        return advice;
    }
    const LawConstants law = clippedLaw(estimate, params);
    schedule.alpha = law.alpha;
    schedule.beta = law.beta;
    schedule.lnC = law.lnC;
    if (schedule.alpha != estimate.law.alpha) {
        advice.limited = true;
        advice.reason = Sentence(KERF_TEXT("The estimated exponent α = %1 is outside %2 to %3 and was clipped."),
                                 SentenceArg(estimate.law.alpha, 3), SentenceArg(params.minAlpha, 2),
                                 SentenceArg(params.maxAlpha, 2));
    }
    if (params.allowedTo_mm > 0.0) {
        schedule.targetDeflection_mm = aimedDeflection_mm(params, spreadAlong(estimate, schedule));
    }
    for (const double overhang_mm : {params.overhangFrom_mm, params.overhangTo_mm}) {
        if (atLimit(schedule, overhang_mm)) {
            advice.limited = true;
            advice.reason = Sentence(
                KERF_TEXT("The best feed at %1 mm overhang lies outside %2 to %3 mm/rev; it sits at the limit."),
                SentenceArg(overhang_mm, 0), SentenceArg(params.minFeed_mmPerRev, 3),
                SentenceArg(params.maxFeed_mmPerRev, 3));
        }
    }
    return advice;
}

double teachMiddle_mm(const FeedLawParams& params) noexcept {
    return 0.5 * (params.overhangFrom_mm + params.overhangTo_mm);
}

BoringSchedule teachSchedule(const FeedLawParams& params) noexcept {
    BoringSchedule schedule = adviseFeed(Estimate{}, params).schedule;
    const double high_mmPerRev = schedule.feed_mmPerRev(params.overhangFrom_mm);
    const double low_mmPerRev = std::max(high_mmPerRev / kTeachRatio, params.minFeed_mmPerRev);
    const double fallsAt_mm = 0.5 * (teachMiddle_mm(params) + params.overhangTo_mm);
    schedule.constantFeed_mmPerRev = 0.0;
    schedule.minFeed_mmPerRev = low_mmPerRev;
    schedule.maxFeed_mmPerRev = high_mmPerRev;
    schedule.alpha = 1.0;
    schedule.beta = kTeachSteepness;
    schedule.lnC = std::log(params.targetDeflection_mm) - 0.5 * std::log(high_mmPerRev * low_mmPerRev) -
                   kTeachSteepness * std::log(fallsAt_mm);
    return schedule;
}

Measurement measurementAt(const BoringSchedule& schedule, double overhang_mm, double deflection_mm) noexcept {
    return {overhang_mm, schedule.feed_mmPerRev(overhang_mm), deflection_mm, atLimit(schedule, overhang_mm)};
}

std::optional<DeflectionPrediction> predict(const EstimatorState& state, const EstimatorParams& params,
                                            double feed_mmPerRev, double overhang_mm) noexcept {
    const Estimate estimate = estimateOf(state);
    if (!estimate.ready) {
        return std::nullopt;
    }
    const Eigen::Vector3d x(1.0, std::log(feed_mmPerRev), std::log(overhang_mm));
    const double expected_mm = std::exp(x.dot(vectorOf(estimate.law)));
    double variance = std::max(0.0, x.dot(matrixOf(estimate.covariance) * x));  // of ln d
    if (params.kind == EstimatorKind::Kalman) {
        variance += params.kalman.quiet.level * params.kalman.quiet.level;
    }
    const double sigma_mm = params.sigma_mm();
    return DeflectionPrediction{expected_mm,
                                kTwoSided95 * std::sqrt(variance * expected_mm * expected_mm + sigma_mm * sigma_mm)};
}

GateAnswer judgeEntry(const EstimatorState& state, const EstimatorParams& params,
                      const Measurement& measurement) noexcept {
    if (!std::isfinite(measurement.deflection_mm)) {
        return {GateVerdict::Refuse, Sentence(KERF_TEXT("The entry is not a number."))};
    }
    if (measurement.deflection_mm <= 0.0) {
        return {GateVerdict::Refuse,
                Sentence(KERF_TEXT("The spindle cannot bend by %1 mm; its deflection must be above 0. Measure again."),
                         SentenceArg(measurement.deflection_mm, 4))};
    }
    const Estimate estimate = estimateOf(state);
    const LawConstants& law = estimate.ready ? estimate.law : params.kalman.prior;
    const double expected_mm = deflection_mm(law, measurement.feed_mmPerRev, measurement.overhang_mm);
    if (std::abs(std::log(measurement.deflection_mm / expected_mm)) > kGateLn) {
        return {
            GateVerdict::Ask,
            Sentence(KERF_TEXT("A deflection of %1 mm was expected, the entry means %2 mm. Measure again or confirm."),
                     SentenceArg(expected_mm, 4), SentenceArg(measurement.deflection_mm, 4))};
    }
    return {};
}

}  // namespace kerf::boring
