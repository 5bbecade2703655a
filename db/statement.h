// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QLoggingCategory>
#include <QSqlDatabase>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "engine/core/result.h"

Q_DECLARE_LOGGING_CATEGORY(kerfDb)

struct sqlite3;
struct sqlite3_stmt;

namespace kerf::db {

struct PreparedPlace;

/// Thrown inside the database room only; every public function turns it into a Result.
class SqlFailure : public std::runtime_error {
 public:
    SqlFailure(const Sentence& sentence, int code, const std::string& detail)
        : std::runtime_error(detail), m_sentence(sentence), m_code(code) {}
    [[nodiscard]] const Sentence& sentence() const noexcept { return m_sentence; }
    [[nodiscard]] int code() const noexcept { return m_code; }  ///< SQLite's primary result code, 0: not from SQLite

 private:
    Sentence m_sentence;
    int m_code;
};

/// The operator's sentence for an SQLite result code (primary or extended).
[[nodiscard]] Sentence sentenceForCode(int code);

/// SQLite's own handle of an open connection; Qt made it and closes it. @throws SqlFailure when it is not open
[[nodiscard]] sqlite3* handleOf(const QSqlDatabase& database);

/// One prepared statement, bound by position. Throws SqlFailure. It speaks to SQLite itself, on Qt's connection: Qt's
/// way there by UTF-16 and QVariant took longer than what SQLite did with it.
class Statement {
 public:
    /// Words of the program itself: on a writing connection the prepared statement is kept for the next use.
    Statement(const QSqlDatabase& database, const char* sql);
    /// Words that were put together: prepared each time.
    Statement(const QSqlDatabase& database, const QString& sql);
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;
    ~Statement();

    Statement& bind(std::int64_t value);
    Statement& bind(std::int32_t value) { return bind(static_cast<std::int64_t>(value)); }
    Statement& bind(std::uint32_t value) { return bind(static_cast<std::int64_t>(value)); }
    Statement& bind(bool value) { return bind(static_cast<std::int64_t>(value ? 1 : 0)); }
    Statement& bind(double value);
    Statement& bind(std::string_view text);
    Statement& bind(const std::string& text) { return bind(std::string_view(text)); }
    Statement& bind(const char* text) { return bind(std::string_view(text)); }
    Statement& bind(const QByteArray& blob);
    template <class T>
    Statement& bind(const std::optional<T>& value) {
        return value ? bind(*value) : bindNull();
    }

    Statement& run();
    [[nodiscard]] bool next();
    /// Row id this INSERT has made.
    [[nodiscard]] std::int64_t lastId() const noexcept { return m_lastId; }
    [[nodiscard]] int changed() const noexcept { return m_changed; }

    // Of the row that next() has come to; nothing where there is none.
    [[nodiscard]] bool isNull(int column) const;
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] std::uint32_t count(int column) const { return static_cast<std::uint32_t>(integer(column)); }
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] QByteArray blob(int column) const;
    [[nodiscard]] std::optional<std::int64_t> maybeInteger(int column) const {
        return isNull(column) ? std::nullopt : std::optional(integer(column));
    }
    [[nodiscard]] std::optional<double> maybeReal(int column) const {
        return isNull(column) ? std::nullopt : std::optional(real(column));
    }

 private:
    enum class At : std::uint8_t { Start, FirstRow, Row, End };
    Statement& bindNull();
    /// The place of the next value; a statement that has run is wound back.
    int place();
    void check(int code);
    void step();
    [[noreturn]] void fail();
    void prepare(std::string_view sql, unsigned flags);

    sqlite3* m_connection;
    const char* m_words{nullptr};  ///< null: not kept
    PreparedPlace* m_place{nullptr};
    sqlite3_stmt* m_statement{nullptr};
    int m_next{0};
    At m_at{At::Start};
    std::int64_t m_lastId{0};
    int m_changed{0};
};

/// Runs one statement without results.
void execute(const QSqlDatabase& database, const QString& sql);
/// First column of the first row of a pragma or query; throws when there is none.
[[nodiscard]] std::int64_t integerOf(const QSqlDatabase& database, const QString& sql);

/// BEGIN IMMEDIATE … COMMIT; rolls back unless committed.
class Transaction {
 public:
    explicit Transaction(const QSqlDatabase& database);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();

 private:
    QSqlDatabase m_database;
    bool m_open{true};
};

/// Several reads that see one state of the file, whatever the writer does meanwhile.
class Snapshot {
 public:
    explicit Snapshot(const QSqlDatabase& database);
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;
    ~Snapshot();

 private:
    QSqlDatabase m_database;
};

/// Now, in milliseconds since 1970-01-01 UTC.
[[nodiscard]] std::int64_t utcNow_ms();

/// Runs `work` and turns SqlFailure into a Result. The detail goes to the log category "kerf.db".
template <class Work>
[[nodiscard]] auto guarded(Work&& work) -> Result<decltype(work())> {
    try {
        if constexpr (std::is_void_v<decltype(work())>) {
            work();
            return {};
        } else {
            return work();
        }
    } catch (const SqlFailure& failure) {
        qCWarning(kerfDb, "%s", failure.what());
        return tl::unexpected<Sentence>(failure.sentence());
    }
}

}  // namespace kerf::db
