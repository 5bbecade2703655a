// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrator.h"

#include <fcntl.h>
#include <unistd.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QTemporaryDir>
#include <algorithm>
#include <optional>
#include <sstream>

#include "db/connection.h"
#include "db/head_file.h"
#include "db/statement.h"
#include "db/stores/audit_log.h"

namespace kerf::db {
namespace {

constexpr std::string_view kMark = "-- statement:";
// SQLite's primary result codes.
constexpr int kError = 1;
constexpr int kCorrupt = 11;
constexpr int kConstraint = 19;
constexpr int kNotADatabase = 26;

/// Short enough for a sentence's argument.
SentenceArg fileName(const std::string& path) {
    return SentenceArg(QFileInfo(QString::fromStdString(path)).fileName().toStdString());
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? std::string()
                                      : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool syncToDisk(const QString& path) {
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        return false;
    }
    const bool done = ::fsync(descriptor) == 0;
    ::close(descriptor);
    return done;
}

/// One step, its log row and the version number, all or nothing.
void applyStep(const QSqlDatabase& database, const Migration& step) {
    Transaction transaction(database);
    for (const MigrationStatement& statement : step.statements) {
        execute(database, QString::fromStdString(statement.sql));
    }
    Statement(database, "INSERT INTO schema_steps (version, applied_utc_ms, program) VALUES (?, ?, ?)")
        .bind(step.version)
        .bind(utcNow_ms())
        .bind(KERF_VERSION)
        .run();
    // Pragmas take no bound values; these are integers of our own.
    execute(database, QStringLiteral("PRAGMA user_version = %1").arg(step.version));
    execute(database, QStringLiteral("PRAGMA application_id = %1").arg(kApplicationId));
    Statement keys(database, "PRAGMA foreign_key_check");
    if (keys.run().next()) {
        throw SqlFailure(sentenceForCode(kConstraint), kConstraint, "a reference is broken after the step");
    }
    transaction.commit();
}

std::string backupPathFor(const std::string& path, int version) {
    const QFileInfo file(QString::fromStdString(path));
    const QString folder = file.absoluteDir().filePath(QStringLiteral("backups"));
    QDir().mkpath(folder);
    const QString stamp = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmsszzz'Z'"));
    return QStringLiteral("%1/%2-v%3-%4.db").arg(folder, file.completeBaseName()).arg(version).arg(stamp).toStdString();
}

/// SQLite's own findings; empty: none.
std::string sqliteFinding(const QSqlDatabase& database) {
    Statement check(database, "PRAGMA integrity_check(1)");
    const std::string finding = check.run().next() ? check.text(0) : "no answer";
    Statement keys(database, "PRAGMA foreign_key_check");
    return finding != "ok" ? finding : keys.run().next() ? "a reference is broken" : "";
}

void checkThrough(const QSqlDatabase& database) {
    if (const std::string finding = sqliteFinding(database); !finding.empty()) {
        throw SqlFailure(sentenceForCode(kCorrupt), kCorrupt, "integrity check: " + finding);
    }
}

/// The log's chain and what it says of the rows; both may be whole for SQLite and yet not what was stored.
Result<void> checkLog(const QSqlDatabase& database, const std::optional<Head>& expected) {
    const AuditVerdict verdict = verifyAudit(database);
    if (!verdict.finding.empty()) {
        return tl::unexpected<Sentence>(verdict.finding);
    }
    const Sentence missing = expected ? missingSince(*expected, database) : Sentence();
    return missing.empty() ? Result<void>() : Result<void>(tl::unexpected<Sentence>(missing));
}

/// The same check on a connection that may write, where SQLite also takes over a log file that was left behind; on a
/// copy, because the file itself is only read. A copy taken while somebody writes may be torn: then it says nothing.
std::string findingOfWritableCopy(const std::string& path) {
    QLockFile lock(QString::fromStdString(path) + QStringLiteral(".lock"));
    lock.setStaleLockTime(0);
    const bool ownLock = QFileInfo(QFileInfo(QString::fromStdString(path)).absolutePath()).isWritable();
    if (ownLock && !lock.tryLock(0)) {
        return {};
    }
    const QTemporaryDir folder;
    const QString copy = folder.filePath(QStringLiteral("copy.db"));
    if (!folder.isValid() || !QFile::copy(QString::fromStdString(path), copy)) {
        return {};
    }
    QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    const QString log = QString::fromStdString(path) + QStringLiteral("-wal");
    if (QFile::exists(log) && !QFile::copy(log, copy + QStringLiteral("-wal"))) {
        return {};
    }
    lock.unlock();
    const Connection connection(copy.toStdString(), Access::Write);
    return sqliteFinding(connection.database());
}

}  // namespace

Migration parseMigration(int version, const std::string& name, const std::string& text) {
    Migration migration{version, name, {}};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(kMark)) {
            migration.statements.push_back({trimmed(line.substr(kMark.size())), {}});
        } else if (!migration.statements.empty()) {
            migration.statements.back().sql += line + '\n';
        }
    }
    for (MigrationStatement& statement : migration.statements) {
        statement.sql = trimmed(statement.sql);
    }
    return migration;
}

