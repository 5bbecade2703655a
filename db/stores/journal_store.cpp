// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/store.h"

/// Alarms, settings and free entries of the audit log.
namespace kerf::db {

Receipt Store::run(const RaiseAlarm& command) {
    Statement insert(
        m_database,
        "INSERT INTO alarms (code, priority, raised_utc_ms, detail_text, detail_args) VALUES (?, ?, ?, ?, ?)");
    insert.bind(static_cast<std::int64_t>(command.code))
        .bind(static_cast<std::int64_t>(command.priority))
        .bind(command.utc_ms != 0 ? command.utc_ms : utcNow_ms())
        .bind(command.detailText.empty() ? std::string(command.detail.text) : command.detailText)
        .bind(command.detailText.empty() ? packArgs(command.detail) : command.detailArgs)
        .run();
    return {insert.lastId()};
}

Receipt Store::run(const ClearAlarm& command) {
    Statement(m_database,
              "UPDATE alarms SET cleared_utc_ms = ?, clear_cause = 'gone' WHERE code = ? AND cleared_utc_ms IS NULL")
        .bind(command.utc_ms != 0 ? command.utc_ms : utcNow_ms())
        .bind(static_cast<std::int64_t>(command.code))
        .run();
    return {};
}

Receipt Store::run(const CloseAlarmsOfLastRun&) {
    Statement(m_database, "UPDATE alarms SET cleared_utc_ms = ?, clear_cause = 'restart' WHERE cleared_utc_ms IS NULL")
        .bind(utcNow_ms())
        .run();
    return {};
}

Receipt Store::run(const AcknowledgeAlarm& command) {
    Statement find(m_database, "SELECT code, acknowledged_by FROM alarms WHERE id = ?");
    if (!find.bind(command.alarm).run().next()) {
        throw SqlFailure(Sentence(KERF_TEXT("There is no such alarm.")), 0, "no such alarm");
    }
    if (!find.text(1).empty()) {
        return {command.alarm};  // a second hand on the same button
    }
    appendAudit(m_database, {.author = command.author,
                             .action = "alarm acknowledged",
                             .object = "alarm",
                             .objectId = command.alarm,
                             .newValue = "code " + find.text(0)});
    Statement(m_database, "UPDATE alarms SET acknowledged_utc_ms = ?, acknowledged_by = ? WHERE id = ?")
        .bind(utcNow_ms())
        .bind(command.author)
        .bind(command.alarm)
        .run();
    return {command.alarm};
}

Receipt Store::run(const ChangeSetting& command) {
    Statement find(m_database, "SELECT value FROM settings WHERE key = ?");
    const bool known = find.bind(command.key).run().next();
    const std::string before = known ? find.text(0) : std::string();
    if (known && before == command.value) {
        return {};  // nothing changed, nothing logged
    }
    Statement(m_database,
              "INSERT INTO settings (key, value, changed_by, changed_utc_ms) VALUES (?, ?, ?, ?) ON CONFLICT (key) DO "
              "UPDATE SET value = excluded.value, changed_by = excluded.changed_by, changed_utc_ms = "
              "excluded.changed_utc_ms")
        .bind(command.key)
        .bind(command.value)
        .bind(command.author)
        .bind(utcNow_ms())
        .run();
    appendAudit(m_database, {.author = command.author,
                             .action = "setting changed",
                             .object = "setting " + command.key,
                             .oldValue = before,
                             .newValue = command.value,
                             .reason = command.reason});
    return {};
}

Receipt Store::run(const AddAudit& command) {
    if (command.object == "measurement") {
        throw SqlFailure(sentenceForCode(19), 19, "audit entries of measurements are written with the measurement");
    }
    appendAudit(m_database, {.author = command.author,
                             .action = command.action,
                             .object = command.object,
                             .objectId = command.objectId,
                             .oldValue = command.oldValue,
                             .newValue = command.newValue,
                             .reason = command.reason});
    return {};
}

}  // namespace kerf::db
