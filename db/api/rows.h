// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/alarm.h"
#include "engine/core/process.h"
#include "engine/core/sentence.h"
#include "engine/process/boring/boring_types.h"

/// Plain values as the database keeps them. Instants are milliseconds since 1970-01-01 UTC; text is UTF-8.
namespace kerf {

using MachineId = std::int64_t;
using PartTypeId = std::int64_t;
using RecipeRevisionId = std::int64_t;
using LotId = std::int64_t;
using ScheduleId = std::int64_t;
using PartId = std::int64_t;
using MeasurementId = std::int64_t;
using AlarmId = std::int64_t;

struct MachineRow {
    MachineId id{0};
    std::string name{};
    std::string kind{};  ///< "simulator", "linuxcnc"
    std::int64_t createdUtc_ms{0};
};

struct PartTypeRow {
    PartTypeId id{0};
    ProcessId process{ProcessId::Boring};
    std::string name{};
    std::int64_t createdUtc_ms{0};
};

/// One revision of a part type's parameters; revisions are never changed, a roll back is a new one.
struct RecipeRevision {
    RecipeRevisionId id{0};
    PartTypeId partType{0};
    std::uint32_t revision{0};  ///< 1, 2, 3 … within the part type
    std::string parametersJson{};
    std::optional<std::uint32_t> restoredFrom{};  ///< set by a roll back: the revision whose parameters came back
    std::string author{};
    std::string reason{};
    std::int64_t createdUtc_ms{0};
};

struct LotRow {
    LotId id{0};
    MachineId machine{0};
    std::string machineName{};
    PartTypeId partType{0};
    std::string partTypeName{};
    ProcessId process{ProcessId::Boring};
    RecipeRevisionId recipe{0};
    std::string name{};
    std::uint32_t size{0};
    std::string estimator{};  ///< boring; else empty
    std::int64_t openedUtc_ms{0};
    std::optional<std::int64_t> closedUtc_ms{};
    std::string tool{};               ///< tool or insert; empty: not said
    std::string gauge{};              ///< empty: not said
    std::string openedBy{};           ///< empty: not known (opened before version 7, and not in the log)
    std::string closedBy{};           ///< empty while it is open
    std::uint32_t recipeRevision{0};  ///< number of `recipe` within its part type
};

/// A boring schedule that was proposed or cut with.
struct ScheduleRow {
    ScheduleId id{0};
    std::optional<LotId> lot{};
    BoringSchedule schedule{};
    std::string predictionJson{};  ///< predicted diameters at each station, as the service made them; may be empty
    std::string reason{};          ///< why it differs from the one before; may be empty
    std::int64_t createdUtc_ms{0};
    std::string acceptedBy{};  ///< empty: only proposed
    std::optional<std::int64_t> acceptedUtc_ms{};
};

enum class MeasurementKind : std::uint8_t {
    Entry,       ///< measured for the first time
    Correction,  ///< takes the place of the row it replaces
    Void,        ///< takes the row it replaces out of the account
};
enum class MeasurementSource : std::uint8_t { Keypad, Gauge, File };
/// "keypad", "gauge", "file".
[[nodiscard]] const char* sourceKey(MeasurementSource source) noexcept;

/// One accepted row; the id rises in the order of acceptance. Rows are never changed or deleted.
struct MeasurementRow {
    MeasurementId id{0};
    PartId part{0};
    MeasurementKind kind{MeasurementKind::Entry};
    std::optional<MeasurementId> replaces{};  ///< Correction and Void: the row that no longer holds
    std::uint8_t station{0};                  ///< index of the depth
    double position_mm{0.0};                  ///< where it was measured (boring: overhang L)
    std::optional<double> diameter_mm{};      ///< empty only in a Void
    MeasurementSource source{MeasurementSource::Keypad};
    std::string sourceName{};  ///< which gauge, which file; empty: not known, or the keypad
    bool confirmed{false};     ///< the operator confirmed an implausible value
    std::string author{};      ///< never empty
    std::string reason{};      ///< never empty in a Correction or Void
    std::int64_t acceptedUtc_ms{0};
};

/// The estimator after a measurement. `stateJson` is all that a restart needs; the columns are for charts and export.
struct EstimatorStateRow {
    std::int64_t id{0};
    MeasurementId measurement{0};        ///< after which it holds; 0 when written: the measurement stored with it
    MeasurementId cause{0};              ///< set by the store: the measurement, correction or void that made this row
    std::string estimator{};             ///< "kalman", "perturbation"
    std::array<double, 3> theta{};       ///< ln C, α, β
    std::array<double, 6> covariance{};  ///< p00 p01 p02 p11 p12 p22
    bool perturbed{false};
    std::string stateJson{};
};

/// A figure of a part as stored; `key` ends in its unit.
struct PartFigure {
    std::string key{};
    double value{0.0};
};

/// One part without its curves.
struct PartRow {
    PartId id{0};
    ProcessId process{ProcessId::Boring};
    std::optional<LotId> lot{};
    std::string lotName{};
    std::string partTypeName{};
    std::uint32_t number{0};  ///< 1-based within the lot
    std::string serial{};     ///< empty: none given
    bool complete{true};      ///< false: aborted
    std::int64_t machineBegin_ns{0};
    std::int64_t machineEnd_ns{0};
    std::int64_t endedUtc_ms{0};
    std::optional<RecipeRevisionId> recipe{};    ///< what it was cut with; empty: not known
    std::uint32_t recipeRevision{0};             ///< its number within the part type; 0: not known
    std::vector<PartFigure> figures{};           ///< as the engine found them (engine/api/part_results.h)
    std::vector<MeasurementRow> measurements{};  ///< every row, in the order of acceptance
};

/// One part with everything that belongs to it.
struct PartDetail {
    PartRow part{};
    std::optional<ScheduleRow> schedule{};
    FeedTrace feed{};
    std::vector<EstimatorStateRow> states{};  ///< newest per measurement, in the order of acceptance
};

/// A whole lot as a service needs it after a restart.
struct LotHistory {
    LotRow lot{};
    RecipeRevision recipe{};
    std::vector<PartDetail> parts{};               ///< by number
    std::vector<MeasurementRow> measurements{};    ///< of all parts, in the order of acceptance
    std::vector<EstimatorStateRow> states{};       ///< newest per measurement, by measurement
    std::optional<EstimatorStateRow> lastState{};  ///< written last: the state the console had
    std::vector<ScheduleRow> schedules{};          ///< by revision, proposed ones too
};

/// A value of one process's room: a setup, a tuning, a model. Rows are never changed or deleted; the newest holds.
struct RoomRecordRow {
    std::int64_t id{0};
    ProcessId process{ProcessId::Boring};
    std::string kind{};
    std::string subject{};
    std::string bodyJson{};
    std::string author{};
    std::string reason{};
    std::int64_t createdUtc_ms{0};
};

/// One occurrence of an alarm.
struct AlarmRow {
    AlarmId id{0};
    AlarmCode code{0};
    std::uint8_t priority{3};
    std::int64_t raisedUtc_ms{0};
    std::optional<std::int64_t> clearedUtc_ms{};
    bool endedByRestart{false};  ///< still stood when the console ended
    std::optional<std::int64_t> acknowledgedUtc_ms{};
    std::string acknowledgedBy{};
    std::string detailText{};  ///< English with %1…%3, as marked with KERF_TEXT; translate, then fill in
    std::vector<SentenceArg> detailArgs{};
};

struct SettingRow {
    std::string key{};
    std::string value{};
    std::string changedBy{};
    std::int64_t changedUtc_ms{0};
};

struct AuditRow {
    std::int64_t id{0};
    std::int64_t utc_ms{0};
    std::string author{};
    std::string action{};
    std::string object{};
    std::int64_t objectId{0};
    std::string oldValue{};
    std::string newValue{};
    std::string reason{};
    std::string previousHash{};
    std::string hash{};
};

/// The rows that hold now: each chain of corrections gives its last row in the place of its first; voids give none.
[[nodiscard]] std::vector<MeasurementRow> effectiveMeasurements(const std::vector<MeasurementRow>& rows);

}  // namespace kerf
