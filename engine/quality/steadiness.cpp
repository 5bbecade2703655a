// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/quality/steadiness.h"

#include <algorithm>
#include <cmath>

#include "engine/quality/capability.h"
#include "engine/quality/distributions.h"

namespace kerf::quality {
namespace {

constexpr double kTests = 3.0;
constexpr double kLambda = 0.2;
constexpr std::size_t kFewestForDrift = 10;  // below, η is far from normal

double limitOfOne(std::size_t points) {
    return normalQuantile(1.0 - chanceOfOnePoint(points) / 2.0);
}

bool levelHolds(std::span<const double> values, double centre, double sigma) {
    const double limit = ewmaLimit(sigma, kLambda, limitOfOne(values.size()));
    double level = 0.0;
    return std::ranges::all_of(values, [&](double value) {
        level += kLambda * (value - centre - level);
        return std::abs(level) <= limit;
    });
}

bool doesNotDrift(std::span<const double> values) {
    if (values.size() < kFewestForDrift) {
        return true;
    }
    Moments moments;
    double steps = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        moments.add(values[i]);
        steps += i > 0 ? (values[i] - values[i - 1]) * (values[i] - values[i - 1]) : 0.0;
    }
    const double n = static_cast<double>(values.size());
    const double squares = moments.deviation() * moments.deviation() * (n - 1.0);
    if (!(squares > 0.0)) {
        return true;
    }
    const double z = (2.0 - steps / squares) / std::sqrt(4.0 * (n - 2.0) / (n * n - 1.0));
    return z <= normalQuantile(1.0 - kUnsteadyByChance / kTests);
}

bool noneFarOff(std::span<const double> values, double centre, double sigma) {
    const double limit = sigma * limitOfOne(values.size());
    return std::ranges::all_of(values, [&](double value) { return std::abs(value - centre) <= limit; });
}

}  // namespace

double chanceOfOnePoint(std::size_t points) noexcept {
    return kUnsteadyByChance / kTests / static_cast<double>(points);
}

bool isSteady(std::span<const double> errors) {
    return errors.empty() || (noneFarOff(errors, 0.0, 1.0) && levelHolds(errors, 0.0, 1.0) && doesNotDrift(errors));
}

bool isSteadySeries(std::span<const double> values) {
    const CentreLine line = centreLine(values);
    Moments moments;
    for (const double value : values) {
        moments.add(value);
    }
    const double s = moments.deviation();
    return !(s > 0.0) || !(line.sigma > 0.0) ||
           (noneFarOff(values, line.centre, s) && levelHolds(values, line.centre, line.sigma) && doesNotDrift(values));
}

}  // namespace kerf::quality
