// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/api/rows.h"

#include <algorithm>

namespace kerf {

const char* sourceKey(MeasurementSource source) noexcept {
    switch (source) {
        case MeasurementSource::Keypad:
            return "keypad";
        case MeasurementSource::Gauge:
            return "gauge";
        case MeasurementSource::File:
            break;
    }
    return "file";
}

std::vector<MeasurementRow> effectiveMeasurements(const std::vector<MeasurementRow>& rows) {
    std::vector<MeasurementRow> effective;
    // place[i]: where in `effective` the chain that row i belongs to sits; the rows are in order of acceptance, so a
    // row's predecessor is always before it.
    std::vector<std::size_t> place(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        place[i] = effective.size();
        if (rows[i].replaces) {
            const auto before =
                std::lower_bound(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(i), *rows[i].replaces,
                                 [](const MeasurementRow& row, MeasurementId id) { return row.id < id; });
            if (before != rows.begin() + static_cast<std::ptrdiff_t>(i) && before->id == *rows[i].replaces) {
                place[i] = place[static_cast<std::size_t>(before - rows.begin())];
                effective[place[i]] = rows[i];
                continue;
            }
        }
        effective.push_back(rows[i]);
    }
    std::erase_if(effective, [](const MeasurementRow& row) { return row.kind == MeasurementKind::Void; });
    return effective;
}

}  // namespace kerf
