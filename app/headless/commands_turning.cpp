// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <ranges>
#include <string>
#include <vector>

#include "app/files/output.h"
#include "app/files/slip.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/read_options.h"
#include "app/headless/turning_robust.h"
#include "app/headless/turning_table.h"
#include "engine/process/turning/blind.h"
#include "engine/process/turning/hard_lathe.h"
#include "engine/process/turning/identifier.h"
#include "engine/process/turning/margins.h"
#include "engine/process/turning/overlap.h"
#include "engine/process/turning/simulation.h"

namespace kerf::headless {
namespace {

using namespace kerf::turning;

template <class T>
T valueOrThrow(const Result<T>& result) {
    if (!result) {
        throw BadInput(result.error().english());
    }
    return *result;
}

// ── overlap ─────────────────────────────────────────────────────────────────────────────────────────────────────────

struct OverlapOptions {
    double toolRadius_um{0.0};
    double depth_um{0.0};
    double infeed_um{0.0};
};

void addOverlap(CLI::App& turning) {
    auto options = std::make_shared<OverlapOptions>();
    CLI::App* command = turning.add_subcommand("overlap", "Overlap factor of tool radius, depth and infeed, as JSON.");
    command->add_option("--tool-radius-um", options->toolRadius_um, "Tool nose radius in um")->required();
    command->add_option("--depth-um", options->depth_um, "Depth of cut in um")->required();
    command->add_option("--infeed-um", options->infeed_um, "Feed per revolution in um")->required();
    command->callback([options] {
        printJson(
            {{"overlap", valueOrThrow(overlapFactor(options->toolRadius_um, options->depth_um, options->infeed_um))}});
    });
}

// ── identify ────────────────────────────────────────────────────────────────────────────────────────────────────────

constexpr double kLeastChip_um = 0.02;  ///< below it nothing cuts; a chip of some µm written in mm is smaller

struct IdentifyOptions {
    std::string file;
    std::shared_ptr<files::ReadOptions> read{};
    ProcessIdentifier::Params params{};
};

/// Samples are told apart by their number; one that is missing would misalign all that follow it.
void requireConsecutive(const Table& table, const std::vector<double>& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (std::abs(samples[i]) > 1e15) {
            throw BadInput(
                fmt::format("{}{} is out of range; expected a sample number.", table.where(i, "k"), samples[i]));
        }
        if (i > 0 && samples[i] != samples[i - 1] + 1.0) {
            throw BadInput(fmt::format("{}{} follows {}; expected every sample, in order.", table.where(i, "k"),
                                       samples[i], samples[i - 1]));
        }
    }
}

/// A diamond tool takes some .01 to 10 N per µm of chip: what is a thousand away is in mN or in kN.
void requireNewtons(const Table& table, const std::vector<double>& force_N, double largestChip_um, bool accepted) {
    constexpr double kLeast_NPerUm = 5e-4;
    constexpr double kMost_NPerUm = 50.0;
    const double largest_N = std::ranges::max(force_N | std::views::transform([](double f) { return std::abs(f); }));
    if (!(largestChip_um > 0.0) || largest_N == 0.0) {
        return;
    }
    const double ratio_NPerUm = largest_N / largestChip_um;
    if (ratio_NPerUm < kLeast_NPerUm || ratio_NPerUm > kMost_NPerUm) {
        files::refuseUnless(
            accepted, table,
            fmt::format("{}the largest force is {:.4g} at chips of {:.4g} µm; expected N, not {}.",
                        table.where(0, "f_n"), largest_N, largestChip_um, ratio_NPerUm < kLeast_NPerUm ? "kN" : "mN"));
    }
}

void addIdentify(CLI::App& turning) {
    auto options = std::make_shared<IdentifyOptions>();
    CLI::App* command = turning.add_subcommand(
        "identify", "Recursive identification of the cutting process from a file k,u_um,f_n: k,a1,b0,b1,trace as CSV.");
    command->add_option("file", options->file, "CSV with the columns k, u_um (uncut chip), f_n (force)")->required();
    command->add_option("--lambda", options->params.forgetting, "Forgetting factor, 0.5 to 1")->required();
    const std::map<std::string, Forgetting> methods{{"paper", Forgetting::Plain}, {"default", Forgetting::Robust}};
    command
        ->add_option("--method", options->params.method, "paper: plain forgetting; default: bounded (docs/turning.md)")
        ->transform(CLI::CheckedTransformer(methods));
    command->add_option("--p0", options->params.initialVariance, "Diagonal of the first covariance")
        ->capture_default_str();
    options->read = addReadOptions(*command);
    command->callback([options] {
        if (const auto why = ProcessIdentifier::whyInvalid(options->params)) {
            throw BadInput(why->english());
        }
        const Table table = Table::read(options->file, *options->read);  // a hole would misalign what follows it
        if (table.rows() == 0) {
            throw BadInput(fmt::format("{}: no samples; expected rows under the header.", table.file()));
        }
        const auto& samples = table.column("k");
        const auto& chip_um = table.column("u_um");
        const auto& force_N = table.column("f_n");
        requireConsecutive(table, samples);
        const auto largest_um = std::ranges::max(chip_um | std::views::transform([](double u) { return std::abs(u); }));
        if (largest_um > 0.0 && largest_um < kLeastChip_um) {
            files::refuseUnless(
                options->read->acceptImplausible, table,
                fmt::format("{}the largest chip is {} µm; expected µm, not mm.", table.where(0, "u_um"), largest_um));
        }
        requireNewtons(table, force_N, largest_um, options->read->acceptImplausible);
        ProcessIdentifier identifier(options->params);
        CsvOutput csv("k,a1,b0,b1,trace");
        for (std::size_t i = 0; i < table.rows(); ++i) {
            identifier.update(force_N[i], chip_um[i]);
            const auto& theta = identifier.theta();
            csv.row(static_cast<long long>(samples[i]), theta[0], theta[1], theta[2], identifier.trace());
        }
        csv.flush();
        tellNotes(table);
    });
}

// ── simulate ────────────────────────────────────────────────────────────────────────────────────────────────────────

struct SimulateOptions {
    SimulationParams params{};
    double seconds{1.0};
    double noise_um{-1.0};
    double toneShift_Hz{0.0};
    double spindle_rps{17.2};
    std::string disturbanceFile;
    std::uint64_t machineSeed{0};
    bool csv{false};
    bool summary{false};
    std::shared_ptr<files::ReadOptions> read{};
};

std::vector<double> disturbanceOf(const SimulateOptions& options) {
    if (!options.disturbanceFile.empty()) {
        const Table table = Table::read(options.disturbanceFile, *options.read);
        requireConsecutive(table, table.column("k"));
        table.requireRange("d_um", -1e4, 1e4);
        return table.column("d_um");
    }
    if (!(options.seconds > 0.0 && options.seconds <= 3600.0)) {
        throw BadInput(fmt::format("--seconds is {}; expected above 0, at most 3600.", options.seconds));
    }
    if (options.machineSeed != 0) {
        return disturbanceOf(hardLathe(options.machineSeed),
                             static_cast<std::size_t>(std::llround(options.seconds * kSampleRate_Hz)));
    }
    const bool reproduction = options.params.plant == PlantKind::R0 || options.params.plant == PlantKind::R1;
    double white_um = reproduction ? 0.02 : 0.05;
    if (options.noise_um >= 0.0 && options.params.plant != PlantKind::B1) {
        white_um = options.noise_um;
    }
    const auto samples = static_cast<std::size_t>(std::llround(options.seconds * kSampleRate_Hz));
    return makeDisturbance(kPaperTones, white_um, samples, options.params.seed, options.toneShift_Hz);
}

void runSimulate(SimulateOptions options) {
    if (!(options.spindle_rps >= kSampleRate_Hz / static_cast<double>(kMaxRevolutionSamples) &&
          options.spindle_rps <= kSampleRate_Hz / 10.0)) {
        throw BadInput(fmt::format("--spindle-rps is {}; expected 2.5 to 500.", options.spindle_rps));
    }
    if (!std::isfinite(options.params.depth_um) || std::abs(options.params.depth_um) > 1e4) {
        throw BadInput(fmt::format("--step-um is {}; expected -10000 to 10000.", options.params.depth_um));
    }
    const HardLathe lathe = hardLathe(options.machineSeed);
    options.params.process = lathe.process;
    options.params.slidePole = lathe.slidePole;
    options.params.revolutionSamples = samplesPerRevolution(options.spindle_rps, kSampleRate_Hz);
    if (options.params.plant == PlantKind::B1) {
        options.params.positionNoise_um = options.noise_um >= 0.0 ? options.noise_um : lathe.positionNoise_um;
    } else if (options.params.plant == PlantKind::B2) {
        options.params.forceNoise_N = lathe.forceNoise_N;
    }
    const std::vector<double> disturbance_um = disturbanceOf(options);
    const SimulationResult result = valueOrThrow(simulate(options.params, disturbance_um));
    if (options.summary) {
        const SimulationSummary summary = summarise(result.rows);
        nlohmann::ordered_json document{{"rms_um", summary.whole.rms_um},
                                        {"pv_um", summary.whole.pv_um},
                                        {"rms_steady_um", summary.steady.rms_um},
                                        {"pv_steady_um", summary.steady.pv_um},
                                        {"mean_force_n", summary.meanForce_N}};
        document["tones"] = nlohmann::ordered_json::array();
        for (const TrackedTone& tone : result.tones) {
            document["tones"].push_back({{"frequency_hz", tone.frequency_Hz},
                                         {"amplitude_um", tone.amplitude_um},
                                         {"visibility", tone.visibility},
                                         {"blind", tone.blind}});
        }
        printJson(document);
        return;
    }
    CsvOutput csv("k,t_s,disturbance_um,command_um,force_n,inner_modulation_um,depth_um");
    for (std::size_t k = 0; k < result.rows.size(); ++k) {
        const SimulationRow& row = result.rows[k];
        csv.row(k, static_cast<double>(k) / kSampleRate_Hz, row.disturbance_um, row.command_um, row.force_N,
                row.inner_um, row.depth_um);
    }
    csv.flush();
}

void addSimulate(CLI::App& turning) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command =
        turning.add_subcommand("simulate", "One plant with one controller at 5 kHz; CSV or JSON summary.");
    const std::map<std::string, PlantKind> plants{
        {"r0", PlantKind::R0}, {"r1", PlantKind::R1}, {"b1", PlantKind::B1}, {"b2", PlantKind::B2}};
    const std::map<std::string, ControllerKind> controllers{{"open", ControllerKind::Open},
                                                            {"paper", ControllerKind::Paper},
                                                            {"pi", ControllerKind::Pi},
                                                            {"default", ControllerKind::Default}};
    command->add_option("--plant", options->params.plant, "r0, r1: the paper's; b1: with delay; b2: force only")
        ->required()
        ->transform(CLI::CheckedTransformer(plants));
    command->add_option("--controller", options->params.controller, "open, paper, pi or default")
        ->required()
        ->transform(CLI::CheckedTransformer(controllers));
    command->add_option("--seconds", options->seconds, "Length in s; of no effect with --disturbance")
        ->capture_default_str();
    command->add_option("--step-um", options->params.depth_um, "Depth of cut that begins at k = 0, um")
        ->capture_default_str();
    command->add_option("--noise-um", options->noise_um,
                        "b1: sensor noise (.02); others: white part of the disturbance (r0, r1 .02; b2 .05), um");
    command->add_option("--gain-error", options->params.gainError, "Factor on the process gain the law does not know")
        ->capture_default_str();
    command->add_option("--extra-delay", options->params.extraDelay, "Further samples of delay, 0 or 1")
        ->capture_default_str();
    command->add_option("--tone-shift-hz", options->toneShift_Hz, "All tones off their names by this")
        ->capture_default_str();
    command->add_option("--spindle-rps", options->spindle_rps, "Spindle speed in rev/s")->capture_default_str();
    command->add_option("--disturbance", options->disturbanceFile, "CSV k,d_um instead of the built-in disturbance");
    command->add_option("--seed", options->params.seed, "Seed of disturbance and sensors")->capture_default_str();
    command
        ->add_option("--machine-seed", options->machineSeed,
                     "A hard lathe with its own disturbance, drawn from this seed (docs/turning.md); options given "
                     "count before it; 0: the reference lathe")
        ->capture_default_str();
    auto* format = command->add_option_group("output", "What to print");
    format->add_flag("--csv", options->csv, "Every sample");
    format->add_flag("--summary", options->summary, "JSON summary; *_steady and the mean force are of the second half");
    format->require_option(1);
    options->read = addReadOptions(*command);
    command->callback([options, command] {
        if (options->machineSeed != 0) {  // what is not said is the machine's
            const HardLathe lathe = hardLathe(options->machineSeed);
            if (command->count("--spindle-rps") == 0) options->spindle_rps = lathe.spindle_rps;
            if (command->count("--extra-delay") == 0) options->params.extraDelay = lathe.extraDelay;
            if (command->count("--step-um") == 0) options->params.depth_um = lathe.depth_um;
        }
        runSimulate(*options);
    });
}

