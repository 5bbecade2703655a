// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "engine/process/boring/campaign.h"
#include "engine/process/boring/lot_tracker.h"

namespace {

using namespace kerf::boring;

constexpr double kSigma_mm = 0.005;

EstimatorParams paramsFor(EstimatorKind kind) {
    return estimatorParams(kind, kSigma_mm, kTableTargetDeflection_mm, 0.5);
}

/// A part in steady state: what most updates look like.
PartVisit steadyVisit(std::uint32_t part) {
    PartVisit visit;
    visit.part = part;
    const LawConstants law = TruthPlan::table().at(1);
    for (const double overhang_mm : {40.0, 310.0}) {
        const double feed_mmPerRev = optimalFeed_mmPerRev(law, kTableTargetDeflection_mm, overhang_mm);
        visit.rows[visit.count++] = {overhang_mm, feed_mmPerRev, kTableTargetDeflection_mm, false};
    }
    return visit;
}

void oneLeastSquaresStep(benchmark::State& state) {
    Eigen::Vector3d theta(-2.4, 0.5, 0.27);
    Eigen::Matrix3d p = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d x(1.0, std::log(0.25), std::log(40.0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(recursiveLeastSquaresStep(theta, p, x, std::log(0.1165), 0.0018, 0.0018));
        benchmark::DoNotOptimize(p);
    }
}
BENCHMARK(oneLeastSquaresStep);

void onePart(benchmark::State& state, EstimatorKind kind) {
    const EstimatorParams params = paramsFor(kind);
    EstimatorState now = step(initialState(params), params, steadyVisit(1));
    std::uint32_t part = 1;
    for (auto _ : state) {
        now = step(now, params, steadyVisit(++part));
        benchmark::DoNotOptimize(now);
    }
}
BENCHMARK_CAPTURE(onePart, perturbation, EstimatorKind::Perturbation);
BENCHMARK_CAPTURE(onePart, kalman, EstimatorKind::Kalman);

void tenThousandLotsOfThirtyParts(benchmark::State& state, EstimatorKind kind) {
    CampaignParams params;
    params.estimator = paramsFor(kind);
    params.feed = feedLawParams(kind, kTableTargetDeflection_mm, 0.5);
    params.scrapBand_mm = 3.0 * kSigma_mm;
    const TruthPlan truth = TruthPlan::paper();
    for (auto _ : state) {
        CampaignTally tally;
        for (std::uint32_t run = 1; run <= 10000; ++run) {
            tally.add(simulateLot(params, truth, 1, run), truth);
        }
        benchmark::DoNotOptimize(tally.summary());
    }
}
BENCHMARK_CAPTURE(tenThousandLotsOfThirtyParts, perturbation, EstimatorKind::Perturbation)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tenThousandLotsOfThirtyParts, kalman, EstimatorKind::Kalman)->Unit(benchmark::kMillisecond);

/// The oldest of n parts corrected: everything after it is stepped again.
void correctionOfTheFirstOf(benchmark::State& state) {
    LotTracker lot(paramsFor(EstimatorKind::Kalman));
    const auto parts = static_cast<std::uint32_t>(state.range(0));
    std::int64_t id = 0;
    for (std::uint32_t part = 1; part <= parts; ++part) {
        CutPart cut;
        cut.number = part;
        cut.schedule.lnC = std::log(kTableC);
        cut.schedule.alpha = kTableAlpha;
        cut.schedule.beta = kTableBeta;
        cut.schedule.targetDeflection_mm = kTableTargetDeflection_mm;
        (void)lot.addPart(cut);
        for (const double overhang_mm : {40.0, 310.0}) {
            (void)lot.add(++id, part, overhang_mm, kTableTargetDeflection_mm);
        }
    }
    double deflection_mm = kTableTargetDeflection_mm;
    for (auto _ : state) {
        deflection_mm = deflection_mm == 0.12 ? 0.11 : 0.12;
        benchmark::DoNotOptimize(lot.correct(1, 1, deflection_mm));
    }
}
BENCHMARK(correctionOfTheFirstOf)->Arg(30)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
