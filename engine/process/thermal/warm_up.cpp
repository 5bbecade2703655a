// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/warm_up.h"

#include <algorithm>
#include <cmath>

namespace kerf::thermal {
namespace {

constexpr double kNoise_um = 0.5;  // changes below it say nothing about how the drift settles
constexpr double kLongest_min = 24.0 * 60.0;

}  // namespace

WarmUpForecast warmUpForecast(const std::array<WarmUpAxis, kAxisCount>& axes, double interval_min, double allowed_um,
                              double period_min) noexcept {
    WarmUpForecast out{WarmUpState::Ready, 0.0};
    for (const WarmUpAxis& axis : axes) {
        const double before_um = axis.drift_um[1] - axis.drift_um[0];
        const double last_um = axis.drift_um[2] - axis.drift_um[1];
        const bool compensated = period_min > 0.0;
        const double room_um = allowed_um - (compensated ? axis.half_um : 0.0);
        if (room_um <= 0.0) {
            return {WarmUpState::TooWide, 0.0};
        }
        const double q = std::abs(before_um) > kNoise_um ? last_um / before_um : 0.0;
        const bool settles = q < 0.98;
        const double inPeriod_um = std::abs(last_um) * period_min / interval_min;
        double left_um = compensated ? inPeriod_um : std::abs(last_um);
        if (!compensated && q > 0.0 && settles) {
            left_um = std::max(left_um, std::abs(last_um) * q / (1.0 - q));
        }
        if (left_um <= room_um) {
            continue;
        }
        if (!settles || q <= 0.0) {
            return {WarmUpState::Unknown, 0.0};
        }
        const double wait_min = interval_min * std::log(left_um / room_um) / -std::log(q);
        if (wait_min > kLongest_min) {
            return {WarmUpState::Unknown, 0.0};
        }
        out.state = WarmUpState::Waiting;
        out.ready_min = std::max(out.ready_min, wait_min);
    }
    return out;
}

}  // namespace kerf::thermal
