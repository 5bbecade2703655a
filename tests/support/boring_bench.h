// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/cycle/engine.h"
#include "engine/machine/simulated/simulated_boring.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "engine/process/boring/boring_loop.h"

namespace kerf::test {

/// A schedule of the built-in machine's true law over a short bore, so that tests are quick.
inline BoringSchedule shortSchedule(std::uint32_t revision = 1) {
    BoringSchedule schedule;
    schedule.revision = revision;
    schedule.lnC = std::log(0.0871);
    schedule.alpha = 0.5025;
    schedule.beta = 0.2676;
    schedule.targetDeflection_mm = 0.1165;
    schedule.overhangFrom_mm = 40.0;
    schedule.overhangTo_mm = 60.0;
    return schedule;
}

/// Simulated boring machine, loop and engine, not started: tests call engine->runCycles() or engine->start().
struct BoringBench {
    explicit BoringBench(const OutputLimits& limits = {}) {
        std::vector<std::unique_ptr<SimulatedProcess>> plants;
        auto plant = std::make_unique<SimulatedBoring>(SimulatedBoring::Params{});
        boring = plant.get();
        plants.push_back(std::move(plant));
        SimulatedMachine::Params machineParams;
        machineParams.limits = limits;
        machine = std::make_unique<SimulatedMachine>(machineParams, std::move(plants));
        (void)machine->connect();
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<BoringLoop>());
        engine = std::make_unique<Engine>(*machine, std::move(loops));
    }
    template <class Action>
    std::uint32_t send(const Action& action) {
        Command command;
        command.action = action;
        return engine->send(command).value_or(0);
    }
    /// Sends, runs one cycle, and returns the engine's echo. Only while not started.
    template <class Action>
    CommandResult execute(const Action& action) {
        (void)send(action);
        engine->runCycles(1);
        return engine->status().lastCommand;
    }
    [[nodiscard]] LoopStatus loop() { return engine->status().loops[static_cast<std::size_t>(ProcessId::Boring)]; }
    /// Runs until `condition` holds; false after `most` cycles.
    template <class Condition>
    bool runUntil(Condition condition, int most = 60'000) {
        for (int i = 0; i < most; ++i) {
            engine->runCycles(1);
            if (condition(engine->status())) {
                return true;
            }
        }
        return false;
    }
    bool runPart() {
        return execute(StartPart{ProcessId::Boring}).done &&
               runUntil([](const Status& s) { return s.program == ProgramState::Running; }) &&
               runUntil([](const Status& s) { return s.program == ProgramState::Finished; });
    }

    SimulatedBoring* boring{nullptr};
    std::unique_ptr<SimulatedMachine> machine;
    std::unique_ptr<Engine> engine;
};

}  // namespace kerf::test
