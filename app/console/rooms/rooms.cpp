// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/milling_room.h"
#include "app/console/rooms/room.h"
#include "app/console/rooms/tapping_room.h"
#include "app/console/rooms/turning_room.h"

namespace kerf::console {

std::vector<std::unique_ptr<Room>> standardRooms() {
    std::vector<std::unique_ptr<Room>> rooms;
    rooms.push_back(std::make_unique<MillingRoom>());
    rooms.push_back(std::make_unique<TurningRoom>());
    rooms.push_back(std::make_unique<TappingRoom>());
    return rooms;
}

}  // namespace kerf::console
