// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "engine/core/sentence.h"

namespace kerf::db {

/// How far a data file had been written: its newest audit entry, and the highest row number each append-only table has
/// given out.
struct Head {
    std::int64_t auditId{0};
    std::string auditHash{};
    std::map<std::string, std::int64_t> rows{};
    friend bool operator==(const Head&, const Head&) = default;
};

/// The head as it stands in a connection's snapshot. @throws SqlFailure
[[nodiscard]] Head headOf(const QSqlDatabase& database);

/// The head of the last commit, kept beside the data file (`kerf.db.head`): SQLite takes a write-ahead log that was cut
/// or deleted for one that never was longer, so that the newest entries go without a trace. Written after each commit,
/// so it never runs ahead of the file; two places in turn, each with its checksum, so that a torn one leaves the other.
class HeadFile {
 public:
    explicit HeadFile(const std::string& databasePath) : m_path(databasePath + ".head") {}
    HeadFile(const HeadFile&) = delete;
    HeadFile& operator=(const HeadFile&) = delete;
    ~HeadFile();

    /// Empty: there is none (a data file of an earlier version, or a copy).
    [[nodiscard]] std::optional<Head> read() const;
    /// A head that cannot be written stays behind the file, which is no finding.
    void write(const Head& head) noexcept;

 private:
    std::string m_path;
    int m_file{-1};
    std::uint64_t m_turn{0};
    Head m_last{};
};

/// What is missing of a file that had been written as far as `expected`; empty: nothing. Read `expected` first.
/// @throws SqlFailure
[[nodiscard]] Sentence missingSince(const Head& expected, const QSqlDatabase& database);

}  // namespace kerf::db
