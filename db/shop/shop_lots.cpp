// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/shop_lots.h"

#include <QByteArray>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "db/row_io.h"

namespace kerf::db {
namespace {

/// A row that no console can have written: its lot is left alone.
struct Unreadable {};

const std::string& text(const PgRow& row, std::size_t column) {
    if (!row.at(column)) {
        throw Unreadable();
    }
    return *row[column];
}

std::string textOrNone(const PgRow& row, std::size_t column) {
    return row.at(column).value_or("");
}

template <class Number>
Number numberOf(const PgRow& row, std::size_t column) {
    const std::string& digits = text(row, column);
    Number value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size()) {
        throw Unreadable();
    }
    return value;
}

double real(const PgRow& row, std::size_t column) {
    const auto value = numberOf<double>(row, column);
    if (!std::isfinite(value)) {
        throw Unreadable();
    }
    return value;
}

std::int64_t integer(const PgRow& row, std::size_t column) {
    return numberOf<std::int64_t>(row, column);
}

using LotKey = std::tuple<std::string, std::string, std::int64_t>;  // store, epoch, id

/// One array literal per column; uuids and integers need no quoting.
struct Keys {
    std::string stores{"{"}, epochs{"{"}, ids{"{"};

    void add(const std::string& store, const std::string& epoch, const std::string& id) {
        const char* before = ids.size() > 1 ? "," : "";
        stores += before + store;
        epochs += before + epoch;
        ids += before + id;
    }
    [[nodiscard]] PgRow parameters() const { return {stores + "}", epochs + "}", ids + "}"}; }
};

struct Found {
    ShopLot lot{};
    bool readable{true};
    std::set<PartId> parts{};
};

class Lots {
 public:
    explicit Lots(const std::vector<PgRow>& rows) {
        for (const PgRow& row : rows) {
            Found found;
            readInto(found, [&] {
                LotRow& lot = found.lot.history.lot;
                found.lot.store = text(row, 0);
                lot.id = integer(row, 2);
                lot.machineName = text(row, 3);
                lot.partTypeName = text(row, 4);
                lot.name = text(row, 5);
                lot.estimator = text(row, 6);
                lot.openedUtc_ms = integer(row, 7);
                found.lot.history.recipe.parametersJson = text(row, 8);
            });
            if (found.readable) {
                m_keys.add(*row[0], *row[1], *row[2]);
                m_order.emplace_back(*row[0], *row[1], found.lot.history.lot.id);
                m_lots.emplace(m_order.back(), std::move(found));
            }
        }
    }
    [[nodiscard]] const Keys& keys() const noexcept { return m_keys; }
    [[nodiscard]] bool empty() const noexcept { return m_order.empty(); }

    /// `read` for the lot that the first three columns name.
    template <class Read>
    void each(const std::vector<PgRow>& rows, const Read& read) {
        for (const PgRow& row : rows) {
            const auto found = m_lots.find({textOrNone(row, 0), textOrNone(row, 1), integer(row, 2)});
            if (found != m_lots.end()) {
                readInto(found->second, [&] { read(found->second, row); });
            }
        }
    }
    [[nodiscard]] std::vector<ShopLot> take() {
        std::vector<ShopLot> out;
        for (const LotKey& key : m_order) {
            Found& found = m_lots.at(key);
            if (found.readable) {
                std::ranges::sort(found.lot.history.parts, {},
                                  [](const PartDetail& detail) { return detail.part.number; });
                out.push_back(std::move(found.lot));
            }
        }
        return out;
    }

