// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/port/machine_description.h"
#include "engine/port/machine_port.h"

namespace kerf::linuxcnc {

/// What the machine can do, from what the bridge found; empty: LinuxCNC has not been reached yet.
/// @param force the force sensor as the machine file has it: without a bandwidth from there or from HAL it is not used,
///              the lower of the two counts, and half the servo thread's rate is the most
[[nodiscard]] Capabilities capabilitiesOf(const std::optional<Fitted>& fitted, const DescribedForce& force) noexcept;

/// Nothing of this machine is commanded, for one reason; what it reports is still read.
void refuseAll(Capabilities& capabilities, const Sentence& why) noexcept;

}  // namespace kerf::linuxcnc
