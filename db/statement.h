// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QLoggingCategory>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "engine/core/result.h"

Q_DECLARE_LOGGING_CATEGORY(kerfDb)

namespace kerf::db {

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

/// One prepared statement, bound by position. Throws SqlFailure.
class Statement {
 public:
    /// Words of the program itself: on a writing connection the prepared statement is kept for the next use.
    Statement(const QSqlDatabase& database, const char* sql);
    /// Words that were put together: prepared each time.
    Statement(const QSqlDatabase& database, const QString& sql);
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;
    ~Statement();

    Statement& bind(std::int64_t value) { return bindVariant(QVariant(static_cast<qlonglong>(value))); }
    Statement& bind(std::int32_t value) { return bind(static_cast<std::int64_t>(value)); }
    Statement& bind(std::uint32_t value) { return bind(static_cast<std::int64_t>(value)); }
    Statement& bind(bool value) { return bind(static_cast<std::int64_t>(value ? 1 : 0)); }
    Statement& bind(double value) { return bindVariant(QVariant(value)); }
    Statement& bind(const std::string& text) { return bindVariant(QVariant(QString::fromStdString(text))); }
    Statement& bind(const char* text) { return bindVariant(QVariant(QString::fromUtf8(text))); }
    Statement& bind(const QByteArray& blob) { return bindVariant(QVariant(blob)); }
    template <class T>
    Statement& bind(const std::optional<T>& value) {
        return value ? bind(*value) : bindVariant(QVariant());
    }

    Statement& run();
    [[nodiscard]] bool next();
    /// Row id this INSERT has made.
    [[nodiscard]] std::int64_t lastId() const noexcept { return m_lastId; }
    [[nodiscard]] int changed() const { return m_query.numRowsAffected(); }

    [[nodiscard]] bool isNull(int column) const { return m_query.value(column).isNull(); }
    [[nodiscard]] std::int64_t integer(int column) const { return m_query.value(column).toLongLong(); }
    [[nodiscard]] std::uint32_t count(int column) const { return static_cast<std::uint32_t>(integer(column)); }
    [[nodiscard]] double real(int column) const { return m_query.value(column).toDouble(); }
    [[nodiscard]] std::string text(int column) const { return m_query.value(column).toString().toStdString(); }
    [[nodiscard]] QByteArray blob(int column) const { return m_query.value(column).toByteArray(); }
    [[nodiscard]] std::optional<std::int64_t> maybeInteger(int column) const {
        return isNull(column) ? std::nullopt : std::optional(integer(column));
    }
    [[nodiscard]] std::optional<double> maybeReal(int column) const {
        return isNull(column) ? std::nullopt : std::optional(real(column));
    }

 private:
    Statement& bindVariant(const QVariant& value);
    [[noreturn]] void fail();
    void prepare(const QString& sql);
    QString m_connection{};  ///< empty: not kept
    QString m_sql{};
    QSqlQuery m_query;
    int m_next{0};
    std::int64_t m_lastId{0};
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
