// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>

#include "engine/api/status.h"
#include "engine/core/process.h"

namespace kerf {
namespace {

std::optional<double> ofTurning(const PartRecord& part, double value) {
    return part.turning.valid ? std::optional(value) : std::nullopt;
}

std::optional<double> ofSecondHalf(const PartRecord& part, double value) {
    return part.turning.valid && part.turning.steadyRms_um > 0.0 ? std::optional(value) : std::nullopt;
}

constexpr std::array kPartResults{
    PartResultRow{{"surface_rms_um", KERF_TEXT("Surface RMS"), "um", 3},
                  [](const PartRecord& p) { return ofTurning(p, p.turning.surfaceRms_um); }},
    PartResultRow{{"steady_rms_um", KERF_TEXT("RMS, second half"), "um", 3},
                  [](const PartRecord& p) { return ofSecondHalf(p, p.turning.steadyRms_um); }},
    PartResultRow{{"steady_pv_um", KERF_TEXT("P-V, second half"), "um", 3},
                  [](const PartRecord& p) { return ofSecondHalf(p, p.turning.steadyPv_um); }},
    PartResultRow{{"surface_pv_um", KERF_TEXT("Surface P-V"), "um", 3},
                  [](const PartRecord& p) { return ofTurning(p, p.turning.surfacePv_um); }},
    PartResultRow{{"untreated_rms_um", KERF_TEXT("Without the loop"), "um", 3},
                  [](const PartRecord& p) { return ofTurning(p, p.turning.untreatedRms_um); }},
    PartResultRow{{"force_mean_N", KERF_TEXT("Mean force"), "N", 3},
                  [](const PartRecord& p) { return std::optional(p.forceMean_N); }},
    PartResultRow{{"force_peak_N", KERF_TEXT("Peak force"), "N", 3},
                  [](const PartRecord& p) { return std::optional(p.forcePeak_N); }},
    PartResultRow{{"trim_peak_um", KERF_TEXT("Largest trim"), "um", 2},
                  [](const PartRecord& p) { return ofTurning(p, p.turning.trimPeak_um); }},
    PartResultRow{{"touch_off_mm", KERF_TEXT("Touch-off"), "mm", 4},
                  [](const PartRecord& p) { return ofTurning(p, p.turning.touchOff_mm); }},
    PartResultRow{{"controlled", KERF_TEXT("Under control"), "", 0},
                  [](const PartRecord& p) { return ofTurning(p, p.turning.controlled ? 1.0 : 0.0); }},
};

}  // namespace

constinit const ProcessDescriptor kTurningProcess{
    .id = ProcessId::Turning,
    .key = "turning",
    .name = KERF_TEXT("Turning"),
    .may = {.toolTrim = true},
    .partResults = kPartResults,
};

}  // namespace kerf
