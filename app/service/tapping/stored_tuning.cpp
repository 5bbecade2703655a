// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/tapping/stored_tuning.h"

#include <algorithm>
#include <cmath>

namespace kerf::tapping {

GainsSource serves(const StoredTuning& tuning, const TapChoice& choice) {
    constexpr double kSame = 1e-3;
    const TapChoice& of = tuning.choice;
    const bool same =
        of.thread == choice.thread && of.gear == choice.gear && of.partType == choice.partType && of.tap == choice.tap;
    const double speed = std::abs(choice.speed_rpm / of.speed_rpm - 1.0);
    if (!same || speed > kSpeedRange + kSame) return GainsSource::Machine;
    const double depth = std::abs(choice.depth_rev / of.depth_rev - 1.0);
    return speed < kSame && depth < kSame ? GainsSource::Stored : GainsSource::StoredGains;
}

TapCurve thinned(const TapCurve& curve, std::size_t most) {
    const std::size_t count = curve.error_um.size();
    if (count <= most || most < 2) return curve;
    const std::size_t step = (count + most - 1) / most;
    TapCurve out;
    for (std::size_t k = 0; k < count; ++k) {
        if (k % step != 0 && k + 1 != count) continue;
        if (k <= curve.reversal) out.reversal = out.error_um.size();
        out.spindle_rev.push_back(curve.spindle_rev[k]);
        out.error_um.push_back(curve.error_um[k]);
    }
    return out;
}

}  // namespace kerf::tapping
