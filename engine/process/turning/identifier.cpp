// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/identifier.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace kerf::turning {
namespace {

constexpr double kParameters = 3.0;
constexpr double kWantedSpread = 0.0025;        ///< Robust: standard deviation no parameter may lose by forgetting
constexpr std::uint64_t kLearningSamples = 30;  ///< Robust: measured force in φ at the start and after a surprise
constexpr double kSurprise = 6.0;               ///< Robust: residual power over noise power that means "process moved"
constexpr double kShortMemory = 0.9;            ///< of the surprise test
constexpr double kLongMemory = 0.995;           ///< of the noise power
constexpr double kExcitationMemory = 0.98;
constexpr double kSmallestNoise_N = 1e-6;
constexpr double kNormal95 = 1.96;
constexpr double kSmallestVariance = 1e-12;
constexpr double kConstantTraceFloor = 1e-3;  ///< share of the trace spread evenly (Åström & Wittenmark)

void symmetrise(Eigen::Matrix3d& p) noexcept {
    const Eigen::Matrix3d transposed = p.transpose();
    p = (p + transposed) / 2.0;
}

}  // namespace

std::optional<Sentence> ProcessIdentifier::whyInvalid(const Params& params) {
    if (!(params.forgetting >= 0.5 && params.forgetting <= 1.0)) {
        return Sentence(KERF_TEXT("The forgetting factor is %1; expected 0.5 to 1."),
                        SentenceArg(params.forgetting, 4));
    }
    if (!(params.initialVariance > 0.0 && params.initialVariance <= 1e9)) {
        return Sentence(KERF_TEXT("The initial covariance is %1; expected above 0, at most 1e9."),
                        SentenceArg(params.initialVariance, 4));
    }
    if (!std::isfinite(params.limit) || params.limit < 0.0) {
        return Sentence(KERF_TEXT("The limit of the forgetting is %1; expected 0 or more."),
                        SentenceArg(params.limit, 4));
    }
    return std::nullopt;
}

ProcessIdentifier::ProcessIdentifier(const Params& params) noexcept : m_params(params) {
    assert(!whyInvalid(params));
    reset();
}

void ProcessIdentifier::reset() noexcept {
    m_theta.setZero();
    m_p = Eigen::Matrix3d::Identity() * m_params.initialVariance;
    m_lastForce_N = m_lastChip_um = m_modelForce_N = m_shortVariance_N2 = m_noise_N2 = 0.0;
    m_chipMean_um = m_chipVariance_um2 = 0.0;
    m_samples = m_sinceSurprise = 0;
}

void ProcessIdentifier::start(const ProcessParams& process, double variance, double force_N, double chip_um) noexcept {
    reset();
    m_lastForce_N = m_modelForce_N = force_N;
    m_lastChip_um = m_chipMean_um = chip_um;
    m_theta = {process.a1, process.b0, process.b1};
    m_p = Eigen::Matrix3d::Identity() * variance;
}

void ProcessIdentifier::update(double force_N, double chip_um) noexcept {
    if (!std::isfinite(force_N) || !std::isfinite(chip_um)) {
        return;
    }
    noteExcitation(chip_um);
    if (m_params.method == Forgetting::Robust) {
        updateRobust(force_N, std::exchange(m_lastForce_N, force_N), chip_um, std::exchange(m_lastChip_um, chip_um));
        return;
    }
    const Eigen::Vector3d phi(m_lastForce_N, chip_um, m_lastChip_um);
    const double error_N = force_N - phi.dot(m_theta);
    m_noise_N2 += (1.0 - kLongMemory) * (error_N * error_N - m_noise_N2);
    m_lastForce_N = force_N;
    m_lastChip_um = chip_um;
    const Eigen::Vector3d pPhi = m_p * phi;
    const double information = phi.dot(pPhi);
    double forgetting = m_params.forgetting;

    switch (m_params.method) {
        case Forgetting::Directional:
            updateDirectional(pPhi, information, error_N, forgetting);
            return;
        case Forgetting::DeadZone:
            if (std::abs(error_N) <= m_params.limit) {
                return;
            }
            break;
        case Forgetting::VariableFactor:
            forgetting = std::max(forgetting, 1.0 - error_N * error_N / ((1.0 + information) * m_params.limit));
            break;
        default:
            break;
    }

    const Eigen::Vector3d gain = pPhi / (forgetting + information);
    m_theta += gain * error_N;
    const Eigen::RowVector3d phiP = phi.transpose() * m_p;
    m_p -= gain * phiP;
    if (m_params.method == Forgetting::TraceLimit && m_p.trace() / forgetting > m_params.limit) {
        forgetting = 1.0;
    }
    m_p /= forgetting;
    if (m_params.method == Forgetting::ConstantTrace) {
        const double even = m_params.limit * kConstantTraceFloor / kParameters;
        m_p = m_p * ((m_params.limit - kParameters * even) / m_p.trace()) + Eigen::Matrix3d::Identity() * even;
    }
    if (m_params.method != Forgetting::Plain) {
        symmetrise(m_p);
    }
}

