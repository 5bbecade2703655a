// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/core/process.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// What one loop would like in this cycle. Empty fields leave the machine as it is. engine/limits decides.
struct LoopOutputs {
    std::optional<double> feedScale{};
    bool feedHold{false};
    std::array<std::optional<double>, kAxisCount> workOffset_um{};
    std::optional<double> toolTrim_um{};
    std::optional<double> zTrim_um{};
    /// Numbered by the loop: process index in the top byte, then a counter, so that replies find their way back. A
    /// start or abort of the loop's own program passes in every mode, its synchronous retract also while advising;
    /// anything else only while the loop controls.
    PortRequest request{};
};

}  // namespace kerf
