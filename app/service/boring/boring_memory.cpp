// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_memory.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/service/boring/lot_records.h"
#include "app/service/boring/shop_memory.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMostLots = 1000;
constexpr std::uint32_t kMostRecords = 100'000;
constexpr std::size_t kMachine = 0;
constexpr std::size_t kPartType = 1;
constexpr std::size_t kGrade = 2;
constexpr std::size_t kMaterial = 3;

const char* changeKey(boring::StretchKind kind) {
    switch (kind) {
        case boring::StretchKind::Reground:
            return "reground";
        case boring::StretchKind::Material:
            return "material";
        case boring::StretchKind::Insert:
        case boring::StretchKind::Unexplained:
            break;
    }
    return "insert";
}

std::optional<boring::StretchKind> changeOf(const std::string& key) {
    for (const auto kind :
         {boring::StretchKind::Insert, boring::StretchKind::Reground, boring::StretchKind::Material}) {
        if (key == changeKey(kind)) {
            return kind;
        }
    }
    return std::nullopt;
}

// Records of another console come from outside: a wrong kind of value is none.
std::string wordIn(const nlohmann::json& json, const char* key, const char* fallback = "") {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string(fallback);
}
std::uint32_t numberIn(const nlohmann::json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number_unsigned() ? found->get<std::uint32_t>() : 0U;
}

/// The room records of boring that memory needs, by lot.
struct Told {
    struct LeftOut {
        bool leftOut{false};
        std::string reason{}, author{};
    };
    std::map<std::string, std::map<std::uint32_t, std::optional<boring::StretchKind>>> changes{};
    std::map<std::string, std::pair<std::string, std::string>> grades{};  // insert grade, material
    std::map<std::string, LeftOut> leftOut{};

    void take(std::span<const RoomRecordRow> rows) {
        for (const RoomRecordRow& row : rows) {  // newest first: what is there already holds
            const auto json = nlohmann::json::parse(row.bodyJson, nullptr, false);
            if (!json.is_object()) {
                continue;
            }
            if (row.kind == kChangeRecord) {
                changes[row.subject].try_emplace(numberIn(json, "part"), changeOf(wordIn(json, "change", "none")));
            } else if (row.kind == kLotRecord) {
                grades.try_emplace(row.subject, wordIn(json, "insert_grade"), wordIn(json, "material"));
            } else if (row.kind == kMemoryRecord) {
                const auto out = json.find("left_out");
                leftOut.try_emplace(row.subject, LeftOut{out != json.end() && out->is_boolean() && out->get<bool>(),
                                                         row.reason, row.author});
            }
        }
    }
    [[nodiscard]] std::vector<boring::AnnouncedChange> announcedIn(LotId lot) const {
        std::vector<boring::AnnouncedChange> out;
        if (const auto found = changes.find(std::to_string(lot)); found != changes.end()) {
            for (const auto& [part, kind] : found->second) {
                if (kind) {
                    out.push_back({part, *kind});
                }
            }
        }
        return out;
    }
    [[nodiscard]] boring::MemoryContext contextOf(const LotRow& lot) const {
        boring::MemoryContext context;
        context.names[kMachine] = lot.machineName;
        context.names[kPartType] = lot.partTypeName;
        if (const auto found = grades.find(std::to_string(lot.id)); found != grades.end()) {
            context.names[kGrade] = found->second.first;
            context.names[kMaterial] = found->second.second;
        }
        return context;
    }
};

/// `subject`: of one lot; empty: of all.
Result<Told> readTold(RoomRecordReader& records, std::initializer_list<const char*> kinds, const std::string& subject) {
    Told told;
    for (const char* kind : kinds) {
        const auto rows = records.roomRecords(ProcessId::Boring, kind, subject, kMostRecords);
        if (!rows) {
            return tl::unexpected(rows.error());
        }
        told.take(*rows);
    }
    return told;
}

Result<Told> readTold(RoomRecordReader& records) {
    return readTold(records, {kChangeRecord, kLotRecord, kMemoryRecord}, {});
}

Result<BoringMemoryBasis> readBefore(LotReader& reader, const std::string& machine, std::optional<LotId> before,
                                     const Told& told) {
    const auto all = reader.lots(std::nullopt, kMostLots, ProcessId::Boring);  // newest first
    if (!all) {
        return tl::unexpected(all.error());
    }
    BoringMemoryBasis basis;
    for (const LotRow& lot : *all) {
        if (lot.machineName != machine || (before && lot.id >= *before)) {
            continue;
        }
        const auto history = reader.history(lot.id);
        if (!history) {
            return tl::unexpected(history.error());
        }
        auto stretches = *history ? stretchesOf(**history, told.announcedIn(lot.id)) : std::vector<boring::Stretch>{};
        if (stretches.empty()) {
            continue;
        }
        BoringMemoryLot one{lot, told.contextOf(lot), std::move(stretches), false, {}, {}, {}, lot.id};
        if (const auto found = told.leftOut.find(std::to_string(lot.id)); found != told.leftOut.end()) {
            one.leftOut = found->second.leftOut;
            one.reason = found->second.reason;
            one.author = found->second.author;
        }
        basis.past.push_back(std::move(one));
        if (basis.past.size() == kMemoryLots) {
            break;
        }
    }
    std::ranges::reverse(basis.past);
    return basis;
}

}  // namespace

