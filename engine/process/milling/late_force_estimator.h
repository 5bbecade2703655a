// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/process/milling/axis_follow.h"
#include "engine/process/milling/noise_meter.h"
#include "engine/process/milling/stiffness_estimator.h"

namespace kerf::milling {

/// The cutting stiffness from a force that comes later than the feed it was made with: by 0 to 2 periods of the law
/// (a filter, an amplifier or a bus on the way of the force alone).
///
/// One StiffnessEstimator for each lateness pairs the force with the feed of so many periods before. Each is weighed by
/// the likelihood of the forces it was surprised by, slowly forgotten; the law gets the estimate of the likeliest. A
/// force counts as prompt until the evidence is clear, and who has the floor keeps it until it is clearly beaten. How
/// noisy the force is, each learns by a NoiseMeter of its own in the first revolutions in the work (a force paired with
/// the wrong feed seems noisy, and then tells the latenesses apart badly); later all are told by the likeliest's.
/// What force and feed are late by together does not show here (AxisFollow learns that).
///
/// Forces ≥ 0 in N, feeds ≥ 0 in mm per period. All functions run in the cycle: no allocation, lock, throw or I/O.
class LateForceEstimator {
 public:
    static constexpr std::size_t kLates = 3;
    static constexpr std::size_t kFilters = StiffnessEstimator::kFilters;

    explicit LateForceEstimator(const StiffnessEstimator::Params& params) noexcept;

    /// One period with a trusted force; `feed_mm` is what the axis made while the force was on its way, the newest.
    /// `learnLate`: the law uses what is learnt of the lateness; else only the likeliest estimator runs.
    void update(double force_N, double feed_mm, double knownChange, bool learnLate) noexcept;
    void coast(double feed_mm) noexcept;
    void air(double force_N, double feed_mm) noexcept;
    void leaveWork() noexcept;
    /// The period of the law is another one: so is every lateness.
    void setPeriod(double shift) noexcept;
    void setReference(double reference_N, double unknownNoise_N) noexcept;
    /// What was learnt of the lateness stays: it is the sensor's, not the tool's.
    void newTool(const StiffnessEstimator::Params& params) noexcept;
    [[nodiscard]] const std::array<double, kFilters>& kxLogWeights() const noexcept;
    bool setKxLogWeights(const std::array<double, kFilters>& weights) noexcept;

    [[nodiscard]] std::size_t late() const noexcept { return m_late; }
    /// Log-likelihood by which late() explains the forces better than any other lateness; negative: worse.
    [[nodiscard]] double lead() const noexcept;
    /// At the period the force belongs to.
    [[nodiscard]] const StiffnessEstimate& estimate() const noexcept { return m_estimators[m_late].estimate(); }
    /// At the end of what was measured, and of `pending_mm` after it (AxisFollow: at most kLates periods).
    [[nodiscard]] StiffnessEstimate after(std::span<const double> pending_mm) const noexcept;
    /// Change of ln b by the blank profile in the periods whose force has not come.
    [[nodiscard]] double pendingChange() const noexcept;
    /// Below: the tool does not cut.
    [[nodiscard]] double airForce_N() const noexcept;

 private:
    struct Period {
        double feed_mm{0.0};
        double knownChange{0.0};
    };
    void take(const Period& period) noexcept;
    [[nodiscard]] bool young() const noexcept;
    void hear(std::size_t late, double force_N) noexcept;
    void judge(const std::array<double, kLates>& logLikelihood) noexcept;

    double m_leastAirForce_N;
    std::array<NoiseMeter, kLates> m_meters;
    std::array<StiffnessEstimator::Noise, kLates> m_noise{};
    int m_revolutions{0};  ///< in the work since nothing was known of the lateness
    std::array<StiffnessEstimator, kLates> m_estimators;
    std::array<Period, kLates> m_periods{};      ///< newest first
    std::array<double, kLates> m_logEvidence{};  ///< highest is 0
    std::size_t m_late{0};
};

}  // namespace kerf::milling