// ── blind, limits, table ────────────────────────────────────────────────────────────────────────────────────────────

struct BlindOptions {
    double spindle_rps{17.2};
    std::vector<double> tones_Hz;
    double sampleRate_Hz{kSampleRate_Hz};
};

void addBlind(CLI::App& turning) {
    auto options = std::make_shared<BlindOptions>();
    CLI::App* command =
        turning.add_subcommand("blind", "Tones the force cannot see at a spindle speed, and a better speed.");
    command->add_option("--spindle-rps", options->spindle_rps, "Spindle speed in rev/s")->required();
    command->add_option("--tones", options->tones_Hz, "Frequencies in Hz, comma-separated")->required()->delimiter(',');
    command->callback([options] {
        const BlindReport report =
            valueOrThrow(blindFrequencies(options->spindle_rps, options->tones_Hz, options->sampleRate_Hz));
        nlohmann::ordered_json tones = nlohmann::ordered_json::array();
        for (const ToneVisibility& tone : report.tones) {
            tones.push_back({{"tone_hz", tone.frequency_Hz}, {"visibility", tone.visibility}, {"blind", tone.blind}});
        }
        printJson({{"spindle_rps", report.spindle_rps},
                   {"samples_per_rev", report.revolutionSamples},
                   {"blind_below", kBlindBelow},
                   {"tones", tones},
                   {"worst_visibility", report.worst},
                   {"suggested_rps", report.suggested_rps},
                   {"suggested_worst_visibility", report.suggestedWorst}});
    });
}

