// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace kerf::sensors {

struct ScanOptions {
    std::string host{};
    int port{502};
    int firstUnit{1};
    int lastUnit{32};
    int timeout_ms{300};
};

struct ScannedBlock {
    int function{4};
    int address{0};
    std::vector<std::uint16_t> registers{};
};

struct ScannedUnit {
    int unit{1};
    std::string identity{};  ///< vendor, product, revision, where the module tells (function 43)
    std::vector<ScannedBlock> blocks{};
};

/// Asks every unit for its first 64 input and holding registers, eight at a time, until it refuses. Reads only. Blocks,
/// with an event loop of its own; needs a QCoreApplication. The sentence: nothing takes a connection there.
[[nodiscard]] Result<std::vector<ScannedUnit>> scanModbus(const ScanOptions& options);

}  // namespace kerf::sensors
