// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/sensor_health.h"

#include <algorithm>
#include <cmath>

namespace kerf::thermal {
namespace {

constexpr double kNoiseMemory_min = 20.0;
constexpr int kSmallestRepeatLimit = 5;

/// In-place inverse of a symmetric positive definite n × n matrix in `a` (row-major, stride kMaxModelSensors):
/// Gauss-Jordan without pivoting, which such a matrix does not need.
void invertSpd(std::array<double, kMaxModelSensors * kMaxModelSensors>& a, std::size_t n) noexcept {
    const auto at = [&a](std::size_t row, std::size_t col) -> double& { return a[row * kMaxModelSensors + col]; };
    for (std::size_t k = 0; k < n; ++k) {
        const double pivot = 1.0 / at(k, k);
        at(k, k) = 1.0;
        for (std::size_t col = 0; col < n; ++col) {
            at(k, col) *= pivot;
        }
        for (std::size_t row = 0; row < n; ++row) {
            if (row == k) {
                continue;
            }
            const double factor = at(row, k);
            at(row, k) = 0.0;
            for (std::size_t col = 0; col < n; ++col) {
                at(row, col) -= factor * at(k, col);
            }
        }
    }
}

}  // namespace

SensorHealth::SensorHealth(const ThermalModel& model, const HealthParams& params)
    : m_params(params), m_count(std::min(model.sensors.size(), kMaxModelSensors)) {
    for (std::size_t i = 0; i < m_count; ++i) {
        m_sensors[i].noise_K = model.sensors[i].noise_K;
        m_sensors[i].repeatLimit = std::max(kSmallestRepeatLimit, 3 * model.sensors[i].longestRepeat);
        for (std::size_t j = 0; j < m_count; ++j) {
            m_moment[i * kMaxModelSensors + j] =
                model.riseMoment_K2(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +
                (i == j ? params.slack_K * params.slack_K : 0.0);
        }
    }
}

void SensorHealth::reset() noexcept {
    for (std::size_t i = 0; i < m_count; ++i) {
        Sensor fresh;
        fresh.noise_K = m_sensors[i].noise_K;
        fresh.repeatLimit = m_sensors[i].repeatLimit;
        m_sensors[i] = fresh;
    }
}

bool SensorHealth::comesBack(Sensor& sensor, const Reading& reading) noexcept {
    const bool good = reading.good() && reading.value >= kLowestTemp_degC && reading.value <= kHighestTemp_degC;
    sensor.returned = good ? sensor.returned + 1 : 0;
    if (sensor.returned < kReturning) {
        return false;
    }
    // What was before says nothing about what comes now: repeats and noise are counted anew.
    const Sensor before = sensor;
    sensor = Sensor{};
    sensor.noise_K = before.noise_K;
    sensor.repeatLimit = before.repeatLimit;
    return true;
}

void SensorHealth::observe(std::size_t sensor, const Reading& reading, double dt_min) noexcept {
    Sensor& s = m_sensors[sensor];
    if (isSick(s.state) && !(s.state == SensorState::Open && comesBack(s, reading))) {
        return;
    }
    s.read = false;
    if (!reading.good() || reading.value > kHighestTemp_degC) {
        s.state = SensorState::Open;
        return;
    }
    if (reading.value < kLowestTemp_degC) {
        s.state = SensorState::Short;
        return;
    }
    s.read = true;
    if (s.readings > 0) {
        s.repeats = reading.value == s.last_degC ? s.repeats + 1 : 0;
        if (s.repeats >= s.repeatLimit) {
            s.state = SensorState::Stuck;
            return;
        }
    }
    if (s.readings > 1) {
        const double second_K = reading.value - 2.0 * s.last_degC + s.beforeLast_degC;
        const double limit_K = std::max(m_params.noiseFactor * s.noise_K, m_params.noiseFloor_K);
        // One jump is an offset, not noise: its share is capped.
        const double curvature_K2 = std::min(second_K * second_K / 6.0, 4.0 * limit_K * limit_K);
        s.curvature_K2 += leakShare(dt_min, kNoiseMemory_min) * (curvature_K2 - s.curvature_K2);
        if (s.curvature_K2 > limit_K * limit_K && s.readings > static_cast<int>(kNoiseMemory_min / 2.0)) {
            s.state = SensorState::Noisy;
            return;
        }
    }
    s.beforeLast_degC = s.last_degC;
    s.last_degC = reading.value;
    ++s.readings;
}

std::size_t SensorHealth::invertHealthy() noexcept {
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
        if (!leftOut(i) && m_sensors[i].read) {
            m_healthy[n++] = i;
        }
    }
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t col = 0; col < n; ++col) {
            m_work[row * kMaxModelSensors + col] = m_moment[m_healthy[row] * kMaxModelSensors + m_healthy[col]];
        }
    }
    invertSpd(m_work, n);
    return n;
}

