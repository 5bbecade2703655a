// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace kerf {

/// SplitMix64 (Steele, Lea & Flood 2014): small, fast, the same digits on every platform.
///
/// The seed is always passed in; there is no global random state. gauss() is Box-Muller.
class Random {
 public:
    explicit constexpr Random(std::uint64_t seed) noexcept : m_state(seed) {}

    [[nodiscard]] constexpr std::uint64_t nextU64() noexcept {
        m_state += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }
    /// Uniform in [0, 1), 53 bits.
    [[nodiscard]] constexpr double uniform() noexcept { return static_cast<double>(nextU64() >> 11U) * 0x1.0p-53; }
    /// Uniform in [low, high).
    [[nodiscard]] constexpr double uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }
    /// Standard normal. Draws come in pairs: the cosine of one now, its sine at the next call.
    [[nodiscard]] double gauss() noexcept {
        if (m_hasSpare) {
            m_hasSpare = false;
            return m_spare;
        }
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        const double angle = 2.0 * std::numbers::pi * uniform();
        m_spare = radius * std::sin(angle);
        m_hasSpare = true;
        return radius * std::cos(angle);
    }
    /// An independent stream for a named purpose: same seed and index, same stream.
    [[nodiscard]] constexpr Random stream(std::uint64_t index) const noexcept {
        Random mixed(m_state ^ (index * 0xD1342543DE82EF95ULL + 0x632BE59BD9B4E019ULL));
        return Random(mixed.nextU64());
    }

 private:
    std::uint64_t m_state;
    double m_spare{0.0};
    bool m_hasSpare{false};
};

}  // namespace kerf
