// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/core/alarm.h"
#include "engine/core/sentence.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// A stop a loop asks for. It counts in every mode; a feed hold of a loop that does not control only forbids starts.
struct StopWish {
    StopKind kind{StopKind::None};
    AlarmCode cause{0};
    Sentence reason{};
};

/// What one loop would like in this cycle. Empty fields leave the machine as it is. engine/limits decides.
struct LoopOutputs {
    std::optional<double> feedScale{};
    /// Scale at which the planned feed is made, of a program that has not declared it.
    std::optional<double> plannedFeedScale{};
    bool feedHold{false};  ///< for this cycle only; what a person must have seen is a stop
    StopWish stop{};
    bool outOfWork{false};  ///< what stood in the work has been turned out
    std::array<std::optional<double>, kAxisCount> workOffset_um{};
    bool forceReset{false};  ///< the force amplifier's reset line, while the loop's own program runs
    std::optional<double> toolTrim_um{};
    std::optional<double> zTrim_um{};
    /// Numbered by the loop: process index in the top byte, then a counter, so that replies find their way back. A
    /// start or abort of the loop's own program passes in every mode, its synchronous retract also while advising;
    /// anything else only while the loop controls.
    PortRequest request{};
};

}  // namespace kerf
