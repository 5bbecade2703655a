// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "db/api/rows.h"
#include "engine/api/status.h"
#include "engine/core/result.h"
#include "engine/core/subscription.h"

/// Everything that can be written. One command is one transaction, with its audit entry inside.
namespace kerf {

/// Find the machine of that name, or create it. Receipt: id.
struct EnsureMachine {
    std::string name{};
    std::string kind{};
};
/// Find the part type, or create it with these parameters as revision 1. Receipt: id, second = newest recipe revision.
struct EnsurePartType {
    ProcessId process{ProcessId::Boring};
    std::string name{};
    std::string parametersJson{};
    std::string author{};
};
/// Add a revision to a part type's recipe. Receipt: id of the revision, second = its number.
struct SaveRecipe {
    PartTypeId partType{0};
    std::string parametersJson{};
    std::string author{};
    std::string reason{};
    std::optional<std::uint32_t> restoredFrom{};
};
/// Roll back: revision `revision` of the part type becomes the newest again, as a new revision. Receipt as SaveRecipe.
struct RestoreRecipe {
    PartTypeId partType{0};
    std::uint32_t revision{0};
    std::string author{};
    std::string reason{};
};
/// A revision of the recipe of that part type, which is made when there is none of the name. The audit log notes the
/// part type and a hash of the parameters. Receipt as SaveRecipe.
struct KeepRecipe {
    ProcessId process{ProcessId::Boring};
    std::string partType{};
    std::string parametersJson{};
    std::string author{};
    std::string reason{};
    std::optional<std::uint32_t> restoredFrom{};  ///< a revision that there is
};
/// Find the lot of that name, or open it. Receipt: id.
struct EnsureLot {
    MachineId machine{0};
    PartTypeId partType{0};
    RecipeRevisionId recipe{0};
    std::string name{};
    std::uint32_t size{0};
    std::string estimator{};  ///< boring; else empty
    std::string author{};
    std::string tool{};   ///< tool or insert; may be empty
    std::string gauge{};  ///< may be empty
};
struct CloseLot {
    LotId lot{0};
    std::string author{};
    std::string reason{};
};
/// From now on parts of that process are begun for this lot, also after a restart. Of which lot a part is says its
/// record.
struct SetActiveLot {
    ProcessId process{ProcessId::Boring};
    std::optional<LotId> lot{};
    std::string author{};
};
/// Store a part by hand (import, tests). The engine's own parts come through the part-record ring. Receipt: id, second
/// = number in the lot.
struct AddPart {
    std::optional<LotId> lot{};
    PartRecord record{};
    std::string serial{};
};
struct SetPartSerial {
    PartId part{0};
    std::string serial{};
    std::string author{};
    std::string reason{};
};
/// A measurement, correction or void with the estimator states that follow from it, and the schedule that follows from
/// those: stored together or not at all. Receipt: id of the measurement.
struct AcceptMeasurement {
    MeasurementRow measurement{};
    std::vector<EstimatorStateRow> states{};
    std::optional<ScheduleRow> nextSchedule{};
};
/// Many at once, in their order, all or none. In a state a measurement −k means the k-th of this command. Receipt: id
/// of the first, second = how many; their ids follow one another.
struct AcceptMeasurements {
    std::vector<AcceptMeasurement> measurements{};
};
/// Keep a proposed schedule (found again by lot, revision and values when the part comes). Receipt: id.
struct StoreSchedule {
    ScheduleRow schedule{};
};
struct AcceptSchedule {
    LotId lot{0};
    std::uint32_t revision{0};
    std::string author{};
};
/// Receipt: id.
struct RaiseAlarm {
    AlarmCode code{0};
    std::uint8_t priority{3};
    Sentence detail{};
    std::int64_t utc_ms{0};    ///< when it came; 0: the writer puts the time of submission
    std::string detailText{};  ///< not empty: as read back from the outbox, in the place of `detail`
    std::string detailArgs{};
};
/// The condition has gone: closes every standing occurrence of the code.
struct ClearAlarm {
    AlarmCode code{0};
    std::int64_t utc_ms{0};  ///< as in RaiseAlarm
};
/// At start: what stood when the console ended stands no longer unless the engine raises it again.
struct CloseAlarmsOfLastRun {};
struct AcknowledgeAlarm {
    AlarmId alarm{0};
    std::string author{};
};
struct ChangeSetting {
    std::string key{};
    std::string value{};
    std::string author{};
    std::string reason{};
};
/// For what is not a row of a table: sign-on, mode switched, hold released.
struct AddAudit {
    std::string author{};
    std::string action{};
    std::string object{};
    std::int64_t objectId{0};
    std::string oldValue{};
    std::string newValue{};
    std::string reason{};
};

/// Keep a value of one process's room for ever (db/api/room_records.h). Receipt: id.
struct AddRoomRecord {
    ProcessId process{ProcessId::Boring};
    std::string kind{};      ///< "tool", "model", "session" …; never empty
    std::string subject{};   ///< what it is about: part type, tool, axis; may be empty
    std::string bodyJson{};  ///< valid JSON; numbers under keys that end in their unit
    std::string author{};    ///< never empty
    std::string reason{};
};

/// A person known at this machine: made, or changed. The seal never reaches the audit log.
struct SaveAccount {
    std::string name{};
    std::string roleKey{};  ///< "operator", "setter", "engineer"
    std::string seal{};     ///< of the PIN (app/service/pin_seal.h); empty: none is asked
    std::string author{};   ///< never empty
    std::string reason{};
};
/// Takes an account off the list; the audit log and everything stored keep the name.
struct RemoveAccount {
    std::string name{};
    std::string author{};  ///< never empty
};
/// Wrong PINs of an account since the last right one: kept, so that a restart does not end the wait.
struct NoteWrongPin {
    std::string name{};
    std::uint32_t tries{0};
    std::int64_t last_utc_ms{0};
};

using StoreCommand =
    std::variant<EnsureMachine, EnsurePartType, SaveRecipe, RestoreRecipe, KeepRecipe, EnsureLot, CloseLot,
                 SetActiveLot, AddPart, SetPartSerial, AcceptMeasurement, AcceptMeasurements, StoreSchedule,
                 AcceptSchedule, RaiseAlarm, ClearAlarm, CloseAlarmsOfLastRun, AcknowledgeAlarm, ChangeSetting,
                 AddAudit, AddRoomRecord, SaveAccount, RemoveAccount, NoteWrongPin>;

/// What a command has made; each command says what it puts here.
struct Receipt {
    std::int64_t id{0};
    std::int64_t second{0};
};

/// A part of the engine, safely on disk.
struct StoredPart {
    PartId id{0};
    std::optional<LotId> lot{};
    std::uint32_t number{0};
    PartRecord record{};
    std::optional<RecipeRevisionId> recipe{};
};

/// Ends when destroyed.
/// The way into the database. One caller thread; no call blocks; callbacks run later on the caller's thread.
///
/// When it fails: a command's transaction is rolled back and `done` gets the sentence; nothing is half-stored and the
/// caller still has the values (a measurement counts as accepted only when `done` says so). Finished parts of the
/// engine are not answered but kept and tried again, oldest first, until they are stored; meanwhile problem() says why.
/// So are commands without a `done`: alarms and entries of the audit log that nobody else holds.
/// Commands run in the order they were submitted, each before any part that the engine finishes later.
class StoreWriter {
 public:
    StoreWriter() = default;
    StoreWriter(const StoreWriter&) = delete;
    StoreWriter& operator=(const StoreWriter&) = delete;
    virtual ~StoreWriter() = default;

    using Done = std::function<void(const Result<Receipt>&)>;
    /// `done` may be empty. It must stay callable until it has run; it does not run any more once the writer is
    /// destroyed.
    virtual void submit(StoreCommand command, Done done) = 0;

    /// Why finished parts cannot be stored at the moment; empty when they can.
    [[nodiscard]] virtual const Sentence& problem() const = 0;
    [[nodiscard]] virtual std::unique_ptr<Subscription> onProblemChanged(std::function<void()> changed) = 0;
    [[nodiscard]] virtual std::unique_ptr<Subscription> onPartStored(std::function<void(const StoredPart&)> stored) = 0;
};

}  // namespace kerf
