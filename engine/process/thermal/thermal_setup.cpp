// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/thermal_setup.h"

namespace kerf::thermal {

std::optional<Sentence> whyUnusable(const ThermalSetup& setup) noexcept {
    const auto inRange = [](double value, double low, double high) { return value >= low && value <= high; };
    const bool usable = setup.revision > 0 && inRange(setup.period_min, 0.1, 60.0) &&
                        inRange(setup.allowed_um, 0.1, 100.0) && inRange(setup.maxShift_um, 1.0, 200.0) &&
                        inRange(setup.maxStep_umPerMin, 1.0, 60.0) && inRange(setup.warmUpSpeed_rpm, 100.0, 30'000.0) &&
                        inRange(setup.warmUp_min, 1.0, 120.0);
    return usable ? std::nullopt
                  : std::optional(
                        Sentence(KERF_TEXT("The thermal setup has a value outside its range; the last one stays.")));
}

}  // namespace kerf::thermal
