// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/process/thermal/thermal_types.h"

/// When the machine is ready for a part: "ready for ±4 µm in 12 min".
namespace kerf::thermal {

struct WarmUpForecast {
    WarmUpState state{WarmUpState::Unknown};
    double ready_min{0.0};
};

/// What is known of one axis.
struct WarmUpAxis {
    std::array<double, 3> drift_um{};  ///< two intervals ago, one interval ago, now
    double half_um{0.0};               ///< of the prediction, 95 %
};

/// Drift settles as d(t) = d∞ + (d − d∞)·exp(−t/τ); three equally spaced values give what is left of it (Aitken):
///   q = (d₂ − d₁)/(d₁ − d₀),  left = (d₂ − d₁)·q/(1 − q),  after t: left·q^(t/h)
/// Not compensated, the drift still to come must fit into `allowed_um`; compensated, what comes in one period, beside
/// the interval. Ready when every axis is. A drift that does not settle (q ≥ 1) is Unknown.
/// @param interval_min h > 0; @param period_min > 0: of the compensation, 0: not compensated
[[nodiscard]] WarmUpForecast warmUpForecast(const std::array<WarmUpAxis, kAxisCount>& axes, double interval_min,
                                            double allowed_um, double period_min) noexcept;

}  // namespace kerf::thermal
