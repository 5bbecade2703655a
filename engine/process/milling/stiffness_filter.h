// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace kerf::milling {

/// What a filter assumes of tool, material and sensor.
struct StiffnessAssumptions {
    double exponent{0.85};        ///< m, (0, 1]
    double forceAngle_deg{45.0};  ///< θ
    double forceNoise_N{9.92};    ///< standard deviation of one averaged force before anything was learnt, > 0
    /// w of a tool that follows slowly: the measured force is (1 − w) F_y(i) + w F_y(i−1). 0: F_y at the end of the
    /// revolution (the paper's equations); 0.5: averaged over it, as a sensor does. The faster the tool follows, the
    /// smaller w is then.
    double meanShare{0.0};
};

/// Kalman filters for the cutting stiffness at one assumed k_x, from the averaged force and the feed the axis really
/// made: one for each way a blank goes on, mixed by how likely each is (interacting multiple models, Blom & Bar-Shalom
/// 1988). While nothing happens the noise of the force is averaged over many revolutions; a step is still followed at
/// once.
///
///   state      F_y, g = ln(C b), v = change of g per revolution, F_y one revolution earlier
///   predict    g ← g + v + Δ, v ← ρ v,  l + (e^g cos θ/k_x) l^m = f_r + δ_x,  F_y ← e^g l^m sin θ
///   correct    with the measured force (1 − w) F_y(i) + w F_y(i−1); equations 1-6 of docs/milling.md, linearised at
///              the estimate
///   ways       calm (v stays: a wall, a long ramp), drift (v changes), step (v jumps when it begins, by so much per mm
///              of feed, is 0 again when it ends, and walks between)
///
/// The jumps belong to the changes of way (turn()): a step is one change, not a walk, so a noisy force does not pass
/// for one, and when it is over nothing is left of its slope. `quiet`: how clean the force is, 1 … 0: in a noisy one a
/// step counts only when it lasts. Δ is a change of ln b known beforehand (blank profile), else 0. Forces ≥ 0 in N,
/// feeds ≥ 0 in mm/rev. All functions run in the cycle: no allocation, lock, throw or I/O.
class StiffnessFilter {
 public:
    static constexpr std::size_t kWays = 3;

    /// Variance of one averaged force: as thought, and the highest it may well be while that is still being learnt.
    struct Noise {
        double variance_N2{25.0};
        double highest_N2{25.0};
    };
    StiffnessFilter() noexcept = default;
    StiffnessFilter(const StiffnessAssumptions& assumptions, double kx_NPerMm) noexcept;

    /// The first revolution in the work: F_y and the feed give a first, wide estimate.
    void begin(double force_N, double feed_mmPerRev, double noise_N2) noexcept;
    void predict(double feed_mmPerRev, double knownChange, double quiet) noexcept;
    /// How a force fits what was predicted.
    struct Fit {
        double surprise{0.0};   ///< 0 within the noise, else the negative half square of the surprise in standard
                                ///< deviations (a log-likelihood with a dead zone, bounded)
        double spread_N2{1.0};  ///< variance it was expected with, > 0
    };
    /// Correct the prediction.
    Fit correct(double force_N, const Noise& noise) noexcept;
    void shift(double change) noexcept;
    /// Take over another filter's estimate, keeping the own k_x.
    void adopt(const StiffnessFilter& other) noexcept;
    void setKx(double kx_NPerMm) noexcept { m_kx_NPerMm = kx_NPerMm; }

    [[nodiscard]] double force_N() const noexcept { return m_mean[0]; }
    [[nodiscard]] double lnCb() const noexcept { return m_mean[1]; }
    [[nodiscard]] double slope() const noexcept { return m_mean[2]; }
    [[nodiscard]] double variance() const noexcept { return m_variance; }
    /// ρ of the ways as mixed.
    [[nodiscard]] double slopeMemory() const noexcept;
    /// Of the last force before it was taken.
    [[nodiscard]] double logLikelihood() const noexcept { return m_logLikelihood; }
    /// Probability that a step is being cut into.
    [[nodiscard]] double stepping() const noexcept { return m_ways[kWays - 1].probability; }

 private:
    struct Way {
        double probability{0.0};
        Eigen::Vector4d state{Eigen::Vector4d::Zero()};
        Eigen::Matrix4d covariance{Eigen::Matrix4d::Zero()};
    };
    struct Walk {
        double deviation;       ///< standard deviation of g per revolution
        double slopeDeviation;  ///< of v
        double slopeMemory;     ///< ρ
    };
    [[nodiscard]] static Walk walkOf(std::size_t way, double quiet) noexcept;
    static void turn(Way& way, std::size_t from, std::size_t to, double feed_mmPerRev, double quiet) noexcept;
    void mix(double feed_mmPerRev) noexcept;
    /// The time constant with which the tool follows, in revolutions.
    double predict(Way& way, const Walk& walk, double feed_mmPerRev, double knownChange) const noexcept;
    void combine() noexcept;

    StiffnessAssumptions m_assume{};
    double m_kx_NPerMm{1.0};
    double m_sin{0.0};
    double m_cos{0.0};
    double m_quiet{1.0};
    double m_lag_rev{1.0};  ///< of the last revolution predicted, > 0
    std::array<Way, kWays> m_ways{};
    std::array<double, kWays> m_share{};  ///< of each in the estimate
    Eigen::Vector4d m_mean{Eigen::Vector4d::Zero()};
    double m_variance{0.0};  ///< of g
    double m_logLikelihood{0.0};
};

}  // namespace kerf::milling
