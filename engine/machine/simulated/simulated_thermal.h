// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/core/latest_value.h"
#include "engine/core/random.h"
#include "engine/machine/simulated/simulated_process.h"
#include "engine/process/thermal/plant/thermal_plant.h"

namespace kerf {

/// The heat of the simulated machine (engine/thermal/plant) beside whatever it cuts: sixty-four thermocouples once a
/// second, three gap sensors while the test bar can be in the spindle, and a warm-up program.
///
/// The spindle speed is that of the running program, so this plant stands after the others in the machine's list. Heat
/// moves in steps of a second whatever the cycle, which keeps a thousandfold speed cheap. The gap sensors read
/// kGapAtRest_um plus the drift; with another process's tool in the spindle they read nothing. The work offset does
/// not move them: the bar is measured in machine coordinates.
class SimulatedThermal final : public SimulatedProcess {
 public:
    static constexpr double kGapAtRest_um = 500.0;
    static constexpr std::uint64_t kMachiningCentre = 1;  ///< seed of the built-in machine
    static constexpr std::uint64_t kDiamondLathe = 2;

    struct Params {
        std::uint64_t machineSeed{kMachiningCentre};
        std::uint64_t daySeed{1};
        std::uint64_t hardSeed{0};  ///< > 0: a machine that bites (thermal::hardThermal); 0: the reference machine
        thermal::Season season{thermal::Season::None};
    };
    /// What the machine remembers between two runs of the program.
    struct Memory {
        thermal::ThermalPlant::State plant{};
        std::array<double, kAxisCount> workOffset_um{};
    };

    explicit SimulatedThermal(const Params& params) noexcept;
    /// Go on where the machine was; before the first cycle.
    void resume(const Memory& memory) noexcept;
    /// Any one thread: newest memory, once a minute of machine time; empty when there is nothing new.
    [[nodiscard]] std::optional<Memory> newMemory() noexcept;

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Thermal; }
    void fit(Capabilities& capabilities) const override;
    /// Warm-up: spindleSpeed_rpm for `revolutions` turns.
    [[nodiscard]] Result<void> begin(const StartProgram& program, std::uint32_t partSequence) noexcept override;
    void abort() noexcept override { m_left_rev = 0.0; }
    [[nodiscard]] std::optional<std::array<double, kAxisCount>> keptWorkOffset_um() const noexcept override {
        return m_keptOffset_um;
    }
    bool advance(const SimulationStep& step, MachineInputs& inputs) noexcept override;

    /// Truth, for tests.
    [[nodiscard]] const thermal::ThermalPlant& plant() const noexcept { return m_plant; }

 private:
    void refresh(const SimulationStep& step, bool barInSpindle) noexcept;
    void readCouples(const SimulationStep& step) noexcept;

    thermal::ThermalPlant m_plant;
    Random m_faultNoise{7};
    TemperatureFrame m_frame{};
    std::array<Reading, kAxisCount> m_gap_um{};
    std::optional<std::array<double, kAxisCount>> m_keptOffset_um{};
    LatestValue<Memory> m_memory{};
    double m_owed_s{1.0};  ///< the first frame is there at once
    double m_turned_rev{0.0};
    double m_left_rev{0.0};
    double m_speed_rpm{0.0};
    std::uint32_t m_sinceMemory_s{0};
};

}  // namespace kerf
