// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/core/param_spec.h"
#include "engine/process/milling/milling_types.h"

namespace kerf {

/// One number of MillingSetup that a person can change: unit, range, default, source and where it stands.
struct MillingField {
    ParamSpec spec{};
    double (*get)(const MillingSetup&){nullptr};
    void (*set)(MillingSetup&, double){nullptr};
};

}  // namespace kerf