Result<BoringMemoryBasis> readBoringMemory(LotReader& lots, RoomRecordReader& records, const LotRow& lot) {
    const auto told = readTold(records);
    if (!told) {
        return tl::unexpected(told.error());
    }
    auto basis = readBefore(lots, lot.machineName, lot.id, *told);
    if (basis) {
        basis->context = told->contextOf(lot);
        basis->announced = told->announcedIn(lot.id);
        auto shop = keptShopLots(records, lot.id);
        if (!shop) {
            return tl::unexpected(shop.error());
        }
        basis->shop = std::move(*shop);
    }
    return basis;
}

Result<BoringMemoryBasis> readBoringMemory(LotReader& lots, RoomRecordReader& records,
                                           const boring::MemoryContext& context) {
    const auto told = readTold(records);
    if (!told) {
        return tl::unexpected(told.error());
    }
    auto basis = readBefore(lots, context.names[kMachine], std::nullopt, *told);
    if (basis) {
        basis->context = context;
    }
    return basis;
}

std::vector<boring::Stretch> stretchesOf(const LotHistory& history, std::vector<boring::AnnouncedChange> announced) {
    const auto recipe = recipeFromJson(history.recipe.parametersJson);
    if (!recipe) {
        return {};
    }
    LotRecords records(*recipe, boring::EstimatorKind::Kalman);
    for (const PartDetail& detail : history.parts) {
        records.addPart(servicePartOf(detail));
    }
    records.setAnnounced(std::move(announced));
    records.restoreRows(history.measurements);
    return records.tracker().stretches();
}

BoringLotTold toldOf(LotId lot, std::span<const RoomRecordRow> records) {
    Told told;
    told.take(records);
    LotRow row;
    row.id = lot;
    const boring::MemoryContext context = told.contextOf(row);
    BoringLotTold one{context.names[kGrade], context.names[kMaterial], told.announcedIn(lot), false, {}, {}};
    if (const auto found = told.leftOut.find(std::to_string(lot)); found != told.leftOut.end()) {
        one.leftOut = found->second.leftOut;
        one.reason = found->second.reason;
        one.author = found->second.author;
    }
    return one;
}

Result<void> applyLeftOut(RoomRecordReader& records, std::span<BoringMemoryLot> lots) {
    const auto told = readTold(records, {kMemoryRecord}, {});
    if (!told) {
        return tl::unexpected(told.error());
    }
    for (BoringMemoryLot& lot : lots) {
        const auto found = told->leftOut.find(memorySubject(lot.store, lot.lot.id));
        if (found != told->leftOut.end()) {
            lot.leftOut = found->second.leftOut;
            lot.reason = found->second.reason;
            lot.author = found->second.author;
        }
    }
    return {};
}

std::string memorySubject(const std::string& store, LotId lot) {
    return store.empty() ? std::to_string(lot) : store + "/" + std::to_string(lot);
}

Result<std::vector<boring::AnnouncedChange>> announcedIn(RoomRecordReader& records, LotId lot) {
    const auto told = readTold(records, {kChangeRecord}, std::to_string(lot));
    if (!told) {
        return tl::unexpected(told.error());
    }
    return told->announcedIn(lot);
}

Result<std::vector<boring::MemoryContext>> memoryContextsOf(RoomRecordReader& records, std::span<const LotRow> lots) {
    const auto told = readTold(records);
    if (!told) {
        return tl::unexpected(told.error());
    }
    std::vector<boring::MemoryContext> contexts;
    for (const LotRow& lot : lots) {
        contexts.push_back(told->contextOf(lot));
    }
    return contexts;
}

boring::LotBegin lotBegin(const BoringMemoryBasis& basis, const BoringRecipe& recipe) {
    auto past = std::make_shared<std::vector<boring::PastLot>>();
    for (const auto* lots : {&basis.past, &basis.shop}) {
        for (const BoringMemoryLot& lot : *lots) {
            if (!lot.leftOut) {
                past->push_back({lot.memoryId, lot.context, lot.stretches});
            }
        }
    }
    return {recipe.usesMemory(), basis.context, std::move(past)};
}

std::string changeJson(std::uint32_t part, std::optional<boring::StretchKind> kind) {
    return nlohmann::json{{"part", part}, {"change", kind ? changeKey(*kind) : "none"}}.dump();
}

std::string lotRecordJson(const std::string& insertGrade, const std::string& material) {
    return nlohmann::json{{"insert_grade", insertGrade}, {"material", material}}.dump();
}

std::string leftOutJson(bool leftOut) {
    return nlohmann::json{{"left_out", leftOut}}.dump();
}

}  // namespace kerf
