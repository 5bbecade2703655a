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

namespace {

bool sameTuning(const StoredTuning& a, const StoredTuning& b) {
    const TapSettings& x = a.settings;
    const TapSettings& y = b.settings;
    return a.choice.thread == b.choice.thread && a.choice.tap == b.choice.tap &&
           a.choice.partType == b.choice.partType && a.choice.gear == b.choice.gear &&
           a.choice.speed_rpm == b.choice.speed_rpm && a.choice.depth_rev == b.choice.depth_rev &&
           x.spindleKp_perS == y.spindleKp_perS && x.zKp_perS == y.zKp_perS && x.zVelocityFf == y.zVelocityFf &&
           x.zAccelFf == y.zAccelFf;
}

/// The newest word on it: behind it in the list, since one that is accepted anew stands again.
const StoredTuning* wordOn(const std::vector<StoredTuning>& known, const StoredTuning& tuning) {
    for (std::size_t i = known.size(); i-- > 0 && &known[i] != &tuning;) {
        if (known[i].leftOut && sameTuning(known[i], tuning)) {
            return &known[i];
        }
    }
    return nullptr;
}

}  // namespace

std::vector<const StoredTuning*> standing(const std::vector<StoredTuning>& known) {
    std::vector<const StoredTuning*> out;
    for (const StoredTuning& tuning : known) {
        const StoredTuning* word = tuning.leftOut ? nullptr : wordOn(known, tuning);
        if (!tuning.leftOut && (word == nullptr || !*word->leftOut)) {
            out.push_back(&tuning);
        }
    }
    return out;
}

const StoredTuning* leftOutFor(const std::vector<StoredTuning>& known, const TapChoice& choice) {
    for (std::size_t i = known.size(); i-- > 0;) {
        if (!known[i].leftOut && serves(known[i], choice) != GainsSource::Machine) {
            const StoredTuning* word = wordOn(known, known[i]);
            if (word != nullptr && *word->leftOut) {
                return word;
            }
        }
    }
    return nullptr;
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
