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

std::string measurementText(const MeasurementRow& row) {
    return fmt::format("part={};station={};position_mm={:.17g};diameter_mm={};replaces={};source={};confirmed={};at={}",
                       row.part, row.station, row.position_mm,
                       row.diameter_mm ? fmt::format("{:.17g}", *row.diameter_mm) : std::string("void"),
                       row.replaces ? std::to_string(*row.replaces) : std::string("-"), sourceKey(row.source),
                       row.confirmed ? 1 : 0, row.acceptedUtc_ms);
}

AuditVerdict verifyAudit(const QSqlDatabase& database) {
    AuditVerdict verdict;
    verdict.headHash = kGenesis;
    const auto broken = [&verdict](std::int64_t id, const Sentence& finding) {
        verdict.firstBad = id;
        verdict.finding = finding;
        return verdict;
    };
    Statement entries(database,
                      QStringLiteral("SELECT %1 FROM audit u ORDER BY u.id").arg(QLatin1String(kAuditColumns)));
    entries.run();
    while (entries.next()) {
        const AuditRow row = readAudit(entries);
        const auto number = SentenceArg(static_cast<double>(row.id), 0);
        ++verdict.entries;
        if (row.id != static_cast<std::int64_t>(verdict.entries) || row.previousHash != verdict.headHash) {
            return broken(row.id,
                          Sentence(KERF_TEXT("The audit log is broken before entry %1: entries are missing."), number));
        }
        if (row.hash != auditHash(row)) {
            return broken(row.id, Sentence(KERF_TEXT("Audit entry %1 was changed after it was written."), number));
        }
        verdict.headHash = row.hash;
    }
    Statement pairs(database,
                    QStringLiteral("SELECT %1, u.author, u.new_value FROM measurements m LEFT JOIN audit u ON "
                                   "u.object = 'measurement' AND u.object_id = m.id ORDER BY m.id")
                        .arg(QLatin1String(kMeasurementColumns)));
    pairs.run();
    while (pairs.next()) {
        const MeasurementRow row = readMeasurement(pairs);
        ++verdict.measurements;
        if (pairs.isNull(13) || pairs.text(13) != measurementText(row) || pairs.text(12) != row.author) {
            return broken(row.id,
                          Sentence(KERF_TEXT("Measurement %1 differs from what was logged when it was accepted."),
                                   SentenceArg(static_cast<double>(row.id), 0)));
        }
    }
    const auto logged = integerOf(database, QStringLiteral("SELECT count(*) FROM audit WHERE object = 'measurement'"));
    if (logged != static_cast<std::int64_t>(verdict.measurements)) {
        return broken(0, Sentence(KERF_TEXT("%1 measurements were accepted, %2 are stored."),
                                  SentenceArg(static_cast<double>(logged), 0),
                                  SentenceArg(static_cast<double>(verdict.measurements), 0)));
    }
    return verdict;
}

}  // namespace kerf::db
