// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/api/status.h"
#include "ui/services/tapping_service.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

inline constexpr int kErrorDecimals = 1;  ///< of µm
inline constexpr int kGainDecimals = 2;

/// "1/4-20 UNC"; "M8 × 1.25", the pitch in mm in every unit system: it is the thread's name.
[[nodiscard]] QString threadText(const TapThreadView& thread);
/// "M8 × 1.25, 3000 rpm, 22 rev, gear 1".
[[nodiscard]] QString choiceText(const TapChoice& choice, const TapThreadView& thread);
[[nodiscard]] QString stateText(const TappingServiceView& view);
/// "12.3 µm", with as many decimals as the size has room for.
[[nodiscard]] QString errorText(double error_um, const UnitSystem& units);
/// Three figures: "220", "26.6", "0.42".
[[nodiscard]] int decimalsFor(double value);
/// Where the gains in force come from, one sentence.
[[nodiscard]] QString sourceText(const TappingServiceView& view);
/// Before and after in one line; empty without a proof.
[[nodiscard]] QString proofText(const TappingServiceView& view, const UnitSystem& units);

}  // namespace kerf::ui
