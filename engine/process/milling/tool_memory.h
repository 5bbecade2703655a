// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/process/milling/milling_types.h"

/// What a new milling tool begins from: the tools of its kind that were in the spindle before it.
///
///   of a tool     ln k_x from its filters' weights (mean and variance), ln(C b) as the mean of its first part
///   mean          μ = Σ x_j/n
///   spread        τ² = (ν₀ τ₀² + Σ (x_j − μ)²)/(ν₀ + n − 1): a guess of the trade, and what the tools themselves say
///   the next one  N(μ, τ²(1 + 1/n) + mean variance of the x_j), its interval with Student's t of ν₀ + n − 1
///
/// k_x belongs to tool and holder, so tools of the same radius and flutes count; ln(C b) belongs to the material too,
/// so only those that cut the same part type do. Few tools: a wide interval. None: what the filters begin with anyway.
/// Only the beginning comes from here: every revolution is used as before, so a tool that is different shows it at
/// once. Pure function, recomputed whenever it is wanted; not for the cycle. Source: normal model with a scaled
/// inverse-χ² prior, Gelman et al., Bayesian Data Analysis, 3rd ed., section 3.3.
namespace kerf::milling {

struct PastTool {
    double firstStiffness{0.0};  ///< mean ln(C b) of its first part; 0: not known
    std::array<double, kMillingKxFilters> kxLogWeight{};
    bool samePartType{false};
};

/// A quantity of the next tool with its 95 % interval.
struct Expected {
    double mean{0.0};
    double half95{0.0};
    std::uint32_t tools{0};  ///< that it rests on
};

struct ToolMemory {
    std::optional<Expected> lnKx{};                       ///< k_x in N/mm
    std::optional<Expected> stiffness{};                  ///< ln(C b) of the first part
    std::array<double, kMillingKxFilters> kxLogWeight{};  ///< to begin with; only when lnKx is there
};

[[nodiscard]] ToolMemory toolMemory(std::span<const PastTool> past) noexcept;
/// Mean ln k_x of a tool's weights, k_x in N/mm.
[[nodiscard]] double meanLnKx(const std::array<double, kMillingKxFilters>& logWeight) noexcept;

}  // namespace kerf::milling
