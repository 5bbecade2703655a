// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

class QSqlQuery;

namespace kerf::db {

/// Who this data file is towards the shop, and since when.
struct ShopIdentity {
    std::string store{};  ///< uuid, drawn when the file got its outbox
    std::string epoch{};  ///< uuid of this history; another one after a restored backup or in a cloned folder
    std::string reason{};
    std::int64_t began_utc_ms{0};
};

/// The two numberings of the outbox: everything, and feed traces with lower priority.
enum class ShopStream : std::uint8_t { Rows, Traces };
[[nodiscard]] const char* streamKey(ShopStream stream) noexcept;

/// A table the shop follows.
struct FollowedTable {
    const char* name;
    const char* key;        ///< the column that names a row
    const char* condition;  ///< which rows travel; "": all. Sealed PINs never do.
};
[[nodiscard]] const std::vector<FollowedTable>& followedTables();

/// One entry of a batch as the server wants it.
struct OutboxRow {
    std::int64_t seq{0};
    std::string table{};
    std::string key{};
    std::string json{};  ///< the row's columns without braces; empty: the row is gone
};

struct OutboxBatch {
    std::int64_t firstSeq{0};
    std::vector<std::int64_t> marks{};  ///< one per number from firstSeq
    std::vector<OutboxRow> rows{};      ///< a row that stands there twice comes once, with its last number
};

/// Reads the outbox and the rows behind it on one read connection. A batch is one state of the file. Throws SqlFailure.
class OutboxReader {
 public:
    explicit OutboxReader(const QSqlDatabase& database);
    ~OutboxReader();
    OutboxReader(const OutboxReader&) = delete;
    OutboxReader& operator=(const OutboxReader&) = delete;

    [[nodiscard]] ShopIdentity identity() const;
    [[nodiscard]] std::int64_t newestSeq(ShopStream stream) const;
    [[nodiscard]] std::optional<std::int64_t> markAt(ShopStream stream, std::int64_t seq) const;
    /// Is there an audit entry with this hash among the rows up to `seq`?
    [[nodiscard]] bool hasAuditHead(const std::string& hash, std::int64_t seq) const;
    /// Columns of a followed table as they are in this file.
    [[nodiscard]] std::vector<std::string> columns(const std::string& table) const;
    /// From `firstSeq` on, at most `maxEntries` and about `maxBytes`, but at least one. Empty: there is nothing.
    [[nodiscard]] OutboxBatch batch(ShopStream stream, std::int64_t firstSeq, std::size_t maxEntries,
                                    std::size_t maxBytes);

 private:
    struct RowSource;
    std::string rowJson(const std::string& table, const class QVariant& key);

    QSqlDatabase m_database;
    std::map<std::string, RowSource> m_sources;
};

/// A JSON string literal, quotes included.
[[nodiscard]] std::string jsonText(const std::string& text);
/// 17 digits, so that the same double comes out again; infinity as a text.
[[nodiscard]] std::string jsonNumber(double value);

/// Notes in the data file that from now on its history is another one: a short write of its own. @throws SqlFailure
void beginShopEpoch(const std::string& dataFile, const std::string& reason);

}  // namespace kerf::db
