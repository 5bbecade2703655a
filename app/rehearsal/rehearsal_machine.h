// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/rehearsal/scenario.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "engine/process/thermal/thermal_model.h"

namespace kerf::rehearsal {

/// The built-in machine of the scenario, as the console runs it, with the scenario's seed.
[[nodiscard]] std::unique_ptr<SimulatedMachine> simulatedMachine(const Scenario& scenario);
/// What a person has trained before he rehearses the thermal loop: a model of that machine's simulated days.
[[nodiscard]] std::optional<thermal::ThermalModel> trainedModel(const Scenario& scenario);

}  // namespace kerf::rehearsal
