// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/service/boring/boring_memory.h"

namespace kerf::db {
class PgConnection;
struct ShopLot;
}  // namespace kerf::db

/// Memory that draws on the shop: lots of the same part type on other machines, when the recipe says so.
///
/// The machine is the widest step of the tree (engine/process/boring/memory.h): its spread is estimated from how much
/// machines differ, so a lot of another machine counts through that step only and the less the more they differ.
///
/// What the shop had when a lot was opened is kept with the lot (room record boring.shop_lots) as evidence, stretch by
/// stretch with every digit, not as an estimate: the lot begins from the same after a restart and without the shop, and
/// a lot left out is the same computation without it.
namespace kerf {

inline constexpr std::uint32_t kShopLotsPerMachine = 6;
inline constexpr std::uint32_t kShopLots = 40;

/// What the shop has. @throws db::PgFailure
[[nodiscard]] std::vector<BoringMemoryLot> askShopLots(db::PgConnection& server, const std::string& partType,
                                                       const std::string& ownStore, bool simulated);
/// As evidence; lots without a usable bore are left away. Their own console's "left out" holds until this one says
/// otherwise.
[[nodiscard]] std::vector<BoringMemoryLot> memoryLotsOf(std::span<const db::ShopLot> lots);

/// Body of boring.shop_lots.
[[nodiscard]] std::string shopLotsJson(std::span<const BoringMemoryLot> lots);
/// A lot that cannot be read is left away.
[[nodiscard]] std::vector<BoringMemoryLot> shopLotsFromJson(const std::string& text);
/// What was kept with a lot, with what was left out since; empty: nothing was.
[[nodiscard]] Result<std::vector<BoringMemoryLot>> keptShopLots(RoomRecordReader& records, LotId lot);

}  // namespace kerf
