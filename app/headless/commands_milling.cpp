// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/milling_input.h"
#include "app/files/output.h"
#include "app/files/slip.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/commands_milling.h"
#include "app/headless/read_options.h"
#include "engine/process/milling/cut_simulation.h"
#include "engine/process/milling/hard_machine.h"
#include "engine/process/milling/recorded_angle.h"
#include "engine/process/milling/revolution_averager.h"

namespace kerf::headless {
namespace {

using milling::CutCase;
using milling::CutResult;
using milling::LawKind;

const std::map<std::string, LawKind> kLaws{
    {"constant", LawKind::Constant}, {"pi", LawKind::Pi}, {"model", LawKind::Model}, {"preview", LawKind::Preview}};

/// CLI::Range lets "nan" pass, because it asks whether the value is outside.
CLI::Validator inRange(double low, double high) {
    return {[low, high](std::string& text) {
                double value = 0.0;
                const bool number = CLI::detail::lexical_cast(text, value);
                return number && value >= low && value <= high
                           ? std::string()
                           : fmt::format("{} is not a number from {} to {}", text, low, high);
            },
            fmt::format("FLOAT in [{} - {}]", low, high)};
}

/// What the command line of simulate and replay says; the pulse arrives with the plant.
struct LawOptions {
    LawKind law{LawKind::Model};
    double feed_mmPerS{1.53};
    double kp_pulsePerSPerN{0.75};
    double ki_pulsePerSPerN{0.15};
    double reference_N{40.0 * kNewtonPerKilogramForce};
    std::optional<double> modelKx_NPerMm{};
    std::optional<double> feedFloor_mmPerS{};
    std::optional<double> pulse_mm{};
    std::string plantFile{};

