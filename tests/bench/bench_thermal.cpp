// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/cycle/event_sink.h"
#include "engine/machine/simulated/simulated_thermal.h"
#include "engine/process/thermal/gmdh.h"
#include "engine/process/thermal/plant/simulated_day.h"
#include "engine/process/thermal/thermal_estimator.h"
#include "engine/process/thermal/thermal_loop.h"
#include "engine/process/thermal/training.h"

using namespace kerf;
using namespace kerf::thermal;

namespace {

constexpr Eigen::Index kInputs = 128;
constexpr Eigen::Index kRows = 360;
constexpr Eigen::Index kTrainingRows = 240;

/// One day of the simulated machine as the paper's inputs: 64 thermocouples now and one step before.
struct Problem {
    Eigen::MatrixXd x;
    Eigen::MatrixXd y;
    GmdhRows rows;
};
const Problem& problem() {
    static const Problem made = [] {
        const ThermalHistory day = trainingDay(1, 0);
        Problem p{printedInputs(day), day.drift_um.bottomRows(kRows), {}};
        for (Eigen::Index row = 0; row < kRows; ++row) {
            (row < kTrainingRows / 2 ? p.rows.a : row < kTrainingRows ? p.rows.b : p.rows.check).push_back(row);
        }
        return p;
    }();
    return made;
}

void gmdhTraining(benchmark::State& state) {
    const Problem& p = problem();
    for (auto _ : state) {
        benchmark::DoNotOptimize(trainGmdh(p.x, p.y, p.rows, GmdhOptions::guarded()));
    }
}
BENCHMARK(gmdhTraining)->Unit(benchmark::kMillisecond);

/// One layer the plain way: for each of 8,128 pairs and each axis three least-squares problems (sets A, B, both) and
/// both criteria; by QR from the rows, or by the normal equations of each pair.
double plainLayer(const Problem& p, bool qr) {
    const Eigen::VectorXd mean = p.x.colwise().mean();
    const Eigen::MatrixXd x = (p.x.rowwise() - mean.transpose());
    double best = 1e300;
    const auto fit = [&](Eigen::Index i, Eigen::Index j, Eigen::Index from, Eigen::Index count, Eigen::Index axis) {
        Eigen::MatrixXd design(count, 4);
        design.col(0).setOnes();
        design.col(1) = x.col(i).segment(from, count);
        design.col(2) = x.col(j).segment(from, count);
        design.col(3) = design.col(1).cwiseProduct(design.col(2));
        if (qr) return Eigen::Vector4d(design.householderQr().solve(p.y.col(axis).segment(from, count)));
        Eigen::Matrix4d gram = design.transpose() * design;
        gram.diagonal().array() += 1e-3;
        return Eigen::Vector4d(gram.ldlt().solve(design.transpose() * p.y.col(axis).segment(from, count)));
    };
    for (Eigen::Index i = 0; i < kInputs; ++i) {
        for (Eigen::Index j = i + 1; j < kInputs; ++j) {
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const Eigen::Vector4d a = fit(i, j, 0, kTrainingRows / 2, axis);
                const Eigen::Vector4d b = fit(i, j, kTrainingRows / 2, kTrainingRows / 2, axis);
                const Eigen::Vector4d both = fit(i, j, 0, kTrainingRows, axis);
                Eigen::MatrixXd all(kRows, 4);
                all.col(0).setOnes();
                all.col(1) = x.col(i);
                all.col(2) = x.col(j);
                all.col(3) = x.col(i).cwiseProduct(x.col(j));
                const double u2 = (all * (a - b)).squaredNorm() / p.y.col(axis).squaredNorm();
                const Eigen::Index checkRows = kRows - kTrainingRows;
                const double r2 = (p.y.col(axis).tail(checkRows) - all.bottomRows(checkRows) * both).squaredNorm() /
                                  p.y.col(axis).tail(checkRows).squaredNorm();
                best = std::min(best, r2 + u2);
            }
        }
    }
    return best;
}

