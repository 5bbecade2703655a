// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/port/machine_module.h"

namespace kerf {

/// Names of the modules `kerf-<name>.so` in the folder of the running program, sorted: what --machine may say beside
/// the built-in machines. linuxcnc, which is a package of its own, is one of them also where it is not installed.
[[nodiscard]] std::vector<std::string> machineModules();

/// The machine of the module `kerf-<name>.so` in the folder of the running program, not yet connected.
[[nodiscard]] Result<std::unique_ptr<MachinePort>> loadMachine(const std::string& name,
                                                               const MachineDescription& described = {});

}  // namespace kerf
