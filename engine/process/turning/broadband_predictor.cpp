// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/broadband_predictor.h"

#include <algorithm>
#include <cmath>

namespace kerf::turning {
namespace {

constexpr std::array<double, BroadbandPredictor::kFilters> kPole{0.0, 0.6, 0.85, 0.94, 0.98, 0.995};
constexpr double kMemory = 0.9995;     ///< .4 s
constexpr double kDelayPenalty = 0.5;  ///< ρ
constexpr double kRidge = 1e-4;        ///< of the mean power of a filter
constexpr double kFloor_um2 = 2e-5;    ///< per sample: what no sensor resolves is not learned
constexpr double kWeightShare = 0.02;  ///< per sample
constexpr std::size_t kSolveEvery = 25;
constexpr std::size_t kEarliest = 150;
constexpr double kDoubtUp = 1.6;  ///< of κ, per solution
constexpr double kDoubtDown = 0.97;
constexpr double kDoubtLeast = 1e-4;  ///< of the power of r
constexpr double kNothing_um2 = 1e-12;
constexpr double kWorthFrom = 0.04;  ///< share of the power that can be foreseen
constexpr double kWorthWhole = 0.1;

/// Where the gain is checked, rad per sample: 16 Hz to half the sample rate.
constexpr std::array<double, 11> kChecked{0.02, 0.04, 0.07, 0.12, 0.18, 0.27, 0.4, 0.6, 0.9, 1.6, 3.1416};
constexpr double kSmallGain = 1.4;
constexpr double kGainDoubt = 0.2;
constexpr double kFastDoubt = 0.8;

}  // namespace

void BroadbandPredictor::reset() noexcept {
    m_phi = m_before = m_cross = m_target = m_weight = {};
    for (auto& row : m_normal) {
        row.fill(0.0);
    }
    m_power_um2 = m_missed_um2 = m_doubt_um2 = m_worth = m_full_um = m_prediction_um = m_error_um = 0.0;
    m_samples = 0;
}

void BroadbandPredictor::forget(double share) noexcept {
    for (std::size_t i = 0; i < kFilters; ++i) {
        for (double& value : m_normal[i]) {
            value *= share;
        }
        m_cross[i] *= share;
    }
    m_power_um2 *= share;
    m_missed_um2 *= share;
}

double BroadbandPredictor::update(double value_um) noexcept {
    learn(value_um);
    m_before = m_phi;
    for (std::size_t i = 0; i < kFilters; ++i) {
        m_phi[i] = kPole[i] * m_phi[i] + (1.0 - kPole[i]) * value_um;
    }
    if (++m_samples % kSolveEvery == 0 && m_samples >= kEarliest) {
        solve();
    }
    const double foreseen = 1.0 - m_missed_um2 / std::max(m_power_um2, kNothing_um2);
    m_worth = std::clamp((foreseen - kWorthFrom) / (kWorthWhole - kWorthFrom), 0.0, 1.0);
    m_prediction_um = m_full_um = 0.0;
    for (std::size_t i = 0; i < kFilters; ++i) {
        m_weight[i] += kWeightShare * (m_target[i] - m_weight[i]);
        m_full_um += m_weight[i] * m_phi[i];
    }
    m_prediction_um = m_worth * m_full_um;
    return m_prediction_um;
}

void BroadbandPredictor::learn(double value_um) noexcept {
    m_error_um = value_um - m_prediction_um;
    const double missed_um = value_um - m_full_um;
    m_power_um2 = kMemory * m_power_um2 + value_um * value_um;
    m_missed_um2 = kMemory * m_missed_um2 + missed_um * missed_um;
    for (std::size_t i = 0; i < kFilters; ++i) {
        const double change = m_phi[i] - m_before[i];
        for (std::size_t j = 0; j <= i; ++j) {
            m_normal[i][j] =
                kMemory * m_normal[i][j] + m_phi[i] * m_phi[j] + kDelayPenalty * change * (m_phi[j] - m_before[j]);
        }
        m_cross[i] = kMemory * m_cross[i] + m_phi[i] * value_um;
    }
}

/// Cholesky of the normal equations with a ridge, then the small-gain check: what does not pass is scaled down now, and
/// solved from the next time on as if r were noisier (κ), which takes the gain from where there is little to foresee.
void BroadbandPredictor::solve() noexcept {
    std::array<std::array<double, kFilters>, kFilters> a = m_normal;
    std::array<double, kFilters> x = m_cross;
    double trace = 0.0;
    for (std::size_t i = 0; i < kFilters; ++i) {
        trace += a[i][i];
    }
    const double weighed = (1.0 - std::pow(kMemory, static_cast<double>(m_samples))) / (1.0 - kMemory);
    const double ridge = kRidge * trace / static_cast<double>(kFilters) + kFloor_um2 * weighed;
    for (std::size_t i = 0; i < kFilters; ++i) {
        a[i][i] += ridge;
        for (std::size_t j = 0; j <= i; ++j) {
            // What white noise of variance κ in r would add.
            a[i][j] += m_doubt_um2 * weighed * (1.0 - kPole[i]) * (1.0 - kPole[j]) / (1.0 - kPole[i] * kPole[j]);
            double sum = a[i][j];
            for (std::size_t k = 0; k < j; ++k) {
                sum -= a[i][k] * a[j][k];
            }
            a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-3 * ridge)) : sum / a[j][j];
        }
        for (std::size_t k = 0; k < i; ++k) {
            x[i] -= a[i][k] * x[k];
        }
        x[i] /= a[i][i];
    }
    for (std::size_t i = kFilters; i-- > 0;) {
        for (std::size_t k = i + 1; k < kFilters; ++k) {
            x[i] -= a[k][i] * x[k];
        }
        x[i] /= a[i][i];
    }
    double scale = 1.0;
    for (const double omega : kChecked) {
        const double half = std::sin(0.5 * omega);
        const double most = kSmallGain / (kGainDoubt + 2.0 * half + kFastDoubt * half * half);
        const double gain = std::abs(response(x, omega));
        scale = gain * scale > most ? most / gain : scale;
    }
    const double power_um2 = m_power_um2 / weighed;
    m_doubt_um2 =
        scale < 1.0 ? std::clamp(kDoubtUp * m_doubt_um2, kDoubtLeast * power_um2, power_um2) : kDoubtDown * m_doubt_um2;
    for (std::size_t i = 0; i < kFilters; ++i) {
        m_target[i] = scale * x[i];
    }
}

std::complex<double> BroadbandPredictor::response(const std::array<double, kFilters>& weights,
                                                  double omega_radPerSample) noexcept {
    const std::complex<double> back = std::polar(1.0, -omega_radPerSample);
    std::complex<double> sum{0.0, 0.0};
    for (std::size_t i = 0; i < kFilters; ++i) {
        sum += weights[i] * (1.0 - kPole[i]) / (1.0 - kPole[i] * back);
    }
    return sum;
}

std::array<double, BroadbandPredictor::kFilters> BroadbandPredictor::weights() const noexcept {
    std::array<double, kFilters> acting = m_weight;
    for (double& weight : acting) {
        weight *= m_worth;
    }
    return acting;
}

}  // namespace kerf::turning
