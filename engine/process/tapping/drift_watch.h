// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace kerf {

/// Slow rise of SAEC over production taps: cumulative sum of the relative excess over the mean of the first taps.
///
///   g ← max(0, g + S/S̄ − 1 − slack), alarm at g > .5; S̄ from the first five taps, slack .1
/// Source: Page 1954, continuous inspection schemes. Runs in the cycle.
class DriftWatch {
 public:
    static constexpr int kReferenceTaps = 5;
    static constexpr double kSlack = 0.1;
    static constexpr double kAlarm = 0.5;

    void reset() noexcept { *this = DriftWatch(); }
    /// @pre saec_mm ≥ 0
    void add(double saec_mm) noexcept {
        if (m_taps < kReferenceTaps) {
            m_sum_mm += saec_mm;
            ++m_taps;
            return;
        }
        const double mean_mm = m_sum_mm / kReferenceTaps;
        if (mean_mm > 0.0) {
            m_excess = std::max(0.0, m_excess + saec_mm / mean_mm - 1.0 - kSlack);
        }
    }
    [[nodiscard]] double excess() const noexcept { return m_excess; }
    [[nodiscard]] bool grown() const noexcept { return m_excess > kAlarm; }

 private:
    double m_sum_mm{0.0};
    int m_taps{0};
    double m_excess{0.0};
};

}  // namespace kerf
