// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/process/tapping/drive_params.h"

namespace kerf::headless {

/// A drive from a JSON object of the keys in driveKeys(); keys left out keep the reference value.
/// @throws BadInput for an unreadable file, an unknown key, or a value out of range.
[[nodiscard]] tapping::DriveParams readDriveFile(const std::string& path);

/// Puts KEY=VALUE settings of the command line in. @throws CLI::ValidationError naming the option.
void applyDriveSettings(tapping::DriveParams& drive, const std::string& option,
                        const std::vector<std::string>& settings);

/// One line per key with range and reference value, for --help.
[[nodiscard]] std::string driveKeyHelp();

}  // namespace kerf::headless
