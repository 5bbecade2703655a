// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/tool_memory.h"

#include <algorithm>
#include <cmath>

#include "engine/process/milling/stiffness_estimator.h"

namespace kerf::milling {
namespace {

constexpr double kGuessWeight = 3.0;       // ν₀: the guess counts like three tools
constexpr double kLnKxSpread = 0.10;       // τ₀: clamped anew, sticking out a little more or less
constexpr double kStiffnessSpread = 0.12;  // τ₀ of ln(C b): edges, another batch
constexpr double kTwoSided95 = 1.96;
constexpr double kLeastLogWeight = -6.0;  // a single surprising revolution outweighs it

struct Weighed {
    double mean{0.0};
    double variance{0.0};
};

double lnKxOf(std::size_t filter) noexcept {
    return StiffnessEstimator::lnKxOf(filter, {});
}

Weighed kxOf(const std::array<double, kMillingKxFilters>& logWeight) noexcept {
    const double most = *std::ranges::max_element(logWeight);
    Weighed out;
    double sum = 0.0;
    for (std::size_t i = 0; i < logWeight.size(); ++i) {
        const double weight = std::exp(logWeight[i] - most);
        sum += weight;
        out.mean += weight * lnKxOf(i);
        out.variance += weight * lnKxOf(i) * lnKxOf(i);
    }
    out.mean /= sum;
    out.variance = std::max(0.0, out.variance / sum - out.mean * out.mean);
    return out;
}

/// Sums over the tools that know the quantity.
struct Pool {
    double guess{0.0};
    std::uint32_t tools{0};
    double sum{0.0}, squares{0.0}, variances{0.0};

    void add(const Weighed& value) noexcept {
        ++tools;
        sum += value.mean;
        squares += value.mean * value.mean;
        variances += value.variance;
    }
    [[nodiscard]] double variance() const noexcept {
        const double n = tools;
        const double apart = std::max(0.0, squares - sum * sum / n);
        const double spread = (kGuessWeight * guess * guess + apart) / (kGuessWeight + n - 1.0);
        return spread * (1.0 + 1.0 / n) + variances / n;
    }
    [[nodiscard]] Expected expected() const noexcept {
        const double freedom = kGuessWeight + tools - 1.0;
        // Student's t, by its standard deviation: 3.4 for one tool, 1.96 for many.
        const double t = kTwoSided95 * std::sqrt(freedom / (freedom - 2.0));
        return {sum / tools, t * std::sqrt(variance()), tools};
    }
};

}  // namespace

double meanLnKx(const std::array<double, kMillingKxFilters>& logWeight) noexcept {
    return kxOf(logWeight).mean;
}

ToolMemory toolMemory(std::span<const PastTool> past) noexcept {
    Pool kx{kLnKxSpread};
    Pool stiffness{kStiffnessSpread};
    for (const PastTool& tool : past) {
        kx.add(kxOf(tool.kxLogWeight));
        if (tool.samePartType && tool.firstStiffness != 0.0) {
            stiffness.add({tool.firstStiffness, 0.0});
        }
    }
    ToolMemory memory;
    if (kx.tools > 0) {
        memory.lnKx = kx.expected();
        // Never narrower than half the way from one filter to the next: none of them is ruled out.
        const double halfStep = 0.5 * std::log(StiffnessEstimator::Params{}.ratio);
        const double variance = kx.variance() + halfStep * halfStep;
        for (std::size_t i = 0; i < kMillingKxFilters; ++i) {
            const double off = lnKxOf(i) - memory.lnKx->mean;
            memory.kxLogWeight[i] = -0.5 * off * off / variance;
        }
        const double most = *std::ranges::max_element(memory.kxLogWeight);
        for (double& weight : memory.kxLogWeight) {
            weight = std::max(weight - most, kLeastLogWeight);
        }
    }
    if (stiffness.tools > 0) {
        memory.stiffness = stiffness.expected();
    }
    return memory;
}

}  // namespace kerf::milling
