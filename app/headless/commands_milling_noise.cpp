// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <vector>

#include "app/files/output.h"
#include "app/headless/commands_milling.h"
#include "engine/process/milling/cut_simulation.h"

namespace kerf::headless {
namespace {

constexpr double kLength_mm = 100.0;

struct NoiseOptions {
    int seeds{6};
    std::uint64_t firstSeed{0};
};

struct NamedBlank {
    const char* name;
    milling::BlankProfile blank;
};

milling::BlankProfile equalSteps(const std::vector<double>& heights_mm) {
    return *milling::BlankProfile::ofSegments(heights_mm, kLength_mm / static_cast<double>(heights_mm.size()));
}

std::array<NamedBlank, 3> blanks() {
    constexpr std::size_t kRampSteps = 200;
    constexpr std::size_t kCombSteps = 100;
    std::vector<double> ramp_mm;
    for (std::size_t i = 0; i < kRampSteps; ++i) {
        ramp_mm.push_back(1.0 + 2.0 * (static_cast<double>(i) + 0.5) / kRampSteps);
    }
    std::vector<double> comb_mm;
    for (std::size_t i = 0; i < kCombSteps; ++i) {
        comb_mm.push_back(i % 2 == 0 ? 1.0 : 3.0);
    }
    return {{{"stairs", equalSteps({1, 2, 3, 2, 1})}, {"ramp", equalSteps(ramp_mm)}, {"comb", equalSteps(comb_mm)}}};
}

/// Means over the seeds.
struct NoiseOutcome {
    double waviness_um{0.0}, peak_kgf{0.0};
};

NoiseOutcome milledBy(milling::LawKind law, const milling::CutCase& cutCase, const NoiseOptions& options) {
    NoiseOutcome mean;
    for (int i = 0; i < options.seeds; ++i) {
        milling::CutCase cut = cutCase;
        cut.law = law;
        cut.seed = options.firstSeed + static_cast<std::uint64_t>(i);
        const milling::CutSummary summary = milling::simulateCut(cut).summary;
        mean.waviness_um += (summary.waviness ? summary.waviness->spot_um : 0.0) / options.seeds;
        mean.peak_kgf += summary.peakForce_N / kNewtonPerKilogramForce / options.seeds;
    }
    return mean;
}

void printNoiseTable(const NoiseOptions& options) {
    constexpr std::array kNoises_kgf{0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0};
    CsvOutput csv("blank,late_revs,noise_kgf,waviness_pi_um,peak_pi_kgf,waviness_default_um,peak_default_kgf,worse");
    for (const NamedBlank& named : blanks()) {
        for (const bool late : {false, true}) {
            for (const double noise_kgf : kNoises_kgf) {
                milling::CutCase cut;
                cut.blank = named.blank;
                cut.controller.entryGuard = false;
                cut.wholePulses = true;
                cut.lag = late;
                cut.forceNoise_N = noise_kgf * kNewtonPerKilogramForce;
                const NoiseOutcome paper = milledBy(milling::LawKind::Pi, cut, options);
                const NoiseOutcome ours = milledBy(milling::LawKind::Model, cut, options);
                csv.row(named.name, late ? 1 : 0, noise_kgf, paper.waviness_um, paper.peak_kgf, ours.waviness_um,
                        ours.peak_kgf, ours.waviness_um > paper.waviness_um || ours.peak_kgf > paper.peak_kgf);
            }
        }
    }
    csv.flush();
}

}  // namespace

void addMillingNoise(CLI::App& milling) {
    auto options = std::make_shared<NoiseOptions>();
    CLI::App* command = milling.add_subcommand(
        "noise",
        "The default against the paper's PI, .75/.15, on B0 at 40 kgf, whole pulses: three blanks, a noisy force, and\n"
        "everything measured one revolution late; means over the seeds.\n"
        "CSV: blank,late_revs,noise_kgf,waviness_pi_um,peak_pi_kgf,waviness_default_um,peak_default_kgf,worse (one of\n"
        "the two is above the PI's)");
    command->add_option("--seeds", options->seeds, "seeds per row")->check(CLI::Range(1, 1000));
    command->add_option("--first-seed", options->firstSeed, "the first of them");
    command->callback([options] { printNoiseTable(*options); });
}

}  // namespace kerf::headless
