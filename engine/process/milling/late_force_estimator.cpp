// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/late_force_estimator.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {
constexpr double kMemory = 1.0 - 1.0 / 100.0;  // of the evidence per period
constexpr double kMostSaid = 3.0;              // log-likelihood by which one force may tell one lateness from another
constexpr double kEvidence = 20.0;             // from which a force is taken for late: a comb in step with it says less
constexpr double kEvidenceBack = 4.0;          // from which it is taken for less late again
constexpr double kMostAirShare = 3.0;          // of the air force: noisier air than this does not raise it further
constexpr int kYoung = 200;                    // revolutions in which each lateness has a noise meter of its own
}  // namespace

LateForceEstimator::LateForceEstimator(const StiffnessEstimator::Params& params) noexcept
    : m_leastAirForce_N(params.airForce_N),
      m_meters{NoiseMeter(params.assume), NoiseMeter(params.assume), NoiseMeter(params.assume)},
      m_estimators{StiffnessEstimator(params), StiffnessEstimator(params), StiffnessEstimator(params)} {
    m_noise.fill({params.assume.forceNoise_N, m_meters[0].noise()});
}

void LateForceEstimator::take(const Period& period) noexcept {
    std::shift_right(m_periods.begin(), m_periods.end(), 1);
    m_periods[0] = period;
}

bool LateForceEstimator::young() const noexcept {
    return m_revolutions < kYoung;
}

void LateForceEstimator::hear(std::size_t late, double force_N) noexcept {
    const StiffnessEstimator& estimator = m_estimators[late];
    const Period& period = m_periods[late];
    NoiseMeter& meter = m_meters[late];
    const double before_N = std::sqrt(meter.noise().variance_N2);
    const double kx_NPerMm = estimator.estimate().kx_NPerMm;
    if (estimator.estimate().valid) {
        meter.update(force_N, period.feed_mm, period.knownChange, kx_NPerMm, estimator.filterQuiet(before_N));
    } else if (period.feed_mm > 0.0) {
        meter.begin(force_N, period.feed_mm, kx_NPerMm);
    }
    m_noise[late] = {before_N, meter.noise()};
}

void LateForceEstimator::update(double force_N, double feed_mm, double knownChange, bool learnLate) noexcept {
    take({feed_mm, knownChange});
    m_revolutions = std::min(m_revolutions + 1, kYoung);
    const bool judged =
        learnLate && std::ranges::all_of(m_estimators, [](const auto& one) { return one.estimate().valid; });
    for (std::size_t late = 0; late < kLates; ++late) {
        if (late == m_late || (learnLate && young())) {
            hear(late, force_N);
        }
    }
    std::array<double, kLates> logLikelihood{};
    for (std::size_t late = 0; late < kLates; ++late) {
        if (late != m_late && !young()) {
            m_meters[late] = m_meters[m_late];
            m_noise[late] = m_noise[m_late];
        }
        if (learnLate || late == m_late) {
            m_estimators[late].update(force_N, m_periods[late].feed_mm, m_periods[late].knownChange, m_noise[late]);
            logLikelihood[late] = m_estimators[late].logLikelihood();
        } else {
            m_estimators[late].leaveWork();
        }
    }
    if (judged) {
        judge(logLikelihood);
    }
}

double LateForceEstimator::airForce_N() const noexcept {
    return std::clamp(m_meters[m_late].airReach_N(), m_leastAirForce_N, kMostAirShare * m_leastAirForce_N);
}

void LateForceEstimator::judge(const std::array<double, kLates>& logLikelihood) noexcept {
    const double likeliest = *std::ranges::max_element(logLikelihood);
    for (std::size_t late = 0; late < kLates; ++late) {
        m_logEvidence[late] = kMemory * m_logEvidence[late] + std::max(logLikelihood[late] - likeliest, -kMostSaid);
    }
    const double most = *std::ranges::max_element(m_logEvidence);
    for (double& evidence : m_logEvidence) {
        evidence -= most;
    }
    const auto best = static_cast<std::size_t>(std::ranges::max_element(m_logEvidence) - m_logEvidence.begin());
    if (m_logEvidence[best] - m_logEvidence[m_late] > (best > m_late ? kEvidence : kEvidenceBack)) {
        m_late = best;
    }
}

double LateForceEstimator::lead() const noexcept {
    double other = -1e300;
    for (std::size_t late = 0; late < kLates; ++late) {
        other = late != m_late ? std::max(other, m_logEvidence[late]) : other;
    }
    return m_logEvidence[m_late] - other;
}

void LateForceEstimator::coast(double feed_mm) noexcept {
    take({feed_mm, 0.0});
    for (std::size_t late = 0; late < kLates; ++late) {
        m_estimators[late].coast(m_periods[late].feed_mm, m_noise[late]);
    }
}

void LateForceEstimator::air(double force_N, double feed_mm) noexcept {
    take({feed_mm, 0.0});
    for (NoiseMeter& meter : m_meters) {
        meter.air(force_N);
    }
    leaveWork();
}

void LateForceEstimator::leaveWork() noexcept {
    for (StiffnessEstimator& estimator : m_estimators) {
        estimator.leaveWork();
    }
}

void LateForceEstimator::setPeriod(double shift) noexcept {
    for (StiffnessEstimator& estimator : m_estimators) {
        estimator.shift(shift);
    }
    for (NoiseMeter& meter : m_meters) {
        meter.shift(shift);
    }
    m_revolutions = 0;
    m_logEvidence.fill(0.0);
    m_late = 0;
}

void LateForceEstimator::setReference(double reference_N, double unknownNoise_N) noexcept {
    for (std::size_t late = 0; late < kLates; ++late) {
        m_meters[late].expect(unknownNoise_N);
        m_noise[late].now = m_meters[late].noise();
        m_estimators[late].setReference(reference_N, m_noise[late]);
    }
}

void LateForceEstimator::newTool(const StiffnessEstimator::Params& params) noexcept {
    m_estimators.fill(StiffnessEstimator(params));
    m_meters.fill(NoiseMeter(params.assume));
    m_noise.fill({params.assume.forceNoise_N, m_meters[0].noise()});
}

const std::array<double, LateForceEstimator::kFilters>& LateForceEstimator::kxLogWeights() const noexcept {
    return m_estimators[m_late].kxLogWeights();
}

bool LateForceEstimator::setKxLogWeights(const std::array<double, kFilters>& weights) noexcept {
    return std::ranges::all_of(m_estimators, [&](auto& estimator) { return estimator.setKxLogWeights(weights); });
}

StiffnessEstimate LateForceEstimator::after(std::span<const double> pending_mm) const noexcept {
    std::array<double, 2 * kLates> feeds_mm{};
    std::size_t count = 0;
    for (std::size_t age = m_late; age > 0; --age) {
        feeds_mm[count++] = m_periods[age - 1].feed_mm;
    }
    for (const double feed_mm : pending_mm.first(std::min(pending_mm.size(), kLates))) {
        feeds_mm[count++] = feed_mm;
    }
    return m_estimators[m_late].after({feeds_mm.data(), count});
}

double LateForceEstimator::pendingChange() const noexcept {
    double change = 0.0;
    for (std::size_t age = 0; age < m_late; ++age) {
        change += m_periods[age].knownChange;
    }
    return change;
}

}  // namespace kerf::milling
