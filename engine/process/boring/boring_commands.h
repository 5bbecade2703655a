// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/core/command_list.h"
#include "engine/core/process.h"
#include "engine/process/boring/boring_types.h"

/// What pages and services may ask of the boring loop.
namespace kerf {

/// The schedule for the next part. A part being cut keeps the one it began with.
struct LoadBoringSchedule {
    static constexpr ProcessId kProcess = ProcessId::Boring;
    BoringSchedule schedule{};
};

/// Whose parts the next ones are, when a lot has been chosen and no schedule of it accepted yet.
struct NameBoringLot {
    static constexpr ProcessId kProcess = ProcessId::Boring;
    std::int64_t lot{0};
};

using BoringCommands = CommandList<LoadBoringSchedule, NameBoringLot>;

}  // namespace kerf