    void addTo(CLI::App& command) {
        command.add_option("--law", law, "constant, pi (the paper's), model (default) or preview")
            ->transform(CLI::CheckedTransformer(kLaws, CLI::ignore_case));
        command.add_option("--feed-mm-s", feed_mmPerS, "programmed feed; the constant law's")
            ->check(inRange(0.001, 1000.0));
        command.add_option("--kp", kp_pulsePerSPerN, "PI: k_p in pulse/s per N")->check(inRange(1e-6, 1e6));
        command.add_option("--ki", ki_pulsePerSPerN, "PI: k_i in pulse/s per N")->check(inRange(0.0, 1e6));
        command.add_option("--pulse-mm", pulse_mm, "one pulse of the axis in mm (default .0254)")
            ->check(inRange(1e-6, 1.0));
        command.add_option("--reference-n", reference_N, "averaged normal force to hold, in N")
            ->check(inRange(1.0, 1e5));
        command
            .add_option("--plant-kx-model", modelKx_NPerMm,
                        "one k_x for the model laws in N/mm, instead of learning it while cutting")
            ->check(inRange(10.0, 1e6));
        command.add_option("--feed-floor-mm-s", feedFloor_mmPerS, "lowest feed (B0f: .68)")
            ->check(inRange(0.0, 1000.0));
        command.add_option("--plant", plantFile, "plant constants in JSON (default: B0; see milling plant)");
    }
    void applyTo(CutCase& cut) const {
        cut.law = law;
        cut.pulse_mm = pulse_mm.value_or(cut.pulse_mm);
        auto& controller = cut.controller;
        controller.programmedFeed_mmPerS = feed_mmPerS;
        controller.reference_N = reference_N;
        controller.pi = {kp_pulsePerSPerN * cut.pulse_mm, ki_pulsePerSPerN * cut.pulse_mm, 60.0 / cut.spindle_rpm};
        controller.range.min_mmPerS = feedFloor_mmPerS.value_or(controller.range.min_mmPerS);
        if (controller.range.min_mmPerS >= controller.range.max_mmPerS) {
            throw BadInput(fmt::format("--feed-floor-mm-s: {} is not below the highest feed; expected less than {}.",
                                       controller.range.min_mmPerS, controller.range.max_mmPerS));
        }
        if (modelKx_NPerMm) {
            controller.stiffness.softest_NPerMm = *modelKx_NPerMm;
            controller.stiffness.ratio = 1.0;
        }
    }
};

CutCase caseOf(const LawOptions& options) {
    CutCase cut;
    if (!options.plantFile.empty()) {
        readMillingPlant(options.plantFile, cut);
    }
    options.applyTo(cut);
    return cut;
}

nlohmann::ordered_json summaryOf(const CutResult& result) {
    const auto& summary = result.summary;
    nlohmann::ordered_json json;
    const auto orNull = [&](double value) {
        return summary.waviness ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    };
    const milling::Waviness waviness = summary.waviness.value_or(milling::Waviness());
    json["waviness_um"] = orNull(waviness.spot_um);
    json["waviness_raw_um"] = orNull(waviness.raw_um);
    json["mean_offset_um"] = orNull(waviness.meanOffset_um);
    json["time_s"] = summary.time_s;
    json["force_max_n"] = summary.peakForce_N;
    json["feed_unrest"] = summary.feedUnrest_mmPerS;
    json["finished"] = summary.finished;
    return json;
}

void printCsv(const CutResult& result) {
    CsvOutput csv("rev,x_mm,depth_mm,feed_cmd_mm_s,feed_cut_mm_per_rev,force_y_n,force_meas_n");
    for (const milling::CutRow& row : result.rows) {
        csv.row(row.revolution, row.x_mm, row.depth_mm, row.feedCommand_mmPerS, row.cutFeed_mmPerRev, row.force_N,
                row.forceMeasured_N);
    }
    csv.flush();
}

struct MillingSimulateOptions {
    LawOptions law{};
    std::optional<std::vector<double>> blank_mm{};
    double segment_mm{20.0};
    std::string blankFile{};
    std::uint64_t machineSeed{0};
    bool quantize{false};
    std::optional<double> noise_N{};
    std::optional<int> lag_revs{};
    int forceLate_rev{0};
    std::optional<double> axisLag_s{};
    std::optional<double> drift_NPerS{};
    double fromAir_mm{0.0};
    double previewShift_mm{0.0};
    double previewError_percent{0.0};
    std::uint64_t seed{1};
    bool csv{false};
    bool summary{false};
    std::shared_ptr<files::ReadOptions> read{};
};

void simulate(const MillingSimulateOptions& options) {
    CutCase cut = caseOf(options.law);
    const milling::HardMachine machine = milling::hardMachine(options.machineSeed);
    if (options.machineSeed != 0) {
        milling::putOn(machine, cut);
    }
    if (!options.blankFile.empty()) {
        std::vector<std::string> notes;
        cut.blank = readBlank(options.blankFile, *options.read, &notes);
        tell(notes);
    } else if (options.blank_mm) {
        cut.blank = checked("--blank", milling::BlankProfile::ofSegments(*options.blank_mm, options.segment_mm));
    } else if (options.machineSeed == 0) {
        constexpr std::array kPublished_mm{1.0, 2.0, 3.0, 2.0, 1.0};
        cut.blank = checked("--segment-mm", milling::BlankProfile::ofSegments(kPublished_mm, options.segment_mm));
    }
    cut.wholePulses = options.quantize;
    cut.forceNoise_N = options.noise_N.value_or(cut.forceNoise_N);
    cut.lag = options.lag_revs ? *options.lag_revs == 1 : cut.lag;
    cut.forceLate_rev = options.forceLate_rev;
    cut.axisLag_s = options.axisLag_s.value_or(cut.axisLag_s);
    cut.drift_NPerS = options.drift_NPerS.value_or(cut.drift_NPerS);
    cut.fromAir_mm = options.fromAir_mm;
    cut.controller.entryGuard = options.fromAir_mm > 0.0;
    cut.seed = options.seed;
    if (cut.law == LawKind::Preview) {
        cut.believedBlank = (cut.fromAir_mm > 0.0 ? cut.blank.inAir(true, false) : cut.blank)
                                .distorted(options.previewShift_mm, 1.0 + options.previewError_percent / 100.0);
    }
    const CutResult result = milling::simulateCut(cut);
    if (options.csv) {
        printCsv(result);
    } else {
        printJson(summaryOf(result));
    }
}

void addSimulate(CLI::App& parent) {
    auto options = std::make_shared<MillingSimulateOptions>();
    CLI::App* command = parent.add_subcommand("simulate", "One cut along a stepped blank, revolution by revolution");
    options->law.addTo(*command);
    command->add_option("--blank", options->blank_mm, "heights of the blank's steps in mm")->delimiter(',');
    command->add_option("--segment-mm", options->segment_mm, "length of one step in mm");
    command->add_option("--blank-file", options->blankFile, "blank from a CSV (x_mm,height_mm; the last row ends it)");
    command->add_flag("--quantize", options->quantize, "the axis moves whole pulses, the rest is carried");
    command->add_option("--noise-n", options->noise_N, "standard deviation of the averaged force in N")
        ->check(inRange(0.0, 1e4));
    command->add_option("--lag-revs", options->lag_revs, "measurement reaches the law this many revolutions late")
        ->check(CLI::IsMember({0, 1}));
    command
        ->add_option("--force-late-revs", options->forceLate_rev,
                     "the force alone, not the feed measured with it, comes this many revolutions late")
        ->check(CLI::IsMember({0, 1, 2}));
    command->add_option("--axis-lag-s", options->axisLag_s, "time constant with which the axis reaches a feed")
        ->check(inRange(0.0, 5.0));
    command->add_option("--drift-n-s", options->drift_NPerS, "drift of the force sensor's zero in N/s")
        ->check(inRange(-100.0, 100.0));
    command
        ->add_option(
            "--machine-seed", options->machineSeed,
            "a hard machine with its blank (docs/milling.md); 0: the reference machine. Options given beside it "
            "count")
        ->check(inRange(0.0, 1.8e19))
        ->excludes("--plant");
    command->add_option("--revs-from-air", options->fromAir_mm, "start this many mm before the blank, in air")
        ->check(inRange(0.0, 1000.0));
    command->add_option("--preview-shift-mm", options->previewShift_mm, "preview: the profile is wrong by this shift")
        ->check(inRange(-100.0, 100.0));
    command
        ->add_option("--preview-error-percent", options->previewError_percent, "preview: its heights are wrong by this")
        ->check(inRange(-90.0, 500.0));
    command->add_option("--seed", options->seed, "seed of the noise")->check(inRange(0.0, 1.8e19));
    CLI::Option* csv = command->add_flag("--csv", options->csv, "a row per revolution");
    command->add_flag("--summary", options->summary, "waviness, time, peak force (default)")->excludes(csv);
    options->read = addReadOptions(*command);
    command->callback([options] { simulate(*options); });
}

/// Way of the axis over time, from the recorded feed.
class Travel {
 public:
    Travel(const std::vector<double>& time_s, const std::vector<double>& feed_mmPerS) : m_time_s(time_s) {
        double travel_mm = 0.0;
        for (std::size_t i = 0; i < time_s.size(); ++i) {
            travel_mm += i > 0 ? feed_mmPerS[i] * (time_s[i] - time_s[i - 1]) : 0.0;
            m_travel_mm.push_back(travel_mm);
        }
    }
    [[nodiscard]] double at_mm(double time_s) const {
        const auto above = std::ranges::lower_bound(m_time_s, time_s);
        if (above == m_time_s.begin()) return m_travel_mm.front();
        if (above == m_time_s.end()) return m_travel_mm.back();
        const auto i = static_cast<std::size_t>(above - m_time_s.begin());
        const double share = (time_s - m_time_s[i - 1]) / (m_time_s[i] - m_time_s[i - 1]);
        return m_travel_mm[i - 1] + share * (m_travel_mm[i] - m_travel_mm[i - 1]);
    }

