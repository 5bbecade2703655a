// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <optional>
#include <string>

#include "db/api/store_writer.h"
#include "db/connection.h"
#include "db/migrator.h"
#include "db/readers/database_reader.h"
#include "db/statement.h"
#include "db/stores/store.h"

namespace kerf::test {

/// A scratch folder with one fresh database, gone with the object.
class ScratchDatabase {
 public:
    ScratchDatabase() {
        if (const auto ready = db::prepareDatabase(path()); !ready) {
            qFatal("%s", ready.error().english().c_str());
        }
    }
    [[nodiscard]] std::string path() const { return m_folder.filePath(QStringLiteral("kerf.db")).toStdString(); }
    [[nodiscard]] std::string file(const char* name) const {
        return m_folder.filePath(QString::fromUtf8(name)).toStdString();
    }

 private:
    QTemporaryDir m_folder;
};

inline PartRecord boringPart(std::uint32_t sequence, std::uint32_t scheduleRevision = 1) {
    PartRecord record;
    record.partSequence = sequence;
    record.begin_ns = sequence * 60'000'000'000LL;
    record.end_ns = record.begin_ns + 41'000'000'000LL;
    record.schedule.revision = scheduleRevision;
    record.schedule.lnC = -2.44;
    record.schedule.alpha = 0.5025;
    record.schedule.beta = 0.2676;
    record.schedule.targetDeflection_mm = 0.1165;
    record.feed.count = kFeedTracePoints;
    for (std::size_t i = 0; i < kFeedTracePoints; ++i) {
        record.feed.overhang_mm[i] = 40.0F + 4.0F * static_cast<float>(i);
        record.feed.feed_mmPerRev[i] = 0.25F - 0.001F * static_cast<float>(i);
    }
    return record;
}

inline MeasurementRow measured(PartId part, std::uint8_t station, double diameter_mm) {
    MeasurementRow row;
    row.part = part;
    row.station = station;
    row.position_mm = station == 0 ? 40.0 : 310.0;
    row.diameter_mm = diameter_mm;
    row.author = "Kim";
    return row;
}

inline EstimatorStateRow stateOf(double alpha) {
    EstimatorStateRow state;
    state.estimator = "kalman";
    state.theta = {-2.44, alpha, 0.2676};
    state.covariance = {1.0, 0.1, 0.2, 1.0, 0.3, 1.0};
    state.stateJson = R"({"alpha":)" + std::to_string(alpha) + "}";
    return state;
}

/// A database with a writer's connection, a machine, a part type and a lot in it.
class Shop {
 public:
    explicit Shop(const std::string& path)
        : m_connection(path, db::Access::Write), m_store(m_connection.database()), m_path(path) {
        machine = must(EnsureMachine{"VB-1", "simulator"}).id;
        const Receipt type =
            must(EnsurePartType{ProcessId::Boring, "Sleeve 50", R"({"target_diameter_mm":50})", "Lee"});
        partType = type.id;
        recipe = type.second;
        lot = must(EnsureLot{machine, partType, recipe, "12", 30, "kalman", "Lee"}).id;
    }
    [[nodiscard]] Receipt must(const StoreCommand& command) {
        const auto receipt = m_store.apply(command);
        if (!receipt) {
            qFatal("%s", receipt.error().english().c_str());
        }
        return *receipt;
    }
    [[nodiscard]] Result<Receipt> tried(const StoreCommand& command) { return m_store.apply(command); }
    [[nodiscard]] PartId addPart(std::uint32_t sequence) { return must(AddPart{lot, boringPart(sequence), {}}).id; }
    [[nodiscard]] std::unique_ptr<db::DatabaseReader> reader() const {
        auto opened = db::DatabaseReader::open(m_path);
        return opened ? std::move(*opened) : nullptr;
    }
    [[nodiscard]] const QSqlDatabase& database() const { return m_connection.database(); }
    [[nodiscard]] db::Store& store() { return m_store; }

    MachineId machine{0};
    PartTypeId partType{0};
    RecipeRevisionId recipe{0};
    LotId lot{0};

 private:
    db::Connection m_connection;
    db::Store m_store;
    std::string m_path;
};

/// Runs SQL past the store; false when SQLite refuses.
inline bool tryExecute(const QSqlDatabase& database, const char* sql) {
    try {
        db::execute(database, QString::fromUtf8(sql));
        return true;
    } catch (const db::SqlFailure&) {
        return false;
    }
}

inline std::int64_t number(const QSqlDatabase& database, const char* sql) {
    return db::integerOf(database, QString::fromUtf8(sql));
}

}  // namespace kerf::test
