// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/milling_room.h"
#include "app/console/rooms/room.h"
#include "app/console/rooms/tapping_room.h"
#include "app/console/rooms/thermal_room.h"
#include "app/console/rooms/turning_room.h"

namespace kerf::console {

std::vector<std::unique_ptr<Room>> standardRooms() {
    std::vector<std::unique_ptr<Room>> rooms;
    rooms.push_back(std::make_unique<MillingRoom>());
    rooms.push_back(std::make_unique<TurningRoom>());
    rooms.push_back(std::make_unique<TappingRoom>());
    rooms.push_back(std::make_unique<ThermalRoom>());  // last: its heat comes from what the others cut
    return rooms;
}

}  // namespace kerf::console