void ProcessIdentifier::updateDirectional(const Eigen::Vector3d& pPhi, double information, double error_N,
                                          double forgetting) noexcept {
    m_theta += pPhi * (error_N / (1.0 + information));
    const double kept = information > 0.0 ? forgetting - (1.0 - forgetting) / information : 0.0;
    if (kept != 0.0) {
        const Eigen::Vector3d scaled = pPhi / (1.0 / kept + information);
        m_p -= scaled * pPhi.transpose();
        symmetrise(m_p);
    }
}

void ProcessIdentifier::updateRobust(double force_N, double measuredBefore_N, double chip_um,
                                     double chipBefore_um) noexcept {
    ++m_samples;
    const bool measured = m_samples < kLearningSamples || m_sinceSurprise < kLearningSamples;
    const Eigen::Vector3d phi(measured ? measuredBefore_N : m_modelForce_N, chip_um, chipBefore_um);
    const Eigen::Vector3d pPhi = m_p * phi;
    const double information = phi.dot(pPhi);
    const double error_N = force_N - phi.dot(m_theta);

    const double power = error_N * error_N / (1.0 + information);
    m_shortVariance_N2 += (1.0 - kShortMemory) * (power - m_shortVariance_N2);
    const bool surprised = m_samples > kLearningSamples && m_shortVariance_N2 > kSurprise * m_noise_N2;
    if (m_samples <= kLearningSamples) {
        m_noise_N2 += (power - m_noise_N2) / static_cast<double>(m_samples);
    } else {
        // A surprise may be a louder sensor as well as another process: believe it slowly.
        m_noise_N2 += (surprised ? 0.2 : 1.0) * (1.0 - kLongMemory) * (power - m_noise_N2);
    }
    m_sinceSurprise = surprised ? 0 : m_sinceSurprise + 1;

    const double forgetting = m_params.forgetting;
    const Eigen::Vector3d gain = pPhi / (forgetting + information);
    m_theta += gain * error_N;
    m_p -= gain * pPhi.transpose();
    // Forget only while what is left still holds every parameter to kWantedSpread (at any rate after a surprise).
    const double largest = m_p.diagonal().maxCoeff() / forgetting;
    const bool spare = largest * m_noise_N2 <= kWantedSpread * kWantedSpread || surprised;
    if (spare && largest < m_params.initialVariance) {
        m_p /= forgetting;
    }
    symmetrise(m_p);
    for (Eigen::Index i = 0; i < 3; ++i) {
        m_p(i, i) = std::max(m_p(i, i), kSmallestVariance);
    }
    const double model_N = m_theta[0] * m_modelForce_N + m_theta[1] * chip_um + m_theta[2] * chipBefore_um;
    m_modelForce_N = std::abs(m_theta[0]) < 1.0 && std::isfinite(model_N) ? model_N : force_N;
}

void ProcessIdentifier::noteExcitation(double chip_um) noexcept {
    m_chipMean_um += (1.0 - kExcitationMemory) * (chip_um - m_chipMean_um);
    const double deviation_um = chip_um - m_chipMean_um;
    m_chipVariance_um2 += (1.0 - kExcitationMemory) * (deviation_um * deviation_um - m_chipVariance_um2);
}

double ProcessIdentifier::excitation() const noexcept {
    const double signal_N = std::abs(m_theta[1]) * std::sqrt(m_chipVariance_um2);
    return signal_N / std::max(std::sqrt(m_noise_N2), kSmallestNoise_N);
}

ProcessIdentifier::Estimate ProcessIdentifier::estimate() const noexcept {
    Estimate estimate;
    estimate.process = {m_theta[0], m_theta[1], m_theta[2]};
    for (Eigen::Index i = 0; i < 3; ++i) {
        estimate.half95[i] = kNormal95 * std::sqrt(std::max(0.0, m_p(i, i) * m_noise_N2));
    }
    return estimate;
}

double ProcessIdentifier::residual_N() const noexcept {
    return std::sqrt(m_noise_N2);
}

}  // namespace kerf::turning