 private:
    const std::vector<double>& m_time_s;
    std::vector<double> m_travel_mm{};
};

milling::CheckedAngle checkedAngle(const Table& table, const std::vector<double>& time_s) {
    auto angle = milling::checkAngle(time_s, table.column("angle_rev"));
    if (!angle) {
        throw BadInput(fmt::format("{}, column angle_rev: {}", table.file(), angle.error().english()));
    }
    if (angle->countedDown) {
        table.note(fmt::format("{}: the angle counts down; turned over.", table.file()));
    }
    if (angle->wrap_rev > 0.0) {
        table.note(fmt::format("{}: the angle begins again every {} rev; unwrapped.", table.file(), angle->wrap_rev));
    }
    return std::move(*angle);
}

/// A cut that reaches no newton at all is none, or is in kN.
void requireNewtons(const Table& table, const std::vector<std::optional<double>>& force_N, bool accepted) {
    constexpr double kLeast_N = 2.0;
    double largest_N = 0.0;
    for (const auto& force : force_N) {
        largest_N = std::max(largest_N, std::abs(force.value_or(0.0)));
    }
    if (largest_N > 0.0 && largest_N < kLeast_N) {
        files::refuseUnless(accepted, table,
                            fmt::format("{}the largest force is {:.3g}; expected a cut in N, not kN.",
                                        table.where(0, "force_y_n"), largest_N));
    }
}

/// mm/min where mm/s is meant.
void requireSeconds(const Table& table, const std::vector<double>& feed_mmPerS, double highest_mmPerS, bool accepted) {
    constexpr double kFar = 10.0;
    if (feed_mmPerS.empty()) {
        return;
    }
    std::vector<double> sorted = feed_mmPerS;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    if (*middle > kFar * highest_mmPerS) {
        files::refuseUnless(
            accepted, table,
            fmt::format("{}{:.4g} is far above the law's highest feed of {:.4g} mm/s; expected mm/s, not mm/min (a "
                        "column in mm/min is named feed_mm_min).",
                        table.where(0, "feed_mm_s"), *middle, highest_mmPerS));
    }
}

/// The recorded signal through averager, estimator and law; what the law would have done, without acting.
void replay(const std::string& path, const LawOptions& law, const files::ReadOptions& read) {
    Table table = Table::read(path, read);
    (void)table.columnWithGaps("force_y_n");
    table.dropRowsWithGaps({"t_s", "angle_rev", "feed_mm_s"});
    const auto& time_s = table.column("t_s");
    const auto force_N = table.columnWithGaps("force_y_n");
    const auto& feed_mmPerS = table.column("feed_mm_s");
    table.requireRange("t_s", 0.0, 1e6);
    table.requireRange("feed_mm_s", 0.0, 1000.0);
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        if (i > 0 && time_s[i] <= time_s[i - 1]) {
            throw BadInput(fmt::format("{}{} does not follow {}; expected rising times.", table.where(i, "t_s"),
                                       time_s[i], time_s[i - 1]));
        }
        if (force_N[i] && std::abs(*force_N[i]) > 1e6) {
            throw BadInput(fmt::format("{}{} is out of range; expected -1000000 to 1000000.",
                                       table.where(i, "force_y_n"), *force_N[i]));
        }
    }
    requireNewtons(table, force_N, read.acceptImplausible);
    requireSeconds(table, feed_mmPerS, caseOf(law).controller.range.max_mmPerS, read.acceptImplausible);
    if (const auto missing = std::ranges::count_if(force_N, [](const auto& f) { return !f; }); missing > 0) {
        table.note(fmt::format("{}: column force_y_n: {} samples without a value.", table.file(), missing));
    }
    const milling::CheckedAngle angle = checkedAngle(table, time_s);
    const CutCase cut = caseOf(law);
    milling::FeedController controller(cut.controller, cut.law);
    controller.beginCut();
    milling::RevolutionAverager averager;
    CsvOutput csv(
        "rev,t_s,revolution_s,force_mean_n,force_peak_n,feed_mm_s,advised_feed_mm_s,stiffness_ln,stiffness_half95,in_"
        "air");
    const Travel travel(time_s, feed_mmPerS);
    std::size_t revolutions = 0;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        const auto revolution =
            averager.add({static_cast<std::int64_t>(std::llround(time_s[i] * 1e9)), angle.angle_rev[i],
                          force_N[i].value_or(0.0), force_N[i] ? Quality::Good : Quality::Missing});
        if (!revolution || revolution->end_ns <= revolution->begin_ns) {
            continue;
        }
        ++revolutions;
        const double end_s = static_cast<double>(revolution->end_ns) * 1e-9;
        const double feed_mmPerRev =
            travel.at_mm(end_s) - travel.at_mm(static_cast<double>(revolution->begin_ns) * 1e-9);
        const bool trusted = revolution->quality == Quality::Good;
        const auto force = trusted ? std::optional(std::max(0.0, revolution->mean_N)) : std::nullopt;
        milling::RevolutionInput input{force, feed_mmPerRev, travel.at_mm(end_s), revolution->duration_s()};
        input.advised = true;  // the recorded feed was not ours
        const auto decision = controller.update(input);
        const auto& stiffness = controller.stiffness();
        csv.row(revolution->revolution, end_s, revolution->duration_s(), revolution->mean_N, revolution->peak_N,
                feed_mmPerRev / revolution->duration_s(), decision.feed_mmPerS,
                stiffness.valid ? fmt::format("{}", stiffness.lnCb) : std::string(),
                stiffness.valid ? fmt::format("{}", stiffness.half95) : std::string(), decision.inAir);
    }
    if (revolutions == 0) {
        const bool any = !angle.angle_rev.empty();
        throw BadInput(
            fmt::format("{}the spindle turns from {:.3f} to {:.3f} rev; expected a record with a whole "
                        "revolution between two marks (whole numbers).",
                        any ? table.where(0, "angle_rev") : table.file() + ": ", any ? angle.angle_rev.front() : 0.0,
                        any ? angle.angle_rev.back() : 0.0));
    }
    csv.flush();
    tellNotes(table);
}

