// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/schedule_rows.h"
#include "db/stores/store.h"

/// Finished parts: number in the lot, the schedule they were cut with, the really cut feed.
namespace kerf::db {
namespace {

/// A value that is no number cannot be stored; the part itself must not be lost for it.
bool storable(const BoringSchedule& s) {
    return std::isfinite(s.lnC) && std::isfinite(s.alpha) && std::isfinite(s.beta) &&
           std::isfinite(s.targetDeflection_mm) && std::isfinite(s.constantFeed_mmPerRev) &&
           std::isfinite(s.minFeed_mmPerRev) && std::isfinite(s.maxFeed_mmPerRev) && std::isfinite(s.overhangFrom_mm) &&
           std::isfinite(s.overhangTo_mm) && std::isfinite(s.spindleSpeed_rpm);
}

/// A value as it will be read again, for the seal.
template <class Value>
std::string sealed(const std::optional<Value>& value) {
    return value ? std::to_string(*value) : std::string("-");
}

Receipt insertPart(const QSqlDatabase& database, const std::optional<LotId>& lot,
                   const std::optional<RecipeRevisionId>& recipe, const FinishedPart& part, const std::string& serial) {
    const PartRecord& record = part.record;
    std::optional<ScheduleId> schedule;
    if (record.process == ProcessId::Boring && storable(record.schedule)) {
        ScheduleRow row;
        row.lot = lot;
        row.schedule = record.schedule;
        schedule = findOrAddSchedule(database, row);
    }
    // Within its lot; parts of no lot count per process.
    Statement number(database, lot ? "SELECT coalesce(max(number), 0) + 1 FROM parts WHERE lot_id = ?"
                                   : "SELECT coalesce(max(number), 0) + 1 FROM parts WHERE lot_id IS NULL AND process "
                                     "= ?");
    lot ? number.bind(*lot) : number.bind(processKey(record.process));
    const std::uint32_t next = number.run().next() ? number.count(0) : 1;
    Statement insert(database,
                     "INSERT INTO parts (process, lot_id, number, serial, complete, machine_begin_ns, machine_end_ns, "
                     "ended_utc_ms, schedule_id, recipe_revision_id, seal) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    const std::int64_t end_ns = std::max(record.begin_ns, record.end_ns);
    const std::int64_t ended_ms = part.endedUtc_ms != 0 ? part.endedUtc_ms : utcNow_ms();
    const std::vector<PartResult> results = partResults(record);
    const std::string figures = !part.figuresJson.empty() ? part.figuresJson
                                : results.empty()         ? std::string()
                                                          : packFigures(results);
    Statement last(database, "SELECT seal FROM parts ORDER BY id DESC LIMIT 1");
    const std::string before = last.run().next() ? last.text(0) : std::string();
    const SealedPart kept{processKey(record.process),
                          sealed(lot),
                          std::to_string(next),
                          record.complete ? "1" : "0",
                          std::to_string(record.begin_ns),
                          std::to_string(end_ns),
                          std::to_string(ended_ms),
                          sealed(schedule),
                          sealed(recipe),
                          figures.empty() ? "-" : figures};
    insert.bind(processKey(record.process))
        .bind(lot)
        .bind(next)
        .bind(serial.empty() ? std::optional<std::string>() : std::optional(serial))
        .bind(record.complete)
        .bind(record.begin_ns)
        .bind(end_ns)
        .bind(ended_ms)
        .bind(schedule)
        .bind(recipe)
        .bind(partSeal(before, kept))
        .run();
    const PartId id = insert.lastId();
    if (record.feed.count > 0) {
        Statement(database, "INSERT INTO feed_traces (part_id, points) VALUES (?, ?)")
            .bind(id)
            .bind(packTrace(record.feed))
            .run();
    }
    if (!figures.empty()) {
        Statement(database, "INSERT INTO part_results (part_id, results) VALUES (?, ?)").bind(id).bind(figures).run();
    }
    return {id, next};
}

/// What the part's order names, where this file has it: no part is lost for an order of another one.
std::optional<std::int64_t> known(const QSqlDatabase& database, const char* sql, std::int64_t id, ProcessId process) {
    if (id <= 0) {
        return std::nullopt;
    }
    Statement find(database, sql);
    return find.bind(id).bind(processKey(process)).run().next() ? std::optional(id) : std::nullopt;
}

std::optional<LotId> lotOf(const QSqlDatabase& database, const PartRecord& record) {
    return known(database,
                 "SELECT 1 FROM lots l JOIN part_types t ON t.id = l.part_type_id WHERE l.id = ? AND t.process = ?",
                 record.order.lot, record.process);
}

std::optional<RecipeRevisionId> recipeOf(const QSqlDatabase& database, const PartRecord& record) {
    return known(database,
                 "SELECT 1 FROM recipe_revisions r JOIN part_types t ON t.id = r.part_type_id WHERE r.id = ? AND "
                 "t.process = ?",
                 record.order.recipe, record.process);
}

bool storedAlready(const QSqlDatabase& database, const FinishedPart& part) {
    Statement find(database,
                   "SELECT id FROM parts WHERE process = ? AND machine_begin_ns = ? AND machine_end_ns = ? AND "
                   "ended_utc_ms = ?");
    return find.bind(processKey(part.record.process))
        .bind(part.record.begin_ns)
        .bind(std::max(part.record.begin_ns, part.record.end_ns))
        .bind(part.endedUtc_ms)
        .run()
        .next();
}

}  // namespace

ScheduleId findOrAddSchedule(const QSqlDatabase& database, const ScheduleRow& row) {
    const BoringSchedule& s = row.schedule;
    Statement find(
        database,
        "SELECT id FROM schedules WHERE lot_id IS ? AND revision = ? AND ln_c = ? AND alpha = ? AND beta = ? "
        "AND target_deflection_mm = ? AND constant_feed_mm_per_rev = ? AND min_feed_mm_per_rev = ? AND "
        "max_feed_mm_per_rev = ? AND overhang_from_mm = ? AND overhang_to_mm = ? AND spindle_speed_rpm = ? "
        "ORDER BY id DESC LIMIT 1");
    const auto bindValues = [&](Statement& statement) -> Statement& {
        return statement.bind(row.lot)
            .bind(s.revision)
            .bind(s.lnC)
            .bind(s.alpha)
            .bind(s.beta)
            .bind(s.targetDeflection_mm)
            .bind(s.constantFeed_mmPerRev)
            .bind(s.minFeed_mmPerRev)
            .bind(s.maxFeed_mmPerRev)
            .bind(s.overhangFrom_mm)
            .bind(s.overhangTo_mm)
            .bind(s.spindleSpeed_rpm);
    };
    const std::int64_t accepted_ms = row.acceptedBy.empty() ? 0 : row.acceptedUtc_ms.value_or(utcNow_ms());
    if (bindValues(find).run().next()) {
        const ScheduleId id = find.integer(0);
        // The part may have come before the service's own row: fill in what only the service knows, take nothing away.
        if (!row.predictionJson.empty() || !row.reason.empty() || !row.acceptedBy.empty()) {
            Statement(database,
                      "UPDATE schedules SET prediction = coalesce(nullif(?, ''), prediction), reason = "
                      "coalesce(nullif(?, ''), reason), accepted_by = CASE WHEN accepted_by = '' THEN ? ELSE "
                      "accepted_by END, accepted_utc_ms = coalesce(accepted_utc_ms, nullif(?, 0)) WHERE id = ?")
                .bind(row.predictionJson)
                .bind(row.reason)
                .bind(row.acceptedBy)
                .bind(accepted_ms)
                .bind(id)
                .run();
        }
        return id;
    }
    Statement insert(
        database,
        "INSERT INTO schedules (lot_id, revision, ln_c, alpha, beta, target_deflection_mm, "
        "constant_feed_mm_per_rev, min_feed_mm_per_rev, max_feed_mm_per_rev, overhang_from_mm, "
        "overhang_to_mm, spindle_speed_rpm, prediction, reason, created_utc_ms, accepted_by, accepted_utc_ms) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, nullif(?, 0))");
    return bindValues(insert)
        .bind(row.predictionJson)
        .bind(row.reason)
        .bind(utcNow_ms())
        .bind(row.acceptedBy)
        .bind(accepted_ms)
        .run()
        .lastId();
}

Result<std::vector<StoredPart>> Store::addParts(std::span<const FinishedPart> parts) {
    return guarded([&] {
        std::vector<StoredPart> stored;
        Transaction transaction(m_database);
        for (const FinishedPart& part : parts) {
            const std::optional<LotId> lot = lotOf(m_database, part.record);
            const std::optional<RecipeRevisionId> recipe = recipeOf(m_database, part.record);
            const Receipt receipt = insertPart(m_database, lot, recipe, part, {});
            stored.push_back({receipt.id, lot, static_cast<std::uint32_t>(receipt.second), part.record, recipe});
        }
        transaction.commit();
        return stored;
    });
}

Result<std::vector<StoredPart>> Store::addParts(std::span<const PartRecord> records) {
    std::vector<FinishedPart> parts;
    for (const PartRecord& record : records) {
        parts.push_back({record, utcNow_ms(), {}});
    }
    return addParts(parts);
}

Result<bool> Store::addWaiting(const Waiting& item) {
    return guarded([&] {
        if (const auto* part = std::get_if<FinishedPart>(&item)) {
            Transaction transaction(m_database);
            if (storedAlready(m_database, *part)) {
                return false;
            }
            (void)insertPart(m_database, lotOf(m_database, part->record), recipeOf(m_database, part->record), *part,
                             {});
            transaction.commit();
            return true;
        }
        if (const auto* alarm = std::get_if<RaiseAlarm>(&item)) {
            Statement find(m_database, "SELECT id FROM alarms WHERE code = ? AND raised_utc_ms = ?");
            if (find.bind(static_cast<std::int64_t>(alarm->code)).bind(alarm->utc_ms).run().next()) {
                return false;
            }
        }
        const StoreCommand command = std::visit(
            [](const auto& each) -> StoreCommand {
                if constexpr (std::is_same_v<std::decay_t<decltype(each)>, FinishedPart>) {
                    return AddPart{};
                } else {
                    return each;
                }
            },
            item);
        if (const Result<Receipt> done = apply(command); !done) {
            throw SqlFailure(done.error(), 0, done.error().english());
        }
        return true;
    });
}

Receipt Store::run(const AddPart& command) {
    return insertPart(m_database, command.lot, recipeOf(m_database, command.record), {command.record, utcNow_ms(), {}},
                      command.serial);
}

Receipt Store::run(const SetPartSerial& command) {
    Statement find(m_database, "SELECT serial FROM parts WHERE id = ?");
    if (!find.bind(command.part).run().next()) {
        throw SqlFailure(Sentence(KERF_TEXT("There is no such part.")), 0, "no such part");
    }
    const std::string before = find.text(0);
    Statement(m_database, "UPDATE parts SET serial = ? WHERE id = ?")
        .bind(command.serial.empty() ? std::optional<std::string>() : std::optional(command.serial))
        .bind(command.part)
        .run();
    appendAudit(m_database, {.author = command.author,
                             .action = "serial number set",
                             .object = "part",
                             .objectId = command.part,
                             .oldValue = before,
                             .newValue = command.serial,
                             .reason = command.reason});
    return {command.part};
}

Receipt Store::run(const StoreSchedule& command) {
    return {findOrAddSchedule(m_database, command.schedule)};
}

Receipt Store::run(const AcceptSchedule& command) {
    Statement find(m_database, "SELECT max(id) FROM schedules WHERE lot_id = ? AND revision = ?");
    if (!find.bind(command.lot).bind(command.revision).run().next() || find.isNull(0)) {
        throw SqlFailure(
            Sentence(KERF_TEXT("Schedule %1 of this lot is not stored."), SentenceArg(command.revision, 0)), 0,
            "no such schedule");
    }
    const ScheduleId id = find.integer(0);
    Statement(m_database, "UPDATE schedules SET accepted_by = ?, accepted_utc_ms = ? WHERE id = ? AND accepted_by = ''")
        .bind(command.author)
        .bind(utcNow_ms())
        .bind(id)
        .run();
    appendAudit(m_database, {.author = command.author,
                             .action = "schedule accepted",
                             .object = "schedule",
                             .objectId = id,
                             .newValue = "revision " + std::to_string(command.revision)});
    return {id};
}

}  // namespace kerf::db
