// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/hard_lathe.h"

#include <cmath>

#include "engine/core/random.h"

namespace kerf::turning {

HardLathe hardLathe(std::uint64_t seed) {
    HardLathe lathe;
    lathe.seed = seed;
    if (seed == 0) {
        return lathe;
    }
    Random random(seed);
    const auto logUniform = [&](double low, double high) { return low * std::pow(high / low, random.uniform()); };
    const double gain_NPerUm = ProcessParams{}.dcGain() * logUniform(0.7, 1.4);
    lathe.process.a1 = random.uniform(0.86, 0.885);
    const double zero = random.uniform(0.952, 0.965);
    lathe.process.b0 = gain_NPerUm * (1.0 - lathe.process.a1) / (1.0 - zero);
    lathe.process.b1 = -zero * lathe.process.b0;
    lathe.slidePole = random.uniform(0.992, 0.996);
    lathe.extraDelay = random.uniform() < 0.5 ? 0 : 1;
    lathe.spindle_rps = random.uniform(10.0, 30.0);
    lathe.positionNoise_um *= logUniform(0.5, 3.0);
    lathe.forceNoise_N *= logUniform(0.5, 3.0);
    lathe.depth_um = random.uniform(2.0, 10.0);
    lathe.white_um = random.uniform(0.02, 0.1);
    const auto kind = [&] {
        return static_cast<DisturbanceKind>(random.uniform() * static_cast<double>(kDisturbanceKinds));
    };
    lathe.kinds[0] = kind();
    lathe.kinds[1] = kind();
    lathe.kindCount = random.uniform() < 0.5 ? 1 : 2;
    return lathe;
}

std::vector<double> disturbanceOf(const HardLathe& lathe, std::size_t samples) {
    const Random random(lathe.seed);
    std::vector<double> sum_um =
        drawDisturbance(lathe.kinds[0], samples, Random(random.stream(1)).nextU64(), lathe.white_um);
    if (lathe.kindCount > 1) {
        const std::vector<double> other_um =
            drawDisturbance(lathe.kinds[1], samples, Random(random.stream(2)).nextU64(), 0.0);
        for (std::size_t k = 0; k < samples; ++k) {
            sum_um[k] += other_um[k];
        }
    }
    return sum_um;
}

}  // namespace kerf::turning
