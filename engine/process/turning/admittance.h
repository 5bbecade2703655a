// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/process/turning/revolution_buffer.h"

namespace kerf::turning {

/// Tool motion to force, and force back to tool motion.
///
///   F = (1 − µ)·[C·d(x_o − x_i)/dt + K·(d0 + x_o − x_i)],  x_o(k) = x_i(k − d)
///
/// µ overlap factor, K stiffness in N/µm, C damping in N·s/µm, d0 depth in µm; the derivative is the backward
/// difference over one sample. Sign: x_i grows into the outer surface and lowers the chip (x_o − x_i).
/// The inverse integrates the difference between two revolutions, so an error of the force stays for ever;
/// `leak` < 1 forgets x_o by that factor per revolution.
/// Source: Jeong & Kim, eqs. 3-5. @pre 0 ≤ µ < 1, K + C/T > 0, 0 < leak ≤ 1.
struct AdmittanceParams {
    double overlap{0.9555529619612392};
    double stiffness_NPerUm{5.399684896678685};
    double damping_NsPerUm{0.025283230457389654};
    double depth_um{6.0};
    double dt_s{0.0002};
};

/// x_i → F.
class AdmittanceForward {
 public:
    AdmittanceForward(const AdmittanceParams& params, std::size_t revolutionSamples) noexcept
        : m_params(params), m_surface(revolutionSamples) {}
    [[nodiscard]] double force_N(double inner_um) noexcept {
        const double change_um = m_surface.oldest() - inner_um;
        const double force =
            (1.0 - m_params.overlap) * (m_params.damping_NsPerUm * (change_um - m_lastChange_um) / m_params.dt_s +
                                        m_params.stiffness_NPerUm * (m_params.depth_um + change_um));
        m_lastChange_um = change_um;
        m_surface.push(inner_um);
        return force;
    }

 private:
    AdmittanceParams m_params;
    RevolutionBuffer m_surface;
    double m_lastChange_um{0.0};
};

/// F → x_i.
class AdmittanceInverse {
 public:
    AdmittanceInverse(const AdmittanceParams& params, std::size_t revolutionSamples, double leak = 1.0) noexcept
        : m_params(params), m_leak(leak), m_surface(revolutionSamples) {}
    [[nodiscard]] double inner_um(double force_N) noexcept {
        const double damping_NPerUm = m_params.damping_NsPerUm / m_params.dt_s;
        const double change_um = (force_N / (1.0 - m_params.overlap) + damping_NPerUm * m_lastChange_um -
                                  m_params.stiffness_NPerUm * m_params.depth_um) /
                                 (damping_NPerUm + m_params.stiffness_NPerUm);
        const double inner = m_leak * m_surface.oldest() - change_um;
        m_lastChange_um = change_um;
        m_surface.push(inner);
        return inner;
    }

 private:
    AdmittanceParams m_params;
    double m_leak;
    RevolutionBuffer m_surface;
    double m_lastChange_um{0.0};
};

}  // namespace kerf::turning