Result<int> fileVersion(const std::string& path, int newestKnown) {
    const SentenceArg name = fileName(path);
    QFile file(QString::fromStdString(path));
    if (!file.exists() || file.size() == 0) {
        return 0;
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(KERF_TEXT("The data file %1 cannot be read: check its permissions."), name);
    }
    // Looked at by hand first, so that a file that is not ours is never opened by the database engine.
    const QByteArray header = file.read(100);
    file.close();
    if (header.size() < 100 || !header.startsWith(QByteArrayLiteral("SQLite format 3\0"))) {
        return fail(KERF_TEXT("The file %1 is not a database; it was left as it is."), name);
    }
    try {
        const Connection connection(path, Access::Read);
        const QSqlDatabase& database = connection.database();
        const auto applicationId = integerOf(database, QStringLiteral("PRAGMA application_id"));
        const auto version = integerOf(database, QStringLiteral("PRAGMA user_version"));
        const auto tables = integerOf(database, QStringLiteral("SELECT count(*) FROM sqlite_master"));
        if (tables == 0 && applicationId == 0 && version == 0) {
            return 0;  // made, but its first step never finished
        }
        if (applicationId != kApplicationId) {
            return fail(KERF_TEXT("The file %1 is a database of another program; it was left as it is."), name);
        }
        if (version > newestKnown) {
            return fail(KERF_TEXT("The data file %1 has version %2, written by a newer Kerf; this one knows up to %3. "
                                  "Install the newer program; the file was left as it is."),
                        name, SentenceArg(static_cast<double>(version), 0), SentenceArg(newestKnown, 0));
        }
        return static_cast<int>(version);
    } catch (const SqlFailure& failure) {
        qCWarning(kerfDb, "%s", failure.what());
        if (failure.code() == kCorrupt || failure.code() == kNotADatabase) {
            return fail(KERF_TEXT("The data file %1 is damaged; it was left as it is. Go on with the newest backup."),
                        name);
        }
        return tl::unexpected<Sentence>(failure.sentence());
    }
}

