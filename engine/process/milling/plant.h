// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/core/result.h"
#include "engine/core/units.h"

namespace kerf::milling {

/// Peripheral down-milling with a flexible tool: one machine, one tool, one material.
///
///   cutting force     F_c = C b l^m                                  (1, 7)
///   normal, feed      F_y = F_c sin θ = k_y δ_y,  F_x = F_c cos θ = k_x δ_x   (2-4, 8-11)
///   feed really cut   δ_x(i+1) = f_r(i) + δ_x(i) − l(i+1)            (5, 6)
///
/// Symbols: l feed really cut per revolution in mm, b radial depth of cut in mm, f_r feed of the axis per revolution in
/// mm, δ deflection of the tool in mm. Sign: forces ≥ 0 push the tool back along the feed (x) and away from the wall
/// (y). Source: Oh & Jeong, "A Study on the Improvement of Surface Waviness by Cutting Force Control", 1987. The
/// defaults are the calibrated plant "B0" of docs/milling.md; the paper does not print its constants.
struct PlantParams {
    double exponent{0.85};                              ///< m, (0, 1]
    double forceAngle_deg{45.0};                        ///< θ between F_c and the feed direction, (0, 90)
    double kx_NPerMm{35.0 * kNewtonPerKilogramForce};   ///< k_x, > 0
    double ky_NPerMm{150.0 * kNewtonPerKilogramForce};  ///< k_y, > 0
    double cuttingCoefficient{149.08481304245302 * kNewtonPerKilogramForce};  ///< C in N/mm^(1+m), > 0
    double toolRadius_mm{5.0};                                                ///< r, > 0

    /// Empty when the plant can be computed; else the sentence for the operator.
    [[nodiscard]] std::optional<Sentence> whyInvalid() const;
};

/// The tool after one revolution.
struct RevolutionState {
    double cutFeed_mmPerRev{0.0};  ///< l
    double forceC_N{0.0};          ///< F_c
    double forceY_N{0.0};          ///< F_y
    double deflectionX_mm{0.0};    ///< δ_x
    double deflectionY_mm{0.0};    ///< δ_y: how far the wall stays too high
};

/// l ≥ 0 with l + compliance·l^m = supply; 0 when supply ≤ 0. Newton from above on a concave function: monotonic.
///
/// compliance = C b cos θ / k_x ≥ 0 in mm^(1−m); supply = f_r + δ_x in mm; `tolerance`: of the last step, relative.
[[nodiscard]] double solveCutFeed_mmPerRev(double compliance, double supply_mm, double exponent,
                                           double tolerance = 1e-16) noexcept;

/// One revolution: depth `depth_mm`, axis feed `feed_mmPerRev`, deflection before `deflectionX_mm`. Pure.
[[nodiscard]] RevolutionState stepRevolution(const PlantParams& plant, double depth_mm, double deflectionX_mm,
                                             double feed_mmPerRev) noexcept;

/// The plant near one operating point: F_y(i+1) = a1 F_y(i) + b0 u(i), G(z) = b0/(z − a1) (12, 16-21).
///
/// The paper uses the secant r_a = C b l^(m−1); the tangent m·r_a is what a small change really meets.
/// μ = k_y/(r_a sin θ): the print drops sin θ, which equations 16-19 need.
struct LinearForm {
    double ra_NPerMm{0.0};  ///< r_a
    double mu{0.0};         ///< μ in l = μ δ_y
    double a1{0.0};
    double b0_NPerUnit{0.0};  ///< per unit of u, when one unit of u feeds `feedPerUnit_mmPerRev`
    double dcGain_NPerUnit{0.0};
    double a1Tangent{0.0};
    double b0Tangent_NPerUnit{0.0};
};

/// Linear form at depth b > 0 and cut feed l > 0 when one unit of u moves the axis by k_m T = `feedPerUnit_mmPerRev`.
[[nodiscard]] LinearForm linearForm(const PlantParams& plant, double depth_mm, double cutFeed_mmPerRev,
                                    double feedPerUnit_mmPerRev) noexcept;

/// Axial depth from which at least one flute always cuts: a = 2 r asin √(b / 2r) / tan β (31).
/// Tool radius r > 0, depth 0 < b ≤ 2r, helix angle 0 < β < 90°.
[[nodiscard]] double continuousAxialDepth_mm(double toolRadius_mm, double depth_mm, double helix_deg) noexcept;

}  // namespace kerf::milling
