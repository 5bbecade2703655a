// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/hard_machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/core/units.h"

namespace kerf::milling {
namespace {

constexpr double kLength_mm = 100.0;
constexpr double kReference_N = 40.0 * kNewtonPerKilogramForce;

double logUniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

BlankProfile equalSteps(const std::vector<double>& heights_mm) {
    return *BlankProfile::ofSegments(heights_mm, kLength_mm / static_cast<double>(heights_mm.size()));
}

BlankProfile drawnBlank(Random& random) {
    constexpr std::size_t kRampSteps = 200;
    constexpr std::size_t kCombSteps = 100;
    std::vector<double> heights_mm;
    switch (random.nextU64() % 5U) {
        case 0:
            return equalSteps({1, 2, 3, 2, 1});
        case 1:
        case 2: {
            const bool rising = random.uniform() < 0.5;
            for (std::size_t i = 0; i < kRampSteps; ++i) {
                const double share = (static_cast<double>(i) + 0.5) / kRampSteps;
                heights_mm.push_back(rising ? 1.0 + 2.0 * share : 3.0 - 2.0 * share);
            }
            return equalSteps(heights_mm);
        }
        case 3:
            for (std::size_t i = 0; i < kCombSteps; ++i) {
                heights_mm.push_back(i % 2 == 0 ? 1.0 : 3.0);
            }
            return equalSteps(heights_mm);
        default:
            break;
    }
    const auto steps = static_cast<std::size_t>(random.uniform(5.0, 11.0));
    for (std::size_t i = 0; i < steps; ++i) {
        heights_mm.push_back(random.uniform(1.0, 3.0));
    }
    return equalSteps(heights_mm);
}

/// Cut feed that holds the reference at this depth.
double steadyFeed_mmPerRev(const PlantParams& plant, double depth_mm) {
    const double sin = std::sin(plant.forceAngle_deg * std::numbers::pi / 180.0);
    return std::pow(kReference_N / sin / (plant.cuttingCoefficient * depth_mm), 1.0 / plant.exponent);
}

PlantParams drawnPlant(Random& random) {
    constexpr double kGaugeFeed_mmPerRev = 0.153;
    PlantParams plant;
    do {
        plant.exponent = random.uniform(0.7, 0.95);
        plant.forceAngle_deg = random.uniform(30.0, 60.0);
        const double sin = std::sin(plant.forceAngle_deg * std::numbers::pi / 180.0);
        plant.cuttingCoefficient = logUniform(random, 13.0, 35.0) * kNewtonPerKilogramForce / sin *
                                   std::pow(kGaugeFeed_mmPerRev, -plant.exponent);
    } while (steadyFeed_mmPerRev(plant, 1.0) > 0.35 || steadyFeed_mmPerRev(plant, 3.0) < 0.03);
    plant.kx_NPerMm = logUniform(random, 20.0, 150.0) * kNewtonPerKilogramForce;
    plant.ky_NPerMm = logUniform(random, 80.0, 300.0) * kNewtonPerKilogramForce;
    return plant;
}

}  // namespace

HardMachine hardMachine(std::uint64_t seed) {
    HardMachine machine;
    machine.seed = seed;
    if (seed == 0) {
        machine.blank = equalSteps({1, 2, 3, 2, 1});
        return machine;
    }
    Random random(seed);
    machine.plant = drawnPlant(random);
    machine.shape.runOut = random.uniform(0.0, 0.2);
    if (random.uniform() < 0.2) {  // the next flute takes twice the feed
        const double flutes = machine.shape.flutes;
        machine.shape.missing = true;
        machine.plant.cuttingCoefficient *= (flutes - 2.0 + std::exp2(machine.plant.exponent)) / flutes;
    }
    const bool lags = random.uniform() < 0.5;
    const double lag_s = logUniform(random, 0.05, 0.3);
    machine.axisLag_s = lags ? lag_s : 0.0;
    machine.forceNoise_N = logUniform(random, 0.1, 5.0) * kNewtonPerKilogramForce;
    machine.late = random.uniform() < 0.3;
    machine.drift_NPerS = random.uniform(-1.0, 1.0);
    machine.corner_Hz = 100.0;
    machine.blank = drawnBlank(random);
    constexpr std::uint64_t kChatterStream = 77;  // of its own: the machines of before stay as they were
    Random chatter = Random(seed).stream(kChatterStream);
    const bool chatters = chatter.uniform() < 0.2;
    machine.chatter_Hz = logUniform(chatter, 300.0, 900.0);
    machine.chattersFrom_mm = chatters ? chatter.uniform(2.0, 3.0) : 0.0;
    return machine;
}

void putOn(const HardMachine& machine, CutCase& cut) {
    cut.plant = machine.plant;
    cut.blank = machine.blank;
    cut.forceNoise_N = machine.forceNoise_N;
    cut.lag = machine.late;
    cut.axisLag_s = machine.axisLag_s;
    cut.drift_NPerS = machine.drift_NPerS;
}

bool unstable(const CutResult& cut, double reference_N) {
    double sum_N = 0.0, squares_N2 = 0.0;
    const std::size_t from = cut.rows.size() / 2;
    for (std::size_t i = from; i < cut.rows.size(); ++i) {
        sum_N += cut.rows[i].force_N;
        squares_N2 += cut.rows[i].force_N * cut.rows[i].force_N;
    }
    const auto count = static_cast<double>(cut.rows.size() - from);
    const double mean_N = sum_N / count;
    return !cut.summary.finished || std::sqrt(std::max(0.0, squares_N2 / count - mean_N * mean_N)) > 0.5 * reference_N;
}

}  // namespace kerf::milling
