// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/stores/audit_log.h"

#include <fmt/format.h>

#include <QCryptographicHash>
#include <initializer_list>

#include "db/row_io.h"
#include "db/statement.h"

namespace kerf::db {
namespace {
/// The first entry follows this.
const std::string kGenesis(64, '0');
}  // namespace

std::string auditHash(const AuditRow& row) {
    std::string text;
    for (const std::string& field :
         {row.previousHash, std::to_string(row.id), std::to_string(row.utc_ms), row.author, row.action, row.object,
          std::to_string(row.objectId), row.oldValue, row.newValue, row.reason}) {
        text += std::to_string(field.size()) + ':' + field;
    }
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex().toStdString();
}

void appendAudit(const QSqlDatabase& database, AuditRow row) {
    if (row.author.empty()) {
        throw SqlFailure(Sentence(KERF_TEXT("Sign on first: the audit log needs a name.")), 0,
                         "audit without an author");
    }
    Statement last(database, "SELECT id, hash FROM audit ORDER BY id DESC LIMIT 1");
    const bool first = !last.run().next();
    row.id = first ? 1 : last.integer(0) + 1;
    row.previousHash = first ? kGenesis : last.text(1);
    row.utc_ms = utcNow_ms();
    row.hash = auditHash(row);
    Statement(database,
              "INSERT INTO audit (id, utc_ms, author, action, object, object_id, old_value, new_value, reason, "
              "previous_hash, hash) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(row.id)
        .bind(row.utc_ms)
        .bind(row.author)
        .bind(row.action)
        .bind(row.object)
        .bind(row.objectId)
        .bind(row.oldValue)
        .bind(row.newValue)
        .bind(row.reason)
        .bind(row.previousHash)
        .bind(row.hash)
        .run();
}

std::string measurementText(const MeasurementRow& row, bool withSource) {
    return fmt::format("part={};station={};position_mm={:.17g};diameter_mm={};replaces={};source={};confirmed={};at={}",
                       row.part, row.station, row.position_mm,
                       row.diameter_mm ? fmt::format("{:.17g}", *row.diameter_mm) : std::string("void"),
                       row.replaces ? std::to_string(*row.replaces) : std::string("-"), sourceKey(row.source),
                       row.confirmed ? 1 : 0, row.acceptedUtc_ms) +
           (withSource ? ";from=" + row.sourceName : std::string());
}

}  // namespace kerf::db