void addReplay(CLI::App& parent) {
    auto law = std::make_shared<LawOptions>();
    auto path = std::make_shared<std::string>();
    CLI::App* command = parent.add_subcommand("replay", "Estimator and law in advise mode over a recorded signal");
    command->add_option("force_csv", *path, "CSV with t_s,angle_rev,force_y_n,feed_mm_s")->required();
    law->addTo(*command);
    const auto read = addReadOptions(*command);
    command->callback([path, law, read] { replay(*path, *law, *read); });
}

/// The table of docs/milling.md: every law on B0 with whole pulses and .5 kgf of noise, mean and worst over ten seeds.
void printComparison(int seeds) {
    struct Row {
        const char* name;
        LawKind law;
        double feed_mmPerS, kp, ki, shift_mm, factor;
    };
    const Row rows[] = {
        {"constant 1.53 mm/s", LawKind::Constant, 1.53, 0.75, 0.15, 0.0, 1.0},
        {"constant .85 mm/s", LawKind::Constant, 0.85, 0.75, 0.15, 0.0, 1.0},
        {"pi .75/.15 (paper)", LawKind::Pi, 1.53, 0.75, 0.15, 0.0, 1.0},
        {"pi 1.5/.3", LawKind::Pi, 1.53, 1.5, 0.3, 0.0, 1.0},
        {"model (default)", LawKind::Model, 1.53, 0.75, 0.15, 0.0, 1.0},
        {"preview exact", LawKind::Preview, 1.53, 0.75, 0.15, 0.0, 1.0},
        {"preview .3 mm and 5 % off", LawKind::Preview, 1.53, 0.75, 0.15, 0.3, 1.05},
    };
    CsvOutput csv("law,waviness_mean_um,waviness_worst_um,time_mean_s,peak_mean_kgf,peak_worst_kgf");
    for (const Row& row : rows) {
        double waviness_um = 0.0, worst_um = 0.0, time_s = 0.0, peak_N = 0.0, worstPeak_N = 0.0;
        for (int seed = 0; seed < seeds; ++seed) {
            CutCase cut;
            const double heights_mm[] = {1, 2, 3, 2, 1};
            cut.blank = *milling::BlankProfile::ofSegments(heights_mm, 20.0);
            cut.believedBlank = cut.blank.distorted(row.shift_mm, row.factor);
            cut.law = row.law;
            cut.controller.programmedFeed_mmPerS = row.feed_mmPerS;
            cut.controller.pi = {row.kp * cut.pulse_mm, row.ki * cut.pulse_mm, 0.1};
            cut.controller.entryGuard = false;
            cut.wholePulses = true;
            cut.forceNoise_N = 0.5 * kNewtonPerKilogramForce;
            cut.seed = static_cast<std::uint64_t>(seed);
            const auto summary = milling::simulateCut(cut).summary;
            waviness_um += summary.waviness->spot_um / seeds;
            worst_um = std::max(worst_um, summary.waviness->spot_um);
            time_s += summary.time_s / seeds;
            peak_N += summary.peakForce_N / seeds;
            worstPeak_N = std::max(worstPeak_N, summary.peakForce_N);
        }
        csv.row(row.name, waviness_um, worst_um, time_s, peak_N / kNewtonPerKilogramForce,
                worstPeak_N / kNewtonPerKilogramForce);
    }
    csv.flush();
}

}  // namespace

void addMillingCommands(CLI::App& kerf) {
    CLI::App* milling = kerf.add_subcommand("milling", "Feed that holds the cutting force, so the surface is flat");
    milling->require_subcommand(1);
    addSimulate(*milling);
    addReplay(*milling);
    addMillingRobust(*milling);
    addMillingNoise(*milling);
    auto seeds = std::make_shared<int>(10);
    CLI::App* table =
        milling->add_subcommand("table", "The laws compared on B0, whole pulses and .5 kgf of noise, at 40 kgf");
    table->add_option("--seeds", *seeds, "seeds per law")->check(inRange(1, 1000));
    table->callback([seeds] { printComparison(*seeds); });
    milling->add_subcommand("plant", "Print the constants of B0 as a PLANT.json")->callback([] {
        printMillingPlant(CutCase());
    });
}

}  // namespace kerf::headless
