// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/machine/simulated/simulated_turning.h"
#include "engine/process/turning/turning_loop.h"
#include "tests/support/loop_bench.h"

namespace kerf::test {

/// About 5 s of cutting.
inline TurningSetup shortCut(std::uint32_t revision = 1) {
    TurningSetup setup;
    setup.revision = revision;
    setup.faceTo_mm = 0.5;
    return setup;
}

/// Simulated diamond turning machine at 5 kHz, loop and engine, on the caller's thread.
struct TurningBench : LoopBench {
    explicit TurningBench(const SimulatedTurning::Params& params = {}, std::int64_t cycle_ns = 200'000,
                          TurningExchange* exchange = nullptr) {
        auto plant = std::make_unique<SimulatedTurning>(params);
        turning = plant.get();
        SimulatedMachine::Params machineParams;
        machineParams.cycle_ns = cycle_ns;
        fit(std::move(plant), std::make_unique<TurningLoop>(exchange), machineParams);
    }
    bool start(LoopMode mode = LoopMode::Control, const TurningSetup& setup = shortCut()) {
        return execute(LoadTurningSetup{setup}).done && execute(SetLoopMode{ProcessId::Turning, mode}).done &&
               execute(StartPart{ProcessId::Turning}).done;
    }
    void run(double seconds) { engine->runCycles(static_cast<std::uint64_t>(seconds * 5000.0)); }
    [[nodiscard]] TurningStatus status() { return engine->status().turning; }
    [[nodiscard]] LoopStatus loop() { return loopOf(ProcessId::Turning); }
    /// RMS of the tool's true motion over the next seconds.
    double motionRms_um(double seconds) {
        double square_um2 = 0.0;
        const int count = static_cast<int>(seconds * 5000.0);
        for (int i = 0; i < count; ++i) {
            engine->runCycles(1);
            square_um2 += turning->inner_um() * turning->inner_um() / count;
        }
        return std::sqrt(square_um2);
    }
    /// All alarms raised since the last call.
    std::vector<AlarmCode> alarms() {
        std::vector<AlarmCode> codes;
        AlarmEvent event;
        while (engine->nextAlarm(event)) {
            if (event.raised) {
                codes.push_back(event.code);
            }
        }
        return codes;
    }
    bool raised(AlarmCode code) {
        const auto codes = alarms();
        return std::find(codes.begin(), codes.end(), code) != codes.end();
    }

    SimulatedTurning* turning{nullptr};
};

}  // namespace kerf::test
