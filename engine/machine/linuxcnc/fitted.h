// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/port/machine_port.h"

namespace kerf::linuxcnc {

/// What the machine can do, from what the bridge found; empty: LinuxCNC has not been reached yet.
[[nodiscard]] Capabilities capabilitiesOf(const std::optional<Fitted>& fitted) noexcept;

/// Nothing of this machine is commanded, for one reason; what it reports is still read.
void refuseAll(Capabilities& capabilities, const Sentence& why) noexcept;

}  // namespace kerf::linuxcnc
