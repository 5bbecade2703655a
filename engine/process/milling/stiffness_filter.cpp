// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/stiffness_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::milling {
namespace {

constexpr std::size_t kCalmWay = 0, kDriftWay = 1, kStepWay = 2;
constexpr double kFirstDeviation = 0.5;         // of g after the first revolution
constexpr double kFirstSlopeDeviation = 0.148;  // of v
constexpr std::array<double, StiffnessFilter::kWays> kFirstProbability{0.2, 0.2, 0.6};
constexpr double kModelNoise_N2 = 7.55;             // variance of what the plant leaves out
constexpr double kLeastForce_N = 1.0;               // from which l is looked for
constexpr double kSolved = 1e-3;                    // relative, of the last step towards l: what is left is its square
constexpr double kSmallestFeed_mm = 1e-6;           // keeps l^(m−1) finite
constexpr double kSoftest = -5.0, kHardest = 15.0;  // g of anything a tool survives
constexpr double kSurprising = 2.0;                 // squared surprise in standard deviations that counts as noise
constexpr double kMostSurprising = 21.0;            // one force says no more than this about k_x
constexpr double kLeastMixed = 0.00364;   // what is less likely does not widen the other ways: a calm filter stays calm
constexpr double kSurelyNoStep = 0.0169;  // probability below which a step does not enter the estimate
constexpr double kLeastProbability = 1e-9;

// The tool runs into a step, and out of it, within about its own height: v jumps by a share of the feed, and back to 0.
constexpr double kJump = 0.0122;             // of g itself: a step begins within a revolution
constexpr double kSlopeAfterStep = 0.00411;  // standard deviation of v where a step ends

/// A figure for a noisy force and for a quiet one.
struct Range {
    double noisy;
    double quiet;
    [[nodiscard]] double at(double share) const { return noisy + share * (quiet - noisy); }
};
constexpr Range kJumpPerFeed_perMm{0.0, 0.632};
constexpr Range kHighestJump{0.0, 0.146};  // standard deviation of v at most
constexpr Range kSteepest{0.5, 0.177};     // |v| per revolution
constexpr Range kSurelyStep{0.33, 0.196};  // probability from which a step alone makes the estimate

/// Probability per revolution to go from one way to another.
double change(std::size_t from, std::size_t to, double quiet) {
    const std::array<std::array<double, StiffnessFilter::kWays>, StiffnessFilter::kWays> off{{
        {0.0, 0.0213, Range{0.02, 0.0181}.at(quiet)},                           // from calm
        {0.178, 0.0, Range{0.009, 0.0117}.at(quiet)},                           // from drift
        {Range{0.0077, 0.0182}.at(quiet), Range{0.26, 0.0414}.at(quiet), 0.0},  // from step
    }};
    return from == to ? 1.0 - off[from][0] - off[from][1] - off[from][2] : off[from][to];
}

/// l and l^m with l + compliance l^m = supply, from an l^m not far away: solveCutFeed_mmPerRev() with one power per
/// step.
struct CutFeed {
    double feed_mmPerRev;  ///< l
    double power;          ///< l^m
};
CutFeed solveCutFeed(double compliance, double supply_mm, double exponent, double near) {
    if (supply_mm <= kSmallestFeed_mm) {
        return {kSmallestFeed_mm, std::pow(kSmallestFeed_mm, exponent)};
    }
    const double inverse = 1.0 / exponent;
    double power = std::min(near, supply_mm / compliance);
    double feed_mm = 0.0;
    for (int i = 0; i < 64; ++i) {  // convex: from the left it goes right of the root, and from there falls onto it
        feed_mm = std::pow(power, inverse);
        const double slope = inverse * feed_mm / power;
        const double step = (feed_mm + compliance * power - supply_mm) / (slope + compliance);
        power -= step;
        feed_mm -= slope * step;
        if (std::abs(step) <= kSolved * power) {
            break;
        }
    }
    return {std::max(feed_mm, kSmallestFeed_mm), power};
}

}  // namespace

StiffnessFilter::StiffnessFilter(const StiffnessAssumptions& assumptions, double kx_NPerMm) noexcept
    : m_assume(assumptions),
      m_kx_NPerMm(kx_NPerMm),
      m_sin(std::sin(assumptions.forceAngle_deg * std::numbers::pi / 180.0)),
      m_cos(std::cos(assumptions.forceAngle_deg * std::numbers::pi / 180.0)) {}

StiffnessFilter::Walk StiffnessFilter::walkOf(std::size_t way, double quiet) noexcept {
    switch (way) {
        case kCalmWay:
            return {0.000316, 0.0000804, 0.998};
        case kDriftWay:
            return {0.0034, 0.000347, 0.989};
        default:
            return {Range{0.042, 0.0201}.at(quiet), Range{0.12, 0.0929}.at(quiet), Range{0.97, 0.991}.at(quiet)};
    }
}

