// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "engine/core/units.h"
#include "engine/process/milling/milling_types.h"

namespace kerf::milling {

/// ln(C b), C b in N/mm^m, with its 95 % interval.
struct StiffnessEstimate {
    bool valid{false};  ///< false until the tool has cut under a trusted force
    double lnCb{0.0};
    double slope{0.0};      ///< change expected per revolution
    double half95{0.0};     ///< half width of the 95 % interval of lnCb
    double force_N{0.0};    ///< F_y freed from measurement noise
    double kx_NPerMm{0.0};  ///< stiffness of the tool along the feed that explains the cut best
};

/// What a filter assumes of tool, material and sensor.
struct StiffnessAssumptions {
    double exponent{0.85};        ///< m, (0, 1]
    double forceAngle_deg{45.0};  ///< θ
    double forceNoise_N{5.0};     ///< standard deviation of one averaged force, > 0
    double walk{0.05};            ///< standard deviation of g per revolution, > 0
    double slopeWalk{0.1};        ///< of v per revolution, > 0
    double slopeMemory{0.85};     ///< ρ, [0, 1): a step in the blank is cut into within some ten revolutions
    double meanShare{0.0};  ///< w: the measured force is (1 − w) F_y(i) + w F_y(i−1). 0: F_y at the end of the
                            ///< revolution (the paper's equations); 0.5: averaged over it, as a sensor does
};

/// Kalman filter for the cutting stiffness at one assumed k_x, from the averaged force and the feed the axis really
/// made.
///
///   state      F_y, g = ln(C b), v = change of g per revolution, F_y one revolution earlier
///   predict    g ← g + v + Δ, v ← ρ v,  l + (e^g cos θ/k_x) l^m = f_r + δ_x,  F_y ← e^g l^m sin θ
///   correct    with the measured force (1 − w) F_y(i) + w F_y(i−1); equations 1-6 of docs/milling.md, linearised at
///   the estimate
///
/// Δ is a change of ln b known beforehand (blank profile), else 0. Forces ≥ 0 in N, feeds ≥ 0 in mm/rev.
/// All functions run in the cycle: no allocation, lock, throw or I/O.
class StiffnessFilter {
 public:
    StiffnessFilter() noexcept = default;
    StiffnessFilter(const StiffnessAssumptions& assumptions, double kx_NPerMm) noexcept;

    /// The first revolution in the work: F_y and the feed give a first, wide estimate.
    void begin(double force_N, double feed_mmPerRev) noexcept;
    void predict(double feed_mmPerRev, double knownChange) noexcept;
    /// Correct the prediction; returns how badly the force fits it: 0 within the noise, else the negative half square
    /// of the surprise in standard deviations (a log-likelihood with a dead zone).
    double correct(double force_N) noexcept;
    void shift(double change) noexcept { m_state[1] += change; }
    /// Take over another filter's estimate, keeping the own k_x.
    void adopt(const StiffnessFilter& other) noexcept;

    [[nodiscard]] double force_N() const noexcept { return m_state[0]; }
    [[nodiscard]] double lnCb() const noexcept { return m_state[1]; }
    [[nodiscard]] double slope() const noexcept { return m_state[2]; }
    [[nodiscard]] double variance() const noexcept { return m_covariance(1, 1); }

 private:
    StiffnessAssumptions m_assume{};
    double m_kx_NPerMm{1.0};
    double m_sin{0.0};
    double m_cos{0.0};
    Eigen::Vector4d m_state{Eigen::Vector4d::Zero()};
    Eigen::Matrix4d m_covariance{Eigen::Matrix4d::Zero()};
};

/// Cutting stiffness when k_x is not known: filters at several k_x side by side, weighed by how well each explains the
/// measured force (Magill 1965). A wrong k_x shows in every transient, so the weights settle within the first entry. A
/// filter that no longer explains the force is set back onto the best one's estimate, so it can come into its own
/// again.
///
/// Without the bank a law must assume a stiff tool to stay stable on every machine (docs/milling.md has the
/// comparison).
class StiffnessEstimator {
 public:
    static constexpr std::size_t kFilters = kMillingKxFilters;
    struct Params {
        StiffnessAssumptions assume{};
        double softest_NPerMm{22.0 * kNewtonPerKilogramForce};  ///< k_x of the first filter
        double ratio{1.5};                                      ///< from filter to filter; 1: one k_x only
        double likely_NPerMm{70.0 * kNewtonPerKilogramForce};   ///< centre of the weights before anything was cut
        double likelyWidth{0.8};                                ///< their standard deviation in ln k_x
        double airForce_N{20.0};                                ///< below: the tool does not cut
    };
    explicit StiffnessEstimator(const Params& params) noexcept;

    /// One revolution with a trusted force and the feed the axis made in it; `knownChange` see StiffnessFilter.
    void update(double force_N, double feed_mmPerRev, double knownChange = 0.0) noexcept;
    /// One revolution without a trusted force: predicted only, the interval widens.
    void coast(double feed_mmPerRev) noexcept;
    /// The period of the law has changed: ln(C b) of the new one is larger by this.
    void shift(double change) noexcept;
    /// Forget the cut (the tool has left the work); what was learnt of k_x stays.
    void leaveWork() noexcept;
    /// What was learnt of k_x: to keep it over a change of setup or a restart. Weights that are no numbers are refused.
    [[nodiscard]] const std::array<double, kFilters>& kxLogWeights() const noexcept { return m_logWeight; }
    bool setKxLogWeights(const std::array<double, kFilters>& weights) noexcept;
    [[nodiscard]] const StiffnessEstimate& estimate() const noexcept { return m_estimate; }
    [[nodiscard]] double airForce_N() const noexcept { return m_params.airForce_N; }

 private:
    void combine() noexcept;

    Params m_params;
    std::array<StiffnessFilter, kFilters> m_filters{};
    std::array<double, kFilters> m_lnKx{};
    std::array<double, kFilters> m_logWeight{};  ///< highest is 0
    StiffnessEstimate m_estimate{};
};

}  // namespace kerf::milling
