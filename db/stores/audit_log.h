// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <string>

#include "db/api/audit_reader.h"
#include "db/api/rows.h"

namespace kerf::db {

/// The first entry follows this.
inline const std::string kGenesis(64, '0');

/// SHA-256 over the previous hash and every field of the entry, each with its length in front, as hexadecimal text.
/// The lengths make the text unambiguous: moving a character from one field to the next changes the hash.
[[nodiscard]] std::string auditHash(const AuditRow& row);

/// Adds an entry to the chain, inside the caller's transaction. id, time and hashes are filled in.
/// @throws SqlFailure, also when the author is empty.
void appendAudit(const QSqlDatabase& database, AuditRow row);

/// What the audit log says about a measurement when it is accepted; compared again by verifyAudit(). `withSource`: with
/// the name of gauge or file, if any; of those accepted before version 5 the log does not say it.
[[nodiscard]] std::string measurementText(const MeasurementRow& row, bool withSource = true);

/// What the audit log says about a room record, or a recipe of KeepRecipe: subject or part type, and the hash of the
/// body.
[[nodiscard]] std::string roomRecordText(const std::string& subject, const std::string& body);
/// One hash over all room records up to `last`, for those kept before each had its own. @throws SqlFailure
[[nodiscard]] std::string roomRecordsSeal(const QSqlDatabase& database, std::int64_t last);
inline constexpr const char* kRoomRecordsSealed = "room records sealed";

/// What the audit log says about a lot when it is opened, and when it is closed.
inline constexpr const char* kLotOpened = "lot opened";
inline constexpr const char* kLotClosed = "lot closed";
[[nodiscard]] std::string lotText(const LotRow& lot);
/// As versions before 7 wrote it.
[[nodiscard]] std::string lotTextOfBefore(const LotRow& lot);
[[nodiscard]] std::string lotEndText(std::int64_t closedUtc_ms);

/// What is kept of a part once it is made, each value as it is stored; "-" stands for none.
struct SealedPart {
    std::string process{}, lot{}, number{}, complete{}, begin_ns{}, end_ns{}, ended_ms{}, schedule{}, recipe{},
        figures{};
};
/// SHA-256 over the seal of the part before ("" for the first one) and this part's values, with lengths as auditHash().
[[nodiscard]] std::string partSeal(const std::string& before, const SealedPart& part);

/// Takes text out of old entries, and leaves the chain whole: the entry keeps the hash it was written with, so that the
/// next one still follows from it, and a new entry "entry redacted" says why and what the entry reads now (its hash as
/// it stands). verifyAudit() accepts a changed entry only so. @throws SqlFailure
void redactAudit(const QSqlDatabase& database, const AuditRow& asItShallRead, const std::string& author,
                 const std::string& reason);
inline constexpr const char* kRedacted = "entry redacted";

/// Recomputes the whole chain and compares every measurement, room record, recipe, lot and setting with its entry, and
/// the chain of the parts. @throws SqlFailure
[[nodiscard]] AuditVerdict verifyAudit(const QSqlDatabase& database);

}  // namespace kerf::db