void plainLoop(benchmark::State& state, bool qr) {
    const Problem& p = problem();
    for (auto _ : state) {
        benchmark::DoNotOptimize(plainLayer(p, qr));
    }
}
BENCHMARK_CAPTURE(plainLoop, qr, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plainLoop, normalEquations, false)->Unit(benchmark::kMillisecond);

const ThermalModel& model() {
    static const ThermalModel trained = std::move(*trainRegression(trainingDays(1), {}));
    return trained;
}

void defaultTraining(benchmark::State& state) {
    const std::vector<ThermalHistory> days = trainingDays(1);
    for (auto _ : state) {
        benchmark::DoNotOptimize(trainRegression(days, {}));
    }
}
BENCHMARK(defaultTraining)->Unit(benchmark::kMillisecond);

void onePrediction(benchmark::State& state) {
    ThermalEstimator estimator(model());
    const std::vector<Reading> readings(estimator.sensors(), Reading{22.0, 0, Quality::Good});
    Random random(1);
    std::vector<Reading> now = readings;
    for (int k = -5; k < 0; ++k)
        estimator.baseline(k, readings);
    double time_min = 0.0;
    for (auto _ : state) {
        for (Reading& one : now)
            one.value = 22.0 + random.uniform();
        benchmark::DoNotOptimize(estimator.update(time_min, 1000.0, now));
        time_min += 1.0;
    }
}
BENCHMARK(onePrediction)->Unit(benchmark::kMicrosecond);

/// What the loop costs in the machine's cycle: 60,000 cycles of 1 ms with one prediction.
void loopCycle(benchmark::State& state) {
    ThermalExchange exchange;
    ThermalLoop loop(exchange);
    SimulatedThermal plant({});
    Capabilities capabilities;
    plant.fit(capabilities);
    MachineInputs inputs;
    inputs.link = LinkState::Up;
    const MachineOutputs sent;
    const InjectedFaults faults;
    SpscRing<AlarmEvent> alarms(16);
    SpscRing<PartRecord> parts(4);
    EventSink events(alarms, parts);
    const std::vector<std::string> names = trainingDay(1, 0).sensors;
    exchange.offer(std::move(*LiveModel::make(model(), names, 1)));
    loop.setMode(LoopMode::Control);
    SimulationStep step;
    step.dt_s = 0.001;
    step.outputs = &sent;
    step.faults = &faults;
    for (auto _ : state) {
        step.now_ns += 1'000'000;
        inputs.time_ns = step.now_ns;
        inputs.spindleSpeed_rpm = {1000.0, step.now_ns, Quality::Good};
        for (Reading& offset : inputs.workOffset_um)
            offset = {0.0, step.now_ns, Quality::Good};
        (void)plant.advance(step, inputs);
        LoopOutputs outputs;
        benchmark::DoNotOptimize(loop.step(inputs, capabilities, outputs, events));
    }
}
BENCHMARK(loopCycle)->Unit(benchmark::kNanosecond);

/// CPU time: other work on the machine does not count.
double seconds(const auto& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// The smallest of several, alternating.
void printRatio() {
    double gmdh_s = 1e9;
    double qr_s = 1e9;
    double normal_s = 1e9;
    for (int k = 0; k < 3; ++k) {
        gmdh_s = std::min(
            gmdh_s, seconds([] {
                benchmark::DoNotOptimize(trainGmdh(problem().x, problem().y, problem().rows, GmdhOptions::guarded()));
            }));
        qr_s = std::min(qr_s, seconds([] { benchmark::DoNotOptimize(plainLayer(problem(), true)); }));
        normal_s = std::min(normal_s, seconds([] { benchmark::DoNotOptimize(plainLayer(problem(), false)); }));
    }
    std::printf("GMDH, 3 axes, 128 inputs, 360 rows, up to 3 layers: %.1f ms\n", 1000.0 * gmdh_s);
    std::printf(
        "one layer as a plain loop of least-squares problems: by QR %.1f ms, ratio %.1f; by normal equations %.1f ms, "
        "ratio %.1f\n",
        1000.0 * qr_s, qr_s / gmdh_s, 1000.0 * normal_s, normal_s / gmdh_s);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    printRatio();
    return 0;
}
