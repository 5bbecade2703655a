// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

namespace kerf::turning {

inline constexpr double kSampleRate_Hz = 5000.0;  ///< the paper's and the loop's

/// Parameters of the cutting process: F(k) = a1·F(k−1) + b0·u(k) + b1·u(k−1), u uncut chip in µm, F normal force in N.
///
/// b0, b1 in N/µm, a1 without unit. Source: Jeong & Kim, eqs. 7 and 12 (copper, 17.2 rev/s, 5 kHz).
struct ProcessParams {
    double a1{0.8725};
    double b0{0.7470};
    double b1{-0.7164};

    [[nodiscard]] constexpr double dcGain() const noexcept { return (b0 + b1) / (1.0 - a1); }  ///< N/µm
    /// P(e^{jω}), N/µm.
    [[nodiscard]] std::complex<double> response(double omega_radPerSample) const noexcept {
        const std::complex<double> back = std::polar(1.0, -omega_radPerSample);
        return (b0 + b1 * back) / (1.0 - a1 * back);
    }
    /// Stable, invertible (zero inside the unit circle) and of positive gain: what every law below needs.
    [[nodiscard]] constexpr bool usable() const noexcept {
        return a1 > -1.0 && a1 < 1.0 && b0 > 0.0 && -b1 < b0 && b1 < b0 && dcGain() > 0.0;
    }
};

/// The process with its memory. `offer` gives the force without keeping it, for exact algebraic loops.
class CuttingProcess {
 public:
    explicit constexpr CuttingProcess(const ProcessParams& params) noexcept : m_params(params) {}

    /// The part of F(k) that u(k) cannot change: a1·F(k−1) + b1·u(k−1), N.
    [[nodiscard]] constexpr double memory_N() const noexcept {
        return m_params.a1 * m_force_N + m_params.b1 * m_chip_um;
    }
    constexpr double step(double chip_um) noexcept {
        m_force_N = memory_N() + m_params.b0 * chip_um;
        m_chip_um = chip_um;
        return m_force_N;
    }
    /// The chip that explains this force, kept as this sample's chip: the admittance direction of P.
    constexpr double invert(double force_N) noexcept {
        m_chip_um = (force_N - memory_N()) / m_params.b0;
        m_force_N = force_N;
        return m_chip_um;
    }
    [[nodiscard]] constexpr const ProcessParams& params() const noexcept { return m_params; }
    constexpr void setParams(const ProcessParams& params) noexcept { m_params = params; }
    /// The same force is now another chip: the memory is put over, so that invert() goes on without a step.
    constexpr void retune(const ProcessParams& params) noexcept {
        m_chip_um *= m_params.dcGain() / params.dcGain();
        m_params = params;
    }
    /// Start in the steady state of a chip.
    constexpr void settle(double chip_um) noexcept {
        m_chip_um = chip_um;
        m_force_N = m_params.dcGain() * chip_um;
    }

 private:
    ProcessParams m_params;
    double m_force_N{0.0};
    double m_chip_um{0.0};
};

}  // namespace kerf::turning