constexpr double kSteadyShare = 0.005;  ///< Kalman gain of an amplitude per sample in steady state

void addLimits(CLI::App& turning) {
    CLI::App* command = turning.add_subcommand(
        "limits", "Gain limits of the paper's loops with one sample of delay, and the margins of the laws, as JSON.");
    command->callback([] {
        nlohmann::ordered_json document;
        for (const NamedLimit& limit : paperLimits(ProcessParams{})) {
            document["gain_limits"][std::string(limit.name)] = limit.limit;
        }
        const auto entry = [](const Margins& m) {
            nlohmann::ordered_json out;
            out["gain"] = std::isfinite(m.gain) ? nlohmann::ordered_json(m.gain) : nlohmann::ordered_json("unlimited");
            out["phase_deg"] = m.phase_deg;
            out["delay_samples"] = m.delay_samples;
            out["modulus"] = m.modulus;
            return out;
        };
        for (const auto& [name, gains] :
             {std::pair{"paper", paperGains(PlantKind::B1)}, {"pi", tunedGains(PlantKind::B1)}}) {
            document["margins_b1"][name] = entry(lawMargins(PlantKind::B1, gains, ProcessParams{}));
        }
        for (const auto& [name, gains] :
             {std::pair{"paper", paperGains(PlantKind::B2)}, {"pi", tunedGains(PlantKind::B2)}}) {
            document["margins_b2"][name] = entry(lawMargins(PlantKind::B2, gains, ProcessParams{}));
        }
        document["margins_default_at_each_tone"] = entry(cancellerMargins(120.0, kSampleRate_Hz));
        std::vector<FollowedTone> tones;
        for (const ToneSpec& tone : kPaperTones) {
            tones.push_back({tone.frequency_Hz, kSteadyShare});
        }
        document["margins_default_paper_tones"] = entry(toneMargins(tones, {}, {}, kSampleRate_Hz));
        printJson(document);
    });
}

void addTable(CLI::App& turning) {
    auto seeds = std::make_shared<int>(10);
    CLI::App* command = turning.add_subcommand("table", "The table of docs/turning.md: every controller on b1 and b2.");
    command->add_option("--seeds", *seeds, "Runs per cell")->capture_default_str()->check(CLI::Range(1, 1000));
    command->callback([seeds] { printTurningTable(*seeds); });
}

}  // namespace

void addTurningCommands(CLI::App& kerf) {
    CLI::App* turning = kerf.add_subcommand("turning", "Force feedback of the diamond turning machine.");
    turning->require_subcommand(1);
    addOverlap(*turning);
    addIdentify(*turning);
    addSimulate(*turning);
    addBlind(*turning);
    addLimits(*turning);
    addTable(*turning);
    addTurningRobust(*turning);
}

}  // namespace kerf::headless
