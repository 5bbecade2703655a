// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "db/api/rows.h"
#include "engine/core/result.h"

namespace kerf {

/// Alarm history, over restarts. Use it on one thread.
class AlarmReader {
 public:
    AlarmReader() = default;
    AlarmReader(const AlarmReader&) = delete;
    AlarmReader& operator=(const AlarmReader&) = delete;
    virtual ~AlarmReader() = default;

    /// Newest first; only occurrences older than `before` when given.
    [[nodiscard]] virtual Result<std::vector<AlarmRow>> alarms(std::optional<AlarmId> before, std::uint32_t limit) = 0;
    /// Standing or not yet acknowledged, newest first.
    [[nodiscard]] virtual Result<std::vector<AlarmRow>> openAlarms() = 0;
};

}  // namespace kerf
