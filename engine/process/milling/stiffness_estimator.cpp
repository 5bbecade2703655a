// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/stiffness_estimator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/process/milling/plant.h"

namespace kerf::milling {
namespace {
constexpr double kLeastLogWeight = -12.0;       // no filter is ever ruled out for good
constexpr double kLeastBefore = -6.0;           // … and one surprise may find the least likely
constexpr double kLeastLogLikelihood = -500.0;  // keeps its exponential above 0
constexpr double k95 = 1.96;

constexpr double kAheadMemory = 0.8, kAheadMemoryNoisy = 0.95;  // of the slope in a revolution not yet measured
constexpr double kSolved = 1e-6;                                // relative, of l
constexpr double kSmallestFeed_mm = 1e-6;                       // keeps l^(m−1) finite

StiffnessEstimator::Noise known(double noise_N) {
    return {noise_N, {noise_N * noise_N, noise_N * noise_N}};
}
}  // namespace

constexpr StiffnessEstimator::Quiet StiffnessEstimator::kLawQuiet{0.022, 7.0};
constexpr StiffnessEstimator::Quiet StiffnessEstimator::kFilterQuiet{0.028, 6.0};

double StiffnessEstimator::lnKxOf(std::size_t filter, const Params& params) noexcept {
    constexpr std::size_t kFine = kFilters - kStiff;
    const auto fine = static_cast<double>(std::min(filter, kFine - 1));
    const double stiff = static_cast<double>(filter) - fine;
    const double stiffRatio = params.ratio > 1.0 ? params.stiffRatio : 1.0;
    return std::log(params.softest_NPerMm) + fine * std::log(params.ratio) + stiff * std::log(stiffRatio);
}

StiffnessEstimator::StiffnessEstimator(const Params& params) noexcept : m_params(params) {
    for (std::size_t i = 0; i < kFilters; ++i) {
        m_lnKx[i] = lnKxOf(i, params);
        m_filters[i] = StiffnessFilter(params.assume, std::exp(m_lnKx[i]));
        const double off = (m_lnKx[i] - std::log(params.likely_NPerMm)) / params.likelyWidth;
        m_logWeight[i] = std::max(-0.5 * off * off, kLeastBefore);
    }
    combine(known(params.assume.forceNoise_N));
    m_estimate.valid = false;
}

bool StiffnessEstimator::setKxLogWeights(const std::array<double, kFilters>& weights) noexcept {
    if (!std::ranges::all_of(weights, [](double weight) { return weight <= 0.0 && weight >= kLeastLogWeight; })) {
        return false;
    }
    m_logWeight = weights;
    combine(known(m_estimate.noise_N));
    m_estimate.valid = false;
    return true;
}

void StiffnessEstimator::leaveWork() noexcept {
    m_estimate.valid = false;
}

void StiffnessEstimator::begin(double force_N, double feed_mmPerRev, double noise_N2) noexcept {
    for (StiffnessFilter& filter : m_filters) {
        filter.begin(force_N, feed_mmPerRev, noise_N2);
    }
}

void StiffnessEstimator::update(double force_N, double feed_mmPerRev, double knownChange, const Noise& noise) noexcept {
    if (m_estimate.valid) {
        weigh(force_N, feed_mmPerRev, knownChange, noise);
    } else if (feed_mmPerRev > 0.0) {
        begin(force_N, feed_mmPerRev, noise.now.variance_N2);
    } else {
        return;
    }
    combine(noise);
}

void StiffnessEstimator::weigh(double force_N, double feed_mmPerRev, double knownChange, const Noise& noise) noexcept {
    const double quietness = filterQuiet(noise.before_N);
    std::array<StiffnessFilter::Fit, kFilters> fit{};
    bool surprised = false;
    double total = 0.0;
    double likelihood = 0.0;
    for (std::size_t i = 0; i < kFilters; ++i) {
        const double weight = std::exp(m_logWeight[i]);
        m_filters[i].predict(feed_mmPerRev, knownChange, quietness);
        fit[i] = m_filters[i].correct(force_N, noise.now);
        surprised = surprised || fit[i].surprise < 0.0;
        total += weight;
        likelihood += weight * std::exp(std::max(m_filters[i].logLikelihood(), kLeastLogLikelihood));
    }
    // To a stiff tool every change of depth is a large force at once, so its filter expects nearly anything: it
    // pays for that when others, surer ones, are surprised.
    const double sure_N2 = fit[kFilters - kStiff - 1].spread_N2;
    for (std::size_t i = 0; i < kFilters; ++i) {
        const bool pays = surprised && i >= kFilters - kStiff;
        m_logWeight[i] += fit[i].surprise - (pays ? std::log(fit[i].spread_N2 / sure_N2) : 0.0);
    }
    m_logLikelihood = std::log(likelihood / total);
    const auto best = static_cast<std::size_t>(std::ranges::max_element(m_logWeight) - m_logWeight.begin());
    const double highest = m_logWeight[best];
    for (std::size_t i = 0; i < kFilters; ++i) {
        m_logWeight[i] -= highest;
        if (!(m_logWeight[i] > kLeastLogWeight)) {  // so written, a weight that is no number counts as least
            m_logWeight[i] = kLeastLogWeight;
            m_filters[i].adopt(m_filters[best]);
        }
    }
}

double StiffnessEstimator::quiet(const Quiet& quiet, double noise_N) const noexcept {
    return 1.0 / (1.0 + std::pow(noise_N / (quiet.share * m_params.reference_N), quiet.power));
}

double StiffnessEstimator::filterQuiet(double noise_N) const noexcept {
    return quiet(kFilterQuiet, noise_N);
}

void StiffnessEstimator::setReference(double reference_N, const Noise& noise) noexcept {
    m_params.reference_N = reference_N;
    m_estimate.noise_N = std::sqrt(noise.now.variance_N2);
    m_estimate.quiet = quiet(kLawQuiet, std::sqrt(noise.now.variance_N2));
}

void StiffnessEstimator::shift(double change) noexcept {
    for (StiffnessFilter& filter : m_filters) {
        filter.shift(change);
    }
    m_estimate.lnCb += change;
}

StiffnessEstimate StiffnessEstimator::after(std::span<const double> feeds_mmPerRev) const noexcept {
    StiffnessEstimate ahead = m_estimate;
    if (!ahead.valid) {
        return ahead;
    }
    const double m = m_params.assume.exponent;
    const double theta = m_params.assume.forceAngle_deg * std::numbers::pi / 180.0;
    const double memory = kAheadMemoryNoisy + ahead.quiet * (kAheadMemory - kAheadMemoryNoisy);
    for (const double feed_mmPerRev : feeds_mmPerRev) {
        ahead.lnCb += ahead.slope;
        ahead.slope *= memory * ahead.slopeMemory;
        ++ahead.ahead;
        const double deflection_mm = ahead.force_N / std::tan(theta) / ahead.kx_NPerMm;
        const double cut_mm = std::max(solveCutFeed_mmPerRev(std::exp(ahead.lnCb) * std::cos(theta) / ahead.kx_NPerMm,
                                                             feed_mmPerRev + deflection_mm, m, kSolved),
                                       kSmallestFeed_mm);
        ahead.force_N = std::exp(ahead.lnCb) * std::pow(cut_mm, m) * std::sin(theta);
    }
    return ahead;
}

void StiffnessEstimator::coast(double feed_mmPerRev, const Noise& noise) noexcept {
    if (m_estimate.valid) {
        for (StiffnessFilter& filter : m_filters) {
            filter.predict(feed_mmPerRev, 0.0, filterQuiet(noise.before_N));
        }
        combine(noise);
    }
}

void StiffnessEstimator::combine(const Noise& noise) noexcept {
    double total = 0.0;
    double lnKx = 0.0;
    StiffnessEstimate mixed;
    mixed.valid = true;
    for (std::size_t i = 0; i < kFilters; ++i) {
        const double weight = std::exp(m_logWeight[i]);
        total += weight;
        lnKx += weight * m_lnKx[i];
        mixed.lnCb += weight * m_filters[i].lnCb();
        mixed.slope += weight * m_filters[i].slope();
        mixed.force_N += weight * m_filters[i].force_N();
        mixed.stepping += weight * m_filters[i].stepping();
        mixed.slopeMemory += weight * m_filters[i].slopeMemory();
    }
    mixed.lnCb /= total;
    mixed.slope /= total;
    mixed.force_N /= total;
    mixed.stepping /= total;
    mixed.slopeMemory /= total;
    mixed.noise_N = std::sqrt(noise.now.variance_N2);
    mixed.quiet = quiet(kLawQuiet, std::sqrt(noise.now.variance_N2));
    mixed.kx_NPerMm = std::exp(lnKx / total);
    double variance = 0.0;  // within the filters and between them
    for (std::size_t i = 0; i < kFilters; ++i) {
        const double off = m_filters[i].lnCb() - mixed.lnCb;
        variance += std::exp(m_logWeight[i]) / total * (m_filters[i].variance() + off * off);
    }
    mixed.half95 = k95 * std::sqrt(std::max(variance, 0.0));
    m_estimate = mixed;
}

}  // namespace kerf::milling
