// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/core/force_signal.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

/// A force signal as a person has to know it: its bandwidth, and where its zero stands.
struct ForceSignalView {
    ForceSignal signal{};
    ForceZeroState zero{ForceZeroState::Own};
    double zero_N{0.0};
    double doubt_N{0.0};
};
/// "bandwidth 300 Hz, zero 12 N"; empty without a sensor.
[[nodiscard]] QString forceSignalText(const ForceSignalView& force, const UnitSystem& units, int decimals);

}  // namespace kerf::ui
