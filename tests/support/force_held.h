// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/core/reading.h"

namespace kerf::test {

/// How well a cut held its reference force: each revolution once, with the feed that was made meanwhile.
class ForceHeld {
 public:
    explicit ForceHeld(double reference_N) : m_reference_N(reference_N) {}

    void take(const Reading& force_N, double feed_mmPerS) {
        if (!force_N.good() || force_N.value == m_last_N) {
            return;
        }
        m_last_N = force_N.value;
        m_deviations.push_back(std::abs(m_last_N / m_reference_N - 1.0));
        m_low_mmPerS = std::min(m_low_mmPerS, feed_mmPerS);
        m_high_mmPerS = std::max(m_high_mmPerS, feed_mmPerS);
    }
    [[nodiscard]] std::size_t revolutions() const { return m_deviations.size(); }
    /// Deviation that this share of the revolutions keeps below.
    [[nodiscard]] double within(double share) const {
        std::vector<double> sorted = m_deviations;
        std::ranges::sort(sorted);
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    }
    /// Highest feed over the lowest: it is the feed that holds the force.
    [[nodiscard]] double feedRange() const { return m_high_mmPerS / m_low_mmPerS; }
    void print(const char* what) const {
        qInfo(
            "%s against its reference: %zu revolutions, median %.1f %%, nine of ten within %.1f %%, feed %.2f to "
            "%.2f mm/s",
            what, revolutions(), 100.0 * within(0.5), 100.0 * within(0.9), m_low_mmPerS, m_high_mmPerS);
    }

 private:
    double m_reference_N;
    double m_last_N{0.0};
    double m_low_mmPerS{1e9};
    double m_high_mmPerS{0.0};
    std::vector<double> m_deviations{};
};

}  // namespace kerf::test
