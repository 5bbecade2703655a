// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/command_list.h"
#include "engine/core/process.h"
#include "engine/core/work_order.h"
#include "engine/process/turning/turning_types.h"

/// What pages and services may ask of the turning loop.
namespace kerf {

/// The cut of the next part. A part being cut keeps the one it began with.
struct LoadTurningSetup {
    static constexpr ProcessId kProcess = ProcessId::Turning;
    TurningSetup setup{};
    std::optional<WorkOrder> order{};  ///< whose parts are turned with it; empty: as named before
};

/// Another law, bumpless, also while cutting.
struct SetTurningController {
    static constexpr ProcessId kProcess = ProcessId::Turning;
    TurningController controller{TurningController::Tones};
};

using TurningCommands = CommandList<LoadTurningSetup, SetTurningController>;

}  // namespace kerf
