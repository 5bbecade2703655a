// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/statement.h"

#include <QDateTime>
#include <QSqlError>
#include <utility>

#include "db/prepared.h"

Q_LOGGING_CATEGORY(kerfDb, "kerf.db", QtWarningMsg)

namespace kerf::db {
namespace {
// SQLite's primary result codes (sqlite.org/rescode.html); the low byte of an extended code.
enum SqliteCode : int {
    kBusy = 5,
    kLocked = 6,
    kReadOnly = 8,
    kIoError = 10,
    kCorrupt = 11,
    kFull = 13,
    kCannotOpen = 14,
    kConstraint = 19,
    kNotADatabase = 26,
};

[[noreturn]] void raise(const QSqlError& error, const QString& sql) {
    const int code = error.nativeErrorCode().toInt() & 0xFF;
    const QString detail =
        QStringLiteral("SQLite %1: %2 [%3]").arg(error.nativeErrorCode(), error.text(), sql.left(200));
    throw SqlFailure(sentenceForCode(code), code, detail.toStdString());
}
}  // namespace

Sentence sentenceForCode(int code) {
    switch (code & 0xFF) {
        case kBusy:
        case kLocked:
            return Sentence(KERF_TEXT("The data file is in use by another program; try again in a moment."));
        case kReadOnly:
            return Sentence(KERF_TEXT("The data file cannot be written: it, or its folder, is read-only."));
        case kIoError:
            return Sentence(KERF_TEXT("Reading or writing the data file failed: check the disk."));
        case kCorrupt:
            return Sentence(KERF_TEXT("The data file is damaged: go on with the newest backup and keep this file."));
        case kFull:
            return Sentence(KERF_TEXT("The disk is full: nothing can be stored until space is made."));
        case kCannotOpen:
            return Sentence(KERF_TEXT("The data file cannot be opened: check the folder and its permissions."));
        case kConstraint:
            return Sentence(KERF_TEXT("The data file refused the entry: it contradicts what is already stored."));
        case kNotADatabase:
            return Sentence(KERF_TEXT("The data file is not a Kerf database."));
        default:
            return Sentence(KERF_TEXT("The data file refused the request (code %1)."), SentenceArg(code, 0));
    }
}

Statement::Statement(const QSqlDatabase& database, const char* sql)
    : m_connection(database.connectionName()), m_sql(QString::fromUtf8(sql)), m_query(database) {
    if (auto ready = takePrepared(m_connection, m_sql)) {
        m_query = std::move(*ready);
    } else {
        prepare(m_sql);
    }
}

Statement::Statement(const QSqlDatabase& database, const QString& sql) : m_query(database) {
    prepare(sql);
}

Statement::~Statement() {
    if (!m_connection.isEmpty()) {
        m_query.finish();
        giveBackPrepared(m_connection, m_sql, std::move(m_query));
    }
}

void Statement::prepare(const QString& sql) {
    m_query.setForwardOnly(true);
    if (!m_query.prepare(sql)) {
        raise(m_query.lastError(), sql);
    }
}

Statement& Statement::bindVariant(const QVariant& value) {
    m_query.bindValue(m_next++, value);
    return *this;
}

Statement& Statement::run() {
    m_next = 0;
    if (!m_query.exec()) {
        fail();
    }
    if (!m_query.isSelect()) {
        m_lastId = m_query.lastInsertId().toLongLong();  // of the connection: taken before the next insert changes it
    }
    return *this;
}

bool Statement::next() {
    if (m_query.next()) {
        return true;
    }
    if (m_query.lastError().type() != QSqlError::NoError) {
        fail();
    }
    return false;
}

void Statement::fail() {
    m_connection.clear();
    raise(m_query.lastError(), m_query.lastQuery());
}

void execute(const QSqlDatabase& database, const QString& sql) {
    Statement(database, sql).run();
}

std::int64_t integerOf(const QSqlDatabase& database, const QString& sql) {
    Statement statement(database, sql);
    if (!statement.run().next()) {
        throw SqlFailure(sentenceForCode(0), 0, "no result: " + sql.toStdString());
    }
    return statement.integer(0);
}

Transaction::Transaction(const QSqlDatabase& database) : m_database(database) {
    // IMMEDIATE: a lock that cannot be had is found out here, not in the middle.
    Statement(m_database, "BEGIN IMMEDIATE").run();
}

Transaction::~Transaction() {
    if (m_open) {
        QSqlQuery(m_database).exec(QStringLiteral("ROLLBACK"));  // already rolled back by SQLite after some errors
    }
}

void Transaction::commit() {
    Statement(m_database, "COMMIT").run();
    m_open = false;
}

Snapshot::Snapshot(const QSqlDatabase& database) : m_database(database) {
    execute(m_database, QStringLiteral("BEGIN"));
}

Snapshot::~Snapshot() {
    QSqlQuery(m_database).exec(QStringLiteral("COMMIT"));
}

std::int64_t utcNow_ms() {
    return QDateTime::currentMSecsSinceEpoch();
}

}  // namespace kerf::db
