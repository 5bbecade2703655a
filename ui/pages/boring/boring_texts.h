// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "ui/link/verdict_text.h"
#include "ui/services/boring_service.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

inline constexpr int kDiameterDecimals = 3;  ///< of the stored mm
inline constexpr int kFeedDecimals = 3;      ///< of the stored mm/rev

/// "top", "middle", "bottom" in the operator's language; any other name as it is.
[[nodiscard]] QString depthName(const DepthView& depth);
/// "part 7, top"
[[nodiscard]] QString placeName(std::uint32_t partNumber, const DepthView& depth);
[[nodiscard]] QString diameterText(double diameter_mm, const UnitSystem& units);

/// A bore that is too small can be bored again; without a tolerance nothing is judged.
[[nodiscard]] quality::Verdict boreVerdict(const BoringServiceView& view, double diameter_mm);
/// "Below 49.985 mm: rework possible." and the like; empty when it is good or not judged.
[[nodiscard]] QString outOfToleranceText(const BoringServiceView& view, double diameter_mm, const UnitSystem& units);

/// "new insert", "tool reground", "other material".
[[nodiscard]] QString changeName(BoringChange change);

/// The measurement of a depth that holds now; null while there is none.
[[nodiscard]] const BoreMeasurementView* measurementAt(const BorePartView& part, std::uint8_t depth);
[[nodiscard]] const BorePartView* findPart(const BoringServiceView& view, PartId id);
/// The newest measurement that holds, with its part; nulls while there is none.
struct LastMeasurement {
    const BorePartView* part{nullptr};
    const BoreMeasurementView* measurement{nullptr};
};
[[nodiscard]] LastMeasurement lastMeasurement(const BoringServiceView& view);

}  // namespace kerf::ui
