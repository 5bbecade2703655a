// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/stores/audit_log.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <QCryptographicHash>
#include <initializer_list>
#include <iterator>
#include <string_view>

#include "db/row_io.h"
#include "db/statement.h"

namespace kerf::db {
namespace {
std::string hashOf(std::initializer_list<std::string_view> fields) {
    std::string text;
    text.reserve(1024);
    for (const std::string_view field : fields) {
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("{}:{}"), field.size(), field);
    }
    const QByteArrayView bytes(text.data(), static_cast<qsizetype>(text.size()));
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().toStdString();
}
}  // namespace

std::string auditHash(const AuditRow& row) {
    return hashOf({row.previousHash, std::to_string(row.id), std::to_string(row.utc_ms), row.author, row.action,
                   row.object, std::to_string(row.objectId), row.oldValue, row.newValue, row.reason});
}

std::string lotTextOfBefore(const LotRow& lot) {
    return fmt::format("{}, {} parts, {}", lot.name, lot.size, lot.estimator);
}

std::string lotText(const LotRow& lot) {
    return lotTextOfBefore(lot) + fmt::format("; machine={};part_type={};recipe={};tool={};gauge={};at={}", lot.machine,
                                              lot.partType, lot.recipe, lot.tool, lot.gauge, lot.openedUtc_ms);
}

std::string lotEndText(std::int64_t closedUtc_ms) {
    return fmt::format("at={}", closedUtc_ms);
}

std::string partSeal(const std::string& before, const SealedPart& part) {
    return hashOf({before, part.process, part.lot, part.number, part.complete, part.begin_ns, part.end_ns,
                   part.ended_ms, part.schedule, part.recipe, part.figures});
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
