// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/plant.h"

#include <cmath>

namespace kerf::boring {
namespace {

LawConstants law(double alpha, double beta, double c) {
    return {std::log(c), alpha, beta};
}

}  // namespace

TruthPlan TruthPlan::table() {
    return {{{1, law(kTableAlpha, kTableBeta, kTableC)}}, 0.0};
}

TruthPlan TruthPlan::paper() {
    return {{{1, law(kTableAlpha, kTableBeta, kTableC)}, {11, law(0.7, 0.4, 0.15)}, {21, law(0.6, 0.5, 0.075)}}, 0.0};
}

LawConstants TruthPlan::at(std::uint32_t part) const noexcept {
    LawConstants now = changes.front().law;
    for (const TruthChange& change : changes) {
        if (change.fromPart <= part) {
            now = change.law;
        }
    }
    now.lnC += (static_cast<double>(part) - 1.0) * std::log1p(drift_percentPerPart / 100.0);
    return now;
}

std::vector<std::uint32_t> TruthPlan::changeParts() const {
    std::vector<std::uint32_t> parts;
    for (const TruthChange& change : changes) {
        if (change.fromPart > 1) {
            parts.push_back(change.fromPart);
        }
    }
    return parts;
}

TruthPlan randomChanges(Random& random, double targetDeflection_mm) {
    constexpr double kFeed_mmPerRev = 0.114;
    constexpr double kOverhang_mm = 175.0;
    constexpr int kPlaces = 11;
    constexpr double kLeastFeed_mmPerRev = 0.01;
    constexpr double kMostFeed_mmPerRev = 1.0;
    const auto feasible = [&](const LawConstants& law) {
        const double near_mmPerRev = optimalFeed_mmPerRev(law, targetDeflection_mm, kTableOverhangFrom_mm);
        const double far_mmPerRev = optimalFeed_mmPerRev(law, targetDeflection_mm, kTableOverhangTo_mm);
        return near_mmPerRev <= kMostFeed_mmPerRev && far_mmPerRev >= kLeastFeed_mmPerRev;
    };
    TruthPlan plan = TruthPlan::table();
    for (const std::uint32_t earliest : {5U, 16U}) {
        const auto part = earliest + static_cast<std::uint32_t>(random.uniform() * kPlaces);
        LawConstants drawn;
        do {
            drawn.alpha = random.uniform(0.3, 0.8);
            drawn.beta = random.uniform(0.1, 0.5);
            const double lnD = std::log(targetDeflection_mm) + random.uniform(-0.8, 0.8);
            drawn.lnC = lnD - drawn.alpha * std::log(kFeed_mmPerRev) - drawn.beta * std::log(kOverhang_mm);
        } while (!feasible(drawn));
        plan.changes.push_back({part, drawn});
    }
    return plan;
}

HardMachine hardMachine(std::uint64_t seed, double targetDeflection_mm) {
    HardMachine machine;
    machine.seed = seed;
    if (seed == 0) {
        return machine;
    }
    constexpr double kLevelFeed_mmPerRev = 0.17;
    constexpr double kLeastFeed_mmPerRev = 0.01;
    constexpr double kMostFeed_mmPerRev = 1.0;
    constexpr double kChangeFrom = 8.0;
    constexpr double kChangeBefore = 23.0;
    Random random(seed);
    const double lnFeed = std::log(kLevelFeed_mmPerRev);
    const double lnOverhang = 0.5 * (std::log(kTableOverhangFrom_mm) + std::log(kTableOverhangTo_mm));
    const auto feasible = [&](const LawConstants& one) {
        return one.alpha > 0.1 &&
               optimalFeed_mmPerRev(one, targetDeflection_mm, kTableOverhangFrom_mm) <= kMostFeed_mmPerRev &&
               optimalFeed_mmPerRev(one, targetDeflection_mm, kTableOverhangTo_mm) >= kLeastFeed_mmPerRev;
    };
    double level = 0.0;
    LawConstants first;
    do {
        level = std::log(targetDeflection_mm) + 0.3 * random.gauss();
        first.alpha = random.uniform(0.35, 0.8);
        first.beta = random.uniform(0.1, 0.5);
        first.lnC = level - first.alpha * lnFeed - first.beta * lnOverhang;
    } while (!feasible(first));
    LawConstants second;
    do {
        second.alpha = first.alpha + 0.08 * random.gauss();
        second.beta = first.beta + 0.06 * random.gauss();
        second.lnC = level + 0.25 * random.gauss() - second.alpha * lnFeed - second.beta * lnOverhang;
    } while (!feasible(second));
    const auto part = static_cast<std::uint32_t>(random.uniform(kChangeFrom, kChangeBefore));
    machine.truth.changes = {{1, first}, {part, second}};
    machine.truth.drift_percentPerPart = 100.0 * std::expm1(random.uniform(0.0, 0.01));
    machine.sigmaFactor = std::exp2(random.uniform(-1.0, 1.0));
    machine.wearAlongBore = random.uniform(0.0, 0.03);
    machine.hardnessMemory = random.uniform(0.3, 0.9);
    machine.hardnessSpread = random.uniform(0.0, 0.03);
    machine.warm_K = random.uniform(0.0, 15.0);
    machine.warmSpread_K = 3.0;
    return machine;
}

}  // namespace kerf::boring
