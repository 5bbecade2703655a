// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "db/row_io.h"
#include "db/stores/audit_log.h"
#include "db/stores/schedule_rows.h"
#include "db/stores/store.h"

/// Measurements, corrections and voids with the estimator states that follow from them.
namespace kerf::db {
namespace {

[[noreturn]] void refuse(const char* text) {
    throw SqlFailure(Sentence(text), 0, std::string("measurement refused: ") + text);
}

const char* actionOf(MeasurementKind kind) {
    switch (kind) {
        case MeasurementKind::Entry:
            return "measured";
        case MeasurementKind::Correction:
            return "corrected";
        case MeasurementKind::Void:
            break;
    }
    return "voided";
}

/// The row that is replaced, after a look that it still holds.
MeasurementRow replacedBy(const QSqlDatabase& database, const MeasurementRow& row) {
    Statement find(database,
                   QStringLiteral("SELECT %1, (SELECT count(*) FROM measurements n WHERE n.replaces_id = m.id) "
                                  "FROM measurements m WHERE m.id = ?")
                       .arg(QLatin1String(kMeasurementColumns)));
    if (!find.bind(row.replaces.value_or(0)).run().next()) {
        refuse(KERF_TEXT("The measurement to be replaced is not stored."));
    }
    if (find.integer(kMeasurementColumnCount) > 0) {
        refuse(KERF_TEXT("This measurement was replaced meanwhile: look at the newest value first."));
    }
    return readMeasurement(find);
}

void insertState(const QSqlDatabase& database, const EstimatorStateRow& state, LotId lot, MeasurementId cause) {
    Statement insert(
        database,
        "INSERT INTO estimator_states (lot_id, measurement_id, cause_measurement_id, estimator, ln_c, alpha, "
        "beta, p00, p01, p02, p11, p12, p22, perturbed, state) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
        "?, ?)");
    insert.bind(lot).bind(state.measurement == 0 ? cause : state.measurement).bind(cause).bind(state.estimator);
    for (const double value : state.theta) {
        insert.bind(value);
    }
    for (const double value : state.covariance) {
        insert.bind(value);
    }
    insert.bind(state.perturbed).bind(state.stateJson).run();
}

/// `before`: what the same command has stored already.
MeasurementId accept(const QSqlDatabase& database, const AcceptMeasurement& command,
                     const std::vector<MeasurementId>& before) {
    MeasurementRow row = command.measurement;
    if (row.author.empty()) {
        refuse(KERF_TEXT("Sign on first: a measurement needs a name."));
    }
    if (row.kind != MeasurementKind::Entry && row.reason.empty()) {
        refuse(KERF_TEXT("A correction needs a reason."));
    }
    if (row.diameter_mm && !(std::isfinite(*row.diameter_mm) && *row.diameter_mm > 0.0)) {
        refuse(KERF_TEXT("A diameter is a number above zero."));
    }
    if (row.source == MeasurementSource::File && row.sourceName.empty()) {
        refuse(KERF_TEXT("A value from a file needs the file's name."));
    }
    std::string replaced;
    if (row.kind != MeasurementKind::Entry) {
        const MeasurementRow old = replacedBy(database, row);
        row.part = old.part;
        row.station = old.station;
        row.position_mm = old.position_mm;
        replaced = measurementText(old);
    }
    Statement part(database, "SELECT lot_id FROM parts WHERE id = ?");
    if (!part.bind(row.part).run().next()) {
        refuse(KERF_TEXT("The part of this measurement is not stored."));
    }
    const std::optional<LotId> lot = part.maybeInteger(0);
    if (!command.states.empty() && !lot) {
        refuse(KERF_TEXT("The part belongs to no lot: no estimator can learn from it."));
    }
    row.acceptedUtc_ms = utcNow_ms();
    Statement insert(database,
                     "INSERT INTO measurements (part_id, kind, replaces_id, station, position_mm, diameter_mm, source, "
                     "confirmed, author, reason, accepted_utc_ms) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(row.part)
        .bind(kindKey(row.kind))
        .bind(row.replaces)
        .bind(static_cast<std::int64_t>(row.station))
        .bind(row.position_mm)
        .bind(row.diameter_mm)
        .bind(row.source == MeasurementSource::Gauge ? "gauge" : "keypad")  // all that this column takes
        .bind(row.confirmed)
        .bind(row.author)
        .bind(row.reason)
        .bind(row.acceptedUtc_ms)
        .run();
    row.id = insert.lastId();
    if (row.source == MeasurementSource::File || !row.sourceName.empty()) {  // more than the row itself says
        Statement(database, "INSERT INTO measurement_sources (measurement_id, source, name) VALUES (?, ?, ?)")
            .bind(row.id)
            .bind(sourceKey(row.source))
            .bind(row.sourceName)
            .run();
    }
    for (const EstimatorStateRow& state : command.states) {
        EstimatorStateRow stored = state;
        const auto place = static_cast<std::size_t>(-state.measurement);
        if (state.measurement < 0) {
            stored.measurement = place <= before.size() ? before[place - 1] : row.id;
        }
        insertState(database, stored, *lot, row.id);
    }
    if (command.nextSchedule) {
        (void)findOrAddSchedule(database, *command.nextSchedule);
    }
    appendAudit(database, {.author = row.author,
                           .action = actionOf(row.kind),
                           .object = "measurement",
                           .objectId = row.id,
                           .oldValue = replaced,
                           .newValue = measurementText(row),
                           .reason = row.reason});
    return row.id;
}

}  // namespace

Receipt Store::run(const AcceptMeasurement& command) {
    return {accept(m_database, command, {})};
}

Receipt Store::run(const AcceptMeasurements& command) {
    std::vector<MeasurementId> ids;
    for (const AcceptMeasurement& one : command.measurements) {
        ids.push_back(accept(m_database, one, ids));
        if (ids.back() != ids.front() + static_cast<MeasurementId>(ids.size()) - 1) {
            refuse(KERF_TEXT("The data file numbers its measurements with gaps."));
        }
    }
    return {ids.empty() ? 0 : ids.front(), static_cast<std::int64_t>(ids.size())};
}

}  // namespace kerf::db
