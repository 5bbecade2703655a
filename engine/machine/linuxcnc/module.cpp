// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/port/machine_module.h"

#include "engine/machine/linuxcnc/linuxcnc_machine.h"

extern "C" __attribute__((visibility("default"))) kerf::MachinePort* kerfMakeMachine() {
    return new kerf::linuxcnc::LinuxCncMachine(kerf::linuxcnc::LinuxCncMachine::Params{});
}
