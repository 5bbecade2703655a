// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace kerf::sensors {

inline constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// The clock of all stamps; the same in every process of a computer.
[[nodiscard]] inline std::int64_t monotonic_ns() noexcept {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace kerf::sensors
