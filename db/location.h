// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace kerf::db {

/// The user's data folder: $XDG_DATA_HOME/kerf, else ~/.local/share/kerf. The same for both programs.
[[nodiscard]] std::string defaultDataFolder();

/// The data file inside a data folder.
[[nodiscard]] std::string databaseFile(const std::string& folder);

}  // namespace kerf::db
