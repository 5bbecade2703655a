// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/services/milling_service.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

inline constexpr int kForceDecimals = 0;
inline constexpr int kFeedRateDecimals = 2;
inline constexpr int kWallDecimals = 1;
inline constexpr int kStiffnessDecimals = 2;

/// Name of a law on its button, and as a sentence's part.
[[nodiscard]] QString lawName(MillingLaw law);

/// Saved or lost time in words: "12 s faster than planned".
[[nodiscard]] QString savedText(double saved_s);

/// One cut in a sentence: times, peak and where, waviness; advised cuts say what control would have done.
[[nodiscard]] QString cutText(const MillingCutView& cut, const UnitSystem& units);

/// What a value of the recipe is called, and a stored text in words; null, empty: by its key, as it is stored.
[[nodiscard]] const ParamSpec* millingRecipeSpec(const MillingService& service, const std::string& key);
[[nodiscard]] QString millingRecipeWord(const std::string& key, const QString& stored);

}  // namespace kerf::ui
