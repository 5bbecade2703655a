// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/tapping/contour_error.h"

namespace kerf::tapping {

/// A record put in order: even sampling, unwrapped, into the hole positive, errors counted from its first sample.
struct CheckedRecord {
    double tick_s{0.0};
    std::vector<double> spindle_rev{};
    std::vector<double> z_mm{};
    std::vector<std::uint8_t> valid{};  ///< 0: no sample at this tick
    double missingShare{0.0};
    double wrap_rev{0.0};       ///< > 0: the spindle counter wrapped at this many revolutions
    bool mirrored{false};       ///< Z counted down into the hole
    double foundPitch_mm{0.0};  ///< slope of Z over the spindle
};

/// Samples that are no motion: a single one of the spindle or of Z from which its neighbours know nothing, as a reader
/// that lost a value writes (0, 1372, the value before). Ascending indices. A counter that wraps for
/// one sample only, where the spindle turns round, is one too: that costs a sample.
[[nodiscard]] std::vector<std::size_t> strayedSamples(std::span<const double> spindle_rev, std::span<const double> z_mm,
                                                      double pitch_mm);

/// Checks a record of any machine: spindle revolutions and Z over time.
///
/// Gaps in time become missing ticks, up to 5 % of them. Jumps of the spindle that are all of one size are a wrapped
/// counter and are taken out; other jumps, a turn of more than .25 rev between samples, less than 1 revolution of
/// depth, or a slope of Z over the spindle that differs from the pitch by more than 1 % are refused with the reason.
[[nodiscard]] Result<CheckedRecord> checkRecord(std::span<const double> time_s, std::span<const double> spindle_rev,
                                                std::span<const double> z_mm, double pitch_mm);

}  // namespace kerf::tapping
