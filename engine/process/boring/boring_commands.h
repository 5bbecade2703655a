// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/core/command_list.h"
#include "engine/core/process.h"
#include "engine/core/work_order.h"
#include "engine/process/boring/boring_types.h"

/// What pages and services may ask of the boring loop.
namespace kerf {

/// The schedule for the next part. A part being cut keeps the one it began with.
struct LoadBoringSchedule {
    static constexpr ProcessId kProcess = ProcessId::Boring;
    BoringSchedule schedule{};
    std::optional<WorkOrder> order{};  ///< whose parts are cut with it; empty: as named before
};

using BoringCommands = CommandList<LoadBoringSchedule>;

}  // namespace kerf
