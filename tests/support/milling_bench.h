// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "engine/machine/simulated/simulated_milling.h"
#include "engine/process/milling/milling_loop.h"
#include "tests/support/loop_bench.h"

namespace kerf::test {

inline milling::BlankProfile millingStairs() {
    const double heights_mm[] = {1, 2, 3, 2, 1};
    return *milling::BlankProfile::ofSegments(heights_mm, 20.0);
}

inline MillingSetup millingSetup() {
    MillingSetup setup;
    setup.revision = 1;
    setup.to_mm = 110.0;
    return setup;
}

/// Simulated milling machine, loop and engine, not started: tests call engine->runCycles().
struct MillingBench : LoopBench {
    explicit MillingBench(SimulatedMilling::Params params = {}, double maxFeedScale = 1.0) {
        if (params.blanks.empty()) {
            params.blanks.push_back(millingStairs());
        }
        auto plant = std::make_unique<SimulatedMilling>(params);
        milling = plant.get();
        SimulatedMachine::Params machineParams;
        machineParams.maxFeedScale = maxFeedScale;
        fit(std::move(plant), std::make_unique<MillingLoop>(), machineParams);
    }
    [[nodiscard]] Status status() { return engine->status(); }
    [[nodiscard]] LoopStatus loop() { return loopOf(ProcessId::Milling); }
    template <class Condition>
    bool runUntil(Condition condition, int most = 200'000) {
        for (int i = 0; i < most; ++i) {
            engine->runCycles(1);
            if (condition(engine->status())) {
                return true;
            }
        }
        return false;
    }
    bool start(LoopMode mode, const MillingSetup& setup = millingSetup()) {
        return execute(LoadMillingSetup{setup}).done && execute(SetLoopMode{ProcessId::Milling, mode}).done &&
               execute(StartPart{ProcessId::Milling}).done &&
               runUntil([](const Status& s) { return s.milling.cutting; }, 100);
    }
    /// Under way at `position_mm` along the path.
    bool cutTo(double position_mm) {
        return runUntil([=](const Status& s) { return s.milling.position_mm >= position_mm; });
    }
    bool finish(PartRecord& part) {
        return runUntil([](const Status& s) { return s.program == ProgramState::Finished; }) &&
               (engine->runCycles(2), engine->partRecords().tryPop(part));
    }
    void runRevolutions(double revolutions) {
        engine->runCycles(static_cast<int>(revolutions * status().milling.revolution_s * 1000.0));
    }
    bool alarmRaised(AlarmCode code) {
        AlarmEvent event;
        bool raised = false;
        while (engine->nextAlarm(event)) {
            raised = raised || (event.code == code && event.raised);
        }
        return raised;
    }

    SimulatedMilling* milling{nullptr};
};

}  // namespace kerf::test
