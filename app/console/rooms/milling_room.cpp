// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/milling_room.h"

#include <array>

#include "engine/machine/simulated_milling.h"
#include "engine/milling/milling_loop.h"

namespace kerf::console {

bool MillingRoom::fits(const std::string& machineKind) const {
    return machineKind != "diamond-lathe";
}

std::unique_ptr<SimulatedProcess> MillingRoom::makePlant(const Options& options) {
    constexpr std::array kHeights_mm{1.0, 2.0, 3.0, 2.0, 1.0};  // the published experiment's blank
    constexpr double kSegment_mm = 20.0;
    SimulatedMilling::Params params;
    params.blanks = {milling::BlankProfile::ofSegments(kHeights_mm, kSegment_mm)->inAir(true, true)};
    params.seed = options.seed;
    return std::make_unique<SimulatedMilling>(params);
}

std::unique_ptr<ProcessLoop> MillingRoom::makeLoop() {
    return std::make_unique<MillingLoop>();
}

}  // namespace kerf::console
