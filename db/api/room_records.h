// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"

namespace kerf {

/// What the rooms keep over a restart beside parts, measurements and recipes: tools, models, sessions. Written with
/// AddRoomRecord, never changed: a correction is a newer row. Own read-only connection; use it on one thread.
class RoomRecordReader {
 public:
    RoomRecordReader() = default;
    RoomRecordReader(const RoomRecordReader&) = delete;
    RoomRecordReader& operator=(const RoomRecordReader&) = delete;
    virtual ~RoomRecordReader() = default;

    /// Newest first; an empty `subject` takes every one.
    [[nodiscard]] virtual Result<std::vector<RoomRecordRow>> roomRecords(ProcessId process, const std::string& kind,
                                                                         const std::string& subject,
                                                                         std::uint32_t limit) = 0;
    /// The newest of each subject, oldest of those first: whatever their number, none is left out.
    [[nodiscard]] virtual Result<std::vector<RoomRecordRow>> newestRoomRecords(ProcessId process,
                                                                               const std::string& kind) = 0;
};

}  // namespace kerf
