// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>

#include "engine/api/status.h"
#include "engine/core/process.h"

namespace kerf {
namespace {

constexpr std::array kPartResults{
    PartResultRow{{"waviness_um", KERF_TEXT("Waviness"), "um", 1},
                  [](const PartRecord& p) { return std::optional(p.milling.waviness_um); }},
    PartResultRow{{"force_mean_N", KERF_TEXT("Mean force"), "N", 0},
                  [](const PartRecord& p) { return std::optional(p.milling.meanForce_N); }},
    PartResultRow{{"force_peak_N", KERF_TEXT("Peak force"), "N", 0},
                  [](const PartRecord& p) { return std::optional(p.milling.peakForce_N); }},
    PartResultRow{{"force_peak_at_mm", KERF_TEXT("Peak at"), "mm", 1},
                  [](const PartRecord& p) { return std::optional(p.milling.peakAt_mm); }},
    PartResultRow{{"cut_time_s", KERF_TEXT("Time cut"), "s", 1},
                  [](const PartRecord& p) { return std::optional(p.milling.cutTime_s); }},
    PartResultRow{{"planned_time_s", KERF_TEXT("Time at planned feed"), "s", 1},
                  [](const PartRecord& p) { return std::optional(p.milling.plannedTime_s); }},
    PartResultRow{{"controlled_time_s", KERF_TEXT("Time under control"), "s", 1},
                  [](const PartRecord& p) { return std::optional(p.milling.controlledTime_s); }},
    PartResultRow{
        {"saved_s", KERF_TEXT("Saved"), "s", 1},
        [](const PartRecord& p) { return std::optional(p.milling.plannedTime_s - p.milling.controlledTime_s); }},
    PartResultRow{{"reference_N", KERF_TEXT("Reference force"), "N", 0},
                  [](const PartRecord& p) { return std::optional(p.milling.reference_N); }},
    PartResultRow{{"over_reference_s", KERF_TEXT("Time above reference"), "s", 1},
                  [](const PartRecord& p) { return std::optional(p.milling.overReference_s); }},
    PartResultRow{{"stops", KERF_TEXT("Stops by the loop"), "", 0},
                  [](const PartRecord& p) { return std::optional(static_cast<double>(p.milling.stops)); }},
    PartResultRow{{"stiffness", KERF_TEXT("Cutting stiffness ln(C b)"), "", 3},
                  [](const PartRecord& p) { return std::optional(p.milling.stiffnessMean); }},
    PartResultRow{{"stiffness_half95", KERF_TEXT("Its 95 % half width"), "", 3},
                  [](const PartRecord& p) { return std::optional(p.milling.stiffnessHalf95); }},
};

}  // namespace

constinit const ProcessDescriptor kMillingProcess{
    .id = ProcessId::Milling,
    .key = "milling",
    .name = KERF_TEXT("Milling"),
    .may = {.feedScale = true},
    .partResults = kPartResults,
};

}  // namespace kerf
