// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <string>

#include "db/api/audit_reader.h"
#include "db/api/rows.h"

namespace kerf::db {

/// SHA-256 over the previous hash and every field of the entry, each with its length in front, as hexadecimal text.
/// The lengths make the text unambiguous: moving a character from one field to the next changes the hash.
[[nodiscard]] std::string auditHash(const AuditRow& row);

/// Adds an entry to the chain, inside the caller's transaction. id, time and hashes are filled in.
/// @throws SqlFailure, also when the author is empty.
void appendAudit(const QSqlDatabase& database, AuditRow row);

/// What the audit log says about a measurement when it is accepted; compared again by verifyAudit().
[[nodiscard]] std::string measurementText(const MeasurementRow& row);

/// Recomputes the whole chain and compares every measurement with its entry. @throws SqlFailure
[[nodiscard]] AuditVerdict verifyAudit(const QSqlDatabase& database);

}  // namespace kerf::db
