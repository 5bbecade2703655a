// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>

#include "engine/api/status.h"
#include "engine/core/process.h"

namespace kerf {
namespace {

constexpr std::array kPartResults{
    PartResultRow{{"engaged_pp_um", KERF_TEXT("Error p-p in the work"), "um", 1},
                  [](const PartRecord& p) { return std::optional(p.tap.figures.engagedPp_um); }},
    PartResultRow{
        {"tolerance_used_percent", KERF_TEXT("Tolerance used"), "%", 0},
        [](const PartRecord& p) { return std::optional(100.0 * p.tap.figures.engagedPp_um / p.tap.job.allowedPp_um); }},
    PartResultRow{{"saec_mm", KERF_TEXT("Sum of errors (SAEC)"), "mm", 2},
                  [](const PartRecord& p) { return std::optional(p.tap.figures.saec_mm); }},
    PartResultRow{{"peak_um", KERF_TEXT("Largest error"), "um", 1},
                  [](const PartRecord& p) { return std::optional(p.tap.figures.peak_um); }},
    PartResultRow{{"rms_um", KERF_TEXT("Error RMS"), "um", 2},
                  [](const PartRecord& p) { return std::optional(p.tap.figures.rms_um); }},
    PartResultRow{{"speed_rpm", KERF_TEXT("Spindle speed"), "rpm", 0},
                  [](const PartRecord& p) { return std::optional(p.tap.job.speed_rpm); }},
};

}  // namespace

constinit const ProcessDescriptor kTappingProcess{
    .id = ProcessId::Tapping,
    .key = "tapping",
    .name = KERF_TEXT("Tapping"),
    .may = {.servo = true},
    .partResults = kPartResults,
};

}  // namespace kerf