SensorState SensorHealth::nameOf(std::size_t sensor) const noexcept {
    const Sensor& s = m_sensors[sensor];
    double coldest_degC = kHighestTemp_degC;
    for (std::size_t i = 0; i < m_count; ++i) {
        if (i != sensor && m_sensors[i].read && !isSick(m_sensors[i].state)) {
            coldest_degC = std::min(coldest_degC, m_sensors[i].last_degC);
        }
    }
    if (s.residual_K < -2.0 * m_params.residualLimit_K && s.last_degC < coldest_degC + 1.0) {
        return SensorState::Short;
    }
    const bool steady = std::abs(s.residual_K - s.firstResidual_K) < 0.15 * std::abs(s.residual_K);
    return steady ? SensorState::Offset : SensorState::Disagrees;
}

void SensorHealth::compare(std::span<const double> rise_K) noexcept {
    // The last minute's suspects are looked at again with everyone else.
    for (std::size_t i = 0; i < m_count; ++i) {
        if (m_sensors[i].state == SensorState::Suspect) {
            m_sensors[i].state = SensorState::Healthy;
        }
    }
    std::size_t n = invertHealthy();
    for (std::size_t round = 0; round < m_count && n > 2; ++round) {
        double worst = m_params.zLimit;
        std::size_t accused = kMaxModelSensors;
        for (std::size_t row = 0; row < n; ++row) {
            double sum = 0.0;
            for (std::size_t col = 0; col < n; ++col) {
                sum += m_work[row * kMaxModelSensors + col] * rise_K[m_healthy[col]];
            }
            const double precision = m_work[row * kMaxModelSensors + row];
            const double z = std::abs(sum) / std::sqrt(precision);
            const double residual_K = sum / precision;
            if (z > worst && std::abs(residual_K) > m_params.residualLimit_K) {
                worst = z;
                accused = m_healthy[row];
                m_sensors[accused].residual_K = residual_K;
            }
        }
        if (accused == kMaxModelSensors) {
            break;
        }
        Sensor& s = m_sensors[accused];
        if (s.suspicions == 0) {
            s.firstResidual_K = s.residual_K;
        }
        s.state = SensorState::Suspect;
        if (++s.suspicions >= m_params.confirmations) {
            s.state = nameOf(accused);
        }
        n = invertHealthy();
    }
    for (std::size_t i = 0; i < m_count; ++i) {
        if (m_sensors[i].state == SensorState::Healthy) {
            m_sensors[i].suspicions = 0;
        }
    }
    // Expectations: for a healthy sensor given the other healthy ones; for one left out given all healthy ones.
    for (std::size_t i = 0; i < m_count; ++i) {
        m_sensors[i].expected_K = 0.0;
    }
    std::array<double, kMaxModelSensors> weighted{};
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t col = 0; col < n; ++col) {
            weighted[row] += m_work[row * kMaxModelSensors + col] * rise_K[m_healthy[col]];
        }
    }
    for (std::size_t row = 0; row < n; ++row) {
        const std::size_t i = m_healthy[row];
        m_sensors[i].expected_K = rise_K[i] - weighted[row] / m_work[row * kMaxModelSensors + row];
    }
    for (std::size_t i = 0; i < m_count; ++i) {
        if (leftOut(i)) {
            for (std::size_t row = 0; row < n; ++row) {
                m_sensors[i].expected_K += m_moment[i * kMaxModelSensors + m_healthy[row]] * weighted[row];
            }
        }
    }
}

}  // namespace kerf::thermal
