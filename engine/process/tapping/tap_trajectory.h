// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace kerf::tapping {

/// Spindle command of one tap: to depth with equal ramps (trapezium, or triangle when the depth is short), reversal
/// at the bottom without a stop, and back.
class TapTrajectory {
 public:
    struct Point {
        double position_rev{0.0};
        double velocity_revPerS{0.0};
        double accel_revPerS2{0.0};
    };

    /// @pre all > 0
    TapTrajectory(double depth_rev, double speed_rpm, double ramp_revPerS2)
        : m_depth_rev(depth_rev), m_accel_revPerS2(ramp_revPerS2) {
        m_peak_revPerS = std::min(speed_rpm / 60.0, std::sqrt(ramp_revPerS2 * depth_rev));
        m_ramp_s = m_peak_revPerS / ramp_revPerS2;
        const double cruise_s = (depth_rev - m_peak_revPerS * m_ramp_s) / m_peak_revPerS;
        m_cruiseEnd_s = m_ramp_s + cruise_s;
        m_reversal_s = 2.0 * m_ramp_s + cruise_s;
    }

    [[nodiscard]] Point at(double time_s) const noexcept {
        if (time_s <= 0.0 || time_s >= end_s()) return {};
        if (time_s <= m_reversal_s) return inward(time_s);
        const Point mirrored = inward(time_s - m_reversal_s);
        return {m_depth_rev - mirrored.position_rev, -mirrored.velocity_revPerS, -mirrored.accel_revPerS2};
    }
    [[nodiscard]] double reversal_s() const noexcept { return m_reversal_s; }
    [[nodiscard]] double end_s() const noexcept { return 2.0 * m_reversal_s; }
    [[nodiscard]] double peakSpeed_revPerS() const noexcept { return m_peak_revPerS; }

 private:
    [[nodiscard]] Point inward(double time_s) const noexcept {
        if (time_s < m_ramp_s) {
            return {0.5 * m_accel_revPerS2 * time_s * time_s, m_accel_revPerS2 * time_s, m_accel_revPerS2};
        }
        if (time_s < m_cruiseEnd_s) {
            return {0.5 * m_peak_revPerS * m_ramp_s + m_peak_revPerS * (time_s - m_ramp_s), m_peak_revPerS, 0.0};
        }
        if (time_s <= m_reversal_s) {
            const double left_s = m_reversal_s - time_s;
            return {m_depth_rev - 0.5 * m_accel_revPerS2 * left_s * left_s, m_accel_revPerS2 * left_s,
                    -m_accel_revPerS2};
        }
        return {m_depth_rev, 0.0, 0.0};
    }

    double m_depth_rev;
    double m_accel_revPerS2;
    double m_peak_revPerS{0.0};
    double m_ramp_s{0.0};
    double m_cruiseEnd_s{0.0};
    double m_reversal_s{0.0};
};

}  // namespace kerf::tapping
