// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "db/api/rows.h"

namespace kerf::test {

/// A toy estimator whose state is a fold over the effective measurements: enough to tell whether a stored state belongs
/// to the stored measurements, and it changes with every one of them and with their order.
inline double foldOf(const std::vector<MeasurementRow>& rows) {
    double state = 0.0;
    for (const MeasurementRow& row : effectiveMeasurements(rows)) {
        state = 0.5 * state + row.diameter_mm.value_or(0.0);
    }
    return state;
}

/// What the victim acknowledges: "id kind part station diameter state".
inline std::string storyLine(const MeasurementRow& row, double state) {
    return fmt::format("{} {} {} {} {:.17g} {:.17g}", row.id, static_cast<int>(row.kind), row.part, row.station,
                       row.diameter_mm.value_or(0.0), state);
}

}  // namespace kerf::test
