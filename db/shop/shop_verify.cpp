// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/shop_verify.h"

#include <fmt/format.h>

#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>
#include <bit>
#include <charconv>
#include <vector>

#include "db/connection.h"
#include "db/shop/outbox.h"
#include "db/statement.h"

namespace kerf::db {
namespace {

constexpr int kPage = 2000;

using Cell = std::optional<std::string>;

bool sameDouble(double here, const std::string& there) {
    double value = 0.0;
    const auto read = std::from_chars(there.data(), there.data() + there.size(), value);
    if (read.ec != std::errc{}) {
        return (there == "Infinity" && here > 0 && here - here != 0) ||
               (there == "-Infinity" && here < 0 && here - here != 0);
    }
    return std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(here);
}

bool same(const QVariant& here, const Cell& there) {
    if (here.isNull() || !there) {
        return here.isNull() && !there;
    }
    switch (here.typeId()) {
        case QMetaType::Double:
            return sameDouble(here.toDouble(), *there);
        case QMetaType::QByteArray:
            return "\\x" + here.toByteArray().toHex().toStdString() == *there;
        default:
            return here.toString().toStdString() == *there;
    }
}

/// The server's rows of one table in the order of their key, a page at a time.
class ServerRows {
 public:
    ServerRows(PgConnection& server, const ShopIdentity& who, const FollowedTable& table,
               const std::vector<std::string>& columns)
        : m_server(server), m_who(who) {
        std::string list = fmt::format("{}", table.key);
        for (const std::string& column : columns) {
            list += fmt::format(", \"{}\"", column);
        }
        const bool text = std::string_view(table.key) == "key";
        const std::string key = text ? std::string(R"("key" COLLATE "C")") : std::string(table.key);
        m_sql = fmt::format(
            "SELECT {} FROM shop.{} WHERE store = $1 AND epoch = $2 AND ($3::{} IS NULL OR {} > $3) ORDER BY {} "
            "LIMIT {}",
            list, table.name, text ? "text" : "bigint", key, key, kPage);
    }
    /// Null when there are no more.
    const PgRow* next() {
        if (m_at == m_page.size() && !m_end) {
            m_page = m_server.query(m_sql, {m_who.store, m_who.epoch, m_last});
            m_at = 0;
            m_end = m_page.size() < kPage;
            if (!m_page.empty()) {
                m_last = m_page.back().front();
            }
        }
        return m_at < m_page.size() ? &m_page[m_at++] : nullptr;
    }

 private:
    PgConnection& m_server;
    const ShopIdentity& m_who;
    std::string m_sql;
    std::vector<PgRow> m_page;
    std::size_t m_at{0};
    Cell m_last{};
    bool m_end{false};
};

std::string absent(PgConnection& server, const ShopIdentity& who, const FollowedTable& table, const std::string& key) {
    if (const auto reason =
            server.value("SELECT reason FROM shop.quarantine WHERE store = $1 AND epoch = $2 AND table_name = $3 "
                         "AND row_key = $4 ORDER BY seq DESC LIMIT 1",
                         {who.store, who.epoch, std::string(table.name), key})) {
        return "put aside by the shop: " + *reason;
    }
    return "not in the shop";
}

/// Compares one table; the first difference, if any.
std::optional<ShopDifference> compareTable(const QSqlDatabase& database, PgConnection& server, const ShopIdentity& who,
                                           const FollowedTable& table, const std::vector<std::string>& columns,
                                           std::int64_t& equal) {
    QSqlQuery here(database);
    here.setForwardOnly(true);
    QString list;
    for (const std::string& column : columns) {
        list += QStringLiteral(", \"%1\"").arg(QString::fromStdString(column));
    }
    const QString where =
        table.condition[0] == '\0' ? QString() : QStringLiteral(" WHERE ") + QLatin1String(table.condition);
    if (!here.exec(QStringLiteral("SELECT %1%2 FROM %3%4 ORDER BY %1")
                       .arg(QLatin1String(table.key), list, QLatin1String(table.name), where))) {
        throw SqlFailure(sentenceForCode(1), 1, here.lastError().text().toStdString());
    }
    ServerRows rows(server, who, table, columns);
    while (here.next()) {
        const PgRow* there = rows.next();
        const std::string key = here.value(0).toString().toStdString();
        if (there == nullptr || there->front().value_or("") != key) {
            // The server's row may be one that this file does not have.
            const bool more =
                there != nullptr && (here.value(0).typeId() == QMetaType::LongLong
                                         ? std::stoll(there->front().value_or("0")) < here.value(0).toLongLong()
                                         : there->front().value_or("") < key);
            return more ? ShopDifference{table.name, there->front().value_or(""), "not in this file"}
                        : ShopDifference{table.name, key, absent(server, who, table, key)};
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const QVariant value = here.value(static_cast<int>(i) + 1);
            if (!same(value, (*there)[i + 1])) {
                return ShopDifference{table.name, key,
                                      fmt::format("{} is {} here and {} there", columns[i],
                                                  value.isNull() ? "nothing" : value.toString().toStdString(),
                                                  (*there)[i + 1].value_or("nothing"))};
            }
        }
        ++equal;
    }
    if (const PgRow* there = rows.next()) {
        return ShopDifference{table.name, there->front().value_or(""), "not in this file"};
    }
    return std::nullopt;
}

}  // namespace

ShopComparison compareWithShop(const std::string& dataFile, PgConnection& server) {
    const Connection connection(dataFile, Access::Read);
    const Snapshot snapshot(connection.database());
    const OutboxReader outbox(connection.database());
    const ShopIdentity who = outbox.identity();
    ShopComparison comparison{who.store, who.epoch, 0, std::nullopt};
    for (const FollowedTable& table : followedTables()) {
        const auto columns = outbox.columns(table.name);
        comparison.difference = compareTable(connection.database(), server, who, table, columns, comparison.rows);
        if (comparison.difference) {
            break;
        }
    }
    return comparison;
}

}  // namespace kerf::db
