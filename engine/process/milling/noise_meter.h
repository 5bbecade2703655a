// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/process/milling/stiffness_filter.h"

namespace kerf::milling {

/// How noisy the averaged force is, learnt from the signal.
///
/// In the cut: filters that assume standard deviations of 1.5, 3, 6 … 192 N run side by side; the likelihood of what
/// they were surprised by, slowly forgotten, weighs them. (One filter that adapts its noise to its own surprises stays
/// where it is when a lively blank and a noisy force explain them equally well.) A single force says only so much, so a
/// step is not taken for noise.
/// In air: the scatter of the force there is what the weights start from.
///
/// Forces ≥ 0 in N as the law gets them, cut off at 0. All functions run in the cycle.
class NoiseMeter {
 public:
    static constexpr std::size_t kLevels = 8;

    explicit NoiseMeter(const StiffnessAssumptions& assumptions) noexcept;

    void air(double force_N) noexcept;
    /// What a noise is taken for until air has been measured, > 0.
    void expect(double noise_N) noexcept;
    /// The first revolution in the work.
    void begin(double force_N, double feed_mmPerRev, double kx_NPerMm) noexcept;
    /// A further one, with what is known of k_x so far.
    void update(double force_N, double feed_mmPerRev, double knownChange, double kx_NPerMm, double quiet) noexcept;
    void shift(double change) noexcept;

    [[nodiscard]] const StiffnessFilter::Noise& noise() const noexcept { return m_noise; }
    /// Force that air does not reach, as far as its scatter is known; 0 until it is.
    [[nodiscard]] double airReach_N() const noexcept;

 private:
    void judge() noexcept;

    StiffnessAssumptions m_assume{};
    StiffnessFilter::Noise m_noise{};
    double m_likelyLn_N{0.0};  ///< ln of the standard deviation before the cut says more
    double m_likelyWidth{1.0};
    std::array<StiffnessFilter, kLevels> m_filters{};
    std::array<double, kLevels> m_logWeight{};  ///< highest is 0
    static constexpr std::size_t kAirKept = 12;
    std::array<double, kAirKept> m_air_N{};  ///< last forces in air, newest first: the way into the work is not air
    std::size_t m_airKnown{0};
    double m_airSum_N2{0.0};  ///< of squared differences
    double m_airCount{0.0};
};

}  // namespace kerf::milling
