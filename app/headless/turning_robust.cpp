// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/turning_robust.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "app/files/output.h"
#include "app/files/whole_file.h"
#include "app/headless/robust_table.h"
#include "engine/process/turning/blind.h"
#include "engine/process/turning/hard_lathe.h"
#include "engine/process/turning/simulation.h"

namespace kerf::headless {
namespace {

using namespace turning;

constexpr std::size_t kSamples = 10000;  // 2 s
constexpr double kTimesOpenLoop = 3.0;   // and more: unstable
constexpr double kTwoPoints = 0.02;      // of the open loop

struct TurningRobustOptions {
    RobustOptions shared{};
    std::string plant;  ///< empty: b1 and b2
};

SimulationSummary runOf(const HardLathe& lathe, PlantKind plant, ControllerKind controller,
                        std::span<const double> disturbance_um, std::uint64_t seed) {
    SimulationParams params;
    params.plant = plant;
    params.controller = controller;
    params.process = lathe.process;
    params.slidePole = lathe.slidePole;
    params.extraDelay = lathe.extraDelay;
    params.depth_um = lathe.depth_um;
    params.seed = seed;
    params.revolutionSamples = samplesPerRevolution(lathe.spindle_rps, kSampleRate_Hz);
    if (plant == PlantKind::B1) {
        params.positionNoise_um = lathe.positionNoise_um;
    } else {
        params.forceNoise_N = lathe.forceNoise_N;
    }
    const auto result = simulate(params, disturbance_um);
    if (!result) throw files::BadInput(result.error().english());
    return summarise(result->rows);
}

/// RMS of the disturbance about its mean over the whole run: what the open loop leaves once the cut stands.
double movedBy_um(std::span<const double> disturbance_um) {
    double sum_um = 0.0;
    double square_um2 = 0.0;
    for (const double d_um : disturbance_um) {
        sum_um += d_um;
        square_um2 += d_um * d_um;
    }
    const auto count = static_cast<double>(disturbance_um.size());
    return std::sqrt(std::max(square_um2 / count - std::pow(sum_um / count, 2), 0.0));
}

std::string kindsOf(const HardLathe& lathe) {
    std::string text;
    for (std::size_t i = 0; i < lathe.kindCount; ++i) {
        text += i > 0 ? "+" : "";
        text += kDisturbanceNames[static_cast<std::size_t>(lathe.kinds[i])];
    }
    return text;
}

void turningRobust(const TurningRobustOptions& options) {
    CsvOutput csv(
        "machine_seed,plant,disturbance,rms_open_um,rms_paper_um,rms_pi_um,rms_default_um,ratio,worse,"
        "unstable_default,unstable_simple");
    RobustTally tally;
    double byTwoPoints = 0.0;
    double worseThanOpen = 0.0;
    double runs = 0.0;
    for (std::uint32_t i = 1; i <= options.shared.machines; ++i) {
        const HardLathe lathe = hardLathe(options.shared.machineSeed(i));
        const std::vector<double> disturbance_um = disturbanceOf(lathe, kSamples);
        for (const auto& [name, plant] : {std::pair{"b1", PlantKind::B1}, {"b2", PlantKind::B2}}) {
            if (!options.plant.empty() && options.plant != name) continue;
            const auto summary = [&](ControllerKind controller) {
                return runOf(lathe, plant, controller, disturbance_um, options.shared.seed);
            };
            const auto rms_um = [&](ControllerKind controller) { return summary(controller).steady.rms_um; };
            const double open_um = rms_um(ControllerKind::Open);
            const double moved_um = movedBy_um(disturbance_um);
            const double paper_um = rms_um(ControllerKind::Paper);
            const double pi_um = rms_um(ControllerKind::Pi);
            const double ours_um = rms_um(ControllerKind::Default);
            const auto runsAway = [&](double value_um) { return !(value_um < kTimesOpenLoop * moved_um); };
            const double simple_um = std::min(paper_um, pi_um);
            const double ratio = ours_um / simple_um;
            const bool bothRunAway = runsAway(paper_um) && runsAway(pi_um);
            csv.row(lathe.seed, name, kindsOf(lathe), open_um, paper_um, pi_um, ours_um, ratio, ratio > 1.0,
                    runsAway(ours_um), bothRunAway);
            tally.add({ratio, ratio > 1.0, runsAway(ours_um), bothRunAway});
            runs += 1.0;
            byTwoPoints += ours_um > simple_um + kTwoPoints * open_um ? 1.0 : 0.0;
            worseThanOpen += ours_um > open_um ? 1.0 : 0.0;
        }
    }
    if (options.shared.csv) {
        csv.flush();
        return;
    }
    nlohmann::ordered_json json{{"machines", options.shared.machines}, {"seed", options.shared.seed}};
    for (const auto& [name, value] : tally.figures())
        json[name] = value;
    json["share_worse_by_two_points"] = byTwoPoints / runs;
    json["share_worse_than_open"] = worseThanOpen / runs;
    printJson(json);
}

}  // namespace

void addTurningRobust(CLI::App& turning) {
    auto options = std::make_shared<TurningRobustOptions>();
    CLI::App* command = turning.add_subcommand(
        "robust",
        "Hard lathes, each drawn from a seed of its own (docs/turning.md), on b1 and b2: the default law against the "
        "better of pi and paper.\n"
        "--csv: machine_seed (for simulate --machine-seed --seconds 2), plant, disturbance, RMS of the second half in "
        "um of\n"
        "  open, paper, pi and default, ratio (default over the better PI), worse, unstable (above three times the "
        "open "
        "loop).\n"
        "  Without it, JSON: share_worse, worst_ratio, share_unstable and more.");
    options->shared.addTo(*command);
    command->add_option("--plant", options->plant, "b1 or b2 alone")->check(CLI::IsMember({"b1", "b2"}));
    command->callback([options] { turningRobust(*options); });
}

}  // namespace kerf::headless
