// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "engine/process/thermal/history.h"

/// What the models see of a machine: per sensor the temperature rise and two leaky means of it, and the spindle's heat.
///
///   rise      r = T − T0, T0 the mean over the baseline
///   leaky     m += (1 − exp(−dt/τ))·(r − m)            τ = 4 and 15 min
///   heat      h += (1 − exp(−dt/τ))·((n/1000)^1.5 − h)  τ = 4, 12 and 40 min, n in rpm
///
/// The leaky means say how fast a part warms, which "one step before" drowns in noise. The heat terms stand for the
/// shaft, whose temperature no thermocouple sees; 1.5 is the usual speed exponent of bearing friction power. All terms
/// are zero at the baseline, so an absolute temperature never enters. One code computes them for training and for the
/// cycle.
namespace kerf::thermal {

inline constexpr int kTermsPerSensor = 3;
inline constexpr int kSpeedTerms = 3;

struct FeatureSpec {
    std::array<double, 2> leak_min{4.0, 15.0};
    std::array<double, 3> speedLeak_min{4.0, 12.0, 40.0};
    double speedExponent{1.5};
    friend bool operator==(const FeatureSpec&, const FeatureSpec&) = default;
};

/// Share of the way a leaky mean goes in dt.
[[nodiscard]] inline double leakShare(double dt_min, double tau_min) noexcept {
    return -std::expm1(-dt_min / tau_min);
}

/// Features of one sensor over time.
struct SensorTerms {
    std::array<double, kTermsPerSensor> value{};  ///< rise and its two leaky means, K

    void update(double rise_K, double dt_min, const FeatureSpec& spec) noexcept {
        update(rise_K, {leakShare(dt_min, spec.leak_min[0]), leakShare(dt_min, spec.leak_min[1])});
    }
    /// With the shares of this step, the same for every sensor.
    void update(double rise_K, const std::array<double, 2>& share) noexcept {
        value[0] = rise_K;
        value[1] += share[0] * (rise_K - value[1]);
        value[2] += share[1] * (rise_K - value[2]);
    }
};

/// Heat of the spindle over time, (krpm)^1.5.
struct SpeedTerms {
    std::array<double, kSpeedTerms> value{};

    void update(double speed_rpm, double dt_min, const FeatureSpec& spec) noexcept {
        const double heat = std::pow(std::abs(speed_rpm) / 1000.0, spec.speedExponent);
        for (std::size_t k = 0; k < value.size(); ++k) {
            value[k] += leakShare(dt_min, spec.speedLeak_min[k]) * (heat - value[k]);
        }
    }
};

/// Mean over the baseline rows of each sensor, degC. @pre every baseline reading is present
[[nodiscard]] Eigen::VectorXd baselineOf(const ThermalHistory& history);

/// work rows × (3·sensors + 3): terms of sensor 0, sensor 1, …, then the heat terms (zero when no speed was recorded).
/// @pre whyNotTrainable(history) is empty
[[nodiscard]] Eigen::MatrixXd featureMatrix(const ThermalHistory& history, const FeatureSpec& spec);

/// work rows × (2·sensors): absolute temperature now, and one step before (the paper's inputs).
[[nodiscard]] Eigen::MatrixXd printedInputs(const ThermalHistory& history);

}  // namespace kerf::thermal
