// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace kerf::turning {

/// What comes next of a disturbance that is no tone: prediction of the next sample from the samples so far.
///
///   v(k) = Σ α_i φ_i(k),  φ_i = low passes of r with poles .0 to .996
///   α minimises Σ λ^n (r(k+1) − v(k))² + ρ Σ λ^n (v(k) − v(k−1))²  over the last .4 s
///
/// The second sum is what one sample more delay than modelled would cost: it keeps the gain down where the phase is not
/// sure. α is solved anew every 5 ms, smoothed over 10 ms, and scaled down until |V/R|·|e^{jω} − 1| stays below 1 at
/// every frequency and |V/R| below 7: so the loop is stable with a path that is a sample later (small gain). A
/// disturbance of which less than 4 % can be foreseen is left alone. Units µm. update() runs in the cycle: no
/// allocation, lock, throw or I/O.
class BroadbandPredictor {
 public:
    static constexpr std::size_t kFilters = 6;

    BroadbandPredictor() noexcept { reset(); }
    void reset() noexcept;
    /// What was seen so far counts this much less, 0 … 1: r is another signal from now on. The weights stay until then.
    void forget(double share) noexcept;
    /// r of this sample, µm; returns v, the prediction of the next one.
    double update(double value_um) noexcept;
    /// What is foreseen of the next sample.
    [[nodiscard]] double prediction_um() const noexcept { return m_prediction_um; }
    /// r minus what was foreseen of it, of the last sample.
    [[nodiscard]] double error_um() const noexcept { return m_error_um; }
    /// α, of what acts.
    [[nodiscard]] std::array<double, kFilters> weights() const noexcept;
    /// V(e^{jω})/R(e^{jω}) with these α.
    [[nodiscard]] static std::complex<double> response(const std::array<double, kFilters>& weights,
                                                       double omega_radPerSample) noexcept;

 private:
    void learn(double value_um) noexcept;
    void solve() noexcept;

    std::array<double, kFilters> m_phi{};
    std::array<double, kFilters> m_before{};  ///< φ one sample earlier
    std::array<std::array<double, kFilters>, kFilters> m_normal{};
    std::array<double, kFilters> m_cross{};
    std::array<double, kFilters> m_target{};
    std::array<double, kFilters> m_weight{};
    double m_power_um2{0.0};
    double m_missed_um2{0.0};
    double m_doubt_um2{0.0};  ///< κ
    double m_worth{0.0};      ///< 0 … 1
    double m_full_um{0.0};    ///< prediction with the whole target weights
    double m_prediction_um{0.0};
    double m_error_um{0.0};
    std::size_t m_samples{0};
};

}  // namespace kerf::turning
