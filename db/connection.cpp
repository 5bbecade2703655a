// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection.h"

#include <QSqlError>
#include <atomic>

#include "db/statement.h"

namespace kerf::db {
namespace {
std::atomic<std::uint64_t> connectionCount{0};
}  // namespace

Connection::Connection(const std::string& path, Access access)
    : m_name(QStringLiteral("kerf-%1").arg(connectionCount.fetch_add(1))),
      m_database(QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), m_name)) {
    const auto giveUp = [this] {
        m_database = QSqlDatabase();
        QSqlDatabase::removeDatabase(m_name);
    };
    m_database.setDatabaseName(QString::fromStdString(path));
    m_database.setConnectOptions(access == Access::Read
                                     ? QStringLiteral("QSQLITE_OPEN_READONLY;QSQLITE_BUSY_TIMEOUT=2000")
                                     : QStringLiteral("QSQLITE_BUSY_TIMEOUT=2000"));
    if (!m_database.open()) {
        const QSqlError error = m_database.lastError();
        const int code = error.nativeErrorCode().toInt() & 0xFF;
        giveUp();
        throw SqlFailure(sentenceForCode(code), code, error.text().toStdString());
    }
    try {
        if (access == Access::Write) {
            execute(m_database, QStringLiteral("PRAGMA journal_mode = WAL"));
            execute(m_database, QStringLiteral("PRAGMA synchronous = FULL"));
            execute(m_database, QStringLiteral("PRAGMA foreign_keys = ON"));
            // INSERT OR REPLACE must not get past the delete triggers of the append-only tables.
            execute(m_database, QStringLiteral("PRAGMA recursive_triggers = ON"));
            execute(m_database, QStringLiteral("PRAGMA journal_size_limit = 67108864"));
        } else {
            execute(m_database, QStringLiteral("PRAGMA query_only = ON"));
        }
    } catch (const SqlFailure&) {
        giveUp();
        throw;
    }
}

Connection::~Connection() {
    m_database.close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

}  // namespace kerf::db
