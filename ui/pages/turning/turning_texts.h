// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/process/turning/turning_types.h"
#include "ui/services/turning_service.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

inline constexpr int kSurfaceDecimals = 3;  ///< of µm: nanometres
inline constexpr int kForceDecimals = 3;
inline constexpr int kDepthDecimals = 2;
inline constexpr int kToneDecimals = 1;

[[nodiscard]] QString controllerName(TurningController controller);
[[nodiscard]] QString stageName(TurningStage stage);
/// "6.00 µm deep, 1032 rpm, 5.80 µm per revolution, tool radius 800 µm"
[[nodiscard]] QString setupText(const TurningSetup& setup, const UnitSystem& units);
/// "17.0, 52.0 Hz"; a dash when there is none.
[[nodiscard]] QString toneList(const TurningSetup& setup);

/// What a value of the recipe is called, and a stored text in words; null, empty: by its key, as it is stored.
[[nodiscard]] const ParamSpec* turningRecipeSpec(const TurningService& service, const std::string& key);
[[nodiscard]] QString turningRecipeWord(const std::string& key, const QString& stored);

}  // namespace kerf::ui
