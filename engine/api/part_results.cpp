// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/api/part_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace kerf {
namespace {

/// A figure with the place it comes from.
struct Row {
    PartResultSpec spec;
    std::optional<double> (*read)(const PartRecord&);
};

std::optional<double> ofTurning(const PartRecord& part, double value) {
    return part.turning.valid ? std::optional(value) : std::nullopt;
}

std::optional<double> ofSecondHalf(const PartRecord& part, double value) {
    return part.turning.valid && part.turning.steadyRms_um > 0.0 ? std::optional(value) : std::nullopt;
}

constexpr std::array kMilling{
    Row{{"waviness_um", KERF_TEXT("Waviness"), "um", 1},
        [](const PartRecord& p) { return std::optional(p.milling.waviness_um); }},
    Row{{"force_mean_N", KERF_TEXT("Mean force"), "N", 0},
        [](const PartRecord& p) { return std::optional(p.milling.meanForce_N); }},
    Row{{"force_peak_N", KERF_TEXT("Peak force"), "N", 0},
        [](const PartRecord& p) { return std::optional(p.milling.peakForce_N); }},
    Row{{"force_peak_at_mm", KERF_TEXT("Peak at"), "mm", 1},
        [](const PartRecord& p) { return std::optional(p.milling.peakAt_mm); }},
    Row{{"cut_time_s", KERF_TEXT("Time cut"), "s", 1},
        [](const PartRecord& p) { return std::optional(p.milling.cutTime_s); }},
    Row{{"planned_time_s", KERF_TEXT("Time at planned feed"), "s", 1},
        [](const PartRecord& p) { return std::optional(p.milling.plannedTime_s); }},
    Row{{"controlled_time_s", KERF_TEXT("Time under control"), "s", 1},
        [](const PartRecord& p) { return std::optional(p.milling.controlledTime_s); }},
    Row{{"saved_s", KERF_TEXT("Saved"), "s", 1},
        [](const PartRecord& p) { return std::optional(p.milling.plannedTime_s - p.milling.controlledTime_s); }},
    Row{{"reference_N", KERF_TEXT("Reference force"), "N", 0},
        [](const PartRecord& p) { return std::optional(p.milling.reference_N); }},
    Row{{"over_reference_s", KERF_TEXT("Time above reference"), "s", 1},
        [](const PartRecord& p) { return std::optional(p.milling.overReference_s); }},
    Row{{"stops", KERF_TEXT("Stops by the loop"), "", 0},
        [](const PartRecord& p) { return std::optional(static_cast<double>(p.milling.stops)); }},
    Row{{"stiffness", KERF_TEXT("Cutting stiffness ln(C b)"), "", 3},
        [](const PartRecord& p) { return std::optional(p.milling.stiffnessMean); }},
    Row{{"stiffness_half95", KERF_TEXT("Its 95 % half width"), "", 3},
        [](const PartRecord& p) { return std::optional(p.milling.stiffnessHalf95); }},
};

constexpr std::array kTurning{
    Row{{"surface_rms_um", KERF_TEXT("Surface RMS"), "um", 3},
        [](const PartRecord& p) { return ofTurning(p, p.turning.surfaceRms_um); }},
    Row{{"steady_rms_um", KERF_TEXT("RMS, second half"), "um", 3},
        [](const PartRecord& p) { return ofSecondHalf(p, p.turning.steadyRms_um); }},
    Row{{"steady_pv_um", KERF_TEXT("P-V, second half"), "um", 3},
        [](const PartRecord& p) { return ofSecondHalf(p, p.turning.steadyPv_um); }},
    Row{{"surface_pv_um", KERF_TEXT("Surface P-V"), "um", 3},
        [](const PartRecord& p) { return ofTurning(p, p.turning.surfacePv_um); }},
    Row{{"untreated_rms_um", KERF_TEXT("Without the loop"), "um", 3},
        [](const PartRecord& p) { return ofTurning(p, p.turning.untreatedRms_um); }},
    Row{{"force_mean_N", KERF_TEXT("Mean force"), "N", 3},
        [](const PartRecord& p) { return std::optional(p.forceMean_N); }},
    Row{{"force_peak_N", KERF_TEXT("Peak force"), "N", 3},
        [](const PartRecord& p) { return std::optional(p.forcePeak_N); }},
    Row{{"trim_peak_um", KERF_TEXT("Largest trim"), "um", 2},
        [](const PartRecord& p) { return ofTurning(p, p.turning.trimPeak_um); }},
    Row{{"touch_off_mm", KERF_TEXT("Touch-off"), "mm", 4},
        [](const PartRecord& p) { return ofTurning(p, p.turning.touchOff_mm); }},
    Row{{"controlled", KERF_TEXT("Under control"), "", 0},
        [](const PartRecord& p) { return ofTurning(p, p.turning.controlled ? 1.0 : 0.0); }},
};

constexpr std::array kTapping{
    Row{{"engaged_pp_um", KERF_TEXT("Error p-p in the work"), "um", 1},
        [](const PartRecord& p) { return std::optional(p.tap.figures.engagedPp_um); }},
    Row{{"tolerance_used_percent", KERF_TEXT("Tolerance used"), "%", 0},
        [](const PartRecord& p) { return std::optional(100.0 * p.tap.figures.engagedPp_um / p.tap.job.allowedPp_um); }},
    Row{{"saec_mm", KERF_TEXT("Sum of errors (SAEC)"), "mm", 2},
        [](const PartRecord& p) { return std::optional(p.tap.figures.saec_mm); }},
    Row{{"peak_um", KERF_TEXT("Largest error"), "um", 1},
        [](const PartRecord& p) { return std::optional(p.tap.figures.peak_um); }},
    Row{{"rms_um", KERF_TEXT("Error RMS"), "um", 2},
        [](const PartRecord& p) { return std::optional(p.tap.figures.rms_um); }},
    Row{{"speed_rpm", KERF_TEXT("Spindle speed"), "rpm", 0},
        [](const PartRecord& p) { return std::optional(p.tap.job.speed_rpm); }},
};

std::span<const Row> rowsOf(ProcessId process) noexcept {
    switch (process) {
        case ProcessId::Milling:
            return kMilling;
        case ProcessId::Turning:
            return kTurning;
        case ProcessId::Tapping:
            return kTapping;
        case ProcessId::Boring:  // measured after the cut: see measurements
        case ProcessId::Thermal:
            break;
    }
    return {};
}

template <std::size_t N>
constexpr std::array<PartResultSpec, N> specsOf(const std::array<Row, N>& rows) {
    std::array<PartResultSpec, N> specs{};
    std::ranges::transform(rows, specs.begin(), &Row::spec);
    return specs;
}

constexpr auto kMillingSpecs = specsOf(kMilling);
constexpr auto kTurningSpecs = specsOf(kTurning);
constexpr auto kTappingSpecs = specsOf(kTapping);

}  // namespace

std::span<const PartResultSpec> partResultSpecs(ProcessId process) noexcept {
    switch (process) {
        case ProcessId::Milling:
            return kMillingSpecs;
        case ProcessId::Turning:
            return kTurningSpecs;
        case ProcessId::Tapping:
            return kTappingSpecs;
        case ProcessId::Boring:
        case ProcessId::Thermal:
            break;
    }
    return {};
}

const PartResultSpec* findPartResult(ProcessId process, std::string_view key) noexcept {
    const auto specs = partResultSpecs(process);
    const auto found = std::ranges::find_if(specs, [key](const PartResultSpec& spec) { return spec.key == key; });
    return found == specs.end() ? nullptr : &*found;
}

std::vector<PartResult> partResults(const PartRecord& record) {
    std::vector<PartResult> results;
    const auto rows = rowsOf(record.process);
    const auto specs = partResultSpecs(record.process);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::optional<double> value = rows[i].read(record);
        if (value && std::isfinite(*value)) {
            results.push_back({&specs[i], *value});
        }
    }
    return results;
}

}  // namespace kerf
