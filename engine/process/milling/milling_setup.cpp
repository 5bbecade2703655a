// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/milling_setup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "engine/process/milling/plant.h"

namespace kerf::milling {
namespace {

constexpr const char* kPaper = KERF_TEXT("Oh and Jeong (1987)");
constexpr const char* kCalibrated = KERF_TEXT("calibrated on the published cuts");
constexpr const char* kShop = KERF_TEXT("set up with the machine");
constexpr const char* kProgram = KERF_TEXT("part program");

constexpr MillingSetup kDefault{};

template <auto Member>
constexpr MillingField field(const char* key, const char* label, const char* unit, double min, double max, int decimals,
                             const char* source) {
    using Value = std::remove_cvref_t<decltype(kDefault.*Member)>;
    return {{key, label, unit, min, max, static_cast<double>(kDefault.*Member), decimals, source},
            [](const MillingSetup& setup) { return static_cast<double>(setup.*Member); },
            [](MillingSetup& setup, double value) {
                if constexpr (std::is_floating_point_v<Value>) {
                    setup.*Member = value;
                } else {
                    setup.*Member = static_cast<Value>(std::lround(value));
                }
            }};
}

/// One row per number: key, label, unit, range, decimals, source; the default is MillingSetup's.
constexpr std::array kFields{
    field<&MillingSetup::reference_N>("milling.reference_n", KERF_TEXT("Reference force"), "N", 10.0, 20000.0, 0,
                                      kPaper),
    field<&MillingSetup::overload_N>("milling.overload_n", KERF_TEXT("Force limit"), "N", 11.0, 50000.0, 0, kShop),
    field<&MillingSetup::plannedFeed_mmPerS>("milling.planned_feed_mm_per_s", KERF_TEXT("Planned feed"), "mm/s", 0.01,
                                             500.0, 2, kProgram),
    field<&MillingSetup::highestFeed_mmPerS>("milling.highest_feed_mm_per_s", KERF_TEXT("Highest feed"), "mm/s", 0.01,
                                             1000.0, 2, kShop),
    field<&MillingSetup::lowestFeed_mmPerS>("milling.lowest_feed_mm_per_s", KERF_TEXT("Lowest feed"), "mm/s", 0.001,
                                            500.0, 2, kShop),
    field<&MillingSetup::entryFeed_mmPerS>("milling.entry_feed_mm_per_s", KERF_TEXT("Entry feed"), "mm/s", 0.001,
                                           1000.0, 2, kShop),
    field<&MillingSetup::spindleSpeed_rpm>("milling.spindle_speed_rpm", KERF_TEXT("Spindle speed"), "rpm", 60.0,
                                           12000.0, 0, kPaper),
    field<&MillingSetup::from_mm>("milling.from_mm", KERF_TEXT("Path start"), "mm", -10000.0, 10000.0, 1, kProgram),
    field<&MillingSetup::to_mm>("milling.to_mm", KERF_TEXT("Path end"), "mm", -9999.9, 20000.0, 1, kProgram),
    field<&MillingSetup::toolRadius_mm>("milling.tool_radius_mm", KERF_TEXT("Tool radius"), "mm", 0.1, 100.0, 2,
                                        kPaper),
    field<&MillingSetup::flutes>("milling.flutes", KERF_TEXT("Flutes"), "", 1.0, 16.0, 0, kPaper),
    field<&MillingSetup::exponent>("milling.exponent", KERF_TEXT("Material exponent"), "", 0.3, 1.0, 2, kPaper),
    field<&MillingSetup::forceAngle_deg>("milling.force_angle_deg", KERF_TEXT("Force angle"), "°", 5.0, 85.0, 0,
                                         kCalibrated),
    field<&MillingSetup::ky_NPerMm>("milling.ky_n_per_mm", KERF_TEXT("Across-wall stiffness"), "N/mm", 10.0, 1e6, 0,
                                    kCalibrated),
    field<&MillingSetup::kp_mmPerSPerN>("milling.kp_mm_per_s_per_n", KERF_TEXT("Proportional gain"), "mm/s/N", 1e-5,
                                        10.0, 5, kPaper),
    field<&MillingSetup::ki_mmPerSPerN>("milling.ki_mm_per_s_per_n", KERF_TEXT("Integral gain"), "mm/s/N", 0.0, 10.0, 5,
                                        kPaper),
    field<&MillingSetup::wearWarning>("milling.wear_warning", KERF_TEXT("Wear threshold"), "", 0.01, 2.0, 2, kShop),
};

/// The same limits, where they depend on other numbers of the setup.
std::optional<Sentence> whyInconsistent(const MillingSetup& s) noexcept {
    struct Row {
        const char* label;
        double value, low, high;
        int decimals;
    };
    const std::array rows{
        Row{KERF_TEXT("Force limit"), s.overload_N, 1.1 * s.reference_N, 50000.0, 0},
        Row{KERF_TEXT("Highest feed"), s.highestFeed_mmPerS, s.plannedFeed_mmPerS, 1000.0, 2},
        Row{KERF_TEXT("Lowest feed"), s.lowestFeed_mmPerS, 0.001, s.plannedFeed_mmPerS, 3},
        Row{KERF_TEXT("Entry feed"), s.entryFeed_mmPerS, s.lowestFeed_mmPerS, s.highestFeed_mmPerS, 2},
        Row{KERF_TEXT("Path end"), s.to_mm, s.from_mm + 0.1, 20000.0, 1},
        Row{KERF_TEXT("Integral gain"), s.ki_mmPerSPerN, 0.0, s.kp_mmPerSPerN, 5},
    };
    for (const Row& row : rows) {
        if (!(row.value >= row.low && row.value <= row.high)) {
            return Sentence(KERF_TEXT("%1 must be from %2 to %3."), SentenceArg(std::string_view(row.label)),
                            SentenceArg(row.low, row.decimals), SentenceArg(row.high, row.decimals));
        }
    }
    return std::nullopt;
}

}  // namespace

std::span<const MillingField> setupFields() noexcept {
    return kFields;
}

std::optional<Sentence> whyUnusable(const MillingSetup& s) noexcept {
    for (const MillingField& field : kFields) {
        if (auto why = whyOutOfRange(field.spec, field.get(s))) {
            return why;
        }
    }
    if (auto why = whyInconsistent(s)) {
        return why;
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
