// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/core/result.h"
#include "engine/port/machine_port.h"

/// What is said to LinuxCNC to start one of the shipped subroutines (resources/linuxcnc). All numbers are plain
/// decimals.
namespace kerf::linuxcnc {

/// Revolutions from the start of a tapping cycle to the work: Z catches up with the spindle in the air.
inline constexpr double kTapRunUp_rev = 3.0;

/// What a program declares itself as, over M68 E3: whose it is, and which start of Kerf's it answers (its request's
/// number; 0: a person has started it). Never 0.
inline constexpr std::uint32_t kDeclaredStarts = 8;
[[nodiscard]] constexpr std::uint32_t startNumber(std::uint32_t request) noexcept {
    return request == 0 ? 0 : 1 + request % 10'000;
}
[[nodiscard]] constexpr std::uint32_t declaration(ProcessId process, std::uint32_t request) noexcept {
    return static_cast<std::uint32_t>(process) + 1 + kDeclaredStarts * startNumber(request);
}

/// The line for linuxcncrsh, or the reason why this program cannot be.
[[nodiscard]] Result<std::string> programLine(const StartProgram& start, std::uint32_t request = 0);
/// Total shift of the work origin, whole µm.
[[nodiscard]] std::string originShiftLine(const std::array<double, 3>& shift_um);
/// Asks the control to tell what it has shifted.
[[nodiscard]] std::string originReportLine();

}  // namespace kerf::linuxcnc
