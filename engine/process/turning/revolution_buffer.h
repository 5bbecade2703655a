// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace kerf::turning {

/// Longest revolution the room can hold: 5 kHz at 2.5 rev/s.
inline constexpr std::size_t kMaxRevolutionSamples = 2000;

/// Samples per revolution, rounded to whole samples: d of eq. 5. 17.2 rev/s at 5 kHz gives 291.
[[nodiscard]] inline std::size_t samplesPerRevolution(double spindle_rps, double sampleRate_Hz) noexcept {
    const double samples = std::round(sampleRate_Hz / spindle_rps);
    return samples < 1.0 ? 1U : static_cast<std::size_t>(samples);
}

/// What the tool left one revolution ago: x_o(k) = x_i(k − d), eq. 5. Zero before the first revolution is complete.
class RevolutionBuffer {
 public:
    explicit RevolutionBuffer(std::size_t samples) noexcept : m_samples(samples) {
        assert(samples >= 1 && samples <= kMaxRevolutionSamples);
    }
    [[nodiscard]] double oldest() const noexcept { return m_values[m_next]; }
    void push(double value) noexcept {
        m_values[m_next] = value;
        m_next = m_next + 1 == m_samples ? 0 : m_next + 1;
    }
    /// The value pushed last is another one.
    void replaceNewest(double value) noexcept { m_values[(m_next == 0 ? m_samples : m_next) - 1] = value; }
    void shift(double by) noexcept {
        for (std::size_t i = 0; i < m_samples; ++i) {
            m_values[i] += by;
        }
    }
    void clear() noexcept {
        m_values.fill(0.0);
        m_next = 0;
    }
    [[nodiscard]] std::size_t samples() const noexcept { return m_samples; }

 private:
    std::size_t m_samples;
    std::size_t m_next{0};
    std::array<double, kMaxRevolutionSamples> m_values{};
};

}  // namespace kerf::turning
