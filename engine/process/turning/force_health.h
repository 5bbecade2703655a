// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/port/machine_port.h"

namespace kerf::turning {

enum class ForceState : std::uint8_t { Good, Lost, Saturated };

/// Whether the force signal lives; its zero is engine/cycle/force_zero.h's.
///
/// Lost: the machine says so, no number, or the same number for 11 samples (2.2 ms): no live sensor is that still.
class ForceHealth {
 public:
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
    /// A part begins: nothing of the old signal counts as stuck.
    void begin() noexcept { m_same = 0; }

 private:
    static constexpr int kStuckSamples = 11;

    double m_last_N{0.0};
    int m_same{0};
};

}  // namespace kerf::turning
