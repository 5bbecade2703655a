// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/outbox.h"

#include <fmt/format.h>

#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QUuid>
#include <QVariant>
#include <cmath>
#include <nlohmann/json.hpp>

#include "db/connection.h"
#include "db/statement.h"
#include "db/stores/audit_log.h"

namespace kerf::db {
namespace {

std::string jsonValue(const QVariant& value) {
    if (value.isNull()) {
        return "null";
    }
    switch (value.typeId()) {
        case QMetaType::LongLong:
        case QMetaType::Int:
            return std::to_string(value.toLongLong());
        case QMetaType::Double:
            return jsonNumber(value.toDouble());
        case QMetaType::QByteArray:
            return "\"\\\\x" + value.toByteArray().toHex().toStdString() + "\"";
        default:
            return jsonText(value.toString().toStdString());
    }
}

const char* outboxOf(ShopStream stream) {
    return stream == ShopStream::Rows ? "outbox" : "outbox_traces";
}

}  // namespace

const char* streamKey(ShopStream stream) noexcept {
    return stream == ShopStream::Rows ? "rows" : "traces";
}

const std::vector<FollowedTable>& followedTables() {
    static const std::vector<FollowedTable> kTables{
        {"machines", "id", ""},
        {"part_types", "id", ""},
        {"recipe_revisions", "id", ""},
        {"lots", "id", ""},
        {"schedules", "id", ""},
        {"parts", "id", ""},
        {"part_results", "part_id", ""},
        {"feed_traces", "part_id", ""},
        {"measurements", "id", ""},
        {"measurement_sources", "measurement_id", ""},
        {"estimator_states", "id", ""},
        {"alarms", "id", ""},
        {"settings", "key", "key <> 'operators'"},
        {"audit", "id", "object <> 'setting operators'"},
        {"room_records", "id", ""},
    };
    return kTables;
}

/// The look-up of one table's rows, prepared once.
struct OutboxReader::RowSource {
    std::unique_ptr<QSqlQuery> query;
    std::vector<std::string> names;  ///< each as a JSON key with its colon
};

OutboxReader::OutboxReader(const QSqlDatabase& database) : m_database(database) {}
OutboxReader::~OutboxReader() = default;

ShopIdentity OutboxReader::identity() const {
    Statement newest(m_database, "SELECT store, epoch, reason, began_utc_ms FROM shop_epochs ORDER BY id DESC LIMIT 1");
    if (!newest.run().next()) {
        throw SqlFailure(sentenceForCode(11), 11, "shop_epochs is empty");
    }
    return {newest.text(0), newest.text(1), newest.text(2), newest.integer(3)};
}

std::int64_t OutboxReader::newestSeq(ShopStream stream) const {
    return integerOf(m_database,
                     QStringLiteral("SELECT coalesce(max(seq), 0) FROM %1").arg(QLatin1String(outboxOf(stream))));
}

std::optional<std::int64_t> OutboxReader::markAt(ShopStream stream, std::int64_t seq) const {
    Statement find(m_database,
                   QStringLiteral("SELECT mark FROM %1 WHERE seq = ?").arg(QLatin1String(outboxOf(stream))));
    return find.bind(seq).run().next() ? std::optional(find.integer(0)) : std::nullopt;
}

bool OutboxReader::hasAuditHead(const std::string& hash, std::int64_t seq) const {
    // From the newest entry backwards: the head is nearly always among the first looked at.
    Statement find(
        m_database,
        "SELECT 1 FROM audit a WHERE a.hash = ? AND EXISTS (SELECT 1 FROM outbox o WHERE o.table_name = 'audit' "
        "AND o.row_key = a.id AND o.seq <= ?) ORDER BY a.id DESC LIMIT 1");
    return find.bind(hash).bind(seq).run().next();
}

std::vector<std::string> OutboxReader::columns(const std::string& table) const {
    std::vector<std::string> names;
    Statement info(m_database, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
    info.bind(table).run();
    while (info.next()) {
        names.push_back(info.text(0));
    }
    return names;
}

std::string OutboxReader::rowJson(const std::string& table, const QVariant& key) {
    auto found = m_sources.find(table);
    if (found == m_sources.end()) {
        const char* keyColumn = nullptr;
        for (const FollowedTable& followed : followedTables()) {
            if (table == followed.name) {
                keyColumn = followed.key;
            }
        }
        if (keyColumn == nullptr) {
            throw SqlFailure(sentenceForCode(11), 11, "the outbox names an unknown table: " + table);
        }
        RowSource source;
        source.query = std::make_unique<QSqlQuery>(m_database);
        source.query->setForwardOnly(true);
        if (!source.query->prepare(QStringLiteral("SELECT * FROM %1 WHERE %2 = ?")
                                       .arg(QString::fromStdString(table), QLatin1String(keyColumn)))) {
            throw SqlFailure(sentenceForCode(1), 1, source.query->lastError().text().toStdString());
        }
        for (const std::string& name : columns(table)) {
            source.names.push_back(jsonText(name) + ":");
        }
        found = m_sources.emplace(table, std::move(source)).first;
    }
    QSqlQuery& query = *found->second.query;
    query.bindValue(0, key);
    if (!query.exec()) {
        throw SqlFailure(sentenceForCode(query.lastError().nativeErrorCode().toInt()), 0,
                         query.lastError().text().toStdString());
    }
    std::string json;
    if (query.next()) {
        for (std::size_t i = 0; i < found->second.names.size(); ++i) {
            json += json.empty() ? "" : ",";
            json += found->second.names[i] + jsonValue(query.value(static_cast<int>(i)));
        }
    }
    query.finish();  // an open look-up would hold the state of the file, and its log could not be emptied
    return json;
}

OutboxBatch OutboxReader::batch(ShopStream stream, std::int64_t firstSeq, std::size_t maxEntries,
                                std::size_t maxBytes) {
    OutboxBatch batch;
    batch.firstSeq = firstSeq;
    const Snapshot snapshot(m_database);
    struct Pointer {
        std::int64_t seq;
        std::string table;
        QVariant key;
        std::int64_t mark;
    };
    std::vector<Pointer> pointers;
    {
        QSqlQuery query(m_database);
        query.setForwardOnly(true);
        const QString sql =
            stream == ShopStream::Rows
                ? QStringLiteral(
                      "SELECT seq, table_name, row_key, mark FROM outbox WHERE seq >= ? ORDER BY seq LIMIT ?")
                : QStringLiteral(
                      "SELECT seq, 'feed_traces', row_key, mark FROM outbox_traces WHERE seq >= ? "
                      "ORDER BY seq LIMIT ?");
        query.prepare(sql);
        query.bindValue(0, static_cast<qlonglong>(firstSeq));
        query.bindValue(1, static_cast<qlonglong>(maxEntries));
        if (!query.exec()) {
            throw SqlFailure(sentenceForCode(query.lastError().nativeErrorCode().toInt()), 0,
                             query.lastError().text().toStdString());
        }
        while (query.next()) {
            pointers.push_back({query.value(0).toLongLong(), query.value(1).toString().toStdString(), query.value(2),
                                query.value(3).toLongLong()});
        }
    }
    std::map<std::pair<std::string, std::string>, std::size_t> places;
    std::size_t bytes = 0;
    for (const Pointer& pointer : pointers) {
        if (pointer.seq != firstSeq + static_cast<std::int64_t>(batch.marks.size())) {
            throw SqlFailure(
                sentenceForCode(11), 11,
                fmt::format("outbox number {} is missing", firstSeq + static_cast<std::int64_t>(batch.marks.size())));
        }
        if (bytes > maxBytes) {
            break;
        }
        batch.marks.push_back(pointer.mark);
        const std::string key = pointer.key.toString().toStdString();
        const auto [place, fresh] = places.try_emplace({pointer.table, key}, batch.rows.size());
        if (!fresh) {
            batch.rows[place->second].seq = pointer.seq;
            continue;
        }
        batch.rows.push_back({pointer.seq, pointer.table, key, rowJson(pointer.table, pointer.key)});
        bytes += batch.rows.back().json.size();
    }
    return batch;
}

std::string jsonText(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string jsonNumber(double value) {
    if (std::isnan(value)) {
        return "null";
    }
    return std::isinf(value) ? (value > 0 ? "\"Infinity\"" : "\"-Infinity\"") : fmt::format("{:.17g}", value);
}

void beginShopEpoch(const std::string& dataFile, const std::string& reason) {
    const Connection connection(dataFile, Access::Write);
    Transaction transaction(connection.database());
    const std::string epoch = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    Statement(
        connection.database(),
        "INSERT INTO shop_epochs (store, epoch, reason, began_utc_ms) SELECT store, ?, ?, ? FROM shop_epochs ORDER "
        "BY id DESC LIMIT 1")
        .bind(epoch)
        .bind(reason)
        .bind(utcNow_ms())
        .run();
    appendAudit(
        connection.database(),
        {.author = "Kerf", .action = "shop epoch begun", .object = "shop", .newValue = epoch, .reason = reason});
    transaction.commit();
}

}  // namespace kerf::db
