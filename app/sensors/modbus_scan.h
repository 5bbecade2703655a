// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/sentence.h"

namespace kerf::sensors {

/// What `kerf sensors scan` says of an address, behind it.
inline constexpr const char* kNoConnection =
    KERF_TEXT("nothing takes a connection there; expected a Modbus TCP module that is switched on.");
inline constexpr const char* kNoAddress =
    KERF_TEXT("that is no address; expected HOST or HOST:PORT, PORT from 1 to 65535.");

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
