// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "ui/services/turning_service.h"

/// What the turning service keeps in the room records, as JSON; numbers under keys that end in their unit.
namespace kerf {

[[nodiscard]] std::string turningSetupJson(const TurningSetup& setup);
/// Empty: not a setup of this version, or one that cannot be cut.
[[nodiscard]] std::optional<TurningSetup> turningSetupFrom(const std::string& json);

[[nodiscard]] const char* turningControllerKey(TurningController controller) noexcept;
[[nodiscard]] std::string turningControllerJson(TurningController controller);
[[nodiscard]] std::optional<TurningController> turningControllerFrom(const std::string& json);

[[nodiscard]] std::string turningPartJson(const TurningPartView& part);
[[nodiscard]] std::optional<TurningPartView> turningPartFrom(const std::string& json);

}  // namespace kerf
