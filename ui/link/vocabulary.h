// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/theme/look.h"

namespace kerf::ui {

/// A figure, axis or panel that has two names: one in shop words, one as engineers write it.
///
/// One table for all pages (vocabulary.cpp). Which of the two is shown is a matter of who looks (Look::wording).
enum class Term {
    // Boring
    BendingLaw,  ///< title of what the bores have taught
    FeedExponent,
    OverhangExponent,
    BendingConstant,
    // Milling
    StiffnessTitle,
    StiffnessAxis,
    StiffnessNow,
    ToolStiffness,
    ForceGainMargin,
    // Turning
    SurfaceRms,
    SurfacePv,
    UntreatedRms,
    MarginsTitle,
    GainMargin,
    PhaseMargin,
    DelayMargin,
    ModulusMargin,
    ForceMemory,  ///< a₁
    ForceOfDepthNow,
    ForceOfDepthBefore,
    Covariance,
    // Thermal
    DriftTitle,
    DriftOfAxis,  ///< %1 the axis
    DriftAxis,
    DriftKey,
    ModelRegression,
    ModelHierarchical,
    ModelNetwork,
    ModelNetworkAsPrinted,
    // Tapping
    GainsTitle,
    SpindleGain,
    ZGain,
    SpeedFeedForward,
    AccelFeedForward,
    ContourTitle,  ///< %1 the unit
    SumOfErrors,   ///< %1 the unit
    WidthOfError,  ///< %1 the unit
    Count
};

/// Its name, translated.
[[nodiscard]] QString termText(Term term, Wording wording);

}  // namespace kerf::ui
