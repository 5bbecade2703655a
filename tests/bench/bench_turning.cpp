// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/turning/identifier.h"
#include "engine/process/turning/simulation.h"
#include "tests/support/turning_bench.h"

using namespace kerf::turning;

namespace {

std::vector<double> tonesWithNoise(std::size_t count) {
    std::vector<ToneSpec> tones(kPaperTones.begin(), kPaperTones.end());
    tones.push_back({37.0, 0.3, 0.4});
    tones.push_back({66.0, 0.3, 1.4});
    tones.push_back({151.0, 0.3, 2.4});
    tones.resize(count);
    return makeDisturbance(tones, 0.05, 50000, 3);
}

/// One 5 kHz sample: identification and default law in closed loop on the force-only plant.
void turningSample(benchmark::State& state) {
    const auto disturbance = tonesWithNoise(static_cast<std::size_t>(state.range(0)));
    PlantParams plantParams;
    plantParams.kind = PlantKind::B2;
    plantParams.depth_um = 6.0;
    Plant plant(plantParams);
    DepthControlParams params;
    for (const ToneSpec& tone : kPaperTones) {
        params.knownTones_Hz[params.knownCount++] = tone.frequency_Hz;
    }
    DepthControl control(params);
    ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
    kerf::Random sensor(4);
    double command_um = 0.0;
    std::size_t k = 0;
    std::vector<double> times_ns;
    times_ns.reserve(5'000'000);
    for (auto _ : state) {
        const PlantSample sample = plant.step(disturbance[k], command_um);
        k = k + 1 < disturbance.size() ? k + 1 : 0;
        const double force_N = sample.force_N + 0.005 * sensor.gauss();
        const auto begin = std::chrono::steady_clock::now();
        identifier.update(force_N, sample.depth_um);
        command_um = control.update({force_N, sample.inner_um});
        const auto end = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(command_um);
        const double spent_s = std::chrono::duration<double>(end - begin).count();
        state.SetIterationTime(spent_s);
        if (times_ns.size() < times_ns.capacity()) {
            times_ns.push_back(1e9 * spent_s);
        }
    }
    const auto at = [&](double share) {
        const auto place =
            times_ns.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(times_ns.size() - 1));
        std::nth_element(times_ns.begin(), place, times_ns.end());
        return *place;
    };
    state.counters["median_ns"] = at(0.5);
    state.counters["p99_ns"] = at(0.99);
    state.counters["p99.9_ns"] = at(0.999);
}
BENCHMARK(turningSample)->Arg(1)->Arg(5)->Arg(8)->UseManualTime()->MinTime(0.2);

void identifierUpdate(benchmark::State& state) {
    ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
    CuttingProcess process{ProcessParams{}};
    kerf::Random random(4);
    for (auto _ : state) {
        const double chip_um = 6.0 + 0.5 * (random.uniform() - 0.5);
        identifier.update(process.step(chip_um), chip_um);
        benchmark::DoNotOptimize(identifier.trace());
    }
}
BENCHMARK(identifierUpdate);

/// A whole cycle of the diamond lathe in mid-cut: simulated plant, loop with identification, limits.
void latheCycle(benchmark::State& state) {
    kerf::SimulatedTurning::Params params;
    params.motionSensorNoise_um = 0.005;
    kerf::TurningExchange exchange;
    kerf::test::TurningBench bench(params, 200'000, &exchange);
    kerf::TurningSetup setup = kerf::test::shortCut();
    setup.faceTo_mm = 900.0;
    (void)bench.start(kerf::LoopMode::Control, setup);
    bench.run(3.0);
    for (auto _ : state) {
        bench.engine->runCycles(1);
    }
}
BENCHMARK(latheCycle);

}  // namespace

BENCHMARK_MAIN();
