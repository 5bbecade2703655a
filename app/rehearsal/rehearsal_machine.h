// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/rehearsal/scenario.h"
#include "engine/machine/simulated/simulated_machine.h"

namespace kerf::rehearsal {

/// The built-in machine of the scenario, as the console runs it, with the scenario's seed.
[[nodiscard]] std::unique_ptr<SimulatedMachine> simulatedMachine(const Scenario& scenario);

}  // namespace kerf::rehearsal
