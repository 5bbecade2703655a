// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/turning_room.h"

#include "engine/machine/simulated_turning.h"
#include "engine/turning/turning_loop.h"

namespace kerf::console {

bool TurningRoom::fits(const std::string& machineKind) const {
    return machineKind == "diamond-lathe";
}

std::unique_ptr<SimulatedProcess> TurningRoom::makePlant(const Options& options) {
    SimulatedTurning::Params params;
    params.seed = options.seed;
    return std::make_unique<SimulatedTurning>(params);
}

std::unique_ptr<ProcessLoop> TurningRoom::makeLoop() {
    return std::make_unique<TurningLoop>();
}

}  // namespace kerf::console
