// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/port/machine_description.h"
#include "engine/port/machine_port.h"

/// A machine as a loadable module: one shared object beside the programs, one function. The programs start without it.
namespace kerf {

/// Makes a machine that is not yet connected, as it is described; the caller owns it. The module is never unloaded: the
/// sentences a machine speaks in are literals of the module.
using MakeMachine = MachinePort*(const MachineDescription&);
inline constexpr const char* kMakeMachineSymbol = "kerfMakeMachine";

}  // namespace kerf
