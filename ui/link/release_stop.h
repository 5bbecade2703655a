// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "engine/api/status.h"

namespace kerf::ui {

/// The person's release of the stop that stands for that process, as shown.
[[nodiscard]] inline ReleaseStop releaseOf(const Status& status, ProcessId process, const std::string& person) {
    ReleaseStop release;
    release.process = process;
    release.number = status.stops[static_cast<std::size_t>(process)].slot.number;
    release.person.set(person);
    return release;
}

/// The first process whose stop satisfies `wanted`.
template <class Wanted>
[[nodiscard]] std::optional<ProcessId> firstStopped(const Status& status, const Wanted& wanted) {
    const auto found = std::ranges::find_if(
        status.stops, [&](const StopStatus& stop) { return stop.slot.active() && wanted(stop.slot.kind); });
    return found == status.stops.end() ? std::nullopt
                                       : std::optional(static_cast<ProcessId>(found - status.stops.begin()));
}
/// A stop that a person may release after a look.
[[nodiscard]] inline std::optional<ProcessId> stoppedProcess(const Status& status) {
    return firstStopped(status, [](StopKind kind) { return kind != StopKind::InWork; });
}
/// A tap in the hole is not released: its page turns it out, or asks whether it is gone.
[[nodiscard]] inline std::optional<ProcessId> processInWork(const Status& status) {
    return firstStopped(status, [](StopKind kind) { return kind == StopKind::InWork; });
}

}  // namespace kerf::ui
