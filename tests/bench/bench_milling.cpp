// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <optional>

#include "engine/process/milling/feed_controller.h"
#include "engine/process/milling/revolution_averager.h"
#include "engine/process/milling/sampled_force.h"

namespace {

using namespace kerf;
using namespace kerf::milling;

/// One 5 kHz sample through averager and default law, the revolutions included as often as they fall at this speed.
void forceSample(benchmark::State& state) {
    const double step_rev = static_cast<double>(state.range(0)) / 60.0 / 5000.0;
    RevolutionAverager averager;
    FeedController controller(FeedController::Params(), LawKind::Model);
    double angle_rev = 0.0;
    std::int64_t time_ns = 0;
    double feed_mmPerS = 1.0;
    std::int64_t revolutions = 0;
    for (auto _ : state) {
        angle_rev += step_rev;
        time_ns += 200'000;
        const double force_N =
            380.0 + 40.0 * static_cast<double>(time_ns / 200'000 % 16) / 16.0;  // ripple without a cosine
        if (const auto revolution = averager.add({time_ns, angle_rev, force_N, Quality::Good})) {
            feed_mmPerS = controller.update({revolution->mean_N, 0.1, 1.0, revolution->duration_s()}).feed_mmPerS;
            ++revolutions;
        }
        benchmark::DoNotOptimize(feed_mmPerS);
    }
    state.counters["revolutions_per_sample"] =
        static_cast<double>(revolutions) / static_cast<double>(state.iterations());
}
BENCHMARK(forceSample)->Arg(60)->Arg(600)->Arg(12000);

/// One revolution of a law alone.
void lawRevolution(benchmark::State& state) {
    FeedController controller(FeedController::Params(), static_cast<LawKind>(state.range(0)));
    const double heights_mm[] = {1, 2, 3, 2, 1};
    controller.setBlank(*BlankProfile::ofSegments(heights_mm, 20.0));
    double position_mm = 0.0;
    for (auto _ : state) {
        position_mm = position_mm > 100.0 ? 0.0 : position_mm + 0.1;
        benchmark::DoNotOptimize(controller.update({392.0, 0.1, position_mm, 0.1}));
    }
}
BENCHMARK(lawRevolution)->ArgName("law")->DenseRange(0, 3);

}  // namespace

BENCHMARK_MAIN();
