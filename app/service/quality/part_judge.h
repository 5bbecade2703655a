// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/service/quality/characteristics.h"
#include "db/api/csv_export.h"
#include "db/api/lot_reader.h"
#include "db/api/room_records.h"

namespace kerf {

/// Limits of the figures of a process by the revisions of its recipes, which it worked by one after the other. A
/// revision that says none has what was set for the process before recipes had limits, or the standard ones.
[[nodiscard]] RecipeLimits recipeLimits(LotReader& lots, RoomRecordReader& records, ProcessId process);

/// Room records of this kind say which part type a process works by from then on.
inline constexpr const char* kPartTypeRecord = "part_type";

/// Judges parts of any lot with the recipe they were made under; what is read of it is read once. On the readers'
/// thread.
class PartJudge {
 public:
    PartJudge(LotReader& lots, RoomRecordReader& records) : m_lots(lots), m_records(records) {}

    [[nodiscard]] const std::vector<Characteristic>& characteristics(const PartRow& part);
    [[nodiscard]] PartJudgement judge(const PartRow& part) { return judgePart(part, characteristics(part)); }
    /// For tables written as CSV; this object must outlive it.
    [[nodiscard]] VerdictOf forExport();
    /// Limits were changed, or another part type chosen.
    void forget() { m_byProcess.clear(); }

 private:
    LotReader& m_lots;
    RoomRecordReader& m_records;
    std::map<LotId, std::vector<Characteristic>> m_byLot{};
    [[nodiscard]] const std::map<PartId, Disposition>& decisions();
    std::optional<std::map<PartId, Disposition>> m_decisions{};
    struct Process {
        RecipeLimits limits{};
        std::map<const std::vector<FigureLimit>*, std::vector<Characteristic>> known{};
    };
    std::map<ProcessId, Process> m_byProcess{};
};

}  // namespace kerf