Result<MigrationReport> migrateFile(const std::string& path, const std::vector<Migration>& migrations) {
    const int newest = migrations.empty() ? 0 : migrations.back().version;
    const Result<int> before = fileVersion(path, newest);
    if (!before) {
        return tl::unexpected<Sentence>(before.error());
    }
    MigrationReport report{*before, *before, {}};
    if (*before == newest) {
        return report;
    }
    QDir().mkpath(QFileInfo(QString::fromStdString(path)).absolutePath());
    if (*before > 0) {
        report.backupPath = backupPathFor(path, *before);
        if (const Result<void> copied = backupDatabase(path, report.backupPath); !copied) {
            return tl::unexpected<Sentence>(copied.error());
        }
    }
    int reached = *before;
    std::string doing;
    try {
        const Connection connection(path, Access::Write);
        // A step may rebuild a table that others refer to; the references are checked before it is committed.
        execute(connection.database(), QStringLiteral("PRAGMA foreign_keys = OFF"));
        for (const Migration& step : migrations) {
            if (step.version > reached) {
                doing = step.name;
                applyStep(connection.database(), step);
                reached = step.version;
            }
        }
        checkThrough(connection.database());
    } catch (const SqlFailure& failure) {
        qCWarning(kerfDb, "step %s: %s", doing.c_str(), failure.what());
        if (failure.code() != kError &&
            failure.code() != kConstraint) {  // not a fault of the step itself: disk, lock, permission
            return tl::unexpected<Sentence>(failure.sentence());
        }
        return fail(KERF_TEXT("Bringing the data file %1 up to date failed at step %2; it is as it was after step %3, "
                              "and the copy made before is kept."),
                    fileName(path), SentenceArg(reached + 1, 0), SentenceArg(reached, 0));
    }
    report.toVersion = reached;
    return report;
}

Result<MigrationReport> prepareDatabase(const std::string& path) {
    return migrateFile(path, builtInMigrations());
}

Result<void> backupDatabase(const std::string& path, const std::string& copyPath) {
    const QString copy = QString::fromStdString(copyPath);
    const QString partial = copy + QStringLiteral(".partial");
    if (QFile::exists(copy)) {
        return fail(KERF_TEXT("The file %1 exists already; a backup never overwrites."), fileName(copyPath));
    }
    QFile::remove(partial);
    if (QFile place(partial); !place.open(QIODevice::WriteOnly)) {
        return fail(KERF_TEXT("The backup %1 cannot be written: its folder is missing or read-only."),
                    fileName(copyPath));
    }
    QFile::remove(partial);  // SQLite makes it anew
    const auto expected = HeadFile(path).read();
    Result<void> done = guarded([&] {
        {
            const Connection connection(path, Access::Read);
            // query_only counts VACUUM INTO as a write, though it only reads this file.
            execute(connection.database(), QStringLiteral("PRAGMA query_only = OFF"));
            Statement(connection.database(), "VACUUM INTO ?").bind(partial.toStdString()).run();
        }
        const Connection made(partial.toStdString(), Access::Read);
        checkThrough(made.database());
        if (integerOf(made.database(), QStringLiteral("PRAGMA user_version")) ==
            static_cast<std::int64_t>(builtInMigrations().size())) {  // an earlier form is checked once it is adopted
            if (const auto whole = checkLog(made.database(), expected); !whole) {
                throw SqlFailure(whole.error(), 0, whole.error().english());
            }
        }
    });
    if (done && !(syncToDisk(partial) && QFile::rename(partial, copy) && syncToDisk(QFileInfo(copy).absolutePath()))) {
        done = fail(KERF_TEXT("The backup %1 could not be written completely."), fileName(copyPath));
    }
    if (!done) {
        QFile::remove(partial);
    }
    return done;
}

Result<void> checkDatabase(const std::string& path) {
    const auto expected = HeadFile(path).read();
    Result<void> whole = guarded([&] {
        const Connection connection(path, Access::Read);
        checkThrough(connection.database());
        if (const std::string finding = findingOfWritableCopy(path); !finding.empty()) {
            throw SqlFailure(sentenceForCode(kCorrupt), kCorrupt, "integrity check of a copy: " + finding);
        }
    });
    if (!whole) {
        return whole;
    }
    return guarded([&] {
        const Connection connection(path, Access::Read);
        const Snapshot snapshot(connection.database());
        if (const auto log = checkLog(connection.database(), expected); !log) {
            throw SqlFailure(log.error(), 0, log.error().english());
        }
    });
}

}  // namespace kerf::db
