// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/core/param_spec.h"
#include "engine/process/boring/estimator.h"
#include "engine/process/boring/feed_law.h"
#include "ui/services/boring_lots.h"
#include "ui/services/boring_service.h"

namespace kerf {

/// All that is known beforehand about boring one part type. Stored as JSON under the keys of its ParamSpecs.
///
/// The default is the built-in machine's: ⌀ 50 ± .015 mm, gauged to 5 µm, measured at 40 and 310 mm overhang.
struct BoringRecipe {
    double targetDiameter_mm{50.0};
    double lowerTolerance_mm{49.985};  ///< diameter, absolute
    double upperTolerance_mm{50.015};
    double targetDeflection_mm{boring::kTableTargetDeflection_mm};  ///< d0
    double phi_deg{boring::kTablePhi_deg};                          ///< φ of eq. 11
    double sigma_mm{0.005};                                         ///< standard deviation of one measured deflection
    double alpha0{0.5};                                             ///< paper's estimator only
    double firstFeed_mmPerRev{0.5};
    double minFeed_mmPerRev{0.01};
    double maxFeed_mmPerRev{1.0};
    double overhangFrom_mm{boring::kTableOverhangFrom_mm};
    double overhangTo_mm{boring::kTableOverhangTo_mm};
    double spindleSpeed_rpm{400.0};
    double memory{1.0};            ///< 1: a lot begins from the lots before it; 0: from the prior below
    double shopMemory{0.0};        ///< 1: and from lots of the same part type on the shop's other machines
    double firstPartTeaches{0.0};  ///< 1: without a past the feed varies along the first part; 0: first feed
    double priorLnC{boring::KalmanParams{}.prior.lnC};  ///< the wide prior: what is known of any boring spindle
    double priorAlpha{boring::KalmanParams{}.prior.alpha};
    double priorBeta{boring::KalmanParams{}.prior.beta};
    double priorLevelSpread{boring::KalmanParams{}.priorSpread.level};
    double priorAlphaSpread{boring::KalmanParams{}.priorSpread.alpha};
    double priorBetaSpread{boring::KalmanParams{}.priorSpread.beta};
    double settingRing_mm{
        0.0};  ///< of a comparator gauge, whose readings are deviations from it; 0: it shows diameters
    std::vector<DepthView> depths{{"top", boring::kTableOverhangFrom_mm}, {"bottom", boring::kTableOverhangTo_mm}};

    [[nodiscard]] boring::EstimatorParams estimator(boring::EstimatorKind kind) const;
    [[nodiscard]] bool usesMemory() const noexcept { return memory >= 0.5; }
    [[nodiscard]] bool drawsOnShop() const noexcept { return usesMemory() && shopMemory >= 0.5; }
    [[nodiscard]] bool teaches() const noexcept { return firstPartTeaches >= 0.5; }
    [[nodiscard]] boring::FeedLawParams feedLaw(boring::EstimatorKind kind) const;
    /// Of a lot that has drawn on memory: where its law is known too badly for the tolerance, the feed aims within it.
    [[nodiscard]] boring::FeedLawParams feedLawWithMemory() const;
};

/// The numbers of a recipe, in the order a page shows them.
[[nodiscard]] std::span<const ParamSpec> boringRecipeSpecs();
/// Empty when usable.
[[nodiscard]] std::optional<Sentence> whyInvalid(const BoringRecipe& recipe);

[[nodiscard]] BoringRecipeForm recipeForm(const BoringRecipe& recipe);
/// Not checked; see whyInvalid(). @pre one value per spec
[[nodiscard]] BoringRecipe recipeOf(const BoringRecipeForm& form);
/// What changes from one to the other, in the order of the specs, depths last.
[[nodiscard]] std::vector<BoringRecipeChange> recipeChanges(const BoringRecipe& before, const BoringRecipe& after);

[[nodiscard]] std::string recipeJson(const BoringRecipe& recipe);
/// Missing keys take their defaults; a value out of range or of the wrong kind gives the sentence.
[[nodiscard]] Result<BoringRecipe> recipeFromJson(const std::string& text);

}  // namespace kerf
