// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/rehearsal/rehearsal_machine.h"

#include <array>

#include "engine/machine/simulated/simulated_boring.h"
#include "engine/machine/simulated/simulated_milling.h"
#include "engine/machine/simulated/simulated_tapping.h"
#include "engine/machine/simulated/simulated_thermal.h"
#include "engine/machine/simulated/simulated_turning.h"
#include "engine/process/thermal/plant/simulated_day.h"
#include "engine/process/thermal/training.h"

namespace kerf::rehearsal {
namespace {

constexpr std::int64_t kLatheCycle_ns = 200'000;

}  // namespace

std::unique_ptr<SimulatedMachine> simulatedMachine(const Scenario& scenario) {
    std::vector<std::unique_ptr<SimulatedProcess>> plants;
    SimulatedMachine::Params machine;
    machine.limits = scenario.limits;
    if (scenario.machine == MachineKind::DiamondLathe) {
        machine.name = "Kerf diamond lathe";
        machine.cycle_ns = kLatheCycle_ns;
        SimulatedTurning::Params turning;
        turning.seed = scenario.seed;
        plants.push_back(std::make_unique<SimulatedTurning>(turning));
        plants.push_back(std::make_unique<SimulatedThermal>(
            SimulatedThermal::Params{SimulatedThermal::kDiamondLathe, scenario.seed}));
    } else {
        constexpr std::array kHeights_mm{1.0, 2.0, 3.0, 2.0, 1.0};  // the published experiment's blank
        constexpr double kSegment_mm = 20.0;
        plants.push_back(std::make_unique<SimulatedBoring>(SimulatedBoring::Params{}));
        SimulatedMilling::Params milling;
        milling.blanks = {milling::BlankProfile::ofSegments(kHeights_mm, kSegment_mm)->inAir(true, true)};
        milling.seed = scenario.seed;
        plants.push_back(std::make_unique<SimulatedMilling>(milling));
        SimulatedTapping::Params tapping;
        tapping.noise_um = 2.0;
        tapping.loadSpread = 0.2;
        tapping.frictionSpread = 0.1;
        tapping.seed = scenario.seed;
        plants.push_back(std::make_unique<SimulatedTapping>(tapping));
        plants.push_back(std::make_unique<SimulatedThermal>(
            SimulatedThermal::Params{SimulatedThermal::kMachiningCentre, scenario.seed}));
    }
    return std::make_unique<SimulatedMachine>(machine, std::move(plants));
}

std::optional<thermal::ThermalModel> trainedModel(const Scenario& scenario) {
    const std::uint64_t machine = scenario.machine == MachineKind::DiamondLathe ? SimulatedThermal::kDiamondLathe
                                                                                : SimulatedThermal::kMachiningCentre;
    auto trained = thermal::trainRegression(thermal::trainingDays(machine), {});
    return trained ? std::optional(std::move(*trained)) : std::nullopt;
}

}  // namespace kerf::rehearsal