 private:
    template <class Read>
    static void readInto(Found& found, const Read& read) {
        try {
            read();
        } catch (const Unreadable&) {
            found.readable = false;
        } catch (const std::out_of_range&) {
            found.readable = false;
        }
    }
    Keys m_keys{};
    std::vector<LotKey> m_order{};
    std::map<LotKey, Found> m_lots{};
};

constexpr const char* kNewestLots =
    "WITH history AS (SELECT DISTINCT ON (store) store, epoch FROM shop.stores ORDER BY store, first_contact DESC), "
    "known AS (SELECT l.store, l.epoch, l.id, m.name AS machine, t.name AS part_type, l.name, l.estimator, "
    "l.opened_utc_ms, r.parameters, row_number() OVER (PARTITION BY l.store, l.machine_id "
    "ORDER BY l.opened_utc_ms DESC, l.id DESC) AS age "
    "FROM history h JOIN shop.lots l USING (store, epoch) "
    "JOIN shop.machines m ON m.store = l.store AND m.epoch = l.epoch AND m.id = l.machine_id "
    "JOIN shop.part_types t ON t.store = l.store AND t.epoch = l.epoch AND t.id = l.part_type_id "
    "JOIN shop.recipe_revisions r ON r.store = l.store AND r.epoch = l.epoch AND r.id = l.recipe_revision_id "
    "WHERE t.process = $1 AND t.name = $2 AND l.store <> $3::uuid AND (m.kind = 'simulator') = $4::boolean) "
    "SELECT store, epoch, id, machine, part_type, name, estimator, opened_utc_ms, parameters FROM known "
    "WHERE age <= $5::bigint ORDER BY age, opened_utc_ms DESC, store, id LIMIT $6::bigint";

constexpr const char* kParts =
    "SELECT p.store, p.epoch, p.lot_id, p.id, p.number, p.complete, s.revision, s.ln_c, s.alpha, s.beta, "
    "s.target_deflection_mm, s.constant_feed_mm_per_rev, s.min_feed_mm_per_rev, s.max_feed_mm_per_rev, "
    "s.overhang_from_mm, s.overhang_to_mm, s.spindle_speed_rpm, f.points "
    "FROM unnest($1::uuid[], $2::uuid[], $3::bigint[]) AS k (store, epoch, lot) "
    "JOIN shop.parts p ON p.store = k.store AND p.epoch = k.epoch AND p.lot_id = k.lot "
    "LEFT JOIN shop.schedules s ON s.store = p.store AND s.epoch = p.epoch AND s.id = p.schedule_id "
    "LEFT JOIN shop.feed_traces f ON f.store = p.store AND f.epoch = p.epoch AND f.part_id = p.id";

constexpr const char* kMeasurements =
    "SELECT p.store, p.epoch, p.lot_id, m.id, m.part_id, m.kind, m.replaces_id, m.station, m.position_mm, "
    "m.diameter_mm "
    "FROM unnest($1::uuid[], $2::uuid[], $3::bigint[]) AS k (store, epoch, lot) "
    "JOIN shop.parts p ON p.store = k.store AND p.epoch = k.epoch AND p.lot_id = k.lot "
    "JOIN shop.measurements m ON m.store = p.store AND m.epoch = p.epoch AND m.part_id = p.id ORDER BY m.id";

constexpr const char* kRecords =
    "SELECT o.store, o.epoch, o.subject, o.id, o.kind, o.body, o.author, o.reason, o.created_utc_ms "
    "FROM unnest($1::uuid[], $2::uuid[], $3::bigint[]) AS k (store, epoch, lot) "
    "JOIN shop.room_records o ON o.store = k.store AND o.epoch = k.epoch AND o.subject = k.lot::text "
    "WHERE o.process = $4 AND o.kind = ANY (string_to_array($5, ',')) ORDER BY o.id DESC";

void addPart(Found& found, const PgRow& row) {
    PartDetail detail;
    detail.part.id = integer(row, 3);
    detail.part.number = numberOf<std::uint32_t>(row, 4);
    detail.part.complete = integer(row, 5) != 0;
    if (row.at(6)) {
        ScheduleRow schedule;
        BoringSchedule& law = schedule.schedule;
        law.revision = numberOf<std::uint32_t>(row, 6);
        law.lnC = real(row, 7);
        law.alpha = real(row, 8);
        law.beta = real(row, 9);
        law.targetDeflection_mm = real(row, 10);
        law.constantFeed_mmPerRev = real(row, 11);
        law.minFeed_mmPerRev = real(row, 12);
        law.maxFeed_mmPerRev = real(row, 13);
        law.overhangFrom_mm = real(row, 14);
        law.overhangTo_mm = real(row, 15);
        law.spindleSpeed_rpm = real(row, 16);
        if (!(law.alpha > 0.0 && law.minFeed_mmPerRev > 0.0 && law.maxFeed_mmPerRev >= law.minFeed_mmPerRev)) {
            throw Unreadable();
        }
        detail.schedule = schedule;
    }
    if (row.at(17)) {  // "\x" and hexadecimal digits
        const std::string& hex = *row[17];
        detail.feed = unpackTrace(
            QByteArray::fromHex(QByteArray(hex.data() + std::min<std::size_t>(2, hex.size()),
                                           static_cast<qsizetype>(hex.size() - std::min<std::size_t>(2, hex.size())))));
        for (std::size_t i = 0; i < detail.feed.count; ++i) {
            if (!(detail.feed.feed_mmPerRev[i] > 0.0F && std::isfinite(detail.feed.feed_mmPerRev[i]) &&
                  std::isfinite(detail.feed.overhang_mm[i]))) {
                throw Unreadable();
            }
        }
    }
    if (!found.parts.insert(detail.part.id).second) {
        throw Unreadable();
    }
    found.lot.history.parts.push_back(std::move(detail));
}

void addMeasurement(Found& found, const PgRow& row) {
    MeasurementRow measured;
    measured.id = integer(row, 3);
    measured.part = integer(row, 4);
    const std::string& kind = text(row, 5);
    measured.kind = kind == "entry"        ? MeasurementKind::Entry
                    : kind == "correction" ? MeasurementKind::Correction
                                           : MeasurementKind::Void;
    if (row.at(6)) {
        measured.replaces = integer(row, 6);
    }
    measured.station = numberOf<std::uint8_t>(row, 7);
    measured.position_mm = real(row, 8);
    if (row.at(9)) {
        measured.diameter_mm = real(row, 9);
    }
    const bool whole = measured.kind == MeasurementKind::Entry || measured.replaces.has_value();
    if (!whole || !(measured.position_mm > 0.0) || measured.station >= kMaxBoreDepths) {
        throw Unreadable();
    }
    found.lot.history.measurements.push_back(std::move(measured));
}

}  // namespace

