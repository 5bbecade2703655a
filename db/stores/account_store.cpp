// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/store.h"

/// People known at the machine.
namespace kerf::db {

Receipt Store::run(const SaveAccount& command) {
    Statement find(m_database, "SELECT role, seal FROM accounts WHERE name = ?");
    const bool known = find.bind(command.name).run().next();
    const auto text = [](const std::string& role, const std::string& seal) {
        return role + (seal.empty() ? ", no PIN" : ", PIN");
    };
    const std::string before = known ? text(find.text(0), find.text(1)) : std::string();
    const bool pinChanged = known && find.text(1) != command.seal;
    Statement(
        m_database,
        "INSERT INTO accounts (name, role, seal, changed_utc_ms) VALUES (?, ?, ?, ?) ON CONFLICT (name) DO UPDATE "
        "SET role = excluded.role, seal = excluded.seal, changed_utc_ms = excluded.changed_utc_ms")
        .bind(command.name)
        .bind(command.roleKey)
        .bind(command.seal)
        .bind(utcNow_ms())
        .run();
    appendAudit(m_database, {.author = command.author,
                             .action = known ? "account changed" : "account made",
                             .object = "account " + command.name,
                             .oldValue = before,
                             .newValue = text(command.roleKey, command.seal) + (pinChanged ? ", new PIN" : ""),
                             .reason = command.reason});
    return {};
}

Receipt Store::run(const RemoveAccount& command) {
    Statement find(m_database, "SELECT role FROM accounts WHERE name = ?");
    if (!find.bind(command.name).run().next()) {
        throw SqlFailure(Sentence(KERF_TEXT("There is no such person on the list.")), 0, "no such account");
    }
    const std::string role = find.text(0);
    Statement(m_database, "DELETE FROM accounts WHERE name = ?").bind(command.name).run();
    appendAudit(
        m_database,
        {.author = command.author, .action = "account removed", .object = "account " + command.name, .oldValue = role});
    return {};
}

Receipt Store::run(const NoteWrongPin& command) {
    Statement(m_database, "UPDATE accounts SET wrong_tries = ?, last_wrong_utc_ms = ? WHERE name = ?")
        .bind(command.tries)
        .bind(command.last_utc_ms)
        .bind(command.name)
        .run();
    return {};
}

}  // namespace kerf::db
