// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "engine/process/tapping/tap_drive.h"
#include "engine/process/tapping/trial_machine.h"

using namespace kerf::tapping;

namespace {

/// One tap of 1.18 s machine time: 1180 ticks of 5 substeps.
void simulatedTap(benchmark::State& state) {
    const DriveParams drive;
    std::vector<double> spindle_rev(tapTicks(drive));
    std::vector<double> z_mm(spindle_rev.size());
    for (auto _ : state) {
        simulateTap(drive, {}, spindle_rev, z_mm);
        benchmark::DoNotOptimize(z_mm.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(z_mm.size()));
}
BENCHMARK(simulatedTap)->Unit(benchmark::kMicrosecond);

void tuning(benchmark::State& state, TunerKind kind) {
    const DriveParams drive;
    TunerSetup setup;
    setup.kind = kind;
    setup.assumed = knownTo(drive, middlingDrive());
    setup.initial = settingsOf(drive);
    for (auto _ : state) {
        benchmark::DoNotOptimize(runTuning(setup, drive, {2.0, 4096.0, 1.0, 0.2, 0.1}, 1));
    }
}
BENCHMARK_CAPTURE(tuning, gain, TunerKind::Gain)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tuning, standard, TunerKind::Default)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
