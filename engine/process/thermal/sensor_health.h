// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/core/reading.h"
#include "engine/process/thermal/thermal_model.h"

/// Finds sick thermocouples, names what is wrong, and leaves them out.
///
///   open      no reading, or above the range (a broken couple burns out upscale)
///   short     below the range, or far too cold and like the coldest sensor of the model (it reads its terminal)
///   stuck     the same value again and again, longer than ever in training
///   noisy     second differences far above the noise seen in training
///   offset    jumps away from what its neighbours expect of it, and stays there
///   disagrees drifts away from what its neighbours expect of it
///
/// The neighbours' opinion is the expectation of one rise given all others, from the mean products of rises in
/// training:
///   M = E[r·rᵀ] + slack²·I,  P = M⁻¹ over healthy sensors,  e_i = (P·r)_i / P_ii,  z_i = (P·r)_i / √P_ii
/// With one bad sensor the largest |z| is the bad one (the largest normalised residual of power-system bad-data
/// detection). slack keeps a thermal pattern never seen in training from accusing a sensor.
///
/// A verdict stays until reset(), but for open: a cable that was out, or a module that did not answer, comes back with
/// kReturning good readings in a row.
///
/// update() runs in the cycle: no allocation, lock, throw or I/O.
namespace kerf::thermal {

enum class SensorState : std::uint8_t { Healthy, Suspect, Open, Short, Stuck, Noisy, Offset, Disagrees };
[[nodiscard]] constexpr bool isSick(SensorState state) noexcept {
    return state > SensorState::Suspect;
}

struct HealthParams {
    double slack_K{0.35};         ///< > 0
    double zLimit{5.0};           ///< normalised residual that makes a suspect
    double residualLimit_K{1.5};  ///< and the smallest residual that does
    int confirmations{3};         ///< updates in a row until a suspect is sick
    double noiseFactor{6.0};      ///< × training noise
    double noiseFloor_K{0.5};
};

class SensorHealth {
 public:
    static constexpr int kReturning = 3;

    /// Not in the cycle. Copies what it needs.
    SensorHealth(const ThermalModel& model, const HealthParams& params = {});

    /// Forget everything seen, and every verdict.
    void reset() noexcept;
    /// A reading without a baseline yet: open, short and stuck only.
    void observe(std::size_t sensor, const Reading& reading, double dt_min) noexcept;
    /// After observe() of every sensor: the neighbours' opinion about the rises. Sick and unread sensors' rises are
    /// ignored.
    void compare(std::span<const double> rise_K) noexcept;

    [[nodiscard]] SensorState state(std::size_t sensor) const noexcept { return m_sensors[sensor].state; }
    /// Not to be used now: sick, suspect, or without a reading.
    [[nodiscard]] bool leftOut(std::size_t sensor) const noexcept {
        return m_sensors[sensor].state != SensorState::Healthy;
    }
    /// What the neighbours expect of this sensor's rise; valid for every sensor after compare(), 0 with no neighbour
    /// left.
    [[nodiscard]] double expectedRise_K(std::size_t sensor) const noexcept { return m_sensors[sensor].expected_K; }
    [[nodiscard]] std::size_t sensors() const noexcept { return m_count; }

 private:
    struct Sensor {
        double noise_K{0.0};
        int repeatLimit{0};
        SensorState state{SensorState::Healthy};
        bool read{false};
        int readings{0};
        int repeats{0};
        int suspicions{0};
        int returned{0};  ///< good readings in a row while open
        double last_degC{0.0};
        double beforeLast_degC{0.0};
        double curvature_K2{0.0};  ///< leaky mean of (second difference)²/6
        double residual_K{0.0};
        double firstResidual_K{0.0};
        double expected_K{0.0};
    };
    /// Precision of the sensors not left out; returns how many they are.
    std::size_t invertHealthy() noexcept;
    /// While open: whether the sensor is healthy again with this reading.
    [[nodiscard]] static bool comesBack(Sensor& sensor, const Reading& reading) noexcept;
    [[nodiscard]] SensorState nameOf(std::size_t sensor) const noexcept;

    HealthParams m_params;
    std::size_t m_count;
    std::array<Sensor, kMaxModelSensors> m_sensors{};
    std::array<double, kMaxModelSensors * kMaxModelSensors> m_moment{};
    std::array<double, kMaxModelSensors * kMaxModelSensors> m_work{};
    std::array<std::size_t, kMaxModelSensors> m_healthy{};
};

}  // namespace kerf::thermal
