// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/api/engine_api.h"
#include "ui/units/unit_system.h"

/// Why a machine takes no start now, in the same words on every page. Empty: it does.
namespace kerf::ui {

/// Nothing may move: no link, emergency stop, off, held.
[[nodiscard]] QString machineObstacle(const Status& status);
/// As above, and a stop that nobody has released yet.
[[nodiscard]] QString standingObstacle(const Status& status);
/// Why no part or program of `process` can be started from here.
[[nodiscard]] QString startObstacle(const Status& status, const Capability& cycleStart, ProcessId process,
                                    const UnitSystem& units);

}  // namespace kerf::ui
