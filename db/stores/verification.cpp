// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCryptographicHash>
#include <map>
#include <set>

#include "db/row_io.h"
#include "db/statement.h"
#include "db/stores/audit_log.h"

/// The audit log read again: is it whole, and does what is stored still say what was logged?
namespace kerf::db {
namespace {

// Each query that looks up entries by their object says "object <> 'measurement'" too: the index holds only those.

constexpr const char* kHashMark = "; sha256=";

std::string sha256(const std::string& text) {
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex().toStdString();
}

SentenceArg number(std::int64_t value) {
    return SentenceArg(static_cast<double>(value), 0);
}

/// Found broken at an entry or row.
struct Broken {
    std::int64_t at{0};
    Sentence finding{};
};

/// What each redacted entry reads now, by its number, as the redaction's own entry says.
std::map<std::int64_t, std::string> redactions(const QSqlDatabase& database) {
    std::map<std::int64_t, std::string> hashes;
    Statement find(database,
                   "SELECT object_id, new_value FROM audit WHERE object = 'audit' AND object <> 'measurement' AND "
                   "action = ? ORDER BY id");
    find.bind(kRedacted).run();
    while (find.next()) {
        hashes[find.integer(0)] = find.text(1);
    }
    return hashes;
}

void verifyChain(const QSqlDatabase& database, AuditVerdict& verdict) {
    const auto redacted = redactions(database);
    Statement entries(database,
                      QStringLiteral("SELECT %1 FROM audit u ORDER BY u.id").arg(QLatin1String(kAuditColumns)));
    entries.run();
    while (entries.next()) {
        const AuditRow row = readAudit(entries);
        ++verdict.entries;
        if (row.id != static_cast<std::int64_t>(verdict.entries) || row.previousHash != verdict.headHash) {
            throw Broken{row.id, Sentence(KERF_TEXT("The audit log is broken before entry %1: entries are missing."),
                                          number(row.id))};
        }
        const std::string now = auditHash(row);
        const auto allowed = redacted.find(row.id);
        if (row.hash != now && (allowed == redacted.end() || allowed->second != now)) {
            throw Broken{row.id,
                         Sentence(KERF_TEXT("Audit entry %1 was changed after it was written."), number(row.id))};
        }
        verdict.redacted += row.hash != now ? 1 : 0;
        verdict.headHash = row.hash;
    }
}

void verifyMeasurements(const QSqlDatabase& database, AuditVerdict& verdict) {
    // Side by side: entries come in the order of the measurements they are about. An index over them was a page more
    // for each acceptance.
    Statement entries(database,
                      "SELECT object_id, author, new_value FROM audit WHERE object = 'measurement' ORDER BY id");
    entries.run();
    std::int64_t logged = 0;
    const auto nextEntry = [&] {
        const bool there = entries.next();
        logged += there ? 1 : 0;
        return there;
    };
    bool there = nextEntry();
    Statement rows(
        database,
        QStringLiteral("SELECT %1 FROM measurements m ORDER BY m.id").arg(QLatin1String(kMeasurementColumns)));
    rows.run();
    while (rows.next()) {
        const MeasurementRow row = readMeasurement(rows);
        ++verdict.measurements;
        while (there && entries.integer(0) < row.id) {
            there = nextEntry();
        }
        // Without a row of its own a source is keypad or gauge without a name; before version 5 the log said no name at
        // all.
        const bool ownSource = !rows.isNull(12);
        const std::string logText = there ? entries.text(2) : std::string();
        const bool same = there && entries.integer(0) == row.id && entries.text(1) == row.author &&
                          (logText == measurementText(row) || (!ownSource && logText == measurementText(row, false)));
        if (!same) {
            throw Broken{row.id,
                         Sentence(KERF_TEXT("Measurement %1 differs from what was logged when it was accepted."),
                                  number(row.id))};
        }
    }
    while (there) {
        there = nextEntry();
    }
    if (logged != static_cast<std::int64_t>(verdict.measurements)) {
        throw Broken{0, Sentence(KERF_TEXT("%1 measurements were accepted, %2 are stored."), number(logged),
                                 number(static_cast<std::int64_t>(verdict.measurements)))};
    }
}

void verifyRoomRecords(const QSqlDatabase& database, AuditVerdict& verdict) {
    std::int64_t sealedTo = 0;
    Statement seals(
        database,
        "SELECT object_id, new_value FROM audit WHERE object = 'room records' AND object <> 'measurement' AND "
        "action = ? ORDER BY id");
    seals.bind(kRoomRecordsSealed).run();
    while (seals.next()) {
        sealedTo = seals.integer(0);
        if (roomRecordsSeal(database, sealedTo) != seals.text(1)) {
            throw Broken{sealedTo, Sentence(KERF_TEXT("One of the first %1 kept setups, tunings or models was changed "
                                                      "after it was kept."),
                                            number(sealedTo))};
        }
    }
    Statement pairs(database,
                    "SELECT o.id, o.subject, o.body, o.kind, u.new_value FROM room_records o LEFT JOIN audit u ON "
                    "u.object = 'room record' AND u.object <> 'measurement' AND u.object_id = o.id ORDER BY o.id");
    pairs.run();
    while (pairs.next()) {
        ++verdict.roomRecords;
        const bool own = pairs.text(4).find(kHashMark) != std::string::npos;
        const bool right = own ? pairs.text(4) == roomRecordText(pairs.text(1), pairs.text(2))
                               : pairs.integer(0) <= sealedTo || sealedTo == 0;
        if (!right || pairs.isNull(4)) {
            throw Broken{pairs.integer(0), Sentence(KERF_TEXT("Record %1 (%2) differs from what was logged when it was "
                                                              "kept."),
                                                    number(pairs.integer(0)), SentenceArg(pairs.text(3)))};
        }
    }
    const auto logged =
        integerOf(database, QStringLiteral("SELECT count(*) FROM audit WHERE object = 'room record' AND object <> "
                                           "'measurement'"));
    if (logged != static_cast<std::int64_t>(verdict.roomRecords)) {
        throw Broken{0, Sentence(KERF_TEXT("%1 setups, tunings and models were kept, %2 are stored."), number(logged),
                                 number(static_cast<std::int64_t>(verdict.roomRecords)))};
    }
}

/// A part type's recipe as the log has it, and as room records had it before version 6 (migration 006).
struct RecipeLog {
    std::string name{};
    std::vector<std::string> logged{};  ///< the parameters, or their hash
    struct Kept {
        std::string bodyHash{}, author{}, reason{};  // the bodies themselves may be many megabytes
        std::int64_t created_ms{0};
    };
    std::vector<Kept> kept{};
    std::size_t revisions{0};  ///< that are stored

