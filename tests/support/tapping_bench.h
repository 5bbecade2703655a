// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <memory>
#include <set>
#include <vector>

#include "engine/machine/simulated/simulated_tapping.h"
#include "engine/process/tapping/tapping_loop.h"
#include "engine/process/tapping/trial_machine.h"
#include "engine/process/tapping/tuner.h"
#include "tests/support/loop_bench.h"

namespace kerf::test {

inline TappingJob job() {
    TappingJob job;
    job.revision = 1;
    return job;
}

inline LoadTapGains initialGains() {
    LoadTapGains load;
    load.gains.revision = 1;
    load.gains.gains.spindleKp_perS = 40.0;
    load.gains.gains.zKp_perS = 48.0;
    load.accept = true;
    return load;
}

inline tapping::TunerSetup setup(const tapping::DriveParams& drive) {
    tapping::TunerSetup setup;
    setup.assumed = tapping::knownTo(drive, tapping::middlingDrive());
    setup.initial = tapping::settingsOf(drive);
    setup.maxTaps = 6;
    return setup;
}

/// Simulated tapping machine, loop and engine, not started.
struct TappingBench : WithExchange<TapExchange>, LoopBench {
    explicit TappingBench(const SimulatedTapping::Params& params = {}) {
        fit(std::make_unique<SimulatedTapping>(params), std::make_unique<TappingLoop>(*exchange));
        engine->runCycles(1);
        (void)execute(SetLoopMode{ProcessId::Tapping, LoopMode::Control});
    }
    template <class Condition>
    bool runUntil(Condition condition, int most = 20'000) {
        for (int i = 0; i < most; ++i) {
            engine->runCycles(1);
            if (condition(engine->status().tapping)) return true;
        }
        return false;
    }
    bool runTap() {
        const std::uint32_t before = tapping().taps;
        return execute(StartPart{ProcessId::Tapping}).done &&
               runUntil([before](const TappingStatus& s) { return s.taps > before && s.phase == TapPhase::Idle; });
    }
    [[nodiscard]] TappingStatus tapping() { return engine->status().tapping; }
    [[nodiscard]] const ServoGains& gains() { return engine->cycle().inputs().servoGains; }
    void drainAlarms() {
        AlarmEvent event;
        while (engine->nextAlarm(event)) {
            if (event.raised) raised.insert(event.code);
            QVERIFY(engine->alarmSpec(event.code) != nullptr);
        }
    }
    void inject(SignalFault spindleAngle, int cycles) {
        InjectedFaults faults;
        faults.spindleAngle = spindleAngle;
        machine->inject(faults);
        engine->runCycles(static_cast<std::uint64_t>(cycles));
        machine->inject({});
    }
    /// Job, gains and the air tap.
    bool makeReady(bool production = false) {
        LoadTapGains gains = initialGains();
        gains.production = production;
        return execute(LoadTappingJob{job()}).done && execute(gains).done && runTap();
    }
    bool runInto(double spindle_rev) {
        return execute(StartPart{ProcessId::Tapping}).done &&
               runUntil([spindle_rev](const TappingStatus& s) { return s.spindle_rev > spindle_rev; });
    }
    bool runToIdle() {
        return runUntil([](const TappingStatus& s) { return s.phase == TapPhase::Idle; });
    }
    [[nodiscard]] bool wasRaised(AlarmCode code) {
        drainAlarms();
        return raised.contains(code);
    }

    std::set<AlarmCode> raised;
};

}  // namespace kerf::test
