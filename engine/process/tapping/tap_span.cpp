// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tap_span.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace kerf::tapping {
namespace {

constexpr double kJump_rev = 0.5;    ///< a larger step between neighbours is no motion
constexpr double kBefore_rev = 0.2;  ///< less turning before synchronisation is the record's own begin
constexpr double kMoving = 0.02;     ///< share of Z's range that is motion for certain
constexpr std::size_t kSpan = 4;     ///< samples: wide differences keep encoder steps small
constexpr std::size_t kLeastFitted = 50;

/// Sample after the last jump at or before `last`; 0 without one.
std::size_t afterLastJump(std::span<const double> spindle_rev, std::size_t last) {
    double rate_rev = 0.0;
    std::size_t found = 0;
    for (std::size_t k = 1; k <= last; ++k) {
        const double step_rev = spindle_rev[k] - spindle_rev[k - 1];
        if (std::abs(step_rev - rate_rev) >= kJump_rev) {
            found = k;
        } else {
            rate_rev = step_rev;
        }
    }
    return found;
}

/// The spindle's position at which Z, cleared of lags, stands where it stood at first; relative to spindle[from].
std::optional<double> synchronisation_rev(std::span<const double> spindle_rev, std::span<const double> z_mm,
                                          std::size_t from, std::size_t to) {
    using Row = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Row right = Row::Zero();
    std::size_t fitted = 0;
    for (std::size_t k = std::max(from, kSpan); k + kSpan < to; ++k) {
        const auto speed = [&](std::span<const double> x) { return x[k + kSpan] - x[k - kSpan]; };
        const auto accel = [&](std::span<const double> x) { return x[k + kSpan] - 2.0 * x[k] + x[k - kSpan]; };
        if (std::abs(speed(spindle_rev)) > 2.0 * kSpan * kJump_rev / 2.0) {
            break;  // a wrapped counter: what lies before is enough
        }
        Row row;
        row << 1.0, spindle_rev[k] - spindle_rev[from], speed(spindle_rev), accel(spindle_rev), speed(z_mm),
            accel(z_mm);
        normal += row * row.transpose();
        right += row * (z_mm[k] - z_mm[0]);
        ++fitted;
    }
    if (fitted < kLeastFitted) {
        return std::nullopt;
    }
    const Row scale = normal.diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
    normal = scale.asDiagonal() * normal * scale.asDiagonal();
    normal.diagonal().array() += 1e-9;
    const Row solved = normal.ldlt().solve(Row(scale.asDiagonal() * right));
    const double slope_mm = scale(1) * solved(1);
    const double offset_rev = -scale(0) * solved(0) / slope_mm;
    return std::isfinite(offset_rev) ? std::optional(offset_rev) : std::nullopt;
}

}  // namespace

TapSpan findTap(std::span<const double> spindle_rev, std::span<const double> z_mm) {
    const std::size_t n = z_mm.size();
    TapSpan whole{0, n, false};
    if (n < kLeastFitted) {
        return whole;
    }
    const auto [low, high] = std::ranges::minmax(z_mm);
    const double band_mm = kMoving * (high - low);
    std::size_t moving = 0;
    while (moving < n && std::abs(z_mm[moving] - z_mm[0]) <= band_mm) {
        ++moving;
    }
    if (band_mm <= 0.0 || moving + kLeastFitted > n) {
        return whole;
    }
    const std::size_t jump = afterLastJump(spindle_rev, moving);
    const auto offset_rev = synchronisation_rev(spindle_rev, z_mm, moving, n);
    if (!offset_rev) {
        return whole;
    }
    const double start_rev = spindle_rev[moving] + *offset_rev;
    std::size_t begin = moving;
    for (std::size_t k = moving; k-- > jump;) {
        if (std::abs(spindle_rev[k] - start_rev) >= std::abs(spindle_rev[begin] - start_rev)) {
            break;
        }
        begin = k;
    }
    TapSpan tap = whole;
    const bool turnedBefore = jump > 0 || std::abs(spindle_rev[begin] - spindle_rev[0]) > kBefore_rev;
    if (turnedBefore) {
        tap.begin = begin;
        tap.counterReset = jump > 0 && begin == jump;
    }
    // Back at the angle of synchronisation after the deepest point: what follows is no thread.
    std::size_t deepest = moving;
    for (std::size_t k = moving; k < n; ++k) {
        if (std::abs(z_mm[k] - z_mm[0]) > std::abs(z_mm[deepest] - z_mm[0])) deepest = k;
    }
    const double way = spindle_rev[deepest] >= start_rev ? 1.0 : -1.0;
    std::size_t back = deepest;
    while (back < n && way * (spindle_rev[back] - start_rev) > 0.0) {
        ++back;
    }
    if (back + 1 < n && std::abs(spindle_rev[n - 1] - spindle_rev[back]) > kBefore_rev) {
        tap.end = back + 1;
    }
    return tap;
}

}  // namespace kerf::tapping
