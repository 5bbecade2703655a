// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/service/boring/boring_recipe.h"
#include "db/api/lot_reader.h"
#include "db/api/room_records.h"
#include "engine/process/boring/lot_tracker.h"

/// The boring memory on the database: which lots it rests on, what was announced in them, what was left out and why.
/// Nothing of the estimate is stored; it is computed from the lots each time.
///
/// Room records of boring, subject: the lot's id
///   boring.change   {"part": 11, "change": "insert" | "reground" | "material" | "none"}   newest per part holds
///   boring.lot      {"insert_grade": "…", "material": "…"}                                 newest holds
///   boring.memory   {"left_out": true | false}, with a reason                              newest holds
///   boring.shop_lots  lots of other machines as the shop had them when the lot was opened (shop_memory.h)
/// Subject of boring.memory for a lot of another console: memorySubject(store, lot).
namespace kerf {

inline constexpr const char* kChangeRecord = "boring.change";
inline constexpr const char* kLotRecord = "boring.lot";
inline constexpr const char* kMemoryRecord = "boring.memory";

inline constexpr const char* kShopLotsRecord = "boring.shop_lots";

struct BoringMemoryLot {
    LotRow lot{};
    boring::MemoryContext context{};
    std::vector<boring::Stretch> stretches{};
    bool leftOut{false};
    std::string reason{}, author{};  ///< of leaving it out or taking it in again
    std::string store{};             ///< of another console's lot: which console; empty: of this one
    std::int64_t memoryId{0};        ///< its id in boring::Memory; ids of other consoles' lots are below −1
};

/// What a lot begins from.
struct BoringMemoryBasis {
    std::vector<BoringMemoryLot> past{};  ///< measured lots of the machine that were opened before it, oldest first
    std::vector<BoringMemoryLot> shop{};  ///< of other machines, from the shop; empty: not told to draw on them
    boring::MemoryContext context{};
    std::vector<boring::AnnouncedChange> announced{};  ///< in the lot itself
};

/// For a stored lot. The newest kMemoryLots lots before it are read.
inline constexpr std::size_t kMemoryLots = 60;
[[nodiscard]] Result<BoringMemoryBasis> readBoringMemory(LotReader& lots, RoomRecordReader& records, const LotRow& lot);
/// For a lot that does not exist yet.
[[nodiscard]] Result<BoringMemoryBasis> readBoringMemory(LotReader& lots, RoomRecordReader& records,
                                                         const boring::MemoryContext& context);
/// Machine, part type, insert grade and material of lots, the last two as told when they were opened.
[[nodiscard]] Result<std::vector<boring::MemoryContext>> memoryContextsOf(RoomRecordReader& records,
                                                                          std::span<const LotRow> lots);

/// Changes announced in one lot, by part.
[[nodiscard]] Result<std::vector<boring::AnnouncedChange>> announcedIn(RoomRecordReader& records, LotId lot);

/// What a stored lot has shown, computed from its surviving bores alone. Empty: nothing measured, or no recipe.
[[nodiscard]] std::vector<boring::Stretch> stretchesOf(const LotHistory& history,
                                                       std::vector<boring::AnnouncedChange> announced);
/// Grade, material, announcements and whether the lot was left out, from its own room records, newest first.
struct BoringLotTold {
    std::string insertGrade{}, material{};
    std::vector<boring::AnnouncedChange> announced{};
    bool leftOut{false};
    std::string reason{}, author{};
};
[[nodiscard]] BoringLotTold toldOf(LotId lot, std::span<const RoomRecordRow> records);
/// What boring.memory says of these lots at this console wins over what their own console said.
[[nodiscard]] Result<void> applyLeftOut(RoomRecordReader& records, std::span<BoringMemoryLot> lots);
[[nodiscard]] std::string memorySubject(const std::string& store, LotId lot);

/// Lots left out are not handed on.
[[nodiscard]] boring::LotBegin lotBegin(const BoringMemoryBasis& basis, const BoringRecipe& recipe);

[[nodiscard]] std::string changeJson(std::uint32_t part, std::optional<boring::StretchKind> kind);
[[nodiscard]] std::string lotRecordJson(const std::string& insertGrade, const std::string& material);
[[nodiscard]] std::string leftOutJson(bool leftOut);

}  // namespace kerf
