// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "db/api/alarm_reader.h"
#include "db/api/audit_reader.h"
#include "db/api/lot_reader.h"
#include "db/api/part_reader.h"
#include "db/api/room_records.h"
#include "ui/services/shift_service.h"

/// A shift is what is stored between two handovers: a function of the data file and the time, computed anew each time.
namespace kerf {

inline constexpr const char* kShiftNote = "shift_note";        ///< body {"text", "handover"}
inline constexpr const char* kShiftStopReason = "shift_stop";  ///< subject: begin as UTC ms; body {"reason"}
inline constexpr const char* kToolChange = "tool_change";      ///< subject: process key; body {"last_part"}
inline constexpr const char* kToolLife = "tool_life";          ///< subject: process key; body {"parts"}

struct ShiftSources {
    PartReader& parts;
    LotReader& lots;
    RoomRecordReader& records;
    AlarmReader& alarms;
    AuditReader& audit;
};

[[nodiscard]] std::string noteJson(const std::string& text, bool handover);
[[nodiscard]] std::string stopReasonJson(const std::string& reason);
[[nodiscard]] std::string toolChangeJson(PartId lastPart);
[[nodiscard]] std::string toolLifeJson(std::uint32_t parts);

/// `back` 0: the shift that goes on at `now`; 1: the one before the last handover; and so on.
[[nodiscard]] Result<ShiftView> readShift(const ShiftSources& from, int back, std::int64_t now_ms);
/// Pauses between parts, oldest first. `ended` are the ends of parts and their durations on the clock, oldest first.
struct ShiftCut {
    std::int64_t begin_ms{0};
    std::int64_t end_ms{0};
};
[[nodiscard]] std::vector<ShiftStop> stopsBetween(const std::vector<ShiftCut>& cuts, std::int64_t from_ms,
                                                  std::int64_t to_ms, bool current);
/// Parts with the tool that is in, of every process.
[[nodiscard]] Result<std::vector<ToolLife>> readTools(PartReader& parts, RoomRecordReader& records);

}  // namespace kerf
