// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/process/thermal/history.h"
#include "engine/process/thermal/plant/hard_thermal.h"

/// Days of the simulated machine as training and test data.
namespace kerf::thermal {

struct SimulatedDayOptions {
    std::uint64_t machineSeed{1};
    std::uint64_t daySeed{1};
    int minutes{360};
    double warmSpeed_rpm{0.0};  ///< > 0: the machine ran at this speed before the baseline
    double warm_min{120.0};
    double pause_min{15.0};
    std::uint64_t hardSeed{0};  ///< > 0: a machine that bites (see HardThermal)
    Season season{Season::None};
};

struct SimulatedDay {
    ThermalHistory history{};
    std::vector<double> room_degC{};  ///< per row
};

/// Five baseline rows, then one row a minute: the state at its minute and the spindle speed from then on. The drift is
/// counted from the middle of the baseline. Sensors are named T00…T63. Not for the cycle.
/// @param speed_rpm spindle speed from minute t on
[[nodiscard]] SimulatedDay simulateDay(const SimulatedDayOptions& options,
                                       const std::function<double(int t_min)>& speed_rpm);

/// Days of different histories a model of that machine is trained on: random speeds, a stair, runs with pauses, slow
/// work. The speed of a row is that of the minute before it, as the loop knows it.
inline constexpr std::size_t kTrainingDays = 4;
[[nodiscard]] const char* trainingDayLabel(std::size_t day);
[[nodiscard]] ThermalHistory trainingDay(std::uint64_t machineSeed, std::size_t day, std::uint64_t hardSeed = 0);
[[nodiscard]] std::vector<ThermalHistory> trainingDays(std::uint64_t machineSeed, std::uint64_t hardSeed = 0);

}  // namespace kerf::thermal
