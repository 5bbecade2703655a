// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/statement.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <QDateTime>
#include <QSqlDriver>
#include <QVariant>
#include <cctype>

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

[[noreturn]] void raise(sqlite3* connection, std::string_view sql) {
    const int code = sqlite3_extended_errcode(connection);
    throw SqlFailure(sentenceForCode(code), code & 0xFF,
                     fmt::format("SQLite {}: {} [{}]", code, sqlite3_errmsg(connection), sql.substr(0, 200)));
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

sqlite3* handleOf(const QSqlDatabase& database) {
    const QVariant handle = database.driver()->handle();
    auto* connection =
        qstrcmp(handle.typeName(), "sqlite3*") == 0 ? *static_cast<sqlite3* const*>(handle.constData()) : nullptr;
    if (connection == nullptr) {
        throw SqlFailure(sentenceForCode(kCannotOpen), kCannotOpen, "no open SQLite connection");
    }
    return connection;
}

Statement::Statement(const QSqlDatabase& database, const char* sql) : m_connection(handleOf(database)), m_words(sql) {
    m_place = takePrepared(m_connection, m_words, m_statement);
    if (m_statement == nullptr) {
        prepare(m_words, SQLITE_PREPARE_PERSISTENT);
    }
}

Statement::Statement(const QSqlDatabase& database, const QString& sql) : m_connection(handleOf(database)) {
    prepare(sql.toStdString(), 0);
}

Statement::~Statement() {
    if (m_words == nullptr) {
        sqlite3_finalize(m_statement);
        return;
    }
    sqlite3_reset(m_statement);
    sqlite3_clear_bindings(m_statement);
    giveBackPrepared(m_connection, m_place, m_statement);
}

void Statement::prepare(std::string_view sql, unsigned flags) {
    const char* rest = nullptr;
    if (sqlite3_prepare_v3(m_connection, sql.data(), static_cast<int>(sql.size()), flags, &m_statement, &rest) !=
        SQLITE_OK) {
        raise(m_connection, sql);
    }
    for (; rest != sql.data() + sql.size(); ++rest) {
        if (std::isspace(static_cast<unsigned char>(*rest)) == 0 && *rest != ';') {
            sqlite3_finalize(m_statement);
            throw SqlFailure(sentenceForCode(SQLITE_ERROR), SQLITE_ERROR,
                             fmt::format("more than one statement [{}]", sql.substr(0, 200)));
        }
    }
}

int Statement::place() {
    if (m_at != At::Start) {
        sqlite3_reset(m_statement);
        m_at = At::Start;
    }
    return ++m_next;
}

void Statement::check(int code) {
    if (code != SQLITE_OK) {
        fail();
    }
}

Statement& Statement::bind(std::int64_t value) {
    check(sqlite3_bind_int64(m_statement, place(), value));
    return *this;
}

Statement& Statement::bind(double value) {
    check(sqlite3_bind_double(m_statement, place(), value));
    return *this;
}

Statement& Statement::bind(std::string_view text) {
    const char* bytes = text.data() == nullptr ? "" : text.data();
    check(sqlite3_bind_text64(m_statement, place(), bytes, text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind(const QByteArray& blob) {
    if (blob.isNull()) {
        return bindNull();
    }
    check(sqlite3_bind_blob64(m_statement, place(), blob.constData(), static_cast<sqlite3_uint64>(blob.size()),
                              SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bindNull() {
    check(sqlite3_bind_null(m_statement, place()));
    return *this;
}

void Statement::step() {
    switch (sqlite3_step(m_statement)) {
        case SQLITE_ROW:
            m_at = m_at == At::Start ? At::FirstRow : At::Row;
            return;
        case SQLITE_DONE:
            m_at = At::End;
            return;
        default:
            fail();
    }
}

Statement& Statement::run() {
    if (m_at != At::Start) {
        sqlite3_reset(m_statement);
        m_at = At::Start;
    }
    m_next = 0;
    step();
    if (sqlite3_column_count(m_statement) == 0) {
        m_lastId =
            sqlite3_last_insert_rowid(m_connection);  // of the connection: taken before the next insert changes it
        m_changed = sqlite3_changes(m_connection);
    }
    return *this;
}

bool Statement::next() {
    if (m_at == At::FirstRow) {
        m_at = At::Row;
    } else if (m_at == At::Row) {
        step();
    }
    return m_at == At::Row;
}

bool Statement::isNull(int column) const {
    return m_at != At::Row || sqlite3_column_type(m_statement, column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
    return m_at != At::Row ? 0 : sqlite3_column_int64(m_statement, column);
}

double Statement::real(int column) const {
    return m_at != At::Row ? 0.0 : sqlite3_column_double(m_statement, column);
}

std::string Statement::text(int column) const {
    if (m_at != At::Row) {
        return {};
    }
    if (sqlite3_column_type(m_statement, column) == SQLITE_FLOAT) {
        return fmt::format("{}", sqlite3_column_double(m_statement, column));  // every digit; SQLite's own text has 15
    }
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(m_statement, column));
    return bytes == nullptr ? std::string()
                            : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column)));
}

QByteArray Statement::blob(int column) const {
    if (m_at != At::Row) {
        return {};
    }
    const void* bytes = sqlite3_column_blob(m_statement, column);
    return {static_cast<const char*>(bytes), sqlite3_column_bytes(m_statement, column)};
}

void Statement::fail() {
    const char* words = sqlite3_sql(m_statement);
    const std::string sql = words == nullptr ? std::string() : std::string(words);
    raise(m_connection, sql);
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
        sqlite3_exec(handleOf(m_database), "ROLLBACK", nullptr, nullptr, nullptr);  // done already after some errors
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
    sqlite3_exec(handleOf(m_database), "COMMIT", nullptr, nullptr, nullptr);
}

std::int64_t utcNow_ms() {
    return QDateTime::currentMSecsSinceEpoch();
}

}  // namespace kerf::db
