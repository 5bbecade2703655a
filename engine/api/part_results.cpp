// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/api/part_results.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kerf {

std::span<const PartResultRow> partResultRows(ProcessId process) noexcept {
    const ProcessDescriptor* descriptor = findProcess(process);
    return descriptor != nullptr ? descriptor->partResults : std::span<const PartResultRow>{};
}

const PartResultSpec* findPartResult(ProcessId process, std::string_view key) noexcept {
    const auto rows = partResultRows(process);
    const auto found = std::ranges::find_if(rows, [key](const PartResultRow& row) { return row.spec.key == key; });
    return found == rows.end() ? nullptr : &found->spec;
}

std::vector<PartResult> partResults(const PartRecord& record) {
    std::vector<PartResult> results;
    for (const PartResultRow& row : partResultRows(record.process)) {
        const std::optional<double> value = row.read(record);
        if (value && std::isfinite(*value)) {
            results.push_back({&row.spec, *value});
        }
    }
    return results;
}

}  // namespace kerf
