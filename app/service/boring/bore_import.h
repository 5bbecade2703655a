// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/service/boring/lot_records.h"

namespace kerf {

/// What taking these values over would do to the lot: a pure function, so that what is shown and what is done agree.
///
/// A row belongs to the depth of the recipe within kSamePlace_mm of its overhang; without an overhang only where a part
/// is measured at one depth. A value that is stored already is left out when it is the same, refused when it differs.
[[nodiscard]] BoreImportPlan planBores(const LotRecords& records, const ReadBores& read);

inline constexpr double kSamePlace_mm = 0.5;

/// The rows of a plan as they are stored: ids −1, −2 … until the store has given theirs.
/// @pre nothing of the plan is refused
[[nodiscard]] std::vector<MeasurementRow> importRows(const LotRecords& records, const BoreImportPlan& plan,
                                                     const std::string& file, const std::string& author);

}  // namespace kerf
