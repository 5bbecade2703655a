// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/core/result.h"

namespace kerf::console {

/// Diagnostics: a rotating file beside the database and stderr. Qt's own messages go the same way. Error: the file
/// cannot be opened for writing.
[[nodiscard]] Result<void> startLogging(const std::string& dataDir);

}  // namespace kerf::console
