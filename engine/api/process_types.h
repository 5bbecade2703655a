// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/command_list.h"
#include "engine/process/boring/boring_commands.h"
#include "engine/process/milling/milling_commands.h"
#include "engine/process/tapping/tapping_commands.h"
#include "engine/process/thermal/thermal_commands.h"
#include "engine/process/turning/turning_commands.h"

/// What the processes bring to command, status and part record, each in one line. A process that needs none of its own
/// (its figures are those every part has) is not named here.
namespace kerf {

using ProcessCommands =
    BoringCommands::And<TurningCommands>::And<TappingCommands>::And<MillingCommands>::And<ThermalCommands>;

struct ProcessStatuses {
    BoringStatus boring{};
    TurningStatus turning{};
    TappingStatus tapping{};
    MillingStatus milling{};
    ThermalStatus thermal{};
};

struct ProcessRecords {
    BoringSchedule schedule{};
    FeedTrace feed{};
    TurningRecord turning{};
    MillingCut milling{};
    MillingToolState millingTool{};  ///< after this cut
    TapPart tap{};
};

}  // namespace kerf
