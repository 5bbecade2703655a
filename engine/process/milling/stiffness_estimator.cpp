// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/stiffness_estimator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/process/milling/plant.h"

namespace kerf::milling {
namespace {
constexpr double kFirstDeviation = 0.5;             // of g after the first revolution
constexpr double kFirstSlopeDeviation = 0.1;        // of v
constexpr double kModelNoise_N2 = 1.0;              // variance of what the plant leaves out
constexpr double kSmallestFeed_mm = 1e-6;           // keeps l^(m−1) finite
constexpr double kLeastLogWeight = -12.0;           // no filter is ever ruled out for good
constexpr double kSteepest = 0.5;                   // |v| per revolution: a sharp step, cut into in two
constexpr double kSoftest = -5.0, kHardest = 15.0;  // g of anything a tool survives
constexpr double kCalm = 2.0;                       // squared surprise in standard deviations that counts as noise
constexpr double k95 = 1.96;
}  // namespace

StiffnessFilter::StiffnessFilter(const StiffnessAssumptions& assumptions, double kx_NPerMm) noexcept
    : m_assume(assumptions),
      m_kx_NPerMm(kx_NPerMm),
      m_sin(std::sin(assumptions.forceAngle_deg * std::numbers::pi / 180.0)),
      m_cos(std::cos(assumptions.forceAngle_deg * std::numbers::pi / 180.0)) {}

void StiffnessFilter::begin(double force_N, double feed_mmPerRev) noexcept {
    const double deflection_mm = force_N * m_cos / (m_sin * m_kx_NPerMm);
    const double cut_mm = std::max({feed_mmPerRev - deflection_mm, 0.3 * feed_mmPerRev, kSmallestFeed_mm});
    m_state = {force_N, std::log(force_N / m_sin) - m_assume.exponent * std::log(cut_mm), 0.0, force_N};
    const double noise_N2 = m_assume.forceNoise_N * m_assume.forceNoise_N;
    m_covariance = Eigen::Vector4d(noise_N2, kFirstDeviation * kFirstDeviation,
                                   kFirstSlopeDeviation * kFirstSlopeDeviation, noise_N2)
                       .asDiagonal();
}

void StiffnessFilter::predict(double feed_mmPerRev, double knownChange) noexcept {
    const double m = m_assume.exponent;
    const double perNewton_mm = m_cos / (m_sin * m_kx_NPerMm);  // δ_x per newton of F_y
    const double g = m_state[1] + m_state[2] + knownChange;
    const double compliance = std::exp(g) * m_cos / m_kx_NPerMm;
    const double cut_mm =
        std::max(solveCutFeed_mmPerRev(compliance, feed_mmPerRev + perNewton_mm * m_state[0], m), kSmallestFeed_mm);
    const double force_N = std::exp(g) * std::pow(cut_mm, m) * m_sin;
    // l + K l^m = s: dl/ds = 1/D, and a change of g moves F_y by F_y/D, with D = 1 + m K l^(m−1).
    const double damping = 1.0 + m * compliance * std::pow(cut_mm, m - 1.0);
    const double perForce = m * force_N / cut_mm / damping * perNewton_mm;
    const double perG_N = force_N / damping;
    Eigen::Matrix4d transition;
    transition << perForce, perG_N, perG_N, 0.0,  //
        0.0, 1.0, 1.0, 0.0,                       //
        0.0, 0.0, m_assume.slopeMemory, 0.0,      //
        1.0, 0.0, 0.0, 0.0;
    m_covariance = (transition * m_covariance * transition.transpose()).eval();
    const double walk = m_assume.walk * m_assume.walk;  // of g, felt by F_y in the same revolution
    m_covariance(0, 0) += perG_N * perG_N * walk + kModelNoise_N2;
    m_covariance(0, 1) += perG_N * walk;
    m_covariance(1, 0) += perG_N * walk;
    m_covariance(1, 1) += walk;
    m_covariance(2, 2) += m_assume.slopeWalk * m_assume.slopeWalk;
    m_state = {force_N, g, m_assume.slopeMemory * m_state[2], m_state[0]};
}

double StiffnessFilter::correct(double force_N) noexcept {
    const double w = m_assume.meanShare;
    const Eigen::Vector4d cross = (1.0 - w) * m_covariance.col(0) + w * m_covariance.col(3);
    const double spread_N2 = (1.0 - w) * cross[0] + w * cross[3] + m_assume.forceNoise_N * m_assume.forceNoise_N;
    const double surprise_N = force_N - ((1.0 - w) * m_state[0] + w * m_state[3]);
    const Eigen::Vector4d gain = cross / spread_N2;
    m_state += gain * surprise_N;
    m_covariance -= gain * cross.transpose();
    m_state[0] = std::max(m_state[0], 0.0);
    m_state[1] = std::clamp(m_state[1], kSoftest, kHardest);
    m_state[2] = std::clamp(m_state[2], -kSteepest, kSteepest);
    // What every filter explains says nothing about k_x: counted, small systematic errors would add up in a calm cut.
    return -0.5 * std::max(0.0, surprise_N * surprise_N / spread_N2 - kCalm);
}

void StiffnessFilter::adopt(const StiffnessFilter& other) noexcept {
    m_state = other.m_state;
    m_covariance = other.m_covariance;
}

StiffnessEstimator::StiffnessEstimator(const Params& params) noexcept : m_params(params) {
    for (std::size_t i = 0; i < kFilters; ++i) {
        m_lnKx[i] = std::log(params.softest_NPerMm) + static_cast<double>(i) * std::log(params.ratio);
        m_filters[i] = StiffnessFilter(params.assume, std::exp(m_lnKx[i]));
        const double off = (m_lnKx[i] - std::log(params.likely_NPerMm)) / params.likelyWidth;
        m_logWeight[i] = -0.5 * off * off;
    }
    combine();
    m_estimate.valid = false;
}

bool StiffnessEstimator::setKxLogWeights(const std::array<double, kFilters>& weights) noexcept {
    if (!std::ranges::all_of(weights, [](double weight) { return weight <= 0.0 && weight >= kLeastLogWeight; })) {
        return false;
    }
    m_logWeight = weights;
    combine();
    m_estimate.valid = false;
    return true;
}

void StiffnessEstimator::leaveWork() noexcept {
    m_estimate.valid = false;
}

void StiffnessEstimator::update(double force_N, double feed_mmPerRev, double knownChange) noexcept {
    if (!m_estimate.valid) {
        if (force_N < m_params.airForce_N || feed_mmPerRev <= 0.0) {
            return;
        }
        for (StiffnessFilter& filter : m_filters) {
            filter.begin(force_N, feed_mmPerRev);
        }
    } else {
        for (std::size_t i = 0; i < kFilters; ++i) {
            m_filters[i].predict(feed_mmPerRev, knownChange);
            m_logWeight[i] += m_filters[i].correct(force_N);
        }
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
    combine();
}

void StiffnessEstimator::shift(double change) noexcept {
    for (StiffnessFilter& filter : m_filters) {
        filter.shift(change);
    }
    m_estimate.lnCb += change;
}

void StiffnessEstimator::coast(double feed_mmPerRev) noexcept {
    if (m_estimate.valid) {
        for (StiffnessFilter& filter : m_filters) {
            filter.predict(feed_mmPerRev, 0.0);
        }
        combine();
    }
}

void StiffnessEstimator::combine() noexcept {
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
    }
    mixed.lnCb /= total;
    mixed.slope /= total;
    mixed.force_N /= total;
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
