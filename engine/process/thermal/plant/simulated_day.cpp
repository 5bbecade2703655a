// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/plant/simulated_day.h"

#include <algorithm>
#include <array>
#include <string>

#include "engine/process/thermal/plant/thermal_plant.h"

namespace kerf::thermal {
namespace {

constexpr int kBaseline_min = 5;
constexpr double kMinute_s = 60.0;

std::string sensorName(std::size_t k) {
    return std::string("T") + static_cast<char>('0' + k / 10) + static_cast<char>('0' + k % 10);
}

}  // namespace

SimulatedDay simulateDay(const SimulatedDayOptions& options, const std::function<double(int)>& speed_rpm) {
    ThermalPlant plant(options.machineSeed, options.daySeed,
                       hardThermal(options.hardSeed, options.season, options.daySeed));
    if (options.warmSpeed_rpm > 0.0) {
        plant.advance(options.warmSpeed_rpm, options.warm_min * kMinute_s);
        plant.advance(0.0, options.pause_min * kMinute_s);
    }
    const Eigen::Index rows = kBaseline_min + options.minutes;
    constexpr auto kSensors = static_cast<Eigen::Index>(kMaxTemperatures);
    SimulatedDay day;
    ThermalHistory& history = day.history;
    history.label = "simulated day " + std::to_string(options.daySeed);
    for (std::size_t k = 0; k < kMaxTemperatures; ++k) {
        history.sensors.push_back(sensorName(k));
    }
    history.temp_degC.resize(rows, kSensors);
    history.present = PresentMask::Constant(rows, kSensors, true);
    history.drift_um = Eigen::MatrixXd::Zero(rows, 3);
    history.trueDrift_um = Eigen::MatrixXd::Zero(rows, 3);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const int t_min = static_cast<int>(row) - kBaseline_min;
        // A row tells the state at its minute and the speed from then on.
        plant.advance(t_min <= 0 ? 0.0 : speed_rpm(t_min - 1), kMinute_s);
        // The origin is measured over the baseline: its reference is the middle of it.
        if (t_min == -(kBaseline_min + 1) / 2) {
            plant.setReference();
        }
        history.time_min.push_back(t_min);
        history.speed_rpm.push_back(t_min < 0 ? 0.0 : speed_rpm(t_min));
        day.room_degC.push_back(plant.room_degC());
        const auto temps_degC = plant.readThermocouples();
        history.temp_degC.row(row) = Eigen::Map<const Eigen::RowVectorXd>(temps_degC.data(), kSensors);
        const auto measured_um = plant.measureDrift();
        const auto true_um = plant.drift_um();
        if (t_min >= 0) {
            history.drift_um.row(row) = Eigen::RowVector3d(measured_um[0], measured_um[1], measured_um[2]);
            history.trueDrift_um.row(row) = Eigen::RowVector3d(true_um[0], true_um[1], true_um[2]);
        }
    }
    return day;
}

const char* trainingDayLabel(std::size_t day) {
    constexpr std::array<const char*, kTrainingDays> kLabels{"random speeds", "stair up and down", "runs with pauses",
                                                             "slow work"};
    return kLabels.at(day);
}

ThermalHistory trainingDay(std::uint64_t machineSeed, std::size_t day, std::uint64_t hardSeed) {
    constexpr std::array kRandom_rpm{0.0,   3000.0, 1000.0, 4500.0, 0.0,    2000.0, 6000.0, 1500.0, 3500.0,
                                     500.0, 5000.0, 0.0,    2500.0, 4000.0, 1000.0, 5500.0, 3000.0, 400.0};
    constexpr int kHold_min = 20;
    constexpr std::uint64_t kFirstSeed = 101;
    const auto speed_rpm = [&](int t_min) -> double {
        switch (day) {
            case 0:
                return kRandom_rpm[static_cast<std::size_t>(t_min / kHold_min) % kRandom_rpm.size()];
            case 1:
                return t_min < 180 ? 1000.0 * (1 + t_min / 36) : 1000.0 * (10 - t_min / 36);
            case 2:
                return t_min % 90 < 60 ? 3000.0 : 0.0;
            default:
                return t_min < 240 ? 400.0 : 1200.0;
        }
    };
    SimulatedDayOptions options{machineSeed, kFirstSeed + day};
    options.hardSeed = hardSeed;
    ThermalHistory history = simulateDay(options, speed_rpm).history;
    history.label = trainingDayLabel(day);
    // The loop knows the speed of the minute that has passed, not of the one to come.
    std::ranges::rotate(history.speed_rpm, history.speed_rpm.end() - 1);
    history.speed_rpm.front() = 0.0;
    return history;
}

std::vector<ThermalHistory> trainingDays(std::uint64_t machineSeed, std::uint64_t hardSeed) {
    std::vector<ThermalHistory> days;
    for (std::size_t day = 0; day < kTrainingDays; ++day) {
        days.push_back(trainingDay(machineSeed, day, hardSeed));
    }
    return days;
}

}  // namespace kerf::thermal
