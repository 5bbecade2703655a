// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/milling/milling_setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/milling/plant.h"

namespace kerf::milling {
std::optional<Sentence> whyUnusable(const MillingSetup& s) noexcept {
    struct Row {
        const char* label;
        double value, low, high;
        int decimals;
    };
    const std::array rows{
        Row{KERF_TEXT("Reference force"), s.reference_N, 10.0, 20000.0, 0},
        Row{KERF_TEXT("Force limit"), s.overload_N, 1.1 * s.reference_N, 50000.0, 0},
        Row{KERF_TEXT("Planned feed"), s.plannedFeed_mmPerS, 0.01, 500.0, 2},
        Row{KERF_TEXT("Highest feed"), s.highestFeed_mmPerS, s.plannedFeed_mmPerS, 1000.0, 2},
        Row{KERF_TEXT("Lowest feed"), s.lowestFeed_mmPerS, 0.001, s.plannedFeed_mmPerS, 2},
        Row{KERF_TEXT("Entry feed"), s.entryFeed_mmPerS, s.lowestFeed_mmPerS, s.highestFeed_mmPerS, 2},
        Row{KERF_TEXT("Spindle speed"), s.spindleSpeed_rpm, 60.0, 12000.0, 0},
        Row{KERF_TEXT("Path start"), s.from_mm, -10000.0, 10000.0, 1},
        Row{KERF_TEXT("Path end"), s.to_mm, s.from_mm + 0.1, 20000.0, 1},
        Row{KERF_TEXT("Tool radius"), s.toolRadius_mm, 0.1, 100.0, 2},
        Row{KERF_TEXT("Flutes"), static_cast<double>(s.flutes), 1.0, 16.0, 0},
        Row{KERF_TEXT("Material exponent"), s.exponent, 0.3, 1.0, 2},
        Row{KERF_TEXT("Force angle"), s.forceAngle_deg, 5.0, 85.0, 0},
        Row{KERF_TEXT("Across-wall stiffness"), s.ky_NPerMm, 10.0, 1e6, 0},
        Row{KERF_TEXT("Proportional gain"), s.kp_mmPerSPerN, 1e-6, 10.0, 5},
        Row{KERF_TEXT("Integral gain"), s.ki_mmPerSPerN, 0.0, s.kp_mmPerSPerN, 5},
        Row{KERF_TEXT("Wear threshold"), s.wearWarning, 0.01, 2.0, 2},
    };
    for (const Row& row : rows) {
        if (!(row.value >= row.low && row.value <= row.high)) {
            return Sentence(KERF_TEXT("%1 must be from %2 to %3."), SentenceArg(std::string_view(row.label)),
                            SentenceArg(row.low, row.decimals), SentenceArg(row.high, row.decimals));
        }
    }
    if (static_cast<std::size_t>(s.law) >= kMillingLawCount || s.revision == 0) {
        return Sentence(KERF_TEXT("The milling setup is not complete."));
    }
    return std::nullopt;
}

std::optional<Sentence> whyUnusable(const MillingBlank& blank) noexcept {
    if (blank.count == 0) {
        return std::nullopt;
    }
    const std::size_t count = std::min<std::size_t>(blank.count, MillingBlank::kMaxSteps);
    const Result<BlankProfile> profile = BlankProfile::ofSteps(std::span(blank.begin_mm).first(count),
                                                               std::span(blank.height_mm).first(count), blank.end_mm);
    return profile && count == blank.count ? std::nullopt
           : profile ? std::optional(Sentence(KERF_TEXT("A blank profile needs from 1 to %1 steps."),
                                              SentenceArg(static_cast<double>(MillingBlank::kMaxSteps), 0)))
                     : std::optional(profile.error());
}

BlankProfile profileOf(const MillingBlank& blank) noexcept {
    if (blank.count == 0) {
        return {};
    }
    const Result<BlankProfile> profile = BlankProfile::ofSteps(
        std::span(blank.begin_mm).first(blank.count), std::span(blank.height_mm).first(blank.count), blank.end_mm);
    return profile ? profile->inAir(true, true) : BlankProfile();
}

FeedController::Params controllerParams(const MillingSetup& s) noexcept {
    FeedController::Params params;
    params.reference_N = s.reference_N;
    params.programmedFeed_mmPerS = s.plannedFeed_mmPerS;
    params.entryFeed_mmPerS = s.entryFeed_mmPerS;
    params.range = {s.lowestFeed_mmPerS, s.highestFeed_mmPerS};
    params.pi = {s.kp_mmPerSPerN, s.ki_mmPerSPerN, 60.0 / s.spindleSpeed_rpm};
    params.stiffness.assume.exponent = s.exponent;
    params.stiffness.assume.forceAngle_deg = s.forceAngle_deg;
    params.stiffness.airForce_N = 0.05 * s.reference_N;
    params.stiffness.assume.meanShare = 0.5;
    params.toolRadius_mm = s.toolRadius_mm;
    return params;
}

CutRecord::Params recordParams(const MillingSetup& s) noexcept {
    CutRecord::Params params;
    params.planned_mmPerS = s.plannedFeed_mmPerS;
    params.reference_N = s.reference_N;
    params.ky_NPerMm = s.ky_NPerMm;
    params.airForce_N = 0.05 * s.reference_N;
    params.exit_mm = s.toolRadius_mm;
    return params;
}

InversionModel inversionModel(const MillingSetup& s, const StiffnessEstimate& stiffness) noexcept {
    return {s.exponent, s.forceAngle_deg, stiffness.kx_NPerMm};
}

double gainMargin(const MillingSetup& s, MillingLaw law, const StiffnessEstimate& stiffness,
                  double revolution_s) noexcept {
    if (!stiffness.valid || law == MillingLaw::Constant || revolution_s <= 0.0) {
        return 0.0;
    }
    const Inversion plan = invert(inversionModel(s, stiffness), stiffness.lnCb, s.reference_N, s.reference_N);
    PlantParams plant;
    plant.exponent = s.exponent;
    plant.forceAngle_deg = s.forceAngle_deg;
    plant.kx_NPerMm = stiffness.kx_NPerMm;
    plant.ky_NPerMm = s.ky_NPerMm;
    plant.cuttingCoefficient = std::exp(stiffness.lnCb);                                 // C b, at a depth of one
    const LinearForm form = linearForm(plant, 1.0, plan.steady_mmPerRev, revolution_s);  // u in mm/s
    const double a1 = form.a1Tangent;
    if (law == MillingLaw::Pi) {
        const double alpha = (s.kp_mmPerSPerN - s.ki_mmPerSPerN) / s.kp_mmPerSPerN;
        const double k0 = s.kp_mmPerSPerN * (60.0 / s.spindleSpeed_rpm) / revolution_s;
        const double loop = k0 * form.b0Tangent_NPerUnit;
        return std::min(2.0 * (1.0 + a1) / (loop * (1.0 + alpha)), (1.0 + a1) / (loop * std::max(alpha, 1e-3)));
    }
    return (1.0 + a1) / (a1 * ModelLawParams().backOff);
}

}  // namespace kerf::milling
