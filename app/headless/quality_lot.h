// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/service/quality/lot_quality.h"

namespace kerf::headless {

/// A lot of a data file, with the limits that hold for its figures.
struct StoredLot {
    LotHistory history{};
    RecipeLimits limits{};
    std::vector<boring::AnnouncedChange> announced{};
};

/// By name, or by number when no lot has that name. @throws BadInput: no data file, no such lot, several of that name
[[nodiscard]] StoredLot storedLot(const std::string& folder, const std::string& lot);

}  // namespace kerf::headless
