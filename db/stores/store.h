// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>
#include <span>
#include <vector>

#include "db/api/store_writer.h"
#include "db/waiting.h"

namespace kerf::db {

/// The SQL behind StoreWriter's commands, on one write connection. Synchronous; used by the writer thread alone.
class Store {
 public:
    /// `database` must outlive the store and be open for writing.
    explicit Store(const QSqlDatabase& database) : m_database(database) {}

    /// One command, one transaction. A failure leaves the database as it was.
    [[nodiscard]] Result<Receipt> apply(const StoreCommand& command);
    /// Finished parts of the engine in one transaction, each into the lot of its order.
    [[nodiscard]] Result<std::vector<StoredPart>> addParts(std::span<const FinishedPart> parts);
    [[nodiscard]] Result<std::vector<StoredPart>> addParts(std::span<const PartRecord> records);
    /// An item of the outbox; false: it had been stored already when the program ended.
    [[nodiscard]] Result<bool> addWaiting(const Waiting& item);
    /// What versions before this one kept in another way: people among the settings, their seals in the audit log, room
    /// records without a hash. Does nothing when there is nothing of it.
    [[nodiscard]] Result<void> adoptEarlierForms();

 private:
    Receipt run(const EnsureMachine& command);
    Receipt run(const EnsurePartType& command);
    Receipt run(const SaveRecipe& command);
    Receipt run(const RestoreRecipe& command);
    Receipt run(const KeepRecipe& command);
    Receipt run(const EnsureLot& command);
    Receipt run(const CloseLot& command);
    Receipt run(const SetActiveLot& command);
    Receipt run(const AddPart& command);
    Receipt run(const SetPartSerial& command);
    Receipt run(const AcceptMeasurement& command);
    Receipt run(const AcceptMeasurements& command);
    Receipt run(const StoreSchedule& command);
    Receipt run(const AcceptSchedule& command);
    Receipt run(const RaiseAlarm& command);
    Receipt run(const ClearAlarm& command);
    Receipt run(const CloseAlarmsOfLastRun& command);
    Receipt run(const AcknowledgeAlarm& command);
    Receipt run(const ChangeSetting& command);
    Receipt run(const AddAudit& command);
    Receipt run(const AddRoomRecord& command);
    Receipt run(const SaveAccount& command);
    Receipt run(const RemoveAccount& command);
    Receipt run(const NoteWrongPin& command);

    QSqlDatabase m_database;
};

}  // namespace kerf::db
