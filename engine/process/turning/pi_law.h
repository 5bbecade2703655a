// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/result.h"

namespace kerf::turning {

/// The paper's PI: C(z) = ((k_p + k_i) − k_p·z⁻¹)/(1 − z⁻¹), command w = −gain·C·e.
///
/// k_p 10 and the zero at .6 give k_i = k_p·(1/.6 − 1) = 6.6667 (eq. 6). e in µm, w in µm. `gain` carries the sign of
/// the way from w to e and the scale of the plant (paper: 1 − µ).
struct PiGains {
    double proportional{10.0};
    double integral{10.0 / 0.6 - 10.0};
    double gain{0.02};

    [[nodiscard]] constexpr double now() const noexcept { return proportional + integral; }  ///< of e(k)
    [[nodiscard]] constexpr double before() const noexcept { return -proportional; }         ///< of e(k−1)
};

class PiLaw {
 public:
    explicit constexpr PiLaw(const PiGains& gains) noexcept : m_gains(gains) {}
    /// The part of w(k) that e(k) cannot change: w(k) = memory − gain·now·e(k).
    [[nodiscard]] constexpr double memory_um() const noexcept {
        return m_command_um - m_gains.gain * m_gains.before() * m_error_um;
    }
    [[nodiscard]] constexpr double slope() const noexcept { return m_gains.gain * m_gains.now(); }
    constexpr double update(double error_um) noexcept {
        m_command_um = memory_um() - slope() * error_um;
        m_error_um = error_um;
        return m_command_um;
    }
    /// Answer within the sample: e = offset + lineSlope·w and w = memory − slope·e solved together; returns w.
    constexpr double updateExact(double offset_um, double lineSlope) noexcept {
        const double error_um = (offset_um + lineSlope * memory_um()) / (1.0 + lineSlope * slope());
        return update(error_um);
    }
    /// Take this command as the last one (limits, a held output): the integral follows.
    constexpr void track(double command_um) noexcept { m_command_um = command_um; }
    /// Only this much more of the command has really acted (limits): the integral follows.
    constexpr void shift(double more_um) noexcept { m_command_um += more_um; }
    constexpr void reset() noexcept { m_command_um = m_error_um = 0.0; }

 private:
    PiGains m_gains;
    double m_command_um{0.0};
    double m_error_um{0.0};
};

}  // namespace kerf::turning