    std::size_t seenLogged{0};
    std::size_t seenKept{0};

    /// The next revision, of which the log or a record must speak.
    [[nodiscard]] bool speaksOf(const RecipeRevision& row) {
        if (row.revision != seenLogged + seenKept + 1) {
            return false;
        }
        if (seenKept + logged.size() < revisions && seenKept < kept.size()) {
            const Kept& record = kept[seenKept];
            if (record.bodyHash == sha256(row.parametersJson) && record.author == row.author &&
                record.reason == row.reason && record.created_ms == row.createdUtc_ms) {
                ++seenKept;
                return true;
            }
        }
        if (seenLogged >= logged.size()) {
            return false;
        }
        const std::string& text = logged[seenLogged++];
        return text == row.parametersJson || text == roomRecordText(name, row.parametersJson);
    }
};

std::map<std::int64_t, RecipeLog> recipeLogs(const QSqlDatabase& database) {
    std::map<std::int64_t, RecipeLog> logs;
    Statement types(database,
                    "SELECT t.id, t.name, count(*) FROM part_types t JOIN recipe_revisions r ON r.part_type_id = t.id "
                    "GROUP BY t.id");
    types.run();
    while (types.next()) {
        logs[types.integer(0)].name = types.text(1);
        logs[types.integer(0)].revisions = static_cast<std::size_t>(types.integer(2));
    }
    Statement entries(
        database,
        "SELECT object_id, new_value FROM audit WHERE object = 'part_type' AND object <> 'measurement' AND action IN "
        "('recipe saved', 'recipe rolled back') ORDER BY id");
    entries.run();
    while (entries.next()) {
        logs[entries.integer(0)].logged.push_back(entries.text(1));
    }
    Statement kept(database,
                   "SELECT t.id, k.body, k.author, k.reason, k.created_utc_ms, k.name FROM kept_recipes k LEFT JOIN "
                   "part_types t ON t.process = k.process AND t.name = k.name ORDER BY k.room_record_id");
    kept.run();
    while (kept.next()) {
        RecipeLog& log = logs[kept.integer(0)];
        log.name = kept.text(5);
        log.kept.push_back({sha256(kept.text(1)), kept.text(2), kept.text(3), kept.integer(4)});
    }
    return logs;
}

void verifyRecipes(const QSqlDatabase& database) {
    std::map<std::int64_t, RecipeLog> logs = recipeLogs(database);
    Statement stored(database, QStringLiteral("SELECT %1 FROM recipe_revisions r ORDER BY r.part_type_id, r.revision")
                                   .arg(QLatin1String(kRecipeColumns)));
    stored.run();
    while (stored.next()) {
        const RecipeRevision row = readRecipe(stored);
        if (!logs[row.partType].speaksOf(row)) {
            throw Broken{row.id, Sentence(KERF_TEXT("Recipe revision %1 differs from what was logged when it "
                                                    "was saved."),
                                          number(row.id))};
        }
    }
    for (const auto& [partType, log] : logs) {
        if (log.seenLogged < log.logged.size() || log.seenKept < log.kept.size()) {
            throw Broken{0, Sentence(KERF_TEXT("%1 revisions of the recipe of %2 were saved, %3 are stored."),
                                     number(static_cast<std::int64_t>(log.logged.size() + log.kept.size())),
                                     SentenceArg(log.name), number(static_cast<std::int64_t>(log.revisions)))};
        }
    }
}

void verifyLots(const QSqlDatabase& database) {
    const auto logged = [](const char* what) {
        return QStringLiteral(
                   "(SELECT %1 FROM audit u WHERE u.object = 'lot' AND u.object <> 'measurement' AND "
                   "u.object_id = l.id AND u.action = ?)")
            .arg(QLatin1String(what));
    };
    Statement lots(database, QStringLiteral("SELECT %1, %3, %4, %5, %5 FROM lots l %2 ORDER BY l.id")
                                 .arg(QLatin1String(kLotColumns), QLatin1String(kLotJoins), logged("u.new_value"),
                                      logged("u.new_value || ''"), logged("u.author")));
    lots.bind(kLotOpened).bind(kLotClosed).bind(kLotOpened).bind(kLotClosed).run();
    std::int64_t stored = 0;
    while (lots.next()) {
        ++stored;
        const LotRow lot = readLot(lots);
        const std::string opened = lots.text(kLotColumnCount);
        const bool begun = (opened == lotText(lot) || opened == lotTextOfBefore(lot)) &&
                           lots.text(kLotColumnCount + 2) == lot.openedBy;
        const bool closed = !lots.isNull(kLotColumnCount + 1);
        const std::string end = lots.text(kLotColumnCount + 1);  // of before version 7: without its time
        const bool ended = closed ? lot.closedUtc_ms && (end.empty() || end == lotEndText(*lot.closedUtc_ms)) &&
                                        lots.text(kLotColumnCount + 3) == lot.closedBy
                                  : !lot.closedUtc_ms;
        if (!begun || !ended) {
            throw Broken{lot.id, Sentence(KERF_TEXT("Lot %1 (%2) differs from what was logged when it was opened or "
                                                    "closed."),
                                          number(lot.id), SentenceArg(lot.name))};
        }
    }
    const auto opened = integerOf(
        database, QStringLiteral("SELECT count(*) FROM audit WHERE object = 'lot' AND object <> 'measurement' AND "
                                 "action = '%1'")
                      .arg(QLatin1String(kLotOpened)));
    if (opened != stored) {
        throw Broken{0, Sentence(KERF_TEXT("%1 lots were opened, %2 are stored."), number(opened), number(stored))};
    }
}

/// Parts since version 7 follow from one another.
void verifyParts(const QSqlDatabase& database) {
    Statement parts(
        database,
        "SELECT p.id, p.process, p.lot_id, p.number, p.complete, p.machine_begin_ns, p.machine_end_ns, "
        "p.ended_utc_ms, p.schedule_id, p.recipe_revision_id, x.results, p.seal FROM parts p LEFT JOIN "
        "part_results x ON x.part_id = p.id WHERE p.id >= (SELECT min(id) FROM parts WHERE seal IS NOT NULL) "
        "ORDER BY p.id");
    parts.run();
    std::string before;
    while (parts.next()) {
        const auto value = [&parts](int column) {
            return parts.isNull(column) ? std::string("-") : parts.text(column);
        };
        const SealedPart part{value(1), value(2), value(3), value(4), value(5),
                              value(6), value(7), value(8), value(9), value(10)};
        if (parts.text(11) != partSeal(before, part)) {
            throw Broken{
                parts.integer(0),
                Sentence(KERF_TEXT("Part %1 differs from what was kept of it when it was made, or one before it "
                                   "is missing."),
                         number(parts.integer(0)))};
        }
        before = parts.text(11);
    }
}

void verifySettings(const QSqlDatabase& database) {
    Statement pairs(
        database,
        "SELECT s.key, s.value, (SELECT u.new_value FROM audit u WHERE u.object = 'setting ' || s.key AND u.object <> "
        "'measurement' ORDER BY u.id DESC LIMIT 1) FROM settings s");
    pairs.run();
    while (pairs.next()) {
        if (pairs.text(1) != pairs.text(2)) {
            throw Broken{0, Sentence(KERF_TEXT("Setting %1 differs from what was logged when it was changed."),
                                     SentenceArg(pairs.text(0)))};
        }
    }
}

}  // namespace

std::string roomRecordText(const std::string& subject, const std::string& body) {
    return subject + kHashMark + sha256(body);
}

std::string roomRecordsSeal(const QSqlDatabase& database, std::int64_t last) {
    Statement find(
        database,
        "SELECT id, process, kind, subject, body, author, reason FROM room_records WHERE id <= ? ORDER BY id");
    find.bind(last).run();
    std::string text;
    while (find.next()) {
        for (int column = 0; column < 7; ++column) {
            const std::string field = column == 0 ? std::to_string(find.integer(0)) : find.text(column);
            text += std::to_string(field.size()) + ':' + field;
        }
    }
    return sha256(text);
}

AuditVerdict verifyAudit(const QSqlDatabase& database) {
    AuditVerdict verdict;
    verdict.headHash = kGenesis;
    try {
        verifyChain(database, verdict);
        verifyMeasurements(database, verdict);
        verifyRoomRecords(database, verdict);
        verifyRecipes(database);
        verifyLots(database);
        verifyParts(database);
        verifySettings(database);
    } catch (const Broken& broken) {
        verdict.firstBad = broken.at;
        verdict.finding = broken.finding;
    }
    return verdict;
}

}  // namespace kerf::db
