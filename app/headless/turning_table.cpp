// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/turning_table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "engine/process/turning/simulation.h"

namespace kerf::headless {
namespace {

using namespace kerf::turning;

struct Case {
    const char* title;
    double depth_um;
    double gainError;
    int extraDelay;
    double toneShift_Hz;
};
constexpr std::array<Case, 8> kCases{{{"disturbance", 0.0, 1.0, 0, 0.0},
                                      {"with 6 µm cut", 6.0, 1.0, 0, 0.0},
                                      {"gain +30 %", 6.0, 1.3, 0, 0.0},
                                      {"gain −30 %", 6.0, 0.7, 0, 0.0},
                                      {"one more delay", 6.0, 1.0, 1, 0.0},
                                      {".1 Hz off", 6.0, 1.0, 0, 0.1},
                                      {".5 Hz off", 6.0, 1.0, 0, 0.5},
                                      {"−.5 Hz off", 6.0, 1.0, 0, -0.5}}};

std::string cell(PlantKind plant, ControllerKind controller, const Case& what, int seeds, double& worstForce) {
    double rms = 0.0;
    double pv = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        SimulationParams params;
        params.plant = plant;
        params.depth_um = what.depth_um;
        params.gainError = what.gainError;
        params.extraDelay = what.extraDelay;
        params.seed = static_cast<std::uint64_t>(seed);
        (plant == PlantKind::B1 ? params.positionNoise_um : params.forceNoise_N) =
            plant == PlantKind::B1 ? 0.02 : 0.005;
        const auto disturbance = makeDisturbance(kPaperTones, 0.05, 10000, params.seed, what.toneShift_Hz);
        params.controller = ControllerKind::Open;
        const SimulationSummary open = summarise(simulate(params, disturbance)->rows);
        params.controller = controller;
        const SimulationSummary closed = summarise(simulate(params, disturbance)->rows);
        rms += 100.0 * (1.0 - closed.steady.rms_um / open.steady.rms_um) / seeds;
        pv += 100.0 * (1.0 - closed.steady.pv_um / open.steady.pv_um) / seeds;
        if (what.depth_um > 0.0) {
            worstForce = std::max(worstForce, 100.0 * std::abs(closed.meanForce_N / open.meanForce_N - 1.0));
        }
    }
    return fmt::format("{:.1f} / {:.1f}", rms, pv);
}

}  // namespace

void printTurningTable(int seeds) {
    std::string text = "| plant | controller |";
    std::string rule = "|---|---|";
    for (const Case& what : kCases) {
        text += fmt::format(" {} |", what.title);
        rule += "---|";
    }
    text += " largest change of the mean force, % |\n" + rule + "---|\n";
    for (const auto& [plantName, plant] : {std::pair{"b1", PlantKind::B1}, {"b2", PlantKind::B2}}) {
        for (const auto& [name, controller] : {std::pair{"open", ControllerKind::Open},
                                               {"paper", ControllerKind::Paper},
                                               {"pi", ControllerKind::Pi},
                                               {"default", ControllerKind::Default}}) {
            double worstForce = 0.0;
            text += fmt::format("| {} | {} |", plantName, name);
            for (const Case& what : kCases) {
                text += fmt::format(" {} |", cell(plant, controller, what, seeds, worstForce));
            }
            text += fmt::format(" {:.2f} |\n", worstForce);
        }
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace kerf::headless
