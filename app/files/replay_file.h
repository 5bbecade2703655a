// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/machine/replay/replay_machine.h"

namespace kerf::headless {

struct RecordedDay {
    std::vector<std::string> sensors{};
    std::unique_ptr<ReplayMachine> machine{};
};

/// A day file (docs/thermal.md, docs/sensors.md) as a machine. @throws BadInput with file, line and column
[[nodiscard]] RecordedDay readRecordedDay(const std::string& path);

}  // namespace kerf::headless
