// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "db/api/rows.h"
#include "db/statement.h"
#include "engine/api/part_results.h"

/// Column lists and the reading of a row from them, one place per table.
namespace kerf::db {

[[nodiscard]] const char* kindKey(MeasurementKind kind);
[[nodiscard]] ProcessId processOfKey(const std::string& key);

inline constexpr const char* kMeasurementColumns =
    "m.id, m.part_id, m.kind, m.replaces_id, m.station, m.position_mm, m.diameter_mm, m.source, m.confirmed, m.author, "
    "m.reason, m.accepted_utc_ms, "
    "(SELECT w.source FROM measurement_sources w WHERE w.measurement_id = m.id), "
    "(SELECT w.name FROM measurement_sources w WHERE w.measurement_id = m.id)";
/// How many they are: what a query asks for behind them begins there.
inline constexpr int kMeasurementColumnCount = 14;
[[nodiscard]] MeasurementRow readMeasurement(const Statement& row);

inline constexpr const char* kStateColumns =
    "e.id, e.measurement_id, e.cause_measurement_id, e.estimator, e.ln_c, e.alpha, e.beta, e.p00, e.p01, e.p02, e.p11, "
    "e.p12, e.p22, e.perturbed, e.state";
[[nodiscard]] EstimatorStateRow readState(const Statement& row);

inline constexpr const char* kScheduleColumns =
    "s.id, s.lot_id, s.revision, s.ln_c, s.alpha, s.beta, s.target_deflection_mm, s.constant_feed_mm_per_rev, "
    "s.min_feed_mm_per_rev, s.max_feed_mm_per_rev, s.overhang_from_mm, s.overhang_to_mm, s.spindle_speed_rpm, "
    "s.prediction, s.reason, s.created_utc_ms, s.accepted_by, s.accepted_utc_ms";
/// `from`: the first of its columns in the row.
[[nodiscard]] ScheduleRow readSchedule(const Statement& row, int from = 0);

inline constexpr const char* kPartColumns =
    "p.id, p.process, p.lot_id, l.name, t.name, p.number, p.serial, p.complete, p.machine_begin_ns, p.machine_end_ns, "
    "p.ended_utc_ms, x.results, p.recipe_revision_id, v.revision";
/// How many they are: what a query asks for behind them begins there.
inline constexpr int kPartColumnCount = 14;
inline constexpr const char* kPartJoins =
    " LEFT JOIN lots l ON l.id = p.lot_id LEFT JOIN recipe_revisions v ON v.id = p.recipe_revision_id LEFT JOIN "
    "part_types t ON t.id = coalesce(l.part_type_id, v.part_type_id) LEFT JOIN part_results x ON x.part_id = p.id ";
[[nodiscard]] PartRow readPart(const Statement& row);

inline constexpr const char* kRecipeColumns =
    "r.id, r.part_type_id, r.revision, r.parameters, r.restored_from, r.author, r.reason, r.created_utc_ms";
[[nodiscard]] RecipeRevision readRecipe(const Statement& row);

inline constexpr const char* kLotColumns =
    "l.id, l.machine_id, c.name, l.part_type_id, t.name, t.process, l.recipe_revision_id, l.name, l.size, l.estimator, "
    "l.opened_utc_ms, l.closed_utc_ms, l.tool, l.gauge, l.opened_by, l.closed_by, "
    "(SELECT v.revision FROM recipe_revisions v WHERE v.id = l.recipe_revision_id)";
/// How many they are: what a query asks for behind them begins there.
inline constexpr int kLotColumnCount = 17;
inline constexpr const char* kLotJoins =
    " JOIN machines c ON c.id = l.machine_id JOIN part_types t ON t.id = l.part_type_id ";
[[nodiscard]] LotRow readLot(const Statement& row);

inline constexpr const char* kAlarmColumns =
    "a.id, a.code, a.priority, a.raised_utc_ms, a.cleared_utc_ms, a.clear_cause, a.acknowledged_utc_ms, "
    "a.acknowledged_by, a.detail_text, a.detail_args";
[[nodiscard]] AlarmRow readAlarm(const Statement& row);

inline constexpr const char* kAuditColumns =
    "u.id, u.utc_ms, u.author, u.action, u.object, u.object_id, u.old_value, u.new_value, u.reason, u.previous_hash, "
    "u.hash";
[[nodiscard]] AuditRow readAudit(const Statement& row);

inline constexpr const char* kRoomRecordColumns =
    "o.id, o.process, o.kind, o.subject, o.body, o.author, o.reason, o.created_utc_ms";
[[nodiscard]] RoomRecordRow readRoomRecord(const Statement& row);

/// A part's figures as a JSON object.
[[nodiscard]] std::string packFigures(const std::vector<PartResult>& results);
[[nodiscard]] std::vector<PartFigure> unpackFigures(ProcessId process, const std::string& json);

/// The feed trace as stored: pairs of little-endian 32-bit floats.
[[nodiscard]] QByteArray packTrace(const FeedTrace& trace);
[[nodiscard]] FeedTrace unpackTrace(const QByteArray& points);

/// Arguments of an alarm's sentence as a JSON array: numbers {"v", "d"} and names {"n"}.
[[nodiscard]] std::string packArgs(const Sentence& sentence);
[[nodiscard]] std::vector<SentenceArg> unpackArgs(const std::string& json);

/// The key under which the active lot of a process is kept in the settings.
[[nodiscard]] std::string activeLotKey(ProcessId process);

}  // namespace kerf::db
