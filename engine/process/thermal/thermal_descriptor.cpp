// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/core/process.h"

namespace kerf {

constinit const ProcessDescriptor kThermalProcess{
    .id = ProcessId::Thermal,
    .key = "thermal",
    .name = KERF_TEXT("Thermal"),
    .may = {.workOffset = true},
    .makesParts = false,
};

}  // namespace kerf
