// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "db/shop/pg_connection.h"

namespace kerf::db {

/// A lot of another console, as far as a memory needs it: without estimator states and proposed schedules.
struct ShopLot {
    std::string store{};  ///< which console's history
    LotHistory history{};
    std::vector<RoomRecordRow> records{};  ///< of the kinds asked for, with the lot's id as subject; newest first
};

struct ShopLotQuery {
    ProcessId process{ProcessId::Boring};
    std::string partType{};
    std::string ownStore{};  ///< whose lots are not wanted, whatever their epoch: a clone's lots are this console's own
    bool simulated{false};   ///< machines are simulators; a real one never learns from a simulator, nor the other way
    std::vector<std::string> recordKinds{};
    std::uint32_t lotsPerMachine{1};
    std::uint32_t lots{1};
};

/// Lots of the same part type (by name) on the shop's other machines: the newest of each machine, the newest history of
/// each console. A lot with a row that cannot be read is not among them. Reads only; needs the rights of kerf_reader.
/// @throws PgFailure
[[nodiscard]] std::vector<ShopLot> shopLots(PgConnection& server, const ShopLotQuery& query);

}  // namespace kerf::db
