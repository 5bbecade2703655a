// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/files/dfq.h"

namespace kerf::headless {

/// Reads DFQ files. A DFD and its DFX are one; whichever is named, the other one beside it is found, its suffix in
/// letters of any size. @throws BadInput with file, line and field
[[nodiscard]] std::vector<std::pair<std::string, dfq::File>> readDfqFiles(const std::vector<std::string>& paths,
                                                                          std::optional<dfq::SlashDates> dates = {});

/// Replaces the file last (files::writeFile): nobody sees half a file. @throws BadInput
void writeDfqFile(const std::string& path, const dfq::File& file);

}  // namespace kerf::headless
