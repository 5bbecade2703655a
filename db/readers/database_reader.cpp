// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/readers/database_reader.h"

#include <map>

#include "db/head_file.h"
#include "db/row_io.h"
#include "db/statement.h"
#include "db/stores/audit_log.h"

namespace kerf::db {
namespace {

template <class Row>
std::vector<Row> readAll(Statement& statement, Row (*read)(const Statement&)) {
    std::vector<Row> rows;
    statement.run();
    while (statement.next()) {
        rows.push_back(read(statement));
    }
    return rows;
}

QString select(const char* columns, const char* rest) {
    return QStringLiteral("SELECT %1 %2").arg(QLatin1String(columns), QLatin1String(rest));
}

std::vector<PartDetail> partsOfLot(const QSqlDatabase& database, LotId lot, std::uint32_t from, std::uint32_t to) {
    Statement find(
        database,
        QStringLiteral("SELECT %1, f.points, %2 FROM parts p %3 LEFT JOIN feed_traces f ON f.part_id = "
                       "p.id LEFT JOIN schedules s ON s.id = p.schedule_id WHERE p.lot_id = ? AND p.number BETWEEN "
                       "? AND ? ORDER BY p.number")
            .arg(QLatin1String(kPartColumns), QLatin1String(kScheduleColumns), QLatin1String(kPartJoins)));
    find.bind(lot).bind(from).bind(to).run();
    std::vector<PartDetail> parts;
    while (find.next()) {
        PartDetail detail;
        detail.part = readPart(find);
        detail.feed = unpackTrace(find.blob(kPartColumnCount));
        if (!find.isNull(kPartColumnCount + 1)) {
            detail.schedule = readSchedule(find, kPartColumnCount + 1);
        }
        parts.push_back(std::move(detail));
    }
    return parts;
}

/// Lot and recipe; empty: no such lot.
std::optional<LotHistory> headOfLot(const QSqlDatabase& database, LotId lot) {
    Statement find(database,
                   select(kLotColumns, "FROM lots l ") + QLatin1String(kLotJoins) + QStringLiteral("WHERE l.id = ?"));
    if (!find.bind(lot).run().next()) {
        return std::nullopt;
    }
    LotHistory history;
    history.lot = readLot(find);
    Statement recipe(database, select(kRecipeColumns, "FROM recipe_revisions r WHERE r.id = ?"));
    if (recipe.bind(history.lot.recipe).run().next()) {
        history.recipe = readRecipe(recipe);
    }
    return history;
}

/// Parts from one number to another, with every measurement of theirs.
void addParts(const QSqlDatabase& database, LotHistory& history, std::uint32_t from = 0,
              std::uint32_t to = UINT32_MAX) {
    history.parts = partsOfLot(database, history.lot.id, from, to);
    std::map<PartId, std::size_t> place;
    for (std::size_t i = 0; i < history.parts.size(); ++i) {
        place[history.parts[i].part.id] = i;
    }
    // CROSS JOIN keeps the order: the lot's parts first, then their measurements by index.
    Statement measured(database, select(kMeasurementColumns,
                                        "FROM parts p CROSS JOIN measurements m ON m.part_id = p.id WHERE p.lot_id = ? "
                                        "AND p.number BETWEEN ? AND ? ORDER BY m.id"));
    measured.bind(history.lot.id).bind(from).bind(to);
    history.measurements = readAll(measured, readMeasurement);
    for (const MeasurementRow& row : history.measurements) {
        history.parts[place.at(row.part)].part.measurements.push_back(row);
    }
}

}  // namespace

Result<std::unique_ptr<DatabaseReader>> DatabaseReader::open(const std::string& path) {
    return guarded([&] { return std::unique_ptr<DatabaseReader>(new DatabaseReader(path)); });
}

Result<std::vector<MachineRow>> DatabaseReader::machines() {
    return guarded([&] {
        Statement find(database(), "SELECT id, name, kind, created_utc_ms FROM machines ORDER BY name");
        return readAll<MachineRow>(find, [](const Statement& row) {
            return MachineRow{row.integer(0), row.text(1), row.text(2), row.integer(3)};
        });
    });
}

Result<std::vector<PartTypeRow>> DatabaseReader::partTypes(std::optional<ProcessId> process) {
    return guarded([&] {
        Statement find(database(),
                       QStringLiteral("SELECT id, process, name, created_utc_ms FROM part_types %1 ORDER BY name")
                           .arg(process ? QStringLiteral("WHERE process = ?") : QString()));
        if (process) {
            find.bind(processKey(*process));
        }
        return readAll<PartTypeRow>(find, [](const Statement& row) {
            return PartTypeRow{row.integer(0), processOfKey(row.text(1)), row.text(2), row.integer(3)};
        });
    });
}

Result<std::vector<RecipeRevision>> DatabaseReader::recipes(PartTypeId partType) {
    return guarded([&] {
        Statement find(database(), select(kRecipeColumns,
                                          "FROM recipe_revisions r WHERE r.part_type_id = ? ORDER BY r.revision DESC"));
        find.bind(partType);
        return readAll(find, readRecipe);
    });
}

Result<std::vector<RecipeRevision>> DatabaseReader::newestRecipes(ProcessId process) {
    return guarded([&] {
        Statement find(database(), select(kRecipeColumns,
                                          "FROM part_types t JOIN recipe_revisions r ON r.part_type_id = t.id AND "
                                          "r.revision = (SELECT max(n.revision) FROM recipe_revisions n WHERE "
                                          "n.part_type_id = t.id) WHERE t.process = ? ORDER BY r.id"));
        find.bind(processKey(process));
        return readAll(find, readRecipe);
    });
}

Result<std::vector<RecipeRevision>> DatabaseReader::allRecipes(ProcessId process) {
    return guarded([&] {
        Statement find(database(), select(kRecipeColumns,
                                          "FROM part_types t JOIN recipe_revisions r ON r.part_type_id = t.id WHERE "
                                          "t.process = ? ORDER BY r.id"));
        find.bind(processKey(process));
        return readAll(find, readRecipe);
    });
}

Result<std::vector<LotRow>> DatabaseReader::lots(std::optional<PartTypeId> partType, std::uint32_t limit,
                                                 std::optional<ProcessId> process) {
    return guarded([&] {
        const QString joined = select(kLotColumns, "FROM lots l ") + QLatin1String(kLotJoins);
        QString where;
        if (partType || process) {
            where = QStringLiteral("WHERE %1%2%3 ")
                        .arg(partType ? QStringLiteral("l.part_type_id = ?") : QString(),
                             partType && process ? QStringLiteral(" AND ") : QString(),
                             process ? QStringLiteral("t.process = ?") : QString());
        }
        Statement find(database(), joined + where + QStringLiteral("ORDER BY l.id DESC LIMIT ?"));
        if (partType) {
            find.bind(*partType);
        }
        if (process) {
            find.bind(processKey(*process));
        }
        find.bind(limit);
        return readAll(find, readLot);
    });
}

Result<std::optional<LotId>> DatabaseReader::activeLot(ProcessId process) {
    return guarded([&]() -> std::optional<LotId> {
        Statement find(database(),
                       "SELECT l.id FROM settings s JOIN lots l ON l.id = CAST(s.value AS INTEGER) WHERE s.key = ?");
        return find.bind(activeLotKey(process)).run().next() ? std::optional(find.integer(0)) : std::nullopt;
    });
}

Result<std::optional<RecipeRevision>> DatabaseReader::recipeOf(LotId lot) {
    return guarded([&]() -> std::optional<RecipeRevision> {
        Statement find(database(), select(kRecipeColumns,
                                          "FROM lots l JOIN recipe_revisions r ON r.id = "
                                          "l.recipe_revision_id WHERE l.id = ?"));
        return find.bind(lot).run().next() ? std::optional(readRecipe(find)) : std::nullopt;
    });
}

Result<std::optional<LotHistory>> DatabaseReader::history(LotId lot) {
    return guarded([&]() -> std::optional<LotHistory> {
        const Snapshot snapshot(database());
        std::optional<LotHistory> found = headOfLot(database(), lot);
        if (!found) {
            return std::nullopt;
        }
        LotHistory& history = *found;
        addParts(database(), history);
        std::map<PartId, std::size_t> place;
        for (std::size_t i = 0; i < history.parts.size(); ++i) {
            place[history.parts[i].part.id] = i;
        }
        std::map<MeasurementId, EstimatorStateRow> newest;
        Statement states(database(), select(kStateColumns, "FROM estimator_states e WHERE e.lot_id = ? ORDER BY e.id"));
        for (EstimatorStateRow& state : readAll(states.bind(lot), readState)) {
            history.lastState = state;
            newest[state.measurement] = std::move(state);
        }
        std::map<MeasurementId, PartId> partOf;
        for (const MeasurementRow& row : history.measurements) {
            partOf[row.id] = row.part;
        }
        for (const auto& [measurement, state] : newest) {
            history.states.push_back(state);
            history.parts[place.at(partOf.at(measurement))].states.push_back(state);
        }
        Statement schedules(database(),
                            select(kScheduleColumns, "FROM schedules s WHERE s.lot_id = ? ORDER BY s.revision, s.id"));
        schedules.bind(lot).run();
        while (schedules.next()) {
            history.schedules.push_back(readSchedule(schedules));
        }
        return found;
    });
}

Result<std::optional<LotHistory>> DatabaseReader::newestParts(LotId lot, std::uint32_t count,
                                                              std::optional<PartId> last) {
    return guarded([&]() -> std::optional<LotHistory> {
        const Snapshot snapshot(database());
        std::optional<LotHistory> found = headOfLot(database(), lot);
        if (found) {
            Statement end(database(), "SELECT number FROM parts WHERE lot_id = ? AND id = ?");
            const bool ends = last && end.bind(lot).bind(*last).run().next();
            const std::uint32_t to = ends ? static_cast<std::uint32_t>(end.integer(0)) : UINT32_MAX;
            Statement first(database(),
                            "SELECT MIN(number) FROM (SELECT number FROM parts WHERE lot_id = ? AND number <= ? ORDER "
                            "BY number DESC LIMIT ?)");
            first.bind(lot).bind(to).bind(count).run();
            addParts(database(), *found, first.next() ? static_cast<std::uint32_t>(first.integer(0)) : 0, to);
        }
        return found;
    });
}

Result<std::optional<std::string>> DatabaseReader::setting(const std::string& key) {
    return guarded([&]() -> std::optional<std::string> {
        Statement find(database(), "SELECT value FROM settings WHERE key = ?");
        return find.bind(key).run().next() ? std::optional(find.text(0)) : std::nullopt;
    });
}

Result<std::vector<SettingRow>> DatabaseReader::settings() {
    return guarded([&] {
        Statement find(database(), "SELECT key, value, changed_by, changed_utc_ms FROM settings ORDER BY key");
        return readAll<SettingRow>(find, [](const Statement& row) {
            return SettingRow{row.text(0), row.text(1), row.text(2), row.integer(3)};
        });
    });
}

Result<std::vector<AlarmRow>> DatabaseReader::alarms(std::optional<AlarmId> before, std::uint32_t limit) {
    return guarded([&] {
        Statement find(database(), select(kAlarmColumns, "FROM alarms a WHERE a.id < ? ORDER BY a.id DESC LIMIT ?"));
        find.bind(before.value_or(INT64_MAX)).bind(limit);
        return readAll(find, readAlarm);
    });
}

Result<std::vector<AlarmRow>> DatabaseReader::openAlarms() {
    return guarded([&] {
        Statement find(database(),
                       select(kAlarmColumns,
                              "FROM alarms a WHERE a.cleared_utc_ms IS NULL OR a.acknowledged_utc_ms IS NULL "
                              "ORDER BY a.id DESC LIMIT 1000"));
        return readAll(find, readAlarm);
    });
}

Result<std::vector<AuditRow>> DatabaseReader::audit(std::optional<std::int64_t> before, std::uint32_t limit) {
    return guarded([&] {
        Statement find(database(), select(kAuditColumns, "FROM audit u WHERE u.id < ? ORDER BY u.id DESC LIMIT ?"));
        find.bind(before.value_or(INT64_MAX)).bind(limit);
        return readAll(find, readAudit);
    });
}

Result<std::vector<AuditRow>> DatabaseReader::auditAfter(std::int64_t after, std::uint32_t limit) {
    return guarded([&] {
        Statement find(database(), select(kAuditColumns, "FROM audit u WHERE u.id > ? ORDER BY u.id LIMIT ?"));
        find.bind(after).bind(limit);
        return readAll(find, readAudit);
    });
}

Result<std::vector<RoomRecordRow>> DatabaseReader::roomRecords(ProcessId process, const std::string& kind,
                                                               const std::string& subject, std::uint32_t limit) {
    return guarded([&] {
        Statement find(database(), select(kRoomRecordColumns,
                                          "FROM room_records o WHERE o.process = ? AND o.kind = ? AND (? = '' OR "
                                          "o.subject = ?) ORDER BY o.id DESC LIMIT ?"));
        find.bind(processKey(process)).bind(kind).bind(subject).bind(subject).bind(limit);
        return readAll(find, readRoomRecord);
    });
}

Result<std::vector<RoomRecordRow>> DatabaseReader::newestRoomRecords(ProcessId process, const std::string& kind) {
    return guarded([&] {
        Statement find(database(), select(kRoomRecordColumns,
                                          "FROM room_records o WHERE o.id IN (SELECT max(id) FROM room_records WHERE "
                                          "process = ? AND kind = ? GROUP BY subject) ORDER BY o.id"));
        find.bind(processKey(process)).bind(kind);
        return readAll(find, readRoomRecord);
    });
}

Result<std::vector<AccountRow>> DatabaseReader::accounts() {
    return guarded([&] {
        Statement find(database(),
                       "SELECT name, role, seal, wrong_tries, last_wrong_utc_ms FROM accounts ORDER BY name");
        return readAll<AccountRow>(find, [](const Statement& row) {
            return AccountRow{row.text(0), row.text(1), row.text(2), row.count(3), row.integer(4)};
        });
    });
}

Result<AuditVerdict> DatabaseReader::verifyAudit() {
    return guarded([&] {
        const auto expected = HeadFile(m_path).read();  // first: the writer may go on meanwhile
        const Snapshot snapshot(database());
        AuditVerdict verdict = db::verifyAudit(database());
        if (verdict.finding.empty() && expected) {
            verdict.finding = missingSince(*expected, database());
        }
        return verdict;
    });
}

}  // namespace kerf::db
