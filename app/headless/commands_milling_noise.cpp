// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/files/output.h"
#include "app/headless/commands_milling.h"
#include "engine/process/milling/cut_simulation.h"
#include "engine/process/milling/drawn_blank.h"

namespace kerf::headless {
namespace {

constexpr double kLength_mm = 100.0;

enum class Blanks : std::uint8_t { Published, Drawn };
const std::map<std::string, Blanks> kBlanks{{"published", Blanks::Published}, {"drawn", Blanks::Drawn}};

struct NoiseOptions {
    int seeds{6};
    std::uint64_t firstSeed{0};
    Blanks blanks{Blanks::Published};
    int count{12};
    std::uint64_t blankSeed{1};
    bool summary{false};
};

struct NamedBlank {
    std::string name;
    milling::BlankProfile blank;
};

/// What of the signal comes late, by how many revolutions.
struct Lateness {
    bool all;
    int force_rev;
};

milling::BlankProfile equalSteps(const std::vector<double>& heights_mm) {
    return *milling::BlankProfile::ofSegments(heights_mm, kLength_mm / static_cast<double>(heights_mm.size()));
}

std::vector<NamedBlank> publishedBlanks() {
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
    return {{"stairs", equalSteps({1, 2, 3, 2, 1})}, {"ramp", equalSteps(ramp_mm)}, {"comb", equalSteps(comb_mm)}};
}

std::vector<NamedBlank> drawnBlanks(const NoiseOptions& options) {
    constexpr std::array kNames{"sine", "saw", "walk", "steps", "flat"};
    std::vector<NamedBlank> blanks;
    for (int i = 0; i < options.count; ++i) {
        const milling::DrawnBlank drawn = milling::drawnBlank(options.blankSeed, static_cast<std::uint64_t>(i));
        blanks.push_back({fmt::format("{} {}", i + 1, kNames[static_cast<std::size_t>(drawn.kind)]), drawn.blank});
    }
    return blanks;
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

/// How the rows of a table stand together.
class NoiseTally {
 public:
    void add(const NoiseOutcome& paper, const NoiseOutcome& ours) {
        const double ratio = ours.waviness_um / paper.waviness_um;
        const double peakRatio = ours.peak_kgf / paper.peak_kgf;
        ++m_rows;
        m_wavier += ratio > 1.0 ? 1 : 0;
        m_higher += peakRatio > 1.0 ? 1 : 0;
        m_sum += ratio;
        m_worst = std::max(m_worst, ratio);
        m_worstPeak = std::max(m_worstPeak, peakRatio);
    }
    void print() const {
        printJson(nlohmann::ordered_json{{"rows", m_rows},
                                         {"rows_wavier", m_wavier},
                                         {"rows_higher_peak", m_higher},
                                         {"mean_ratio_waviness", m_sum / m_rows},
                                         {"worst_ratio_waviness", m_worst},
                                         {"worst_ratio_peak", m_worstPeak}});
    }

 private:
    int m_rows{0}, m_wavier{0}, m_higher{0};
    double m_sum{0.0}, m_worst{0.0}, m_worstPeak{0.0};
};

void printNoiseTable(const NoiseOptions& options) {
    constexpr std::array kNoises_kgf{0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0};
    const bool drawn = options.blanks == Blanks::Drawn;
    std::vector<Lateness> latenesses{{false, 0}, {true, 0}};
    if (drawn) {
        latenesses.push_back({false, 1});
    }
    CsvOutput csv(
        "blank,late_revs,noise_kgf,waviness_pi_um,peak_pi_kgf,waviness_default_um,peak_default_kgf,worse,"
        "force_late_revs");
    NoiseTally tally;
    for (const NamedBlank& named : drawn ? drawnBlanks(options) : publishedBlanks()) {
        for (const Lateness& late : latenesses) {
            for (const double noise_kgf : kNoises_kgf) {
                milling::CutCase cut;
                cut.blank = named.blank;
                cut.controller.entryGuard = false;
                cut.wholePulses = true;
                cut.lag = late.all;
                cut.forceLate_rev = late.force_rev;
                cut.forceNoise_N = noise_kgf * kNewtonPerKilogramForce;
                const NoiseOutcome paper = milledBy(milling::LawKind::Pi, cut, options);
                const NoiseOutcome ours = milledBy(milling::LawKind::Model, cut, options);
                csv.row(named.name, late.all ? 1 : 0, noise_kgf, paper.waviness_um, paper.peak_kgf, ours.waviness_um,
                        ours.peak_kgf, ours.waviness_um > paper.waviness_um || ours.peak_kgf > paper.peak_kgf,
                        late.force_rev);
                tally.add(paper, ours);
            }
        }
    }
    if (options.summary) {
        tally.print();
    } else {
        csv.flush();
    }
}

}  // namespace

void addMillingNoise(CLI::App& milling) {
    auto options = std::make_shared<NoiseOptions>();
    CLI::App* command = milling.add_subcommand(
        "noise",
        "The default against the paper's PI, .75/.15, on B0 at 40 kgf, whole pulses: blanks, a noisy force, and\n"
        "everything measured one revolution late; means over the seeds.\n"
        "--blanks published (default): stairs, a ramp and a comb. --blanks drawn: sines, saws, walks, steps and a "
        "flat\n"
        "one from --blank-seed (docs/milling.md), and the force alone one revolution late as well.\n"
        "CSV: blank,late_revs,noise_kgf,waviness_pi_um,peak_pi_kgf,waviness_default_um,peak_default_kgf,worse (one of\n"
        "the two is above the PI's),force_late_revs. --summary, JSON: rows, rows_wavier, rows_higher_peak,\n"
        "mean_ratio_waviness, worst_ratio_waviness, worst_ratio_peak (default over PI).");
    command->add_option("--seeds", options->seeds, "seeds per row")->check(CLI::Range(1, 1000));
    command->add_option("--first-seed", options->firstSeed, "the first of them");
    command->add_option("--blanks", options->blanks, "published or drawn")
        ->transform(CLI::CheckedTransformer(kBlanks, CLI::ignore_case));
    command->add_option("--count", options->count, "drawn blanks")->check(CLI::Range(1, 1000));
    command->add_option("--blank-seed", options->blankSeed, "what they are drawn from");
    command->add_flag("--summary", options->summary, "the figures of all rows, as JSON");
    command->callback([options] { printNoiseTable(*options); });
}

}  // namespace kerf::headless