void StiffnessFilter::begin(double force_N, double feed_mmPerRev, double noise_N2) noexcept {
    const double deflection_mm = force_N * m_cos / (m_sin * m_kx_NPerMm);
    const double cut_mm = std::max({feed_mmPerRev - deflection_mm, 0.3 * feed_mmPerRev, kSmallestFeed_mm});
    for (std::size_t i = 0; i < kWays; ++i) {
        m_ways[i].probability = kFirstProbability[i];
        m_ways[i].state = {force_N, std::log(force_N / m_sin) - m_assume.exponent * std::log(cut_mm), 0.0, force_N};
        m_ways[i].covariance = Eigen::Vector4d(noise_N2, kFirstDeviation * kFirstDeviation,
                                               kFirstSlopeDeviation * kFirstSlopeDeviation, noise_N2)
                                   .asDiagonal();
    }
    combine();
}

void StiffnessFilter::turn(Way& way, std::size_t from, std::size_t to, double feed_mmPerRev, double quiet) noexcept {
    if (to == kStepWay && from != kStepWay) {
        const double jump = std::min(kJumpPerFeed_perMm.at(quiet) * feed_mmPerRev, kHighestJump.at(quiet));
        way.covariance(1, 1) += kJump * kJump;
        way.covariance(2, 2) += jump * jump;
    } else if (from == kStepWay && to != kStepWay) {
        way.state[2] = 0.0;
        way.covariance.row(2).setZero();
        way.covariance.col(2).setZero();
        way.covariance(2, 2) = kSlopeAfterStep * kSlopeAfterStep;
    }
}

void StiffnessFilter::mix(double feed_mmPerRev) noexcept {
    const std::array<Way, kWays> before = m_ways;
    for (std::size_t to = 0; to < kWays; ++to) {
        Way& way = m_ways[to];
        std::array<double, kWays> weight{};
        way.probability = 0.0;
        for (std::size_t from = 0; from < kWays; ++from) {
            weight[from] = change(from, to, m_quiet) * before[from].probability;
            way.probability += weight[from];
        }
        double total = 0.0;
        for (std::size_t from = 0; from < kWays; ++from) {
            weight[from] = std::max(0.0, weight[from] / way.probability - (from == to ? 0.0 : kLeastMixed));
            total += weight[from];
        }
        if (weight[to] == total) {  // nothing comes from the others: stays as it is
            continue;
        }
        std::array<Way, kWays> coming;
        way.state.setZero();
        for (std::size_t from = 0; from < kWays; ++from) {
            if (weight[from] > 0.0) {
                coming[from] = before[from];
                turn(coming[from], from, to, feed_mmPerRev, m_quiet);
                way.state += weight[from] / total * coming[from].state;
            }
        }
        way.covariance.setZero();
        for (std::size_t from = 0; from < kWays; ++from) {
            if (weight[from] > 0.0) {
                const Eigen::Vector4d off = coming[from].state - way.state;
                way.covariance += weight[from] / total * (coming[from].covariance + off * off.transpose());
            }
        }
    }
}

double StiffnessFilter::predict(Way& way, const Walk& walk, double feed_mmPerRev, double knownChange) const noexcept {
    const double m = m_assume.exponent;
    const double perNewton_mm = m_cos / (m_sin * m_kx_NPerMm);  // δ_x per newton of F_y
    const double g = way.state[1] + way.state[2] + knownChange;
    const double stiffness = std::exp(g);
    const double compliance = stiffness * m_cos / m_kx_NPerMm;
    const double near = std::max(way.state[0], kLeastForce_N) / (stiffness * m_sin);
    const CutFeed cut = solveCutFeed(compliance, feed_mmPerRev + perNewton_mm * way.state[0], m, near);
    const double cut_mm = cut.feed_mmPerRev;
    const double force_N = stiffness * cut.power * m_sin;
    // l + K l^m = s: dl/ds = 1/D, and a change of g moves F_y by F_y/D, with D = 1 + m K l^(m−1).
    const double damping = 1.0 + m * compliance * cut.power / cut_mm;
    const double perForce = m * force_N / cut_mm / damping * perNewton_mm;
    const double perG_N = force_N / damping;
    Eigen::Matrix4d& covariance = way.covariance;
    // T P Tᵀ with the transition T: F_y by perForce of itself and perG_N of g and v, g by v, v kept by ρ.
    Eigen::Matrix4d half;
    half.row(1) = covariance.row(1) + covariance.row(2);
    half.row(0) = perForce * covariance.row(0) + perG_N * half.row(1);
    half.row(2) = walk.slopeMemory * covariance.row(2);
    half.row(3) = covariance.row(0);
    covariance.col(1) = half.col(1) + half.col(2);
    covariance.col(0) = perForce * half.col(0) + perG_N * covariance.col(1);
    covariance.col(2) = walk.slopeMemory * half.col(2);
    covariance.col(3) = half.col(0);
    const double variance = walk.deviation * walk.deviation;  // of g, felt by F_y in the same revolution
    covariance(0, 0) += perG_N * perG_N * variance + kModelNoise_N2;
    covariance(0, 1) += perG_N * variance;
    covariance(1, 0) += perG_N * variance;
    covariance(1, 1) += variance;
    covariance(2, 2) += walk.slopeDeviation * walk.slopeDeviation;
    way.state = {force_N, g, walk.slopeMemory * way.state[2], way.state[0]};
    return damping - 1.0;
}

