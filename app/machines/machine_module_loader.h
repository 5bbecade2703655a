// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/port/machine_module.h"

namespace kerf {

/// The machine of the module `kerf-<name>.so` in the folder of the running program, not yet connected.
[[nodiscard]] Result<std::unique_ptr<MachinePort>> loadMachine(const std::string& name,
                                                               const MachineDescription& described = {});

}  // namespace kerf
