// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ui/services/boring_service.h"

namespace kerf {

/// Diameters of a table in any dialect (docs/data.md): columns part, diameter_mm and, where there is one, overhang_mm.
/// What cannot be read stands in `problem`. Any thread.
[[nodiscard]] ReadBores readBores(const std::string& path);

}  // namespace kerf