void StiffnessFilter::predict(double feed_mmPerRev, double knownChange, double quiet) noexcept {
    m_quiet = quiet;
    mix(feed_mmPerRev);
    for (std::size_t i = 0; i < kWays; ++i) {
        const double lag_rev = predict(m_ways[i], walkOf(i, quiet), feed_mmPerRev, knownChange);
        m_lag_rev = i == kCalmWay ? lag_rev : m_lag_rev;
    }
    combine();
}

StiffnessFilter::Fit StiffnessFilter::correct(double force_N, const Noise& noise) noexcept {
    // Within a revolution F_y goes to its end value with the time constant m K l^(m−1): a stiff tool is there at once.
    const double w = m_assume.meanShare * 2.0 * (m_lag_rev - 1.0 / std::expm1(1.0 / m_lag_rev));
    const auto expected_N = [w](const Eigen::Vector4d& state) { return (1.0 - w) * state[0] + w * state[3]; };
    const double mean_N = expected_N(m_mean);
    double spread_N2 = noise.highest_N2;  // of the ways together
    std::array<double, kWays> logLikelihood{};
    for (std::size_t i = 0; i < kWays; ++i) {
        Way& way = m_ways[i];
        const Eigen::Vector4d cross = (1.0 - w) * way.covariance.col(0) + w * way.covariance.col(3);
        const double own_N2 = (1.0 - w) * cross[0] + w * cross[3];
        const double surprise_N = force_N - expected_N(way.state);
        const double off_N = expected_N(way.state) - mean_N;
        spread_N2 += way.probability * (own_N2 + off_N * off_N);
        const double expected_N2 = own_N2 + noise.variance_N2;
        const Eigen::Vector4d gain = cross / expected_N2;
        logLikelihood[i] = -0.5 * (surprise_N * surprise_N / expected_N2 + std::log(expected_N2));
        way.state += gain * surprise_N;
        way.covariance -= gain * cross.transpose();
        way.state[0] = std::max(way.state[0], 0.0);
        way.state[1] = std::clamp(way.state[1], kSoftest, kHardest);
        way.state[2] = std::clamp(way.state[2], -kSteepest.at(m_quiet), kSteepest.at(m_quiet));
    }
    const double most = *std::ranges::max_element(logLikelihood);
    double total = 0.0;
    for (std::size_t i = 0; i < kWays; ++i) {
        m_ways[i].probability *= std::exp(logLikelihood[i] - most);
        total += m_ways[i].probability;
    }
    m_logLikelihood = most + std::log(total);
    for (Way& way : m_ways) {
        way.probability = std::max(way.probability / total, kLeastProbability);
    }
    combine();
    // What every filter explains says nothing about k_x: counted, small systematic errors would add up in a calm cut.
    const double surprise_N = force_N - mean_N;
    const double surprise = surprise_N * surprise_N / spread_N2 - kSurprising;
    return {-0.5 * std::clamp(surprise, 0.0, kMostSurprising - kSurprising), spread_N2};
}

void StiffnessFilter::combine() noexcept {
    // A step that is hardly likely, but as wide as a step is, would shake the estimate with every force.
    const double step = m_ways[kStepWay].probability;
    m_share[kStepWay] = step * std::clamp((step - kSurelyNoStep) / (kSurelyStep.at(m_quiet) - kSurelyNoStep), 0.0, 1.0);
    const double others = m_ways[kCalmWay].probability + m_ways[kDriftWay].probability;
    for (const std::size_t i : {kCalmWay, kDriftWay}) {
        m_share[i] = m_ways[i].probability * (1.0 - m_share[kStepWay]) / others;
    }
    m_mean.setZero();
    for (std::size_t i = 0; i < kWays; ++i) {
        m_mean += m_share[i] * m_ways[i].state;
    }
    m_variance = 0.0;
    for (const Way& way : m_ways) {
        const double off = way.state[1] - m_mean[1];
        m_variance += way.probability * (way.covariance(1, 1) + off * off);
    }
}

double StiffnessFilter::slopeMemory() const noexcept {
    double memory = 0.0;
    for (std::size_t i = 0; i < kWays; ++i) {
        memory += m_share[i] * walkOf(i, m_quiet).slopeMemory;
    }
    return memory;
}

void StiffnessFilter::shift(double change) noexcept {
    for (Way& way : m_ways) {
        way.state[1] += change;
    }
    m_mean[1] += change;
}

void StiffnessFilter::adopt(const StiffnessFilter& other) noexcept {
    m_ways = other.m_ways;
    m_quiet = other.m_quiet;
    combine();
}

}  // namespace kerf::milling
