// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace kerf::ui
