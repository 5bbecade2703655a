// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "app/service/quality/characteristics.h"
#include "db/api/csv_export.h"
#include "db/api/lot_reader.h"
#include "db/api/room_records.h"

namespace kerf {

/// Limits that hold for the figures of a process: the newest set ones, or the standard ones. What cannot be read is no
/// limit: such parts are not judged.
[[nodiscard]] std::vector<FigureLimit> figureLimits(RoomRecordReader& records, ProcessId process);

/// Judges parts of any lot with the recipe of the lot and the limits of its process; both are read once per lot. On the
/// readers' thread.
class PartJudge {
 public:
    PartJudge(LotReader& lots, RoomRecordReader& records) : m_lots(lots), m_records(records) {}

    [[nodiscard]] const std::vector<Characteristic>& characteristics(const PartRow& part);
    [[nodiscard]] PartJudgement judge(const PartRow& part) { return judgePart(part, characteristics(part)); }
    /// For tables written as CSV; this object must outlive it.
    [[nodiscard]] VerdictOf forExport();
    /// Limits were changed.
    void forget();

 private:
    LotReader& m_lots;
    RoomRecordReader& m_records;
    std::map<LotId, std::vector<Characteristic>> m_byLot{};
    std::array<std::optional<std::vector<Characteristic>>, kProcessPlaces> m_byProcess{};
};

}  // namespace kerf
