// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/api/status.h"

/// The figures of a finished part beside its measurements: declared once in its process's descriptor, stored under
/// their keys, shown by table, detail and export.
namespace kerf {

struct PartResult {
    const PartResultSpec* spec{nullptr};  ///< never null
    double value{0.0};
};

/// In the order a page shows them; the first is the one that matters.
[[nodiscard]] std::span<const PartResultRow> partResultRows(ProcessId process) noexcept;
/// Null: not a figure of this process (a file of a later version).
[[nodiscard]] const PartResultSpec* findPartResult(ProcessId process, std::string_view key) noexcept;
/// What this part has; figures that are not finite or do not apply are left out. Allocates: never in the cycle.
[[nodiscard]] std::vector<PartResult> partResults(const PartRecord& record);

}  // namespace kerf
