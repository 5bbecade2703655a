// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "db/api/store_writer.h"

namespace kerf::db {

/// A part of the engine on its way to the disk: when it came out of the machine, not when it is stored at last.
struct FinishedPart {
    PartRecord record{};
    std::int64_t endedUtc_ms{0};
    std::string figuresJson{};  ///< as found in the outbox; empty: those of the record
};

/// What waits in the outbox, one line of text each. What the database keeps of a part is in it to the last digit; live
/// figures that only a screen shows are not.
using Waiting = std::variant<FinishedPart, RaiseAlarm, ClearAlarm, AddAudit>;

[[nodiscard]] std::string waitingText(const Waiting& item);
/// Empty: not an item that this version knows.
[[nodiscard]] std::optional<Waiting> waitingOf(const std::string& text);

}  // namespace kerf::db
