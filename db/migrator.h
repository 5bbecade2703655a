// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace kerf::db {

/// One statement of a migration with the purpose written above it.
struct MigrationStatement {
    std::string purpose{};
    std::string sql{};
};

/// One numbered file: brings a database from version − 1 to version.
struct Migration {
    int version{0};
    std::string name{};
    std::vector<MigrationStatement> statements{};
};

/// Reads one migration file: each line "-- statement: purpose" begins exactly one SQL statement, up to the next such
/// line. So nothing is ever split at ';'; the driver itself refuses a block that holds two statements.
[[nodiscard]] Migration parseMigration(int version, const std::string& name, const std::string& text);

/// The migrations compiled into the program, ascending and without a gap.
[[nodiscard]] std::vector<Migration> builtInMigrations();

/// What happened to a file when it was opened.
struct MigrationReport {
    int fromVersion{0};
    int toVersion{0};
    std::string backupPath{};  ///< the file as it was before; empty when nothing had to change or the file is new
};

/// Checks a data file and brings it to the newest version of `migrations`. Run it before any other connection.
///
/// A missing or empty file becomes a new database. A file that is no database, no Kerf database, damaged, or newer
/// than this program is refused in one sentence and not touched. Before the first step an existing file is copied whole
/// to `backups/` beside it, the copy checked and synced. Each step, its row in schema_steps and PRAGMA user_version are
/// one transaction: a step that fails leaves the version before it and the backup.
[[nodiscard]] Result<MigrationReport> migrateFile(const std::string& path, const std::vector<Migration>& migrations);

/// migrateFile() with the built-in migrations.
[[nodiscard]] Result<MigrationReport> prepareDatabase(const std::string& path);

/// One consistent copy of a database that may be in use (VACUUM INTO), checked as checkDatabase() does and
/// synced; never overwrites a file.
[[nodiscard]] Result<void> backupDatabase(const std::string& path, const std::string& copyPath);

/// SQLite's own integrity check, on this file and on a writable copy of it, the foreign keys, the audit chain with what
/// it says of measurements and kept records, and that nothing is missing since the last commit. Reads the whole file.
[[nodiscard]] Result<void> checkDatabase(const std::string& path);

/// Refuses what is not a Kerf database of a version this program knows, without touching it. 0: missing or empty.
[[nodiscard]] Result<int> fileVersion(const std::string& path, int newestKnown);

}  // namespace kerf::db
