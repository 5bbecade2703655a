// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/process/milling/blank_profile.h"
#include "engine/process/milling/plant.h"

namespace kerf::milling {

/// The plant between revolutions: a tool that is moved and turned by somebody else cuts a blank and bends.
///
///   L + K (n dt)^−m L^m = v dt + δ_x,  K = C b cos θ / k_x
/// with L the length cut in this step, v dt the axis' movement and n dt the part of a revolution turned: equation 5 of
/// docs/milling.md for a part of a revolution; dt = T gives it back exactly. Lengths mm, forces N ≥ 0.
class MovingCut {
 public:
    /// Tool and axis at `axis_mm`, not bent. `coefficient`: C with wear.
    void begin(const PlantParams& plant, const BlankProfile& blank, double coefficient, double axis_mm) noexcept {
        m_plant = plant;
        m_blank = blank;
        m_coefficient = coefficient;
        const double theta = plant.forceAngle_deg * std::numbers::pi / 180.0;
        m_cos = std::cos(theta);
        m_tan = std::tan(theta);
        m_turned_rev = 0.0;
        m_axis_mm = axis_mm;
        m_tip_mm = axis_mm;
        leaveWork();
    }
    /// `sharpness` scales C: a broken tool hardly cuts.
    void step(double moved_mm, double turned_rev, double sharpness) noexcept {
        m_axis_mm += moved_mm;
        if (turned_rev <= 0.0) {
            m_tip_mm = m_axis_mm - m_deflection_mm;  // a standing tool does not cut
            return;
        }
        if (turned_rev != m_turned_rev) {  // at one speed it is taken once
            m_turned_rev = turned_rev;
            m_perTurn = std::pow(turned_rev, -m_plant.exponent);
        }
        m_depth_mm = m_blank.engagedDepth_mm(m_tip_mm, m_plant.toolRadius_mm);
        const double compliance = m_coefficient * sharpness * m_depth_mm * m_cos / m_plant.kx_NPerMm;
        const double supply_mm = moved_mm + m_deflection_mm;
        const double cut_mm = solveCutFeed_mmPerRev(compliance * m_perTurn, supply_mm, m_plant.exponent);
        m_deflection_mm = std::max(0.0, supply_mm - cut_mm);
        m_force_N = m_deflection_mm * m_plant.kx_NPerMm * m_tan;
        m_tip_mm += cut_mm;
    }
    void leaveWork() noexcept {
        m_deflection_mm = 0.0;
        m_force_N = 0.0;
        m_depth_mm = 0.0;
    }

    [[nodiscard]] double axis_mm() const noexcept { return m_axis_mm; }
    [[nodiscard]] double tip_mm() const noexcept { return m_tip_mm; }
    [[nodiscard]] double force_N() const noexcept { return m_force_N; }
    /// Engaged depth of the last step.
    [[nodiscard]] double depth_mm() const noexcept { return m_depth_mm; }

 private:
    PlantParams m_plant{};
    BlankProfile m_blank{};
    double m_coefficient{0.0};
    double m_cos{1.0};  ///< of θ
    double m_tan{0.0};
    double m_turned_rev{0.0};
    double m_perTurn{0.0};  ///< (n dt)^−m
    double m_axis_mm{0.0};
    double m_tip_mm{0.0};
    double m_deflection_mm{0.0};
    double m_force_N{0.0};
    double m_depth_mm{0.0};
};

}  // namespace kerf::milling
