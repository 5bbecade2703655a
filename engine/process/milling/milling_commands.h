// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/command_list.h"
#include "engine/core/process.h"
#include "engine/core/work_order.h"
#include "engine/process/milling/milling_types.h"

/// What pages and services may ask of the milling loop.
namespace kerf {

/// Everything for the next parts; refused while one is being cut.
struct LoadMillingSetup {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingSetup setup{};
    std::optional<WorkOrder> order{};  ///< whose parts are milled with it; empty: as named before
};

/// Blank profile for the preview law; refused while a part is being cut. An empty one takes it away.
struct LoadMillingBlank {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingBlank blank{};
};

/// Change of law, bumpless, also while cutting.
struct SetMillingLaw {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingLaw law{MillingLaw::Model};
};

/// Reference force, also while cutting.
struct SetMillingReference {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    double reference_N{0.0};
};

/// Take the mean force of this cut (or of the last one) as the reference.
struct TeachMillingReference {
    static constexpr ProcessId kProcess = ProcessId::Milling;
};

/// What was learnt of the tool before a restart; refused while a part is being cut.
struct RestoreMillingTool {
    static constexpr ProcessId kProcess = ProcessId::Milling;
    MillingToolState tool{};
};

/// A new tool; wear and tool stiffness are learnt anew.
struct NewMillingTool {
    static constexpr ProcessId kProcess = ProcessId::Milling;
};

using MillingCommands = CommandList<LoadMillingSetup, LoadMillingBlank, SetMillingLaw, SetMillingReference,
                                    TeachMillingReference, RestoreMillingTool, NewMillingTool>;

}  // namespace kerf
