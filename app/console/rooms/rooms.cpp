// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "app/console/rooms/boring_room.h"
#include "app/console/rooms/milling_room.h"
#include "app/console/rooms/room.h"
#include "app/console/rooms/tapping_room.h"
#include "app/console/rooms/thermal_room.h"
#include "app/console/rooms/turning_room.h"

namespace kerf::console {
namespace {
constexpr double kSpeedForCurves = 40.0;
}

std::vector<std::unique_ptr<Room>> standardRooms() {
    std::vector<std::unique_ptr<Room>> rooms;
    rooms.push_back(std::make_unique<BoringRoom>());
    rooms.push_back(std::make_unique<MillingRoom>());
    rooms.push_back(std::make_unique<TurningRoom>());
    rooms.push_back(std::make_unique<TappingRoom>());
    rooms.push_back(std::make_unique<ThermalRoom>());  // last: its heat comes from what the others cut
    return rooms;
}

std::uint32_t madeUpTo(PartReader& reader, ProcessId process, std::optional<PartId> last) {
    PartQuery query;
    query.process = process;
    if (last) {
        query.before = *last + 1;
    }
    const auto count = reader.count(query, std::numeric_limits<std::uint32_t>::max());
    return count ? static_cast<std::uint32_t>(*count) : 0;
}

bool cutBeforehand(EngineApi& engine, ProcessId process, std::uint32_t cut, std::uint32_t wanted) {
    const Status& status = engine.status();
    const bool busy = status.program == ProgramState::Running || status.program == ProgramState::Paused;
    if (cut >= wanted) {
        return !busy;
    }
    if (!busy && !status.held) {
        Command speed;  // the last one slowly enough for the curves on its page
        speed.action = SetSimulationSpeed{cut + 1 == wanted ? kSpeedForCurves : 0.0};
        (void)engine.send(speed);
        Command start;
        start.action = StartPart{process};
        (void)engine.send(start);
    }
    return false;
}

}  // namespace kerf::console
