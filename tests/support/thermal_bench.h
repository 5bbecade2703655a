// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/machine/simulated/simulated_thermal.h"
#include "engine/process/thermal/plant/simulated_day.h"
#include "engine/process/thermal/thermal_alarms.h"
#include "engine/process/thermal/thermal_loop.h"
#include "engine/process/thermal/training.h"
#include "tests/support/loop_bench.h"

namespace kerf::test {

/// Trained once per test program on simulated days of the built-in machine.
inline const thermal::ThermalModel& machineModel() {
    static const thermal::ThermalModel model = [] {
        auto trained = thermal::trainRegression(thermal::trainingDays(SimulatedThermal::kMachiningCentre), {});
        return std::move(*trained);
    }();
    return model;
}

inline std::vector<std::string> channelNames() {
    return thermal::simulateDay({1, 1, 0}, [](int) { return 0.0; }).history.sensors;
}

/// The simulated machine's heat, the thermal loop and the engine, not started; 100 ms of machine time a cycle.
struct ThermalBench : WithExchange<ThermalExchange>, LoopBench {
    static constexpr std::int64_t kCycle_ns = 100'000'000;
    static constexpr int kCyclesPerMinute = 600;

    explicit ThermalBench(const SimulatedThermal::Params& params = {},
                          const SimulatedThermal::Memory* memory = nullptr) {
        auto made = std::make_unique<SimulatedThermal>(params);
        plant = made.get();
        if (memory != nullptr) plant->resume(*memory);
        SimulatedMachine::Params machineParams;
        machineParams.cycle_ns = kCycle_ns;
        fit(std::move(made), std::make_unique<ThermalLoop>(*exchange), machineParams);
        engine->runCycles(1);
        (void)execute(SetLoopMode{ProcessId::Thermal, LoopMode::Control});
    }
    void offer(const thermal::ThermalModel& model, std::uint32_t revision = 1) {
        const std::vector<std::string> names = channelNames();
        exchange->offer(std::move(*LiveModel::make(model, names, revision)));
        engine->runCycles(1);
    }
    void runMinutes(double minutes) { engine->runCycles(static_cast<std::uint64_t>(minutes * kCyclesPerMinute)); }
    /// Warm-up program at this speed, run to its end.
    bool warmUp(double speed_rpm, double minutes) {
        ThermalSetup setup;
        setup.revision = ++setupRevision;
        setup.warmUpSpeed_rpm = speed_rpm;
        setup.warmUp_min = minutes;
        setup.allowed_um = allowed_um;
        const bool begun = execute(LoadThermalSetup{setup}).done && execute(StartPart{ProcessId::Thermal}).done;
        runMinutes(minutes + 0.1);
        return begun;
    }
    [[nodiscard]] ThermalStatus thermal() { return engine->status().thermal; }
    [[nodiscard]] LoopStatus loop() { return loopOf(ProcessId::Thermal); }
    /// True drift plus shift, the largest of the axes, µm.
    [[nodiscard]] double worstResidual_um() {
        double worst = 0.0;
        const auto drift_um = plant->plant().drift_um();
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            worst = std::max(worst, std::abs(drift_um[axis] + thermal().shifted_um[axis].value));
        }
        return worst;
    }
    void drainAlarms() {
        AlarmEvent event;
        while (engine->nextAlarm(event)) {
            if (event.raised) {
                raised.insert(event.code);
                details.push_back(event.detail.english());
            } else {
                cleared.insert(event.code);
            }
            QVERIFY(engine->alarmSpec(event.code) != nullptr);
        }
    }
    [[nodiscard]] bool wasRaised(AlarmCode code) {
        drainAlarms();
        return raised.contains(code);
    }

    double allowed_um{4.0};
    std::uint32_t setupRevision{0};
    SimulatedThermal* plant{nullptr};
    std::set<AlarmCode> raised;
    std::set<AlarmCode> cleared;
    std::vector<std::string> details;
};

}  // namespace kerf::test
