// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "engine/core/result.h"
#include "engine/process/turning/cutting_process.h"

namespace kerf::turning {

/// How old information is forgotten.
enum class Forgetting : std::uint8_t {
    Plain,           ///< the paper's, eqs. 8-11: P grows as λ⁻ᵏ without excitation and loses its symmetry
    Symmetric,       ///< the same, P symmetrised each step
    Directional,     ///< forgets only where new information arrives (Kulhavý 1987)
    TraceLimit,      ///< no forgetting while trace P/λ would exceed `limit`
    ConstantTrace,   ///< trace P held at `limit`
    VariableFactor,  ///< λ = max(λ, 1 − e²/((1 + φᵀPφ)·limit)) (Fortescue et al. 1981)
    DeadZone,        ///< no update while |e| ≤ limit
    Robust,          ///< the default: see ProcessIdentifier
};

/// Recursive least squares for the cutting process.
///
///   φ = [F(k−1), u(k), u(k−1)], θ = [a1, b0, b1], e = F − φᵀθ
///   m = Pφ/(λ + φᵀPφ), θ += m·e, P = (P − m·φᵀP)/λ
///
/// u uncut chip in µm, F force in N. Source: Jeong & Kim, eqs. 8-11, λ = .9, P(0) = 10⁴·I, θ(0) = 0.
/// `Robust` differs in three ways. (1) It forgets by λ only while P times the residual's own variance still holds every
/// parameter to a standard deviation of .0025; so the memory is as short as the noise allows and P stays bounded
/// without excitation. (2) φ takes the model's force instead of the measured one (output-error form): sensor noise then
/// neither biases a1 nor passes for excitation. (3) When the residual's power jumps above six times its usual value,
/// the process has moved: φ is measured again and forgetting is free until the residual is noise again. Directional
/// forgetting is as still without excitation, but needs some 1,400 samples to follow a moved process and drifts over
/// days (docs/turning.md). Samples that are not finite are ignored; P is symmetric at any time. update() runs in the
/// cycle: no allocation, lock, throw or I/O.
class ProcessIdentifier {
 public:
    struct Params {
        double forgetting{0.9};  ///< λ, [.5, 1]
        Forgetting method{Forgetting::Robust};
        double initialVariance{1e4};  ///< P(0) = this·I, (0, 1e9]
        double limit{0.0};            ///< of the method, where it has one
    };
    /// An estimate with the half width of its 95 % interval.
    struct Estimate {
        ProcessParams process{};
        Eigen::Vector3d half95{Eigen::Vector3d::Zero()};
    };

    /// Reason for the operator; empty if usable.
    [[nodiscard]] static std::optional<Sentence> whyInvalid(const Params& params);
    explicit ProcessIdentifier(const Params& params) noexcept;  ///< @pre !whyInvalid(params)

    void update(double force_N, double chip_um) noexcept;
    void reset() noexcept;
    /// Begin from a known process, with the force and the chip of the sample before: in mid-cut, without a jolt.
    void start(const ProcessParams& process, double variance, double force_N = 0.0, double chip_um = 0.0) noexcept;

    [[nodiscard]] const Eigen::Vector3d& theta() const noexcept { return m_theta; }
    [[nodiscard]] const Eigen::Matrix3d& covariance() const noexcept { return m_p; }
    [[nodiscard]] double trace() const noexcept { return m_p.trace(); }
    [[nodiscard]] Estimate estimate() const noexcept;
    /// Variation of the chip over the last ~50 samples, as force, over the residual noise: below about 1 nothing but
    /// the gain at rest can be learned.
    [[nodiscard]] double excitation() const noexcept;
    /// RMS of the residual over the last ~200 samples, N.
    [[nodiscard]] double residual_N() const noexcept;

 private:
    void updateDirectional(const Eigen::Vector3d& pPhi, double information, double error_N, double forgetting) noexcept;
    void updateRobust(double force_N, double measuredBefore_N, double chip_um, double chipBefore_um) noexcept;
    void noteExcitation(double chip_um) noexcept;

    Params m_params;
    Eigen::Vector3d m_theta{Eigen::Vector3d::Zero()};
    Eigen::Matrix3d m_p{Eigen::Matrix3d::Zero()};
    double m_lastForce_N{0.0};
    double m_lastChip_um{0.0};
    double m_chipMean_um{0.0};
    double m_chipVariance_um2{0.0};
    double m_shortVariance_N2{0.0};
    double m_noise_N2{0.0};
    double m_modelForce_N{0.0};
    std::uint64_t m_sinceSurprise{0};
    std::uint64_t m_samples{0};
};

}  // namespace kerf::turning
