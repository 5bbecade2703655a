// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "ui/shell/page.h"

namespace kerf::ui {

/// A start names what the screen shows, and the engine refuses one of anything else. So the button rests, and says why,
/// from the moment something newer is on its way to the disk until the screen shows that the engine has it.
/// `process`: what a touch would start; none, when it starts nothing now.
void restUntilShown(ActionButton* start, const PageContext& context, std::function<std::optional<ProcessId>()> process);
inline void restUntilShown(ActionButton* start, const PageContext& context, ProcessId process) {
    restUntilShown(start, context, [process] { return std::optional(process); });
}

}  // namespace kerf::ui
