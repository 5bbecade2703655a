// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/robust_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "engine/core/random.h"

namespace kerf::headless {

void RobustOptions::addTo(CLI::App& command) {
    command.add_option("--machines", machines, "how many")->check(CLI::Range(1U, 100000U))->capture_default_str();
    command.add_option("--seed", seed, "same seed, same digits")->capture_default_str();
    command.add_flag("--csv", csv, "one row per machine");
}

std::uint64_t RobustOptions::machineSeed(std::uint32_t number) const noexcept {
    return Random(seed).stream(number).nextU64() >> 32U | 1U;
}

void RobustTally::add(const Machine& machine) {
    m_ratios.push_back(machine.ratio);
    m_worse += machine.worse ? 1.0 : 0.0;
    m_unstable += machine.unstable ? 1.0 : 0.0;
    m_unstableSimple += machine.unstableSimple ? 1.0 : 0.0;
}

std::vector<std::pair<std::string, double>> RobustTally::figures() const {
    std::vector<double> sorted = m_ratios;
    std::ranges::sort(sorted);
    const auto machines = static_cast<double>(sorted.size());
    return {{"ratio_median", sorted[sorted.size() / 2]},
            {"share_worse", m_worse / machines},
            {"worst_ratio", sorted.back()},
            {"share_unstable", m_unstable / machines},
            {"share_unstable_simple", m_unstableSimple / machines}};
}

}  // namespace kerf::headless
