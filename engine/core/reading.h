// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace kerf {

/// How far a reading can be trusted. Anything but Good never makes a machine faster.
enum class Quality : std::uint8_t {
    Missing,    ///< not fitted, unplugged, or never read
    Stale,      ///< older than its source promises
    Bad,        ///< not a number, or the source says it is faulty
    Saturated,  ///< at the end of the sensor's range
    Good,
};

/// One signal of a machine: value in the unit its name ends in, time of measurement on the machine's clock, quality.
struct Reading {
    double value{0.0};
    std::int64_t stamp_ns{0};
    Quality quality{Quality::Missing};

    [[nodiscard]] bool good() const noexcept { return quality == Quality::Good && std::isfinite(value); }
};

}  // namespace kerf
