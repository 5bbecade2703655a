// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tap_span.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
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

/// Positions without the counter's jumps: resets, and beginning again each revolution.
std::vector<double> unwrapped(std::span<const double> spindle_rev) {
    std::vector<double> out(spindle_rev.size(), 0.0);
    double rate_rev = 0.0;
    for (std::size_t k = 1; k < spindle_rev.size(); ++k) {
        const double step_rev = spindle_rev[k] - spindle_rev[k - 1];
        if (std::abs(step_rev - rate_rev) < kJump_rev) {
            rate_rev = step_rev;
        }
        out[k] = out[k - 1] + rate_rev;
    }
    return out;
}

/// The way in and out of the hole between two rapids, as a share of the record.
class Way {
 public:
    Way(std::span<const double> spindle_rev, std::span<const double> z_mm)
        : m_spindle_rev(unwrapped(spindle_rev)), m_z_mm(z_mm) {
        const auto [low, high] = std::ranges::minmax_element(z_mm);
        const double leave_mm = kLeft * (*high - *low);
        for (const auto extreme : {low, high}) {
            takeBottom(static_cast<std::size_t>(extreme - z_mm.begin()), leave_mm);
        }
    }
    /// First sample, and the one behind the last.
    [[nodiscard]] std::pair<std::size_t, std::size_t> ends() const {
        const std::size_t n = m_z_mm.size();
        if (m_turned_rev <= 0.0) {
            return {0, n};
        }
        const std::size_t begin = standing();
        const double height_mm = m_z_mm[begin] - m_z_mm[m_bottom];
        const auto above_mm = [&](std::size_t k) {
            return height_mm > 0.0 ? m_z_mm[k] - m_z_mm[begin] : m_z_mm[begin] - m_z_mm[k];
        };
        std::size_t out = m_after;
        while (out < n && above_mm(out) < 0.0) {
            ++out;
        }
        double farthest_mm = 0.0;
        for (std::size_t k = out; k < n; ++k) {
            farthest_mm = std::max(farthest_mm, above_mm(k));
        }
        const bool away = farthest_mm > kStanding * std::abs(height_mm) && !follows(out, n - 1);
        return {begin, away ? out + 1 : n};
    }

 private:
    static constexpr double kLeft = 0.1;       ///< share of Z's range by which it has left the bottom for certain
    static constexpr double kStanding = 0.01;  ///< share of the depth, and of the speed
    static constexpr double kFollows = 0.2;    ///< share of the way by which a motion with the spindle may miss
    static constexpr std::size_t kStill = 16;  ///< samples

    /// The bottom of a hole is where Z and spindle turn round together.
    void takeBottom(std::size_t bottom, double leave_mm) {
        const auto left = [&](std::size_t k) { return std::abs(m_z_mm[k] - m_z_mm[bottom]) > leave_mm; };
        std::size_t before = bottom;
        while (before > 0 && !left(before)) {
            --before;
        }
        std::size_t after = bottom;
        while (after + 1 < m_z_mm.size() && !left(after)) {
            ++after;
        }
        const double in_rev = m_spindle_rev[bottom] - m_spindle_rev[before];
        const double out_rev = m_spindle_rev[after] - m_spindle_rev[bottom];
        if (left(before) && left(after) && in_rev * out_rev < 0.0 && std::abs(in_rev) > m_turned_rev) {
            m_turned_rev = std::abs(in_rev);
            m_bottom = bottom;
            m_before = before;
            m_after = after;
            m_slope_mm = (m_z_mm[bottom] - m_z_mm[before]) / in_rev;
        }
    }
    [[nodiscard]] bool follows(std::size_t from, std::size_t to) const {
        const double way_mm = m_z_mm[to] - m_z_mm[from];
        return std::abs(way_mm - m_slope_mm * (m_spindle_rev[to] - m_spindle_rev[from])) < kFollows * std::abs(way_mm);
    }
    /// Where Z began to stand before it went in; 0 when it came with the spindle or did not stand.
    [[nodiscard]] std::size_t standing() const {
        const double speed_mm =
            std::abs(m_z_mm[m_bottom] - m_z_mm[m_before]) / static_cast<double>(m_bottom - m_before);
        std::size_t still = m_before;
        while (still >= kStill && std::abs(m_z_mm[still] - m_z_mm[still - kStill]) > kStanding * kStill * speed_mm) {
            --still;
        }
        if (still < kStill) {
            return 0;
        }
        const double settled_mm = kStanding * kStill * speed_mm;
        std::size_t begin = still;
        while (begin > 0 && std::abs(m_z_mm[begin - 1] - m_z_mm[still]) <= settled_mm) {
            --begin;
        }
        double farthest_mm = 0.0;
        for (std::size_t k = 0; k < begin; ++k) {
            farthest_mm = std::max(farthest_mm, std::abs(m_z_mm[k] - m_z_mm[still]));
        }
        if (farthest_mm <= kStanding * std::abs(m_z_mm[still] - m_z_mm[m_bottom])) {
            return 0;  // it stood, and moved no more than an axis at rest does
        }
        return follows(0, begin) ? 0 : begin;
    }

    std::vector<double> m_spindle_rev;
    std::span<const double> m_z_mm;
    std::size_t m_bottom{0}, m_before{0}, m_after{0};
    double m_turned_rev{0.0};  ///< 0: no bottom
    double m_slope_mm{0.0};    ///< per revolution
};

TapSpan findBetweenRapids(std::span<const double> spindle_rev, std::span<const double> z_mm) {
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
    std::size_t deepest = moving;
    for (std::size_t k = moving; k < n; ++k) {
        if (std::abs(z_mm[k] - z_mm[0]) > std::abs(z_mm[deepest] - z_mm[0])) deepest = k;
    }
    std::size_t out = deepest;  // behind it the spindle may turn on without Z
    while (out < n && std::abs(z_mm[out] - z_mm[0]) > band_mm) {
        ++out;
    }
    const auto offset_rev = synchronisation_rev(spindle_rev, z_mm, moving, out);
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

}  // namespace

TapSpan findTap(std::span<const double> spindle_rev, std::span<const double> z_mm) {
    const std::size_t n = z_mm.size();
    if (n < kLeastFitted) {
        return {0, n, false};
    }
    const auto [from, to] = Way(spindle_rev, z_mm).ends();
    TapSpan tap = findBetweenRapids(spindle_rev.subspan(from, to - from), z_mm.subspan(from, to - from));
    tap.begin += from;
    tap.end += from;
    return tap;
}

}  // namespace kerf::tapping
