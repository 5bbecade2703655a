// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/tapping_room.h"

#include "engine/machine/simulated_tapping.h"
#include "engine/tapping/tapping_loop.h"

namespace kerf::console {

bool TappingRoom::fits(const std::string& machineKind) const {
    return machineKind != "diamond-lathe";
}

std::unique_ptr<SimulatedProcess> TappingRoom::makePlant(const Options& options) {
    SimulatedTapping::Params params;
    params.seed = options.seed;
    return std::make_unique<SimulatedTapping>(params);
}

std::unique_ptr<ProcessLoop> TappingRoom::makeLoop() {
    return std::make_unique<TappingLoop>(*m_exchange);
}

}  // namespace kerf::console
