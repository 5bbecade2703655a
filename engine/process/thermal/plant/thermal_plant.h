// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/core/random.h"
#include "engine/port/machine_port.h"
#include "engine/process/thermal/plant/hard_thermal.h"

/// A vertical machining centre as eighteen lumps of heat, sixty-four thermocouples and three gap sensors.
///
///   C_i·dT_i/dt = Σ_j G_ij·(T_j − T_i) + H_i·(T_room − T_i) + Q_i          explicit steps of at most 5 s
///   Q_bearing   = q·(n/1000)^1.5·exp(−β·(T_bearing − 20))                 friction falls as the grease thins
///   Q_motor     = m·n/1000
///   drift_a     = Σ_i k_ai·(T_i − T_i at the reference)                    µm, > 0 along +axis
///
/// n spindle speed, rpm. The shaft has no thermocouple. The fan of the motor blows over the right side of the head
/// while the spindle turns, so head and column bend. Room temperature: a mean, a swing over hours and a slow wander,
/// all from the seed. Thermocouples: σ .05-.10 K, offsets up to .5 K, two badly mounted (half the room, and slow).
/// Figures are our own choice of a machine with about 10 K rise and 10/30/27 µm drift over a shift; they fit no
/// maker's.
///
/// Everything runs in the cycle: no allocation, lock, throw or I/O. Same seed, same machine and day.
namespace kerf::thermal {

enum class PlantNode : std::uint8_t {
    FrontBearing,
    RearBearing,
    Shaft,
    Quill,
    Motor,
    HeadLeft,
    HeadRight,
    ColumnUpper,
    ColumnLower,
    ColumnBack,
    ColumnLeft,
    ColumnRight,
    Bed,
    Saddle,
    Table,
    ScrewZ,
    ScrewY,
    ScrewX,
};

class ThermalPlant {
 public:
    /// `machineSeed` makes the machine (offsets, mounting), `daySeed` the room and the noise of one day.
    ThermalPlant(std::uint64_t machineSeed, std::uint64_t daySeed) noexcept;
    /// The same with what bites; `hard` as it is by default changes no digit.
    ThermalPlant(std::uint64_t machineSeed, std::uint64_t daySeed, const HardThermal& hard) noexcept;

    /// Everything at room temperature, time 0, drift reference here.
    void restart(std::uint64_t daySeed) noexcept;
    /// Let `dt_s` ≥ 0 pass with the spindle at this speed.
    void advance(double speed_rpm, double dt_s) noexcept;
    /// The drift is counted from now on.
    void setReference() noexcept;

    [[nodiscard]] double room_degC() const noexcept { return m_room_degC; }
    [[nodiscard]] double temp_degC(PlantNode node) const noexcept {
        return m_temp_degC[static_cast<std::size_t>(node)];
    }
    /// True drift of the origin since the reference, µm, X Y Z.
    [[nodiscard]] std::array<double, kAxisCount> drift_um() const noexcept;
    /// One reading of every thermocouple, with its own noise.
    [[nodiscard]] std::array<double, kMaxTemperatures> readThermocouples() noexcept;
    /// Where a thermocouple sits; empty: it hangs in the room.
    [[nodiscard]] static std::optional<PlantNode> nodeOf(std::size_t couple) noexcept;

    /// All that a machine remembers between two runs of the program.
    struct State {
        std::array<double, kPlantNodes> temp_degC{};
        std::array<double, kPlantNodes> reference_degC{};
        std::array<double, kMaxTemperatures> couple_degC{};
        double time_s{0.0};
        double wander_K{0.0};
    };
    [[nodiscard]] State state() const noexcept;
    /// Go on where that machine was; the room's day stays the one of the seed.
    void resume(const State& state) noexcept;

    /// One measurement of the drift by the three gap sensors: σ .5 µm.
    [[nodiscard]] std::array<double, kAxisCount> measureDrift() noexcept;

 private:
    void step(double speed_rpm, double dt_s) noexcept;
    void stepBy(double dt_s) noexcept;
    void moveRoom(double dt_s) noexcept;
    void addSeason(std::array<double, kPlantNodes>& heat_W) const noexcept;

    struct Thermocouple {
        std::size_t node{0};
        double noise_K{0.0};
        double offset_K{0.0};
        double contact{1.0};  ///< 1: reads its node; .5: half the room
        double lag_s{0.0};
        double share{0.0};  ///< of the way to its target in a step
        double value_degC{0.0};
    };
    HardThermal m_hard{};
    /// Steps mostly have one length: what depends on it alone is kept for the next.
    double m_step_s{-1.0};
    double m_kept{1.0};     ///< of the room's wander after a step
    double m_stirred{0.0};  ///< … and what a step adds to it, of its spread
    std::array<Thermocouple, kMaxTemperatures> m_couples{};
    std::array<double, kPlantNodes> m_temp_degC{};
    std::array<double, kPlantNodes> m_reference_degC{};
    Random m_random{0};
    double m_time_s{0.0};
    double m_room_degC{22.0};
    double m_roomMean_degC{22.0};
    double m_roomSwing_K{0.0};
    double m_roomPhase{0.0};
    double m_wander_K{0.0};
};

}  // namespace kerf::thermal
