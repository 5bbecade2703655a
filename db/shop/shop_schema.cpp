// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/shop_schema.h"

#include <QDir>
#include <QFile>
#include <vector>

#include "db/migrator.h"

// A static library's resources are linked only when named; the macro must be outside any namespace.
static void initShopResources() {
    Q_INIT_RESOURCE(shop_migrations);
}

namespace kerf::db {
namespace {

std::vector<Migration> shopMigrations() {
    initShopResources();
    std::vector<Migration> steps;
    const QDir folder(QStringLiteral(":/kerf/shop"));
    for (const QString& name : folder.entryList({QStringLiteral("shop_*.sql")}, QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            steps.push_back(parseMigration(name.mid(5, 3).toInt(), name.toStdString(), file.readAll().toStdString()));
        }
    }
    return steps;
}

std::string quoted(const std::string& identifier) {
    std::string text = "\"";
    for (const char c : identifier) {
        text += c == '"' ? "\"\"" : std::string(1, c);
    }
    return text + "\"";
}

}  // namespace

int newestShopVersion() {
    return shopMigrations().back().version;
}

ShopSchemaReport prepareShop(PgConnection& server) {
    ShopSchemaReport report;
    server.query("BEGIN");
    server.query("SELECT pg_advisory_xact_lock(hashtext('kerf shop schema'))");
    if (server.value("SELECT to_regclass('shop.schema_steps')")) {
        report.fromVersion = std::stoi(server.value("SELECT max(version) FROM shop.schema_steps").value_or("0"));
    } else {
        server.query("CREATE SCHEMA IF NOT EXISTS shop");
    }
    report.toVersion = report.fromVersion;
    for (const Migration& step : shopMigrations()) {
        if (step.version <= report.fromVersion) {
            continue;
        }
        for (const MigrationStatement& statement : step.statements) {
            server.query(statement.sql);
        }
        server.query("INSERT INTO shop.schema_steps (version, program) VALUES ($1, $2)",
                     {std::to_string(step.version), std::string(KERF_VERSION)});
        report.toVersion = step.version;
    }
    server.query("COMMIT");
    return report;
}

void allowUnenrolled(PgConnection& server, bool allowed) {
    server.query("UPDATE shop.server_settings SET value = $1 WHERE key = 'allow_unenrolled'",
                 {std::string(allowed ? "true" : "false")});
}

std::string consoleRole(const std::string& store) {
    return "kerf_console_" + store.substr(0, 8) + store.substr(9, 4);
}

void enrolConsole(PgConnection& server, const Enrolment& enrolment) {
    server.query("BEGIN");
    if (!server.value("SELECT 1 FROM pg_roles WHERE rolname = $1", {enrolment.role})) {
        server.query("CREATE ROLE " + quoted(enrolment.role) + " LOGIN");
    }
    server.query("GRANT kerf_console TO " + quoted(enrolment.role));
    server.query(
        "INSERT INTO shop.enrolled (store, role, console) VALUES ($1, $2, $3) ON CONFLICT (store) DO UPDATE SET "
        "role = excluded.role, console = excluded.console",
        {enrolment.store, enrolment.role, enrolment.console});
    server.query("COMMIT");
}

}  // namespace kerf::db
