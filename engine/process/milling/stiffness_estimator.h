// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/core/units.h"
#include "engine/process/milling/milling_types.h"
#include "engine/process/milling/stiffness_filter.h"

namespace kerf::milling {

/// ln(C b), C b in N/mm^m, with its 95 % interval.
struct StiffnessEstimate {
    bool valid{false};  ///< false until the tool has cut under a trusted force
    double lnCb{0.0};
    double slope{0.0};        ///< change expected per revolution
    double half95{0.0};       ///< half width of the 95 % interval of lnCb
    double force_N{0.0};      ///< F_y freed from measurement noise
    double kx_NPerMm{0.0};    ///< stiffness of the tool along the feed that explains the cut best
    double noise_N{0.0};      ///< standard deviation of one averaged force, as learnt
    double quiet{1.0};        ///< how clean the force is, 1 … 0
    double stepping{0.0};     ///< probability that a step is being cut into
    double slopeMemory{0.0};  ///< share of the slope left after a revolution
    int ahead{0};             ///< revolutions predicted since the last force
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
    static constexpr std::size_t kStiff = 3;  ///< of them, for tools that hardly give way
    struct Params {
        StiffnessAssumptions assume{};
        double softest_NPerMm{22.0 * kNewtonPerKilogramForce};  ///< k_x of the first filter
        double ratio{1.5};                                      ///< from filter to filter; 1: one k_x only
        double stiffRatio{3.0};                                 ///< … of the last ones, where k_x matters less
        double likely_NPerMm{70.0 * kNewtonPerKilogramForce};   ///< centre of the weights before anything was cut
        double likelyWidth{0.8};                                ///< their standard deviation in ln k_x
        double airForce_N{20.0};                                ///< below: the tool does not cut
        double reference_N{40.0 * kNewtonPerKilogramForce};     ///< what a noise counts against, > 0
    };
    explicit StiffnessEstimator(const Params& params) noexcept;
    /// ln of the k_x that a filter of the bank assumes, in N/mm.
    [[nodiscard]] static double lnKxOf(std::size_t filter, const Params& params) noexcept;

    /// How noisy the force is, as learnt before this revolution and with it (NoiseMeter).
    struct Noise {
        double before_N{0.0};
        StiffnessFilter::Noise now{};
    };
    /// One revolution with a trusted force and the feed the axis made in it; `knownChange` see StiffnessFilter.
    void update(double force_N, double feed_mmPerRev, double knownChange, const Noise& noise) noexcept;
    /// One revolution without a trusted force: predicted only, the interval widens.
    void coast(double feed_mmPerRev, const Noise& noise) noexcept;
    /// The period of the law has changed: ln(C b) of the new one is larger by this.
    void shift(double change) noexcept;
    /// Forget the cut (the tool has left the work); what was learnt of k_x stays.
    void leaveWork() noexcept;
    /// What was learnt of k_x: to keep it over a change of setup or a restart. Weights that are no numbers are refused.
    [[nodiscard]] const std::array<double, kFilters>& kxLogWeights() const noexcept { return m_logWeight; }
    bool setKxLogWeights(const std::array<double, kFilters>& weights) noexcept;
    [[nodiscard]] const StiffnessEstimate& estimate() const noexcept { return m_estimate; }
    /// The estimate after these feeds as well, of revolutions whose force has not arrived.
    [[nodiscard]] StiffnessEstimate after(std::span<const double> feeds_mmPerRev) const noexcept;
    /// Of the last force before it was taken, over all filters.
    [[nodiscard]] double logLikelihood() const noexcept { return m_logLikelihood; }
    /// Another reference: the same noise counts as more or less of it.
    void setReference(double reference_N, const Noise& noise) noexcept;
    /// How clean a force of this noise is to the filters, 1 … 0.
    [[nodiscard]] double filterQuiet(double noise_N) const noexcept;

 private:
    struct Quiet {
        double share;  ///< of the reference: noise at which a force is neither quiet nor noisy
        double power;  ///< how sharply the one turns to the other
    };
    static const Quiet kLawQuiet, kFilterQuiet;
    void begin(double force_N, double feed_mmPerRev, double noise_N2) noexcept;
    void weigh(double force_N, double feed_mmPerRev, double knownChange, const Noise& noise) noexcept;
    void combine(const Noise& noise) noexcept;
    [[nodiscard]] double quiet(const Quiet& quiet, double noise_N) const noexcept;

    Params m_params;
    std::array<StiffnessFilter, kFilters> m_filters{};
    std::array<double, kFilters> m_lnKx{};
    std::array<double, kFilters> m_logWeight{};  ///< highest is 0
    StiffnessEstimate m_estimate{};
    double m_logLikelihood{0.0};
};

}  // namespace kerf::milling