std::vector<ShopLot> shopLots(PgConnection& server, const ShopLotQuery& query) {
    // One picture of the shop: a console may be pushing meanwhile.
    server.query("BEGIN TRANSACTION ISOLATION LEVEL REPEATABLE READ READ ONLY");
    Lots lots(server.query(
        kNewestLots, {processKey(query.process), query.partType, query.ownStore, query.simulated ? "true" : "false",
                      std::to_string(query.lotsPerMachine), std::to_string(query.lots)}));
    if (!lots.empty()) {
        const PgRow keys = lots.keys().parameters();
        lots.each(server.query(kParts, keys), addPart);
        lots.each(server.query(kMeasurements, keys), addMeasurement);
        PgRow ofRecords = keys;
        ofRecords.emplace_back(processKey(query.process));
        std::string kinds;
        for (const std::string& kind : query.recordKinds) {
            kinds += (kinds.empty() ? "" : ",") + kind;
        }
        ofRecords.emplace_back(kinds);
        lots.each(server.query(kRecords, ofRecords), [&](Found& found, const PgRow& row) {
            found.lot.records.push_back({integer(row, 3), query.process, text(row, 4), textOrNone(row, 2),
                                         textOrNone(row, 5), textOrNone(row, 6), textOrNone(row, 7), integer(row, 8)});
        });
    }
    server.query("COMMIT");
    return lots.take();
}

}  // namespace kerf::db
