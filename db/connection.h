// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <QString>
#include <QTemporaryDir>
#include <memory>
#include <string>

namespace kerf::db {

/// "KERF" in the file header (PRAGMA application_id).
inline constexpr int kApplicationId = 0x4B455246;

enum class Access : std::uint8_t { Read, Write };

/// One SQLite connection with the project's pragmas, for the thread that made it. Closes with the object.
///
/// Write: WAL, synchronous=FULL (a commit is on the disk before it returns), foreign keys, busy timeout 2 s.
/// Read: read-only at SQLite's level, so that no reader can write by mistake. On a medium that cannot be written the
/// file is read as one that nobody changes; a write-ahead log beside it counts, from a copy of both in the temporary
/// folder.
class Connection {
 public:
    /// Opens an existing file (Write also makes a new one). @throws SqlFailure
    Connection(const std::string& path, Access access);
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection();

    [[nodiscard]] const QSqlDatabase& database() const noexcept { return m_database; }

 private:
    QString m_name;
    std::unique_ptr<QTemporaryDir> m_copy{};  ///< of a file on a medium that cannot be written, with its log
    QSqlDatabase m_database;
};

}  // namespace kerf::db
