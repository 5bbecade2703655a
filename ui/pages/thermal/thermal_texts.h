// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTableWidget>
#include <array>
#include <span>

#include "engine/api/status.h"
#include "ui/services/thermal_service.h"
#include "ui/shell/page.h"
#include "ui/theme/look.h"

namespace kerf::ui {

inline constexpr int kDriftDecimals = 1;
inline constexpr int kTemperatureDecimals = 1;
inline constexpr std::array<const char*, kAxisCount> kThermalAxes{"X", "Y", "Z"};

[[nodiscard]] QString coupleStateName(CoupleState state);
[[nodiscard]] QString modelKindName(const std::string& kind, Wording wording);
[[nodiscard]] QString minutesText(double minutes);
/// What a measurement leaves in a part, with its verdict: of an axis, of all three.
[[nodiscard]] QString leftText(const ThermalGapRow& row, std::size_t axis, const UnitSystem& units);
[[nodiscard]] QString leftText(const ThermalGapRow& row, const UnitSystem& units);
/// "0.2 / 0.5 / 1.4": one figure per axis in the shown unit.
[[nodiscard]] QString threeText(std::span<const double, kAxisCount> values_um, const UnitSystem& units, int decimals);
/// "ready for ±4.0 µm in 12 min", or what stands in the way.
[[nodiscard]] QString warmUpText(const ThermalStatus& status, const UnitSystem& units);
/// "T07, front bearing"
[[nodiscard]] QString sensorText(const ThermalSensorView& sensor);

/// A table of the house for sheets: rows to be touched, no selection, wrapped words.
[[nodiscard]] QTableWidget* makeThermalTable(Look& look, const char* name, const QStringList& titles, QWidget* parent);
void setTableRow(QTableWidget* table, int row, const QStringList& cells);

[[nodiscard]] KeyFigure thermalFigure(const Services& services, const Status& status);

}  // namespace kerf::ui
