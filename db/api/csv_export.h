// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "db/api/audit_reader.h"
#include "db/api/part_reader.h"

/// Tables as CSV for other programs: RFC 4180, UTF-8, '.' and 17 digits, stored units whatever the screen shows.
/// Oldest first, read page by page, so that a long history needs little memory. Used by the Parts page and by `kerf
/// data`.
namespace kerf {

/// Takes the text piece by piece, whole lines at a time; false stops the export (the disk is full, the page was
/// closed).
using CsvSink = std::function<bool(std::string_view)>;

/// One row per part and station with what holds now: part_id, process, part_type, lot, number, serial, complete,
/// ended_utc, cutting_time_s, station, position_mm, diameter_mm, source, author, accepted_utc, corrected. A part
/// without a measurement has one row with empty fields from station on. Gives the number of rows; `query`'s paging is
/// ignored.
[[nodiscard]] Result<std::uint64_t> exportParts(PartReader& reader, const PartQuery& query, const CsvSink& sink);

/// Every accepted row, corrections and voids too: part_id, part_type, lot, number, measurement_id, kind, replaces_id,
/// station, position_mm, diameter_mm, source, confirmed, author, reason, accepted_utc.
[[nodiscard]] Result<std::uint64_t> exportMeasurements(PartReader& reader, const PartQuery& query, const CsvSink& sink);

/// The engine's figures of each part, one row per figure: part_id, process, part_type, lot, number, serial, ended_utc,
/// figure (ends in its unit), value.
[[nodiscard]] Result<std::uint64_t> exportFigures(PartReader& reader, const PartQuery& query, const CsvSink& sink);

/// The schedule against what was cut, one row per point: part_id, lot, number, schedule_revision, overhang_mm,
/// scheduled_feed_mm_per_rev, cut_feed_mm_per_rev.
[[nodiscard]] Result<std::uint64_t> exportFeed(PartReader& reader, const PartQuery& query, const CsvSink& sink);

/// The audit log with its hashes: id, utc, author, action, object, object_id, old_value, new_value, reason,
/// previous_hash, hash.
[[nodiscard]] Result<std::uint64_t> exportAudit(AuditReader& reader, const CsvSink& sink);

/// Milliseconds since 1970-01-01 UTC as ISO 8601: 2026-11-22T03:48:16.250Z.
[[nodiscard]] std::string isoTime(std::int64_t utc_ms);

}  // namespace kerf
