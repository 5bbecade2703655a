// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace kerf::console {

/// Diagnostics: a rotating file beside the database and stderr. Qt's own messages go the same way.
void startLogging(const std::string& dataDir);

}  // namespace kerf::console
