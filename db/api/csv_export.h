// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "db/api/audit_reader.h"
#include "db/api/lot_reader.h"
#include "db/api/part_reader.h"

/// Tables as CSV for other programs: RFC 4180, UTF-8, '.' and shortest digits unless asked otherwise, stored units
/// whatever the screen shows. Oldest first, read page by page, so that a long history needs little memory. Used by the
/// Parts page and by `kerf data`.
namespace kerf {

/// What a spreadsheet of another country wants. Numbers have the fewest digits that give the same number back; a text
/// that a spreadsheet would run as a formula (= + - @ in front) has an apostrophe before it.
struct CsvFormat {
    char separator{','};
    char decimal{'.'};
    bool byteOrderMark{false};  ///< Excel takes UTF-8 without one for the country's old code page
    bool localTime{false};      ///< at the end of each row, its times once more as the clock on the wall showed them
};

/// Takes the text piece by piece, whole lines at a time; false stops the export (the disk is full, the page was
/// closed).
using CsvSink = std::function<bool(std::string_view)>;

/// What quality says of a part's value; whoever knows tolerances gives it. Empty texts: nobody was asked.
struct ExportedVerdict {
    std::optional<double> lower{};
    std::optional<double> upper{};
    std::string value{};     ///< "good", "rework", "scrap", "not_judged"
    std::string part{};      ///< the worst of the part's values
    std::string decision{};  ///< what was done with a part out of tolerance; empty: nothing yet
    std::string decisionBy{};
};
/// `key`: a figure's key, or "bore_0" for the first depth.
using VerdictOf = std::function<ExportedVerdict(const PartRow&, std::string_view key)>;

/// One row per part and station with what holds now: part_id, process, part_type, lot, number, serial, complete,
/// ended_utc, cutting_time_s, station, position_mm, diameter_mm, source, author, accepted_utc, corrected, lower_mm,
/// upper_mm, verdict, part_verdict, source_name (which gauge, which file), decision (what was done with a part out of
/// tolerance), decision_by, lot_id, recipe_revision. A part without a measurement has one row with empty fields from
/// station on. Gives the number of rows; `query`'s paging is ignored.
[[nodiscard]] Result<std::uint64_t> exportParts(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                                const CsvFormat& format = {}, const VerdictOf& verdictOf = {});

/// What `kerf boring replay` reads: part (its number in the lot), overhang_mm, feed_mm_per_rev (really cut there),
/// diameter_mm, lot, source, source_name; one row per bore that holds, in the order of parts. `feedAt` is the law's:
/// feed of a part at an overhang, empty when it is not known (the row is then left out).
using FeedAt = std::function<std::optional<double>(const PartDetail&, double overhang_mm)>;
[[nodiscard]] Result<std::uint64_t> exportBores(PartReader& reader, const PartQuery& query, const FeedAt& feedAt,
                                                const CsvSink& sink, const CsvFormat& format = {});

/// Every accepted row, corrections and voids too: part_id, part_type, lot, number, measurement_id, kind, replaces_id,
/// station, position_mm, diameter_mm, source, confirmed, author, reason, accepted_utc, source_name.
[[nodiscard]] Result<std::uint64_t> exportMeasurements(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                                       const CsvFormat& format = {});

/// The engine's figures of each part, one row per figure: part_id, process, part_type, lot, number, serial, ended_utc,
/// figure (ends in its unit), value, lower, upper, verdict, part_verdict, decision, decision_by.
[[nodiscard]] Result<std::uint64_t> exportFigures(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                                  const CsvFormat& format = {}, const VerdictOf& verdictOf = {});

/// The schedule against what was cut, one row per point: part_id, lot, number, schedule_revision, overhang_mm,
/// scheduled_feed_mm_per_rev, cut_feed_mm_per_rev.
[[nodiscard]] Result<std::uint64_t> exportFeed(PartReader& reader, const PartQuery& query, const CsvSink& sink,
                                               const CsvFormat& format = {});

/// Every revision of every recipe, of one process or of all: revision_id, process, part_type, revision, restored_from,
/// author, reason, created_utc, parameters (JSON).
[[nodiscard]] Result<std::uint64_t> exportRecipes(LotReader& reader, std::optional<ProcessId> process,
                                                  const CsvSink& sink, const CsvFormat& format = {});

/// Every lot, of one process or of all: lot_id, process, part_type, lot, machine, recipe_revision, size, estimator,
/// tool, gauge, opened_utc, opened_by, closed_utc, closed_by.
[[nodiscard]] Result<std::uint64_t> exportLots(LotReader& reader, std::optional<ProcessId> process, const CsvSink& sink,
                                               const CsvFormat& format = {});

/// The audit log with its hashes: id, utc, author, action, object, object_id, old_value, new_value, reason,
/// previous_hash, hash.
[[nodiscard]] Result<std::uint64_t> exportAudit(AuditReader& reader, const CsvSink& sink, const CsvFormat& format = {});

/// Milliseconds since 1970-01-01 UTC as ISO 8601: 2026-11-22T03:48:16.250Z.
[[nodiscard]] std::string isoTime(std::int64_t utc_ms);
/// In the computer's time zone, as spreadsheets read it: 2026-11-27 10:07:45.
[[nodiscard]] std::string localTime(std::int64_t utc_ms);

}  // namespace kerf
