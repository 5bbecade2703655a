// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tap_record.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/process/tapping/tuner.h"

namespace kerf::tapping {
namespace {

constexpr std::size_t kLeastSamples = 50;
constexpr double kWrapJump_rev = 0.5;  ///< a larger step between neighbours is no motion
constexpr double kLargestStep_rev = 0.25;
constexpr double kPitchTolerance = 0.01;
constexpr double kSlowestTick_s = 0.1;  ///< slower is no record of a tap, or one in ms
constexpr double kUneven = 0.25;        ///< deviation of a time step, in ticks, that is uneven sampling

double medianStep_s(std::span<const double> time_s) {
    std::vector<double> steps(time_s.size() - 1);
    for (std::size_t k = 0; k < steps.size(); ++k)
        steps[k] = time_s[k + 1] - time_s[k];
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Takes the jumps out of a wrapped counter. `at` holds each sample's tick: a step is compared with the speed before
/// it. Returns the wrap found, 0 without jumps, negative when the jumps are of no one whole number of revolutions.
double unwrap_rev(std::vector<double>& spindle_rev, const std::vector<std::size_t>& at) {
    const std::vector<double> raw = spindle_rev;
    const auto forEachJump = [&](auto&& jump) {
        double rate_revPerTick = 0.0;
        for (std::size_t k = 1; k < raw.size(); ++k) {
            const double ticks = static_cast<double>(at[k] - at[k - 1]);
            const double surplus_rev = raw[k] - raw[k - 1] - rate_revPerTick * ticks;
            const bool jumped = std::abs(surplus_rev) >= kWrapJump_rev;
            jump(k, jumped ? surplus_rev : 0.0);
            if (!jumped) rate_revPerTick = (raw[k] - raw[k - 1]) / ticks;
        }
    };
    double smallest_rev = 0.0;
    forEachJump([&](std::size_t, double surplus_rev) {
        const double size_rev = std::abs(surplus_rev);
        if (size_rev > 0.0) smallest_rev = smallest_rev == 0.0 ? size_rev : std::min(smallest_rev, size_rev);
    });
    if (smallest_rev == 0.0) return 0.0;
    const double wrap_rev = std::max(1.0, std::round(smallest_rev));  // counters wrap at whole revolutions
    bool fits = true;
    double offset_rev = 0.0;
    forEachJump([&](std::size_t k, double surplus_rev) {
        const double turns = std::round(surplus_rev / wrap_rev);
        if (surplus_rev != 0.0) fits = fits && std::abs(surplus_rev - turns * wrap_rev) < kLargestStep_rev;
        offset_rev -= turns * wrap_rev;
        spindle_rev[k] = raw[k] + offset_rev;
    });
    return fits ? wrap_rev : -1.0;
}

/// Slope of Z over the spindle, mm/rev, cleared of both axes' lags: least squares of z on turn and on the speed and
/// acceleration of both, as two loops of second order under one command satisfy it.
double slope_mm(const std::vector<double>& spindle_rev, std::span<const double> z_mm,
                const std::vector<std::size_t>& at) {
    using Row = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Row right = Row::Zero();
    constexpr std::size_t kSpan = 4;  // wide differences: encoder steps and noise stay small beside the motion
    for (std::size_t k = kSpan; k + kSpan < z_mm.size(); ++k) {
        if (at[k + kSpan] - at[k - kSpan] != 2 * kSpan) continue;
        const auto speed = [&](const auto& x) { return x[k + kSpan] - x[k - kSpan]; };
        const auto accel = [&](const auto& x) { return x[k + kSpan] - 2.0 * x[k] + x[k - kSpan]; };
        Row row;
        row << 1.0, spindle_rev[k] - spindle_rev.front(), speed(spindle_rev), accel(spindle_rev), speed(z_mm),
            accel(z_mm);
        normal += row * row.transpose();
        right += row * (z_mm[k] - z_mm.front());
    }
    const Row scale = normal.diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
    normal = scale.asDiagonal() * normal * scale.asDiagonal();
    normal.diagonal().array() += 1e-9;
    const Row found = normal.ldlt().solve(Row(scale.asDiagonal() * right));
    return scale(1) * found(1);
}

}  // namespace

std::vector<std::size_t> strayedSamples(std::span<const double> spindle_rev, std::span<const double> z_mm,
                                        double pitch_mm) {
    assert(spindle_rev.size() == z_mm.size());
    std::vector<std::size_t> found;
    const auto strayed = [](std::span<const double> x, std::size_t k, double most) {
        return std::abs(x[k] - x[k - 1]) > most && std::abs(x[k + 1] - x[k]) > most &&
               std::abs(x[k + 1] - x[k - 1]) < most;
    };
    for (std::size_t k = 1; k + 1 < z_mm.size(); ++k) {
        if (strayed(spindle_rev, k, kWrapJump_rev) || strayed(z_mm, k, kWrapJump_rev * pitch_mm)) {
            found.push_back(k);
        }
    }
    return found;
}

Result<CheckedRecord> checkRecord(std::span<const double> time_s, std::span<const double> spindle_rev,
                                  std::span<const double> z_mm, double pitch_mm) {
    assert(time_s.size() == spindle_rev.size() && time_s.size() == z_mm.size());
    const std::size_t n = time_s.size();
    if (n < kLeastSamples) {
        return fail(KERF_TEXT("The record has %1 samples; at least %2 are needed."),
                    SentenceArg(static_cast<double>(n), 0), SentenceArg(static_cast<double>(kLeastSamples), 0));
    }
    for (std::size_t k = 1; k < n; ++k) {
        if (!(time_s[k] > time_s[k - 1])) {
            return fail(KERF_TEXT("Time does not rise at sample %1; expected one row per sample, oldest first."),
                        SentenceArg(static_cast<double>(k + 1), 0));
        }
    }
    CheckedRecord record;
    record.tick_s = medianStep_s(time_s);
    if (record.tick_s > kSlowestTick_s) {
        return fail(KERF_TEXT("The samples are %1 s apart, at most %2 s are expected: is the time in ms?"),
                    SentenceArg(record.tick_s, 3), SentenceArg(kSlowestTick_s, 1));
    }
    std::size_t total = 0;
    std::vector<std::size_t> at(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double ticks = k == 0 ? 0.0 : (time_s[k] - time_s[k - 1]) / record.tick_s;
        const double whole = std::round(ticks);
        if (k > 0 && (whole < 1.0 || std::abs(ticks - whole) > kUneven * std::max(1.0, 0.02 * whole))) {
            return fail(KERF_TEXT("Sampling is uneven: %1 ms between samples %2 and the next, %3 ms elsewhere."),
                        SentenceArg(1000.0 * (time_s[k] - time_s[k - 1]), 3), SentenceArg(static_cast<double>(k), 0),
                        SentenceArg(1000.0 * record.tick_s, 3));
        }
        at[k] = k == 0 ? 0 : at[k - 1] + static_cast<std::size_t>(whole);
        // A gap may be long in time; how much of it is refused below.
        if (at[k] > 100 * n) break;
        total = at[k] + 1;
    }
    record.missingShare = 1.0 - static_cast<double>(n) / static_cast<double>(total);
    if (record.missingShare > kMaxMissingShare) {
        return fail(KERF_TEXT("%1 % of the samples are missing; a record with more than %2 % does not count."),
                    SentenceArg(100.0 * record.missingShare, 1), SentenceArg(100.0 * kMaxMissingShare, 0));
    }
    std::vector<double> turned(spindle_rev.begin(), spindle_rev.end());
    record.wrap_rev = unwrap_rev(turned, at);
    if (record.wrap_rev < 0.0) {
        return fail(
            KERF_TEXT("The spindle position jumps by no whole number of revolutions: counts are lost or the "
                      "column is not in revolutions."));
    }
    double largestStep_rev = 0.0;
    for (std::size_t k = 1; k < n; ++k) {
        const double step_rev = std::abs(turned[k] - turned[k - 1]) / static_cast<double>(at[k] - at[k - 1]);
        largestStep_rev = std::max(largestStep_rev, step_rev);
    }
    if (largestStep_rev > kLargestStep_rev) {
        return fail(KERF_TEXT("The spindle turns up to %1 rev between two samples; at most %2 rev: sample faster."),
                    SentenceArg(largestStep_rev, 2), SentenceArg(kLargestStep_rev, 2));
    }

    const auto [lowest, highest] = std::ranges::minmax(turned);
    if (highest - lowest < 1.0) {
        return fail(KERF_TEXT("The spindle turns %1 rev in the whole record; a tap needs at least one."),
                    SentenceArg(highest - lowest, 2));
    }
    const double found_mm = slope_mm(turned, z_mm, at);
    record.mirrored = found_mm < 0.0;
    record.foundPitch_mm = std::abs(found_mm);
    if (std::abs(record.foundPitch_mm / pitch_mm - 1.0) > kPitchTolerance) {
        return fail(KERF_TEXT("Z moves %1 mm per revolution; that does not fit a pitch of %2 mm."),
                    SentenceArg(record.foundPitch_mm, 4), SentenceArg(pitch_mm, 4));
    }

    const bool spindleBackward = std::abs(lowest - turned.front()) > std::abs(highest - turned.front());
    const double turnSign = spindleBackward ? -1.0 : 1.0;
    const double zSign = turnSign * (record.mirrored ? -1.0 : 1.0);
    record.spindle_rev.assign(total, 0.0);
    record.z_mm.assign(total, 0.0);
    record.valid.assign(total, 0);
    for (std::size_t k = 0; k < n; ++k) {
        record.spindle_rev[at[k]] = turnSign * (turned[k] - turned.front());
        record.z_mm[at[k]] = zSign * (z_mm[k] - z_mm.front());
        record.valid[at[k]] = 1;
    }
    return record;
}

}  // namespace kerf::tapping
