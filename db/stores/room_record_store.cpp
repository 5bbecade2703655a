// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/store.h"

/// What the rooms keep: setups, tunings, models.
namespace kerf::db {

Receipt Store::run(const AddRoomRecord& command) {
    Statement insert(m_database,
                     "INSERT INTO room_records (process, kind, subject, body, author, reason, created_utc_ms) VALUES "
                     "(?, ?, ?, ?, ?, ?, ?)");
    insert.bind(processKey(command.process))
        .bind(command.kind)
        .bind(command.subject)
        .bind(command.bodyJson)
        .bind(command.author)
        .bind(command.reason)
        .bind(utcNow_ms())
        .run();
    const std::int64_t id = insert.lastId();
    // The body stays where it is: the audit entry says who kept what, and why, and by its hash that it is this one.
    appendAudit(m_database, {.author = command.author,
                             .action = std::string(processKey(command.process)) + " " + command.kind + " kept",
                             .object = "room record",
                             .objectId = id,
                             .newValue = roomRecordText(command.subject, command.bodyJson),
                             .reason = command.reason});
    return {id};
}

}  // namespace kerf::db
