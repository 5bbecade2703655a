// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "engine/core/result.h"

namespace kerf {

/// A number a person can change: unit, range, default, decimals and source, declared once.
///
/// Pages build their fields from it, commands and files are checked against it, the headless program prints it.
struct ParamSpec {
    const char* key{""};    ///< "boring.target_diameter_mm": stored under this name
    const char* label{""};  ///< KERF_TEXT
    const char* unit{""};   ///< stored unit: "mm", "N", "s", "degC", "um", "" for a ratio
    double min{0.0};
    double max{0.0};
    double fallback{0.0};  ///< default value
    int decimals{3};
    const char* source{""};  ///< KERF_TEXT: where the default comes from
};

/// Empty when `value` is finite and inside the range; else the sentence for the operator.
[[nodiscard]] std::optional<Sentence> whyOutOfRange(const ParamSpec& spec, double value);

}  // namespace kerf
