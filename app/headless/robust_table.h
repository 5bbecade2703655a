// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

/// What `kerf <process> robust` has in common: hard machines drawn from seeds, the default against the simple law on
/// each of them, one CSV row per machine or the figures of all of them.
namespace kerf::headless {

struct RobustOptions {
    std::uint32_t machines{200};
    std::uint64_t seed{1};
    bool csv{false};

    void addTo(CLI::App& command);
    /// Seed of machine `number` (from 1), for `simulate --machine-seed`; never 0, which is the reference machine.
    [[nodiscard]] std::uint64_t machineSeed(std::uint32_t number) const noexcept;
};

/// How the default stands against the simple law over all machines. A ratio is a figure of the default over the same of
/// the simple law, smaller is better.
class RobustTally {
 public:
    struct Machine {
        double ratio{1.0};
        bool worse{false};
        bool unstable{false};        ///< the default
        bool unstableSimple{false};  ///< the simple law
    };
    void add(const Machine& machine);
    /// ratio_median, share_worse, worst_ratio, share_unstable, share_unstable_simple, in this order. @pre one was added
    [[nodiscard]] std::vector<std::pair<std::string, double>> figures() const;

 private:
    std::vector<double> m_ratios{};
    double m_worse{0.0}, m_unstable{0.0}, m_unstableSimple{0.0};  ///< machines
};

}  // namespace kerf::headless
