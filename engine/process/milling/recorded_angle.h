// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"

namespace kerf::milling {

/// A recorded spindle angle as the averager takes it: revolutions that only rise.
struct CheckedAngle {
    std::vector<double> angle_rev{};
    bool countedDown{false};
    double wrap_rev{0.0};  ///< > 0: the counter began again after this many revolutions
};

/// Unwraps and turns a recorded angle of a cutting spindle.
///
/// Read: rising, counting down, a counter that begins again after a whole number of revolutions. Refused with the
/// sample: more than .25 rev from sample to sample or more than 30,000 rpm (degrees, mostly), jumps that are of no
/// whole number of revolutions, or of 360 (degrees), an angle that does not move, a spindle that turns both ways.
/// @pre time rises strictly; both are of one length and not empty
[[nodiscard]] Result<CheckedAngle> checkAngle(std::span<const double> time_s, std::span<const double> angle_rev);

}  // namespace kerf::milling
