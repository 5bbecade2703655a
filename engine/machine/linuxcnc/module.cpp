// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/port/machine_module.h"

#include "engine/machine/linuxcnc/linuxcnc_machine.h"

extern "C" __attribute__((visibility("default"))) kerf::MachinePort* kerfMakeMachine(
    const kerf::MachineDescription& described) {
    kerf::linuxcnc::LinuxCncMachine::Params params;
    params.rsh.host = described.commandHost;
    params.rsh.port = described.commandPort;
    params.described = described;
    return new kerf::linuxcnc::LinuxCncMachine(params);
}
