// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/noise_meter.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {
constexpr double kLowest_N = 1.5;
constexpr double kRatio = 2.0;
constexpr double kMemory = 0.997;            // of the weights per revolution
constexpr double kMostSaid = 6.0;            // log-likelihood by which one force may tell a level from the best
constexpr double kLeastLogWeight = -8.0;     // no level is ever ruled out for good
constexpr double kUnknownWidth = 0.697;      // of ln deviation before anything was measured
constexpr double kAirWidth = 0.5;            // when air has been measured
constexpr double kDifferenceShare = 0.6817;  // E[(F − F')²]/σ² of a noise cut off at 0
constexpr double kAirMemory = 0.98;
constexpr double kAirEnough = 8.0;  // revolutions in air from which their scatter says something
constexpr double kHighest = 2.3;    // standard deviations up to which the noise may well be
constexpr double kReach = 4.0;      // standard deviations air does not reach
}  // namespace

NoiseMeter::NoiseMeter(const StiffnessAssumptions& assumptions) noexcept
    : m_assume(assumptions), m_likelyLn_N(std::log(assumptions.forceNoise_N)), m_likelyWidth(kUnknownWidth) {
    m_noise.variance_N2 = assumptions.forceNoise_N * assumptions.forceNoise_N;
    m_noise.highest_N2 = m_noise.variance_N2;
}

void NoiseMeter::air(double force_N) noexcept {
    std::shift_right(m_air_N.begin(), m_air_N.end(), 1);
    m_air_N[0] = force_N;
    m_airKnown = std::min(m_airKnown + 1, kAirKept);
    if (m_airKnown < kAirKept) {
        return;
    }
    const double difference_N = m_air_N[kAirKept - 2] - m_air_N[kAirKept - 1];
    m_airSum_N2 = kAirMemory * m_airSum_N2 + difference_N * difference_N / kDifferenceShare;
    m_airCount = kAirMemory * m_airCount + 1.0;
    if (m_airCount > kAirEnough) {
        m_likelyLn_N = std::log(std::max(std::sqrt(m_airSum_N2 / m_airCount), kLowest_N));
        m_likelyWidth = kAirWidth;
        judge();
    }
}

void NoiseMeter::expect(double noise_N) noexcept {
    if (m_airCount <= kAirEnough) {
        m_likelyLn_N = std::log(noise_N);
        judge();
    }
}

double NoiseMeter::airReach_N() const noexcept {
    return m_airCount > kAirEnough ? kReach * std::sqrt(m_airSum_N2 / m_airCount) : 0.0;
}

void NoiseMeter::begin(double force_N, double feed_mmPerRev, double kx_NPerMm) noexcept {
    m_airKnown = 0;
    for (StiffnessFilter& filter : m_filters) {
        filter = StiffnessFilter(m_assume, kx_NPerMm);
        filter.begin(force_N, feed_mmPerRev, m_noise.variance_N2);
    }
}

void NoiseMeter::update(double force_N, double feed_mmPerRev, double knownChange, double kx_NPerMm,
                        double quiet) noexcept {
    double deviation_N = kLowest_N;
    double likeliest = -1e300;
    for (StiffnessFilter& filter : m_filters) {
        filter.setKx(kx_NPerMm);
        filter.predict(feed_mmPerRev, knownChange, quiet);
        const double variance_N2 = deviation_N * deviation_N;
        (void)filter.correct(force_N, {variance_N2, variance_N2});
        likeliest = std::max(likeliest, filter.logLikelihood());
        deviation_N *= kRatio;
    }
    double best = -1e300;
    for (std::size_t i = 0; i < kLevels; ++i) {
        m_logWeight[i] = kMemory * m_logWeight[i] + std::max(m_filters[i].logLikelihood() - likeliest, -kMostSaid);
        best = std::max(best, m_logWeight[i]);
    }
    for (double& weight : m_logWeight) {
        weight = std::max(weight - best, kLeastLogWeight);
    }
    judge();
}

void NoiseMeter::judge() noexcept {
    double total = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < kLevels; ++i) {
        const double ln_N = std::log(kLowest_N) + static_cast<double>(i) * std::log(kRatio);
        const double off = (ln_N - m_likelyLn_N) / m_likelyWidth;
        const double weight = std::exp(m_logWeight[i] - 0.5 * off * off);
        total += weight;
        sum += weight * ln_N;
        squares += weight * ln_N * ln_N;
    }
    const double mean = sum / total;
    const double deviation = std::sqrt(std::max(0.0, squares / total - mean * mean));
    m_noise.variance_N2 = std::exp(2.0 * mean);
    m_noise.highest_N2 = std::exp(2.0 * (mean + kHighest * deviation));
}

void NoiseMeter::shift(double change) noexcept {
    for (StiffnessFilter& filter : m_filters) {
        filter.shift(change);
    }
}

}  // namespace kerf::milling
