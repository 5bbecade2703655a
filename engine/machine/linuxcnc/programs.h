// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "engine/core/result.h"
#include "engine/port/machine_port.h"

/// What is said to LinuxCNC to start one of the shipped subroutines (resources/linuxcnc). All numbers are plain
/// decimals.
namespace kerf::linuxcnc {

/// Revolutions from the start of a tapping cycle to the work: Z catches up with the spindle in the air.
inline constexpr double kTapRunUp_rev = 3.0;

/// The line for linuxcncrsh, or the reason why this program cannot be.
[[nodiscard]] Result<std::string> programLine(const StartProgram& start);
/// Total shift of the work origin, whole µm.
[[nodiscard]] std::string originShiftLine(const std::array<double, 3>& shift_um);
/// Asks the control to tell what it has shifted.
[[nodiscard]] std::string originReportLine();

}  // namespace kerf::linuxcnc
