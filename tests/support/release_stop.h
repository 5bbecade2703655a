// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/command.h"
#include "engine/api/status.h"

namespace kerf::test {

/// A person who has looked releases the stop that stands for that process.
inline ReleaseStop releaseOf(const Status& status, ProcessId process, const char* person = "somebody") {
    ReleaseStop release;
    release.process = process;
    release.number = status.stops[static_cast<std::size_t>(process)].slot.number;
    release.person.set(person);
    return release;
}

}  // namespace kerf::test
