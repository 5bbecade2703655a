// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "engine/port/machine_port.h"

namespace kerf::turning {

enum class ForceState : std::uint8_t { Good, Lost, Saturated };

/// Whether the force signal lives, and where its zero lies.
///
/// Lost: the machine says so, no number, or the same number for 11 samples (2.2 ms): no live sensor is that still.
/// Zero: the slow mean of the force in the air (.1 s), known after 500 samples; signed like the force, N.
class ForceHealth {
 public:
    static constexpr std::uint32_t kZeroSamples = 500;

    [[nodiscard]] ForceState judge(const FastSample& sample) noexcept {
        if (sample.quality == Quality::Saturated) {
            return ForceState::Saturated;
        }
        if (sample.quality != Quality::Good || !std::isfinite(sample.force_N)) {
            return ForceState::Lost;
        }
        m_same = sample.force_N == m_last_N ? m_same + 1 : 0;
        m_last_N = sample.force_N;
        return m_same >= kStuckSamples ? ForceState::Lost : ForceState::Good;
    }
    /// A part begins: nothing of the old signal counts as stuck, and the zero is looked at anew.
    void begin() noexcept {
        m_same = 0;
        m_airSamples = 0;
    }
    /// The tool is in the air again: the zero is taken anew from here.
    void leaveCut() noexcept { m_airSamples = 0; }
    /// A sample in the air. Gives, once per stay there and from the second one on, how far the zero has moved.
    [[nodiscard]] std::optional<double> takeZero_N(double raw_N) noexcept {
        ++m_airSamples;
        m_zero_N += std::max(kZeroShare, 1.0 / static_cast<double>(m_airSamples)) * (raw_N - m_zero_N);
        if (m_airSamples != kZeroSamples) {
            return std::nullopt;
        }
        const double moved_N = m_zero_N - m_before_N;
        const bool first = !m_known;
        m_before_N = m_zero_N;
        m_known = true;
        return first ? 0.0 : moved_N;
    }
    [[nodiscard]] double zero_N() const noexcept { return m_zero_N; }
    [[nodiscard]] bool zeroKnown() const noexcept { return m_known; }

 private:
    static constexpr int kStuckSamples = 11;
    static constexpr double kZeroShare = 1.0 / 500.0;

    double m_last_N{0.0};
    int m_same{0};
    double m_zero_N{0.0};
    double m_before_N{0.0};
    std::uint32_t m_airSamples{0};
    bool m_known{false};
};

}  // namespace kerf::turning
