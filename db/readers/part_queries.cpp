// SPDX-License-Identifier: GPL-3.0-or-later
#include <QStringList>
#include <algorithm>

#include "db/readers/database_reader.h"
#include "db/row_io.h"
#include "db/statement.h"

/// Tables of parts. Every query walks an index backwards from the page before, so a million parts cost what ten do.
namespace kerf::db {
namespace {

/// Up to this many parts that match a text are sorted; with more of them the newest are quickly met on the way.
constexpr std::int64_t kSparse = 100'000;

QString columnsOfPart() {
    return QStringLiteral("SELECT %1 FROM parts p %2").arg(QLatin1String(kPartColumns), QLatin1String(kPartJoins));
}

/// LIKE pattern for "contains", with the wildcard characters of the text taken literally.
std::string containsPattern(const std::string& text) {
    std::string pattern = "%";
    for (const char c : text) {
        if (c == '%' || c == '_' || c == '\\') {
            pattern += '\\';
        }
        pattern += c;
    }
    return pattern + '%';
}

/// Serial numbers that start with the text: an index range (the column compares without case).
std::string endOfRange(const std::string& text) {
    return text + "\U0010FFFF";
}

constexpr const char* kTextMatches =
    "SELECT id FROM parts WHERE serial >= ? AND serial < ? UNION SELECT p2.id FROM lots l2 JOIN part_types t2 ON t2.id "
    "= "
    "l2.part_type_id CROSS JOIN parts p2 ON p2.lot_id = l2.id WHERE l2.name LIKE ? ESCAPE '\\' OR t2.name LIKE ? "
    "ESCAPE "
    "'\\' UNION SELECT p3.id FROM part_types t3 JOIN recipe_revisions r3 ON r3.part_type_id = t3.id CROSS JOIN parts "
    "p3 "
    "ON p3.recipe_revision_id = r3.id WHERE p3.lot_id IS NULL AND p3.recipe_revision_id IS NOT NULL AND t3.name LIKE ? "
    "ESCAPE '\\'";

void bindText(Statement& statement, const std::string& text) {
    const std::string contains = containsPattern(text);
    statement.bind(text).bind(endOfRange(text)).bind(contains).bind(contains);
}

void bindMatches(Statement& statement, const std::string& text) {
    bindText(statement, text);
    statement.bind(containsPattern(text));
}

bool isSparse(const QSqlDatabase& database, const std::string& text) {
    // UNION ALL: counting stops at the limit without sorting first.
    QString matches = QString::fromUtf8(kTextMatches).replace(QStringLiteral(" UNION "), QStringLiteral(" UNION ALL "));
    Statement probe(database, QStringLiteral("SELECT count(*) FROM (%1 LIMIT %2)").arg(matches).arg(kSparse + 1));
    bindMatches(probe, text);
    return !probe.run().next() || probe.integer(0) <= kSparse;
}

QString whereOf(const PartQuery& query, bool sparse) {
    QStringList terms;
    if (query.process) {
        terms << QStringLiteral("p.process = ?");
    }
    if (query.lot) {
        terms << QStringLiteral("p.lot_id = ?");
    }
    if (query.numberWithoutLot) {
        terms << QStringLiteral("p.lot_id IS NULL AND p.number = ?");
    }
    if (query.fromUtc_ms) {
        terms << QStringLiteral("p.ended_utc_ms >= ?");
    }
    if (query.toUtc_ms) {
        terms << QStringLiteral("p.ended_utc_ms < ?");
    }
    if (query.before) {
        terms << QStringLiteral("p.id < ?");
    }
    if (query.after) {
        terms << QStringLiteral("p.id > ?");
    }
    if (!query.text.empty()) {
        terms << (sparse ? QStringLiteral("p.id IN (%1)").arg(QString::fromUtf8(kTextMatches))
                         : QStringLiteral(
                               "((p.serial >= ? AND p.serial < ?) OR l.name LIKE ? ESCAPE '\\' OR t.name LIKE ? "
                               "ESCAPE '\\')"));
    }
    return terms.isEmpty() ? QString() : QStringLiteral(" WHERE ") + terms.join(QStringLiteral(" AND "));
}

void bindQuery(Statement& statement, const PartQuery& query, bool sparse) {
    if (query.process) {
        statement.bind(processKey(*query.process));
    }
    if (query.lot) {
        statement.bind(*query.lot);
    }
    if (query.numberWithoutLot) {
        statement.bind(*query.numberWithoutLot);
    }
    if (query.fromUtc_ms) {
        statement.bind(*query.fromUtc_ms);
    }
    if (query.toUtc_ms) {
        statement.bind(*query.toUtc_ms);
    }
    if (query.before) {
        statement.bind(*query.before);
    }
    if (query.after) {
        statement.bind(*query.after);
    }
    if (!query.text.empty()) {
        sparse ? bindMatches(statement, query.text) : bindText(statement, query.text);
    }
}

/// Measurements of the page's parts, one index look-up per part.
void addMeasurements(const QSqlDatabase& database, std::vector<PartRow>& rows) {
    Statement find(database, QStringLiteral("SELECT %1 FROM measurements m WHERE m.part_id = ? ORDER BY m.id")
                                 .arg(QLatin1String(kMeasurementColumns)));
    for (PartRow& row : rows) {
        find.bind(row.id).run();
        while (find.next()) {
            row.measurements.push_back(readMeasurement(find));
        }
    }
}

}  // namespace

Result<std::vector<PartRow>> DatabaseReader::parts(const PartQuery& query) {
    return guarded([&] {
        const Snapshot snapshot(database());
        const bool sparse = !query.text.empty() && isSparse(database(), query.text);
        Statement statement(database(), columnsOfPart() + whereOf(query, sparse) +
                                            QStringLiteral(" ORDER BY p.id %1 LIMIT %2")
                                                .arg(query.oldestFirst ? QStringLiteral("ASC") : QStringLiteral("DESC"))
                                                .arg(query.limit));
        bindQuery(statement, query, sparse);
        statement.run();
        std::vector<PartRow> rows;
        while (statement.next()) {
            rows.push_back(readPart(statement));
        }
        addMeasurements(database(), rows);
        return rows;
    });
}

Result<std::uint64_t> DatabaseReader::count(const PartQuery& query, std::uint64_t atMost) {
    return guarded([&] {
        const bool sparse = !query.text.empty() && isSparse(database(), query.text);
        // Without a text nothing of the joined tables is asked for.
        const QString joins = query.text.empty() || sparse ? QString() : QString::fromUtf8(kPartJoins);
        Statement statement(database(), QStringLiteral("SELECT count(*) FROM (SELECT 1 FROM parts p %1%2 LIMIT %3)")
                                            .arg(joins, whereOf(query, sparse))
                                            .arg(atMost));
        bindQuery(statement, query, sparse);
        return statement.run().next() ? static_cast<std::uint64_t>(statement.integer(0)) : std::uint64_t{0};
    });
}

Result<std::optional<PartDetail>> DatabaseReader::part(PartId id) {
    return guarded([&]() -> std::optional<PartDetail> {
        const Snapshot snapshot(database());
        Statement find(database(), columnsOfPart() + QStringLiteral(" WHERE p.id = ?"));
        if (!find.bind(id).run().next()) {
            return std::nullopt;
        }
        std::vector<PartRow> rows{readPart(find)};
        addMeasurements(database(), rows);
        PartDetail detail;
        detail.part = std::move(rows.front());

        Statement schedule(database(), QStringLiteral("SELECT %1 FROM parts p JOIN schedules s ON s.id = p.schedule_id "
                                                      "WHERE p.id = ?")
                                           .arg(QLatin1String(kScheduleColumns)));
        if (schedule.bind(id).run().next()) {
            detail.schedule = readSchedule(schedule);
        }
        Statement trace(database(), "SELECT points FROM feed_traces WHERE part_id = ?");
        if (trace.bind(id).run().next()) {
            detail.feed = unpackTrace(trace.blob(0));
        }
        Statement states(database(),
                         QStringLiteral("SELECT %1 FROM parts p JOIN measurements m ON m.part_id = p.id JOIN "
                                        "estimator_states e ON e.id = (SELECT max(x.id) FROM estimator_states x WHERE "
                                        "x.lot_id = p.lot_id AND x.measurement_id = m.id) WHERE p.id = ? ORDER BY "
                                        "m.id")
                             .arg(QLatin1String(kStateColumns)));
        states.bind(id).run();
        while (states.next()) {
            detail.states.push_back(readState(states));
        }
        return detail;
    });
}

}  // namespace kerf::db
