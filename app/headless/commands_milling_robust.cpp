// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "app/files/output.h"
#include "app/headless/commands_milling.h"
#include "app/headless/robust_table.h"
#include "engine/process/milling/hard_machine.h"

namespace kerf::headless {
namespace {

/// One machine under one law.
struct CutOutcome {
    double waviness_um{0.0}, peak_N{0.0};
    bool unstable{false};
};

CutOutcome milledBy(milling::LawKind law, const milling::HardMachine& machine, std::uint64_t noiseSeed) {
    constexpr double kFromAir_mm = 5.0;
    milling::CutCase cut;
    milling::putOn(machine, cut);
    cut.law = law;
    cut.wholePulses = true;
    cut.fromAir_mm = kFromAir_mm;
    cut.seed = noiseSeed;
    const milling::CutResult result = milling::simulateCut(cut);
    return {result.summary.waviness ? result.summary.waviness->spot_um : 0.0, result.summary.peakForce_N,
            milling::unstable(result, cut.controller.reference_N)};
}

void millingRobust(const RobustOptions& options) {
    CsvOutput csv(
        "machine_seed,waviness_default_um,waviness_simple_um,force_max_default_n,force_max_simple_n,ratio,ratio_force,"
        "worse,unstable_default,unstable_simple,noise_n,late,axis_lag_s,kx_n_per_mm,m,theta_deg");
    RobustTally tally;
    double waviness_um[2]{};
    double peak_N[2]{};
    double wavier = 0.0, higher = 0.0;
    double worstPeakRatio = 0.0;
    for (std::uint32_t i = 1; i <= options.machines; ++i) {
        const std::uint64_t seed = options.machineSeed(i);
        const milling::HardMachine machine = milling::hardMachine(seed);
        const CutOutcome ours = milledBy(milling::LawKind::Model, machine, options.seed);
        const CutOutcome simple = milledBy(milling::LawKind::Pi, machine, options.seed);
        const double ratio = ours.waviness_um / simple.waviness_um;
        const double peakRatio = ours.peak_N / simple.peak_N;
        const bool worse = ratio > 1.0 || peakRatio > 1.0;
        csv.row(seed, ours.waviness_um, simple.waviness_um, ours.peak_N, simple.peak_N, ratio, peakRatio, worse,
                ours.unstable, simple.unstable, machine.forceNoise_N, machine.late, machine.axisLag_s,
                machine.plant.kx_NPerMm, machine.plant.exponent, machine.plant.forceAngle_deg);
        tally.add({ratio, worse, ours.unstable, simple.unstable});
        waviness_um[0] += ours.waviness_um / options.machines;
        waviness_um[1] += simple.waviness_um / options.machines;
        peak_N[0] += ours.peak_N / options.machines;
        peak_N[1] += simple.peak_N / options.machines;
        wavier += ratio > 1.0 ? 1.0 / options.machines : 0.0;
        higher += peakRatio > 1.0 ? 1.0 / options.machines : 0.0;
        worstPeakRatio = std::max(worstPeakRatio, peakRatio);
    }
    if (options.csv) {
        csv.flush();
        return;
    }
    nlohmann::ordered_json json{{"machines", options.machines},
                                {"seed", options.seed},
                                {"waviness_mean_default_um", waviness_um[0]},
                                {"waviness_mean_simple_um", waviness_um[1]},
                                {"force_max_mean_default_n", peak_N[0]},
                                {"force_max_mean_simple_n", peak_N[1]},
                                {"share_wavier", wavier},
                                {"share_higher_force", higher},
                                {"worst_ratio_force", worstPeakRatio}};
    for (const auto& [name, value] : tally.figures()) {
        json[name] = value;
    }
    printJson(json);
}

}  // namespace

void addMillingRobust(CLI::App& milling) {
    auto options = std::make_shared<RobustOptions>();
    CLI::App* command = milling.add_subcommand(
        "robust",
        "Hard machines, each drawn from a seed of its own (docs/milling.md): the default against the paper's PI, "
        ".75/.15, "
        "on the same cut at 40 kgf, whole pulses, from 5 mm before the blank.\n"
        "--csv: machine_seed (for simulate "
        "--machine-seed),waviness_default_um,waviness_simple_um,force_max_default_n,\n"
        "  force_max_simple_n,ratio (of the waviness),ratio_force,worse (one of the two is above 1),unstable_default,\n"
        "  unstable_simple (the cut does not end, or the force swings by more than half the reference in its second "
        "half),\n"
        "  and what was drawn. Without it, JSON: share_worse, worst_ratio, share_unstable and means.");
    options->addTo(*command);
    command->callback([options] { millingRobust(*options); });
}

}  // namespace kerf::headless
