// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/recorded_angle.h"

#include <algorithm>
#include <cmath>

namespace kerf::milling {
namespace {

constexpr double kJump_rev = 0.5;       ///< a step this far from the one before is no motion
constexpr double kCoarsest_rev = 0.25;  ///< between two samples
constexpr double kFastest_rpm = 30'000.0;
constexpr double kSlowest_rpm = 10.0;  ///< slower is no cut, or one whose time is in ms
constexpr double kDegrees = 360.0;
constexpr double kWhole_rev = 0.05;  ///< a wrap misses a whole number by a change of speed at most
constexpr double kOneWay = 0.9;      ///< share of the turning that goes the way of the whole

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

Result<CheckedAngle> degrees(double step) {
    return fail(KERF_TEXT("angle_rev turns %1 rev between samples; revolutions expected, at most %2 between samples. A "
                          "column in degrees is named angle_deg."),
                SentenceArg(step, 3), SentenceArg(kCoarsest_rev, 2));
}

}  // namespace

Result<CheckedAngle> checkAngle(std::span<const double> time_s, std::span<const double> angle_rev) {
    CheckedAngle out;
    out.angle_rev.assign(angle_rev.begin(), angle_rev.end());
    const std::size_t n = angle_rev.size();
    if (n < 2) {
        return out;
    }
    std::vector<double> steps, times;
    for (std::size_t k = 1; k < n; ++k) {
        steps.push_back(std::abs(angle_rev[k] - angle_rev[k - 1]));
        times.push_back(time_s[k] - time_s[k - 1]);
    }
    const double step_rev = median(steps);
    if (step_rev > kCoarsest_rev) {
        return degrees(step_rev);
    }
    const double speed_rpm = 60.0 * step_rev / median(times);
    if (speed_rpm > kFastest_rpm) {
        return fail(KERF_TEXT("angle_rev means %1 rpm; at most %2 rpm are expected. A column in degrees is named "
                              "angle_deg."),
                    SentenceArg(speed_rpm, 0), SentenceArg(kFastest_rpm, 0));
    }
    if (speed_rpm > 0.0 && speed_rpm < kSlowest_rpm) {
        return fail(KERF_TEXT("angle_rev means %1 rpm; at least %2 rpm are expected: is the time in ms?"),
                    SentenceArg(speed_rpm, 2), SentenceArg(kSlowest_rpm, 0));
    }
    // Jumps are compared with the step before them, so that a wrap is found at any speed.
    double rate_rev = 0.0;
    double offset_rev = 0.0;
    double along_rev = 0.0;
    double against_rev = 0.0;
    for (std::size_t k = 1; k < n; ++k) {
        const double raw_rev = angle_rev[k] - angle_rev[k - 1];
        const double surplus_rev = raw_rev - rate_rev;
        double moved_rev = raw_rev;
        if (std::abs(surplus_rev) >= kJump_rev) {
            const double turns = std::round(surplus_rev);
            if (std::abs(std::abs(turns) - kDegrees) < 1.0) {
                return degrees(std::abs(turns));
            }
            if (std::abs(surplus_rev - turns) > std::max(kWhole_rev, std::abs(rate_rev)) ||
                (out.wrap_rev > 0.0 && std::abs(turns) != out.wrap_rev)) {
                return fail(KERF_TEXT("the spindle's angle jumps by %1 rev at sample %2; expected an angle that rises, "
                                      "falls or begins again after whole revolutions."),
                            SentenceArg(raw_rev, 3), SentenceArg(static_cast<double>(k + 1), 0));
            }
            out.wrap_rev = std::abs(turns);
            offset_rev -= turns;
            moved_rev = raw_rev - turns;
        } else {
            rate_rev = raw_rev;
        }
        (moved_rev > 0.0 ? along_rev : against_rev) += std::abs(moved_rev);
        out.angle_rev[k] = angle_rev[k] + offset_rev;
    }
    const double turned_rev = along_rev + against_rev;
    if (!(turned_rev > 0.0)) {
        return fail(KERF_TEXT("the spindle's angle does not move in the whole record."));
    }
    if (std::max(along_rev, against_rev) < kOneWay * turned_rev) {
        return fail(
            KERF_TEXT("the spindle turns %1 rev one way and %2 rev the other; expected a cut in one direction."),
            SentenceArg(along_rev, 2), SentenceArg(against_rev, 2));
    }
    out.countedDown = against_rev > along_rev;
    if (out.countedDown) {
        for (double& value : out.angle_rev) {
            value = -value;
        }
    }
    return out;
}

}  // namespace kerf::milling
