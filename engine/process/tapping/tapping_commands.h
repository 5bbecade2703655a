// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/command_list.h"
#include "engine/core/process.h"
#include "engine/core/work_order.h"
#include "engine/process/tapping/tapping_types.h"

/// What pages and services may ask of the tapping loop.
namespace kerf {

/// What is tapped. Between taps only; its first tap is made in the air.
struct LoadTappingJob {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
    TappingJob job{};
    std::optional<WorkOrder> order{};  ///< whose taps are made with it; empty: as named before
};

/// Gains and trim for the next taps.
struct LoadTapGains {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
    TapGains gains{};
    bool accept{false};      ///< an abort returns to these
    bool production{false};  ///< taps with them are parts, watched for drift; else trials
};

/// End the running tap in sync, restore the accepted gains.
struct AbortTap {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
};

/// Turn a tap that stands in the hole out in sync.
struct RecoverTap {
    static constexpr ProcessId kProcess = ProcessId::Tapping;
};

using TappingCommands = CommandList<LoadTappingJob, LoadTapGains, AbortTap, RecoverTap>;

}  // namespace kerf
