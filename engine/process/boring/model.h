// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

/// Deflection law of a vertical boring spindle.
///
///   law       d = K·S^α·L^β·a^γ                      (1)   d deflection mm, S feed mm/rev, L overhang mm, a depth of
///   cut mm
///             d = C·S^α·L^β,  C = K·a^γ              (2)   at constant depth of cut
///   feed      S_opt(L) = (d0/C)^(1/α) / L^(β/α)      (3)   holds d = d0 at every L
///   linear    y = ln d = xᵀθ + v                     (4,7) x = (1, ln S, ln L), θ = (ln C, α, β), natural logarithms
///   first     β0 = [ln(d1/d2) − α0·ln(S1/S2)] / ln(L1/L2)          (9)  at one nominal feed the second term is zero
///   part      ln C0 = ln d1 − α0·ln S1 − β0·ln L1                  (10)
///   diameter  d = d0 + δ/(2·cos φ),  δ = target − measured         (11) undersize is +
///
/// Source: C.-W. Lee, "Adaptive control of CNC boring machine by application of the variance perturbation method"
/// (1983). Deviations: eq. 10 is garbled in print, this form follows from eq. 9; eq. 9 keeps the feeds apart, so that
/// two measurements cut at different feeds may begin as well.
namespace kerf::boring {

/// θ of eq. 7. lnC is ln of mm per (mm/rev)^α mm^β; α and β are dimensionless.
struct LawConstants {
    double lnC{0.0};
    double alpha{0.0};
    double beta{0.0};
    friend bool operator==(const LawConstants&, const LawConstants&) = default;
};

/// Table 1 of the paper: the built-in machine.
inline constexpr double kTableAlpha = 0.5025;
inline constexpr double kTableBeta = 0.2676;
inline constexpr double kTableGamma = 0.9777;
inline constexpr double kTableInverseK_perMm = 28.111;  ///< 1/K
inline constexpr double kTableDepthOfCut_mm = 2.5;
inline constexpr double kTableC = 0.0871;  ///< C of eq. 2, printed with the paper's rounding
inline constexpr double kTableOverhangFrom_mm = 40.0;
inline constexpr double kTableOverhangTo_mm = 310.0;
inline constexpr double kTableTargetDeflection_mm = 0.1165;
inline constexpr double kTableSigma_mm = 0.016231;  ///< standard deviation of a measured deflection
inline constexpr double kTablePhi_deg = 60.0;       ///< φ of eq. 11

/// One bore measurement as the estimators take it.
struct Measurement {
    double overhang_mm{0.0};    ///< > 0
    double feed_mmPerRev{0.0};  ///< > 0, really cut at this overhang
    double deflection_mm{0.0};  ///< > 0
    bool feedAtLimit{false};    ///< the wanted feed lay outside the range: d0 could not be reached here
    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// Eq. 1. @pre all positive
[[nodiscard]] double deflection_mm(double k, double alpha, double beta, double gamma, double feed_mmPerRev,
                                   double overhang_mm, double depthOfCut_mm) noexcept;
/// C of eq. 2 from K and the depth of cut.
[[nodiscard]] double constantC(double k, double gamma, double depthOfCut_mm) noexcept;
/// Eq. 2. @pre S > 0, L > 0
[[nodiscard]] double deflection_mm(const LawConstants& law, double feed_mmPerRev, double overhang_mm) noexcept;
/// Eq. 3, not clamped. @pre α ≠ 0, d0 > 0, L > 0
[[nodiscard]] double optimalFeed_mmPerRev(const LawConstants& law, double targetDeflection_mm,
                                          double overhang_mm) noexcept;
/// Eqs. 9-10. @pre overhangs differ, deflections and feeds positive
[[nodiscard]] LawConstants firstEstimate(double alpha0, const Measurement& first, const Measurement& second) noexcept;
/// Eq. 11. @pre |φ| < 90°
[[nodiscard]] double deflectionFromDiameter_mm(double measured_mm, double target_mm, double targetDeflection_mm,
                                               double phi_deg) noexcept;
/// Eq. 11 the other way round: the diameter that a deflection makes.
[[nodiscard]] double diameterFromDeflection_mm(double deflection_mm, double target_mm, double targetDeflection_mm,
                                               double phi_deg) noexcept;

}  // namespace kerf::boring
