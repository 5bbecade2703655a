// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/store.h"

/// Taking text out of the audit log, and what earlier versions had put there.
namespace kerf::db {
namespace {

constexpr const char* kKerf = "Kerf";
constexpr const char* kOldPeople = "operators";  // one line each: name, tab, role, tab, "salt:digest"
constexpr const char* kTakenOut = "(taken out)";

/// The list of people as it was, without its third column.
std::string withoutSeals(const std::string& lines) {
    QStringList kept;
    for (const QString& line : QString::fromStdString(lines).split(QLatin1Char('\n'))) {
        QStringList words = line.split(QLatin1Char('\t'));
        if (words.size() > 2 && !words[2].isEmpty()) {
            words[2] = QLatin1String(kTakenOut);
        }
        kept << words.join(QLatin1Char('\t'));
    }
    return kept.join(QLatin1Char('\n')).toStdString();
}

void adoptPeople(const QSqlDatabase& database) {
    Statement find(database, "SELECT value FROM settings WHERE key = ?");
    if (!find.bind(kOldPeople).run().next()) {
        return;
    }
    for (const QString& line : QString::fromStdString(find.text(0)).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QStringList words = line.split(QLatin1Char('\t'));
        const QString role = words.value(1);
        const bool known = role == QLatin1String("setter") || role == QLatin1String("engineer");
        Statement(database,
                  "INSERT INTO accounts (name, role, seal, changed_utc_ms) VALUES (?, ?, ?, ?) ON CONFLICT (name) DO "
                  "NOTHING")
            .bind(words.value(0).toStdString())
            .bind(known ? role.toStdString() : std::string("operator"))
            .bind(words.value(2).isEmpty() ? std::string() : "old:" + words.value(2).toStdString())
            .bind(utcNow_ms())
            .run();
    }
    Statement(database, "DELETE FROM settings WHERE key = ?").bind(kOldPeople).run();
}

void redactSeals(const QSqlDatabase& database) {
    Statement find(database, QStringLiteral("SELECT %1 FROM audit u WHERE u.object = 'setting operators' AND u.object "
                                            "<> 'measurement' ORDER BY u.id")
                                 .arg(QLatin1String(kAuditColumns)));
    find.run();
    std::vector<AuditRow> entries;
    while (find.next()) {
        entries.push_back(readAudit(find));
    }
    for (AuditRow& entry : entries) {
        const std::string oldValue = withoutSeals(entry.oldValue);
        const std::string newValue = withoutSeals(entry.newValue);
        if (oldValue != entry.oldValue || newValue != entry.newValue) {
            entry.oldValue = oldValue;
            entry.newValue = newValue;
            redactAudit(database, entry, kKerf, "seals of PINs do not belong into the log");
        }
    }
}

void sealRoomRecords(const QSqlDatabase& database) {
    // Records without a hash of their own, not yet under a common one.
    Statement find(
        database,
        "SELECT max(o.id) FROM room_records o JOIN audit u ON u.object = 'room record' AND u.object <> 'measurement' "
        "AND "
        "u.object_id = o.id WHERE u.new_value NOT LIKE '%; sha256=%' AND o.id > (SELECT coalesce(max(object_id), 0) "
        "FROM audit WHERE object = 'room records' AND object <> 'measurement')");
    if (!find.run().next() || find.isNull(0)) {
        return;
    }
    const std::int64_t last = find.integer(0);
    appendAudit(database, {.author = kKerf,
                           .action = kRoomRecordsSealed,
                           .object = "room records",
                           .objectId = last,
                           .newValue = roomRecordsSeal(database, last),
                           .reason = "kept by a version that noted no hash"});
}

}  // namespace

void redactAudit(const QSqlDatabase& database, const AuditRow& asItShallRead, const std::string& author,
                 const std::string& reason) {
    // What is overwritten shall not stay in free pages.
    execute(database, QStringLiteral("PRAGMA secure_delete = ON"));
    Statement trigger(database, "SELECT sql FROM sqlite_master WHERE type = 'trigger' AND name = 'audit_no_update'");
    const bool guarded = trigger.run().next();
    const std::string sql = guarded ? trigger.text(0) : std::string();
    if (guarded) {
        execute(database, QStringLiteral("DROP TRIGGER audit_no_update"));
    }
    Statement(database, "UPDATE audit SET old_value = ?, new_value = ?, reason = ? WHERE id = ?")
        .bind(asItShallRead.oldValue)
        .bind(asItShallRead.newValue)
        .bind(asItShallRead.reason)
        .bind(asItShallRead.id)
        .run();
    if (guarded) {
        execute(database, QString::fromStdString(sql));
    }
    appendAudit(database, {.author = author,
                           .action = kRedacted,
                           .object = "audit",
                           .objectId = asItShallRead.id,
                           .newValue = auditHash(asItShallRead),
                           .reason = reason});
}

Result<void> Store::adoptEarlierForms() {
    return guarded([&] {
        Transaction transaction(m_database);
        adoptPeople(m_database);
        redactSeals(m_database);
        sealRoomRecords(m_database);
        transaction.commit();
    });
}

}  // namespace kerf::db
