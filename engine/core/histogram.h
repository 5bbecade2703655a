// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace kerf {

/// Times of a cycle in bins a quarter octave wide from 64 ns on: percentiles to 19 %, fixed memory, no allocation.
class TimeHistogram {
 public:
    static constexpr std::size_t kBins = 4 * 26 + 1;

    void add(std::int64_t time_ns) noexcept {
        ++m_bins[binOf(time_ns)];
        ++m_count;
        m_max_ns = time_ns > m_max_ns ? time_ns : m_max_ns;
    }
    void reset() noexcept { *this = TimeHistogram(); }
    [[nodiscard]] std::uint64_t count() const noexcept { return m_count; }
    [[nodiscard]] std::int64_t max_ns() const noexcept { return m_max_ns; }
    [[nodiscard]] std::uint64_t bin(std::size_t index) const noexcept { return m_bins[index]; }
    /// Upper edge of the bin that holds the given share (0…1) of all cycles; 0 when empty.
    [[nodiscard]] std::int64_t percentile_ns(double share) const noexcept {
        const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(m_count));
        std::uint64_t seen = 0;
        for (std::size_t i = 0; i < kBins; ++i) {
            seen += m_bins[i];
            if (seen > wanted || (seen == m_count && m_count > 0)) {
                return upperEdge_ns(i) < m_max_ns ? upperEdge_ns(i) : m_max_ns;
            }
        }
        return 0;
    }
    [[nodiscard]] static constexpr std::int64_t upperEdge_ns(std::size_t index) noexcept {
        const std::int64_t base = std::int64_t{64} << (index / 4);
        return base + base * static_cast<std::int64_t>(index % 4) / 4;
    }

 private:
    [[nodiscard]] static constexpr std::size_t binOf(std::int64_t time_ns) noexcept {
        if (time_ns <= 64) {
            return 0;
        }
        const auto value = static_cast<std::uint64_t>(time_ns - 1);
        const auto octave = static_cast<std::size_t>(std::bit_width(value) - 7);
        const std::uint64_t quarter = (value >> (octave + 4)) & 3U;
        const std::size_t index = octave * 4 + static_cast<std::size_t>(quarter) + 1;
        return index < kBins ? index : kBins - 1;
    }

    std::array<std::uint64_t, kBins> m_bins{};
    std::uint64_t m_count{0};
    std::int64_t m_max_ns{0};
};

}  // namespace kerf
