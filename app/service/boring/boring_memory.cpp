// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_memory.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/service/boring/lot_records.h"

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

/// The room records of boring that memory needs, by lot.
struct Told {
    struct LeftOut {
        bool leftOut{false};
        std::string reason{}, author{};
    };
    std::map<std::string, std::map<std::uint32_t, std::optional<boring::StretchKind>>> changes{};
    std::map<std::string, std::pair<std::string, std::string>> grades{};  // insert grade, material
    std::map<std::string, LeftOut> leftOut{};

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
        for (const RoomRecordRow& row : *rows) {  // newest first: what is there already holds
            const auto json = nlohmann::json::parse(row.bodyJson, nullptr, false);
            if (!json.is_object()) {
                continue;
            }
            if (row.kind == kChangeRecord) {
                told.changes[row.subject].try_emplace(json.value("part", 0U), changeOf(json.value("change", "none")));
            } else if (row.kind == kLotRecord) {
                told.grades.try_emplace(row.subject, json.value("insert_grade", ""), json.value("material", ""));
            } else {
                told.leftOut.try_emplace(row.subject,
                                         Told::LeftOut{json.value("left_out", false), row.reason, row.author});
            }
        }
    }
    return told;
}

Result<Told> readTold(RoomRecordReader& records) {
    return readTold(records, {kChangeRecord, kLotRecord, kMemoryRecord}, {});
}

/// What a stored lot has shown, computed from its surviving bores alone. Empty: nothing measured, or no recipe.
Result<std::vector<boring::Stretch>> stretchesOfLot(LotReader& reader, LotId lot,
                                                    std::vector<boring::AnnouncedChange> announced) {
    const auto history = reader.history(lot);
    if (!history) {
        return tl::unexpected(history.error());
    }
    if (!*history) {
        return std::vector<boring::Stretch>{};
    }
    const auto recipe = recipeFromJson((*history)->recipe.parametersJson);
    if (!recipe) {
        return std::vector<boring::Stretch>{};
    }
    LotRecords records(*recipe, boring::EstimatorKind::Kalman);
    for (const PartDetail& detail : (*history)->parts) {
        ServicePart part;
        part.id = detail.part.id;
        part.number = detail.part.number;
        part.complete = detail.part.complete;
        part.schedule = detail.schedule ? detail.schedule->schedule : BoringSchedule{};
        part.feed = detail.feed;
        records.addPart(part);
    }
    records.setAnnounced(std::move(announced));
    records.restoreRows((*history)->measurements);
    return records.tracker().stretches();
}

Result<BoringMemoryBasis> readBefore(LotReader& reader, const std::string& machine, std::optional<LotId> before,
                                     const Told& told) {
    const auto all = reader.lots(std::nullopt, kMostLots);  // newest first
    if (!all) {
        return tl::unexpected(all.error());
    }
    BoringMemoryBasis basis;
    for (const LotRow& lot : *all) {
        if (lot.process != ProcessId::Boring || lot.machineName != machine || (before && lot.id >= *before)) {
            continue;
        }
        auto stretches = stretchesOfLot(reader, lot.id, told.announcedIn(lot.id));
        if (!stretches) {
            return tl::unexpected(stretches.error());
        }
        if (stretches->empty()) {
            continue;
        }
        BoringMemoryLot one{lot, told.contextOf(lot), std::move(*stretches), false, {}, {}};
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
    for (const BoringMemoryLot& lot : basis.past) {
        if (!lot.leftOut) {
            past->push_back({lot.lot.id, lot.context, lot.stretches});
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
