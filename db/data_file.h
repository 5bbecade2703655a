// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "db/migrator.h"
#include "engine/core/result.h"

class QLockFile;

namespace kerf::db {

/// A data file taken by this program, until the object ends: locked, then brought up to date, then what had waited
/// beside it is stored. Nobody else writes in between. Wherever it stops, the file is as it was.
class DataFile {
 public:
    struct Finding {
        MigrationReport migration{};
        Sentence missing{};         ///< newest entries are gone since the last run (head_file.h); empty: none
        std::size_t partsFound{0};  ///< stored now, left waiting by the last run
        std::string setAside{};     ///< a backup was put in place: where the file is that was there; empty: none was
        std::size_t notRead{0};     ///< items of the outbox that this version does not know: kept in a file beside it
    };
    /// @param path kerf.db, in an existing folder
    [[nodiscard]] static Result<std::unique_ptr<DataFile>> open(const std::string& path);
    DataFile(const DataFile&) = delete;
    DataFile& operator=(const DataFile&) = delete;
    ~DataFile();

    [[nodiscard]] const std::string& path() const noexcept { return m_path; }
    [[nodiscard]] const Finding& finding() const noexcept { return m_finding; }

 private:
    DataFile(std::string path, std::unique_ptr<QLockFile> lock);

    std::string m_path;
    std::unique_ptr<QLockFile> m_lock;
    Finding m_finding{};
};

/// The lock of a data file alone. Stale only when its process is gone.
[[nodiscard]] Result<std::unique_ptr<QLockFile>> lockDataFile(const std::string& path);

/// Says whether a data file that is open, and its log file (-wal), still stand under their names: one that was deleted
/// or replaced goes on taking writes that nobody will ever find.
class FilePresence {
 public:
    /// @pre a connection to the file has read: SQLite has made the log file
    explicit FilePresence(const std::string& path);
    /// Why nothing may be stored any more; empty: both files are those that were there first.
    [[nodiscard]] Sentence missing() const;

 private:
    struct Place {
        std::string path{};
        std::uint64_t device{0};
        std::uint64_t inode{0};  ///< 0: it was not there
        [[nodiscard]] bool there() const noexcept;
    };
    [[nodiscard]] static Place placeOf(const std::string& path);

    Place m_file;
    Place m_log;
};

/// What FilePresence says: it goes away when a person puts the file back.
[[nodiscard]] bool saysMissing(const Sentence& sentence);

}  // namespace kerf::db
