// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <chrono>

#include "engine/core/histogram.h"
#include "engine/core/latest_value.h"
#include "engine/core/spsc_ring.h"
#include "tests/support/boring_bench.h"

namespace {

using namespace kerf;

/// One whole cycle (simulated machine, boring loop in control, limits) while a bore is cut; the percentiles are
/// counters.
void engineCycle(benchmark::State& state) {
    test::BoringBench bench;
    BoringSchedule schedule = test::shortSchedule();
    schedule.overhangTo_mm = 310.0;
    (void)bench.execute(LoadBoringSchedule{schedule});
    (void)bench.execute(SetLoopMode{ProcessId::Boring, LoopMode::Control});
    TimeHistogram histogram;
    std::int64_t now_ns = 1'000'000'000;
    for (auto _ : state) {
        if (bench.engine->cycle().inputs().program != ProgramState::Running) {
            state.PauseTiming();
            PartRecord part;
            while (bench.engine->partRecords().tryPop(part)) {
            }
            (void)bench.execute(StartPart{ProcessId::Boring});
            state.ResumeTiming();
        }
        const auto begin = std::chrono::steady_clock::now();
        bench.engine->cycle().step(now_ns += 1'000'000);
        histogram.add((std::chrono::steady_clock::now() - begin).count());
    }
    state.counters["p50_ns"] = static_cast<double>(histogram.percentile_ns(0.5));
    state.counters["p99.9_ns"] = static_cast<double>(histogram.percentile_ns(0.999));
    state.counters["max_ns"] = static_cast<double>(histogram.max_ns());
}
BENCHMARK(engineCycle);

void publishStatus(benchmark::State& state) {
    test::BoringBench bench;
    const CycleStats stats{};
    for (auto _ : state) {
        bench.engine->cycle().publish(stats);
    }
}
BENCHMARK(publishStatus);

void ringPushAndPopOneSample(benchmark::State& state) {
    SpscRing<Sample> ring(1024);
    Sample sample;
    for (auto _ : state) {
        benchmark::DoNotOptimize(ring.tryPush(sample));
        benchmark::DoNotOptimize(ring.tryPop(sample));
    }
}
BENCHMARK(ringPushAndPopOneSample);

}  // namespace

BENCHMARK_MAIN();
