// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/process/thermal/thermal_types.h"

namespace kerf {

/// The minutes since the baseline, so that a new model can run through them and be where the old one is. Keeps the
/// newest kMinutes; all memory is taken at construction.
class ThermalLog {
 public:
    static constexpr std::size_t kBaseline = 5;
    static constexpr std::size_t kMinutes = 720;

    ThermalLog() : m_minutes(kMinutes) {}

    void clear() noexcept {
        m_baselineCount = 0;
        m_end = 0;
    }
    void addBaseline(const ThermalMinute& minute) noexcept {
        if (m_baselineCount < kBaseline) m_baseline[m_baselineCount++] = minute;
    }
    void add(const ThermalMinute& minute) noexcept { m_minutes[m_end++ % kMinutes] = minute; }

    /// The origin at this minute became known later. @pre begin() ≤ k < end()
    void learn(std::size_t k, const std::array<double, kAxisCount>& drift_um, const std::array<bool, kAxisCount>& known,
               double noise_um) noexcept {
        ThermalMinute& minute = m_minutes[k % kMinutes];
        minute.spot = true;
        minute.learntKnown = known;
        minute.learntNoise_um = static_cast<float>(noise_um);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            minute.learnt_um[axis] = static_cast<float>(drift_um[axis]);
    }

    [[nodiscard]] bool baselineDone() const noexcept { return m_baselineCount == kBaseline; }
    [[nodiscard]] std::size_t baselineCount() const noexcept { return m_baselineCount; }
    [[nodiscard]] const ThermalMinute& baseline(std::size_t k) const noexcept { return m_baseline[k]; }
    /// Numbers of the minutes kept: begin() ≤ k < end(), counted from the baseline.
    [[nodiscard]] std::size_t begin() const noexcept { return m_end > kMinutes ? m_end - kMinutes : 0; }
    [[nodiscard]] std::size_t end() const noexcept { return m_end; }
    [[nodiscard]] const ThermalMinute& minute(std::size_t k) const noexcept { return m_minutes[k % kMinutes]; }

 private:
    std::array<ThermalMinute, kBaseline> m_baseline{};
    std::size_t m_baselineCount{0};
    std::vector<ThermalMinute> m_minutes;
    std::size_t m_end{0};
};

}  // namespace kerf
