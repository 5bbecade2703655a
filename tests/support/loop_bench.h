// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/cycle/engine.h"
#include "engine/machine/simulated/simulated_machine.h"

namespace kerf::test {

/// One plant of the simulated machine, its loop and the engine, not started: a test steps it.
struct LoopBench {
    void fit(std::unique_ptr<SimulatedProcess> plant, std::unique_ptr<ProcessLoop> loop,
             const SimulatedMachine::Params& params = {}) {
        std::vector<std::unique_ptr<SimulatedProcess>> plants;
        plants.push_back(std::move(plant));
        machine = std::make_unique<SimulatedMachine>(params, std::move(plants));
        (void)machine->connect();
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::move(loop));
        engine = std::make_unique<Engine>(*machine, std::move(loops));
    }
    /// Sends, runs one cycle, and returns the engine's echo.
    template <class Action>
    CommandResult execute(const Action& action) {
        Command command;
        command.action = action;
        (void)engine->send(command);
        engine->runCycles(1);
        return engine->status().lastCommand;
    }
    [[nodiscard]] LoopStatus loopOf(ProcessId process) {
        return engine->status().loops[static_cast<std::size_t>(process)];
    }

    std::unique_ptr<SimulatedMachine> machine;
    std::unique_ptr<Engine> engine;
};

/// What loop and service hand each other beside commands; a bench has it before its loop, and after it.
template <class Exchange>
struct WithExchange {
    std::unique_ptr<Exchange> exchange{std::make_unique<Exchange>()};
};

}  // namespace kerf::test
