// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/shop_memory.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "db/shop/shop_lots.h"

namespace kerf {
namespace {

using nlohmann::json;

constexpr std::int64_t kFirstId = -2;  // −1 is the lot in work

/// Two consoles may call their machines the same.
std::string machineKey(const std::string& machine, const std::string& store) {
    return machine + "\x1f" + store;
}

void number(std::vector<BoringMemoryLot>& lots) {
    std::int64_t id = kFirstId;
    for (BoringMemoryLot& lot : lots) {
        lot.context.names[0] = machineKey(lot.lot.machineName, lot.store);
        lot.context.names[1] = lot.lot.partTypeName;
        lot.memoryId = id--;
    }
}

bool usable(const boring::Stretch& stretch) {
    return stretch.bores > 0 && stretch.information.allFinite() && stretch.vector.allFinite() &&
           std::isfinite(stretch.lnFeed) && std::isfinite(stretch.lnOverhang);
}

/// A part of another console with more values than a bore has depths is no part of ours.
bool sane(const LotHistory& history) {
    std::vector<PartId> parts;
    for (const MeasurementRow& row : effectiveMeasurements(history.measurements)) {
        parts.push_back(row.part);
    }
    std::ranges::sort(parts);
    for (std::size_t i = 0; i + kMaxBoreDepths < parts.size(); ++i) {
        if (parts[i] == parts[i + kMaxBoreDepths]) {
            return false;
        }
    }
    std::vector<std::uint32_t> numbers;
    for (const PartDetail& detail : history.parts) {
        numbers.push_back(detail.part.number);
    }
    std::ranges::sort(numbers);
    return std::ranges::adjacent_find(numbers) == numbers.end();
}

json jsonOf(const boring::Stretch& stretch) {
    json information = json::array();
    for (int r = 0; r < 3; ++r) {
        for (int c = r; c < 3; ++c) {
            information.push_back(stretch.information(r, c));
        }
    }
    return {{"kind", static_cast<int>(stretch.kind)},
            {"from", stretch.fromPart},
            {"to", stretch.toPart},
            {"bores", stretch.bores},
            {"information", std::move(information)},
            {"vector", {stretch.vector(0), stretch.vector(1), stretch.vector(2)}},
            {"ln_feed", stretch.lnFeed},
            {"ln_overhang", stretch.lnOverhang}};
}

/// @throws json::exception on a value that is missing or of the wrong kind
boring::Stretch stretchOf(const json& body) {
    boring::Stretch stretch;
    const int kind = body.at("kind").get<int>();
    stretch.kind = static_cast<boring::StretchKind>(std::clamp(kind, 0, static_cast<int>(boring::kStretchKinds) - 1));
    stretch.fromPart = body.at("from").get<std::uint32_t>();
    stretch.toPart = body.at("to").get<std::uint32_t>();
    stretch.bores = body.at("bores").get<std::uint32_t>();
    std::size_t at = 0;
    for (int r = 0; r < 3; ++r) {
        for (int c = r; c < 3; ++c) {
            stretch.information(r, c) = stretch.information(c, r) = body.at("information").at(at++).get<double>();
        }
        stretch.vector(r) = body.at("vector").at(static_cast<std::size_t>(r)).get<double>();
    }
    stretch.lnFeed = body.at("ln_feed").get<double>();
    stretch.lnOverhang = body.at("ln_overhang").get<double>();
    return stretch;
}

BoringMemoryLot lotOf(const json& body) {
    BoringMemoryLot one;
    one.store = body.at("store").get<std::string>();
    one.lot.id = body.at("lot").get<std::int64_t>();
    one.lot.machineName = body.at("machine").get<std::string>();
    one.lot.partTypeName = body.at("part_type").get<std::string>();
    one.lot.name = body.at("name").get<std::string>();
    one.lot.openedUtc_ms = body.at("opened_utc_ms").get<std::int64_t>();
    one.context.names[2] = body.at("insert_grade").get<std::string>();
    one.context.names[3] = body.at("material").get<std::string>();
    one.leftOut = body.at("left_out").get<bool>();
    one.reason = body.at("reason").get<std::string>();
    one.author = body.at("author").get<std::string>();
    for (const json& stretch : body.at("stretches")) {
        one.stretches.push_back(stretchOf(stretch));
    }
    return one;
}

}  // namespace

std::vector<BoringMemoryLot> askShopLots(db::PgConnection& server, const std::string& partType,
                                         const std::string& ownStore, bool simulated) {
    const db::ShopLotQuery query{
        ProcessId::Boring,   partType, ownStore, simulated, {kChangeRecord, kLotRecord, kMemoryRecord},
        kShopLotsPerMachine, kShopLots};
    return memoryLotsOf(db::shopLots(server, query));
}

std::vector<BoringMemoryLot> memoryLotsOf(std::span<const db::ShopLot> lots) {
    std::vector<BoringMemoryLot> out;
    for (const db::ShopLot& lot : lots) {
        if (!sane(lot.history)) {
            continue;
        }
        BoringLotTold told = toldOf(lot.history.lot.id, lot.records);
        BoringMemoryLot one;
        one.lot = lot.history.lot;
        one.store = lot.store;
        one.stretches = stretchesOf(lot.history, std::move(told.announced));
        std::erase_if(one.stretches, [](const boring::Stretch& stretch) { return !usable(stretch); });
        one.context.names[2] = std::move(told.insertGrade);
        one.context.names[3] = std::move(told.material);
        one.leftOut = told.leftOut;
        one.reason = std::move(told.reason);
        one.author = std::move(told.author);
        if (!one.stretches.empty()) {
            out.push_back(std::move(one));
        }
    }
    number(out);
    return out;
}

std::string shopLotsJson(std::span<const BoringMemoryLot> lots) {
    json body{{"lots", json::array()}};
    for (const BoringMemoryLot& lot : lots) {
        json stretches = json::array();
        for (const boring::Stretch& stretch : lot.stretches) {
            stretches.push_back(jsonOf(stretch));
        }
        body["lots"].push_back({{"store", lot.store},
                                {"lot", lot.lot.id},
                                {"machine", lot.lot.machineName},
                                {"part_type", lot.lot.partTypeName},
                                {"name", lot.lot.name},
                                {"opened_utc_ms", lot.lot.openedUtc_ms},
                                {"insert_grade", lot.context.names[2]},
                                {"material", lot.context.names[3]},
                                {"left_out", lot.leftOut},
                                {"reason", lot.reason},
                                {"author", lot.author},
                                {"stretches", std::move(stretches)}});
    }
    return body.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<BoringMemoryLot> shopLotsFromJson(const std::string& text) {
    std::vector<BoringMemoryLot> out;
    const json body = json::parse(text, nullptr, false);
    const auto lots = body.is_object() ? body.find("lots") : body.end();
    if (lots == body.end() || !lots->is_array()) {
        return out;
    }
    for (const json& one : *lots) {
        try {
            BoringMemoryLot lot = lotOf(one);
            if (std::ranges::all_of(lot.stretches, usable)) {
                out.push_back(std::move(lot));
            }
        } catch (const json::exception&) {
        }
    }
    number(out);
    return out;
}

Result<std::vector<BoringMemoryLot>> keptShopLots(RoomRecordReader& records, LotId lot) {
    const auto rows = records.roomRecords(ProcessId::Boring, kShopLotsRecord, std::to_string(lot), 1);
    if (!rows) {
        return tl::unexpected(rows.error());
    }
    std::vector<BoringMemoryLot> lots =
        rows->empty() ? std::vector<BoringMemoryLot>{} : shopLotsFromJson(rows->front().bodyJson);
    if (const auto told = applyLeftOut(records, lots); !told) {
        return tl::unexpected(told.error());
    }
    return lots;
}

}  // namespace kerf
