// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_recipe.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/service/setup_keys.h"

namespace kerf {
namespace {

constexpr const char* kDepths = "boring.depths";
constexpr const char* kDrawing = KERF_TEXT("drawing of the part");
constexpr const char* kTable = KERF_TEXT("table 1 of Lee (1983)");
constexpr const char* kShop = KERF_TEXT("set up with the machine");
constexpr const char* kPrior = KERF_TEXT("wide guess for any boring spindle about table 1 of Lee (1983)");
constexpr const char* kMemory = "boring.memory";

struct Field {
    ParamSpec spec;
    double BoringRecipe::*value;
};

/// One row per number: key, label, unit, range, default, decimals, source.
const std::array<Field, 23>& fields() {
    using R = BoringRecipe;
    static const R kDefault{};
    static const std::array<Field, 23> kFields{{
        {{"boring.target_diameter_mm", KERF_TEXT("Target diameter"), "mm", 1.0, 2000.0, kDefault.targetDiameter_mm, 3,
          kDrawing},
         &R::targetDiameter_mm},
        {{"boring.lower_tolerance_mm", KERF_TEXT("Smallest diameter"), "mm", 1.0, 2000.0, kDefault.lowerTolerance_mm, 3,
          kDrawing},
         &R::lowerTolerance_mm},
        {{"boring.upper_tolerance_mm", KERF_TEXT("Largest diameter"), "mm", 1.0, 2000.0, kDefault.upperTolerance_mm, 3,
          kDrawing},
         &R::upperTolerance_mm},
        {{"boring.target_deflection_mm", KERF_TEXT("Target deflection"), "mm", 0.001, 5.0, kDefault.targetDeflection_mm,
          4, kTable},
         &R::targetDeflection_mm},
        {{"boring.phi_deg", KERF_TEXT("Angle of the deflection"), "°", 0.0, 89.0, kDefault.phi_deg, 1, kTable},
         &R::phi_deg},
        {{"boring.sigma_mm", KERF_TEXT("Standard deviation of the gauge"), "mm", 0.0001, 1.0, kDefault.sigma_mm, 4,
          kShop},
         &R::sigma_mm},
        {{"boring.alpha0", KERF_TEXT("Feed exponent by experience"), "", 0.01, 1.0, kDefault.alpha0, 2, kTable},
         &R::alpha0},
        {{"boring.first_feed_mm_per_rev", KERF_TEXT("Feed of the first part"), "mm/rev", 0.005, 2.0,
          kDefault.firstFeed_mmPerRev, 3, kTable},
         &R::firstFeed_mmPerRev},
        {{"boring.min_feed_mm_per_rev", KERF_TEXT("Lowest feed"), "mm/rev", 0.001, 2.0, kDefault.minFeed_mmPerRev, 3,
          kShop},
         &R::minFeed_mmPerRev},
        {{"boring.max_feed_mm_per_rev", KERF_TEXT("Highest feed"), "mm/rev", 0.001, 5.0, kDefault.maxFeed_mmPerRev, 3,
          kShop},
         &R::maxFeed_mmPerRev},
        {{"boring.overhang_from_mm", KERF_TEXT("Overhang at the top"), "mm", 1.0, 5000.0, kDefault.overhangFrom_mm, 1,
          kTable},
         &R::overhangFrom_mm},
        {{"boring.overhang_to_mm", KERF_TEXT("Overhang at the bottom"), "mm", 1.0, 5000.0, kDefault.overhangTo_mm, 1,
          kTable},
         &R::overhangTo_mm},
        {{"boring.spindle_speed_rpm", KERF_TEXT("Spindle speed"), "rpm", 1.0, 20000.0, kDefault.spindleSpeed_rpm, 0,
          kShop},
         &R::spindleSpeed_rpm},
        {{kMemory, KERF_TEXT("Begin from earlier lots (1 yes, 0 no)"), "", 0.0, 1.0, kDefault.memory, 0, kShop},
         &R::memory},
        {{"boring.shop_memory", KERF_TEXT("Draw on other machines' lots in the shop (1 yes, 0 no)"), "", 0.0, 1.0,
          kDefault.shopMemory, 0, kShop},
         &R::shopMemory},
        {{"boring.first_part_teaches", KERF_TEXT("First part teaches (1 yes, 0 no)"), "", 0.0, 1.0,
          kDefault.firstPartTeaches, 0, kShop},
         &R::firstPartTeaches},
        {{"boring.prior_ln_c", KERF_TEXT("Prior: ln C"), "", -20.0, 10.0, kDefault.priorLnC, 4, kPrior}, &R::priorLnC},
        {{"boring.prior_alpha", KERF_TEXT("Prior: feed exponent α"), "", 0.05, 2.0, kDefault.priorAlpha, 3, kPrior},
         &R::priorAlpha},
        {{"boring.prior_beta", KERF_TEXT("Prior: overhang exponent β"), "", -2.0, 5.0, kDefault.priorBeta, 4, kPrior},
         &R::priorBeta},
        {{"boring.prior_level_spread", KERF_TEXT("Prior: spread of the level"), "", 0.05, 3.0,
          kDefault.priorLevelSpread, 2, kPrior},
         &R::priorLevelSpread},
        {{"boring.prior_alpha_spread", KERF_TEXT("Prior: spread of α"), "", 0.01, 1.0, kDefault.priorAlphaSpread, 2,
          kPrior},
         &R::priorAlphaSpread},
        {{"boring.prior_beta_spread", KERF_TEXT("Prior: spread of β"), "", 0.01, 2.0, kDefault.priorBetaSpread, 2,
          kPrior},
         &R::priorBetaSpread},
        {{"boring.setting_ring_mm", KERF_TEXT("Setting ring of a comparator (0: it shows diameters)"), "mm", 0.0,
          2000.0, kDefault.settingRing_mm, 4, kShop},
         &R::settingRing_mm},
    }};
    return kFields;
}

}  // namespace

boring::EstimatorParams BoringRecipe::estimator(boring::EstimatorKind kind) const {
    boring::EstimatorParams params = boring::estimatorParams(kind, sigma_mm, targetDeflection_mm, alpha0);
    params.kalman.prior = {priorLnC, priorAlpha, priorBeta};
    params.kalman.priorSpread = {priorLevelSpread, priorAlphaSpread, priorBetaSpread};
    return params;
}

boring::FeedLawParams BoringRecipe::feedLaw(boring::EstimatorKind kind) const {
    boring::FeedLawParams law = boring::feedLawParams(kind, targetDeflection_mm, firstFeed_mmPerRev);
    law.minFeed_mmPerRev = minFeed_mmPerRev;
    law.maxFeed_mmPerRev = maxFeed_mmPerRev;
    law.overhangFrom_mm = overhangFrom_mm;
    law.overhangTo_mm = overhangTo_mm;
    law.spindleSpeed_rpm = spindleSpeed_rpm;
    return law;
}

boring::FeedLawParams BoringRecipe::feedLawWithMemory() const {
    constexpr double kLeastAllowed = 0.05;  // of d0, where the largest diameter wants less bending than there can be
    boring::FeedLawParams law = feedLaw(boring::EstimatorKind::Kalman);
    const auto deflection = [&](double diameter_mm) {
        return boring::deflectionFromDiameter_mm(diameter_mm, targetDiameter_mm, targetDeflection_mm, phi_deg);
    };
    law.allowedFrom_mm = std::max(kLeastAllowed * targetDeflection_mm, deflection(upperTolerance_mm));
    law.allowedTo_mm = deflection(lowerTolerance_mm);
    return law;
}

std::span<const ParamSpec> boringRecipeSpecs() {
    static const auto kSpecs = [] {
        std::array<ParamSpec, std::tuple_size_v<std::remove_cvref_t<decltype(fields())>>> specs{};
        for (std::size_t i = 0; i < specs.size(); ++i) {
            specs[i] = fields()[i].spec;
        }
        return specs;
    }();
    return kSpecs;
}

std::optional<Sentence> whyInvalid(const BoringRecipe& recipe) {
    for (const Field& field : fields()) {
        if (const auto why = whyOutOfRange(field.spec, recipe.*field.value)) {
            return why;
        }
    }
    if (!(recipe.lowerTolerance_mm < recipe.targetDiameter_mm && recipe.targetDiameter_mm < recipe.upperTolerance_mm)) {
        return Sentence(KERF_TEXT("The target diameter must lie between the smallest and the largest one."));
    }
    if (!(recipe.minFeed_mmPerRev < recipe.maxFeed_mmPerRev)) {
        return Sentence(KERF_TEXT("The lowest feed must be below the highest one."));
    }
    if (!(recipe.overhangFrom_mm < recipe.overhangTo_mm)) {
        return Sentence(KERF_TEXT("The overhang at the top must be below the one at the bottom."));
    }
    if (recipe.depths.empty() || recipe.depths.size() > kMaxBoreDepths) {
        return Sentence(KERF_TEXT("A bore is measured at 1 to %1 depths."), SentenceArg(kMaxBoreDepths, 0));
    }
    for (std::size_t i = 0; i < recipe.depths.size(); ++i) {
        const double overhang_mm = recipe.depths[i].overhang_mm;
        const auto same = [&](const DepthView& other) { return other.overhang_mm == overhang_mm; };
        if (!(overhang_mm >= recipe.overhangFrom_mm && overhang_mm <= recipe.overhangTo_mm) ||
            std::count_if(recipe.depths.begin(), recipe.depths.end(), same) > 1) {
            return Sentence(KERF_TEXT("Depths must differ and lie inside the bore; %1 mm does not."),
                            SentenceArg(overhang_mm, 1));
        }
    }
    return std::nullopt;
}

BoringRecipeForm recipeForm(const BoringRecipe& recipe) {
    BoringRecipeForm form;
    for (const Field& field : fields()) {
        form.values.push_back(recipe.*field.value);
    }
    form.depths = recipe.depths;
    return form;
}

BoringRecipe recipeOf(const BoringRecipeForm& form) {
    BoringRecipe recipe;
    for (std::size_t i = 0; i < fields().size(); ++i) {
        recipe.*fields()[i].value = form.values[i];
    }
    recipe.depths = form.depths;
    return recipe;
}

std::vector<BoringRecipeChange> recipeChanges(const BoringRecipe& before, const BoringRecipe& after) {
    std::vector<BoringRecipeChange> changes;
    for (std::size_t i = 0; i < fields().size(); ++i) {
        const double old = before.*fields()[i].value;
        const double now = after.*fields()[i].value;
        if (old != now) {
            changes.push_back({&boringRecipeSpecs()[i], 0, old, now});
        }
    }
    const auto overhang_mm = [](const BoringRecipe& recipe, std::size_t i) {
        return i < recipe.depths.size() ? std::optional(recipe.depths[i].overhang_mm) : std::nullopt;
    };
    for (std::size_t i = 0; i < std::max(before.depths.size(), after.depths.size()); ++i) {
        if (overhang_mm(before, i) != overhang_mm(after, i)) {
            changes.push_back(
                {nullptr, static_cast<std::uint32_t>(i + 1), overhang_mm(before, i), overhang_mm(after, i)});
        }
    }
    return changes;
}

std::string recipeJson(const BoringRecipe& recipe) {
    nlohmann::ordered_json json;
    for (const Field& field : fields()) {
        json[field.spec.key] = recipe.*field.value;
    }
    for (const DepthView& depth : recipe.depths) {
        json[kDepths].push_back({{"name", depth.name}, {"overhang_mm", depth.overhang_mm}});
    }
    return json.dump();
}

Result<BoringRecipe> recipeFromJson(const std::string& text) {
    BoringRecipe recipe;
    try {
        const auto json = nlohmann::json::parse(text);
        for (const Field& field : fields()) {
            recipe.*field.value = numberOr(json, field.spec.key, field.spec.fallback, "boring recipe");
        }
        if (!json.contains(kMemory)) {
            recipe.memory = 0.0;  // written before there was one: its lots go on as they began
        }
        if (json.contains(kDepths)) {
            recipe.depths.clear();
            for (const auto& depth : json.at(kDepths)) {
                recipe.depths.push_back({depth.at("name").get<std::string>(), depth.at("overhang_mm").get<double>()});
            }
        }
    } catch (const nlohmann::json::exception&) {
        return fail(KERF_TEXT("The part type's parameters cannot be read; they need numbers under their keys."));
    }
    if (const auto why = whyInvalid(recipe)) {
        return tl::unexpected(*why);
    }
    return recipe;
}

}  // namespace kerf
