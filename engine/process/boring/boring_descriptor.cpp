// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/core/process.h"

namespace kerf {

// Its bores are measured after the cut: see measurements.
constinit const ProcessDescriptor kBoringProcess{
    .id = ProcessId::Boring,
    .key = "boring",
    .name = KERF_TEXT("Boring"),
    .may = {.feedScale = true},
};

}  // namespace kerf
