// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/drawn_blank.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/core/random.h"

namespace kerf::milling {
namespace {

constexpr double kLow_mm = 1.0, kHigh_mm = 3.0;
constexpr double kStep_mm = 0.5;
constexpr std::size_t kSteps = 200;
using enum BlankKind;
constexpr std::array kKinds{Sine, Saw, Walk, Steps, Sine, Walk, Steps, Saw, Sine, Walk, Steps, Flat};

double logUniform(Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

/// Share 0 … 1 of the way up, after `turns` periods.
double wave(BlankKind kind, double turns, double rising) {
    const double phase = turns - std::floor(turns);
    if (kind == Sine) {
        return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * phase);
    }
    return phase < rising ? phase / rising : (1.0 - phase) / (1.0 - rising);
}

void drawWave(Random& random, BlankKind kind, std::vector<double>& heights_mm) {
    const double period_mm = logUniform(random, 5.0, 50.0);
    const double rising = random.uniform(0.1, 0.9);
    const double start = random.uniform();
    const double low_mm = random.uniform(kLow_mm, kHigh_mm - 1.0);
    const double high_mm = random.uniform(low_mm + 1.0, kHigh_mm);
    for (std::size_t i = 0; i < kSteps; ++i) {
        const double x_mm = (static_cast<double>(i) + 0.5) * kStep_mm;
        heights_mm.push_back(low_mm + (high_mm - low_mm) * wave(kind, x_mm / period_mm + start, rising));
    }
}

void drawWalk(Random& random, std::vector<double>& heights_mm) {
    const double deviation_mm = logUniform(random, 0.05, 0.3);
    double height_mm = random.uniform(kLow_mm, kHigh_mm);
    for (std::size_t i = 0; i < kSteps; ++i) {
        heights_mm.push_back(height_mm);
        height_mm += deviation_mm * random.gauss();
        height_mm = height_mm > kHigh_mm ? 2.0 * kHigh_mm - height_mm : height_mm;
        height_mm = std::clamp(height_mm < kLow_mm ? 2.0 * kLow_mm - height_mm : height_mm, kLow_mm, kHigh_mm);
    }
}

void drawSteps(Random& random, std::vector<double>& heights_mm) {
    while (heights_mm.size() < kSteps) {
        const auto wanted = static_cast<std::size_t>(std::lround(logUniform(random, 3.0, 30.0) / kStep_mm));
        heights_mm.insert(heights_mm.end(), std::min(wanted, kSteps - heights_mm.size()),
                          random.uniform(kLow_mm, kHigh_mm));
    }
}

}  // namespace

DrawnBlank drawnBlank(std::uint64_t seed, std::uint64_t index) {
    Random random = Random(seed).stream(index);
    DrawnBlank drawn{kKinds[index % kKinds.size()], {}};
    std::vector<double> heights_mm;
    switch (drawn.kind) {
        case Sine:
        case Saw:
            drawWave(random, drawn.kind, heights_mm);
            break;
        case Walk:
            drawWalk(random, heights_mm);
            break;
        case Steps:
            drawSteps(random, heights_mm);
            break;
        case Flat:
            heights_mm.assign(kSteps, random.uniform(kLow_mm, kHigh_mm));
            break;
    }
    drawn.blank = *BlankProfile::ofSegments(heights_mm, kStep_mm);
    return drawn;
}

}  // namespace kerf::milling
