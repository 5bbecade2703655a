// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/files/tapping_drive_file.h"
#include "app/headless/commands.h"
#include "app/headless/read_options.h"
#include "app/headless/tapping_robust.h"
#include "app/headless/tapping_table.h"
#include "engine/process/tapping/tap_drive.h"
#include "engine/process/tapping/tap_record.h"
#include "engine/process/tapping/tap_span.h"
#include "engine/process/tapping/thread_table.h"
#include "engine/process/tapping/trial_machine.h"

namespace kerf::headless {
namespace {

using namespace tapping;
using Json = nlohmann::ordered_json;

struct DriveOptions {
    std::string file;
    std::uint64_t machineSeed{0};
    std::vector<std::string> settings;
    bool csv{false};
    bool summary{false};

    [[nodiscard]] DriveParams drive() const {
        DriveParams out = file.empty() ? hardDrive(machineSeed) : readDriveFile(file);
        applyDriveSettings(out, "--set", settings);
        return out;
    }
};

void addDriveOptions(CLI::App& command, DriveOptions& options) {
    auto* file = command.add_option("--drive", options.file,
                                    "JSON file with constants of the drive; the reference drive without it");
    command
        .add_option("--machine-seed", options.machineSeed,
                    "a hard machine drawn from this seed (docs/tapping.md); 0: the reference drive")
        ->excludes(file);
    command.add_option("--set", options.settings, "KEY=VALUE: one constant, after --drive and --machine-seed")
        ->expected(1)
        ->take_all();
    auto* form = command.add_option_group("output")->require_option(1);
    form->add_flag("--csv", options.csv, "rows as CSV");
    form->add_flag("--summary", options.summary, "figures as JSON");
    command.footer(driveKeyHelp());
}

void putFigures(Json& out, const ContourFigures& figures) {
    out["saec_mm"] = figures.saec_mm;
    out["peak_um"] = figures.peak_um;
    out["rms_um"] = figures.rms_um;
    out["engaged_pp_um"] = figures.engagedPp_um;
}

void requireFinite(const ContourFigures& figures) {
    if (!std::isfinite(figures.saec_mm) || figures.peak_um > 1e6) {
        throw BadInput("The drive is unstable with these constants: its positions leave every bound.");
    }
}

void simulate(const DriveOptions& options) {
    const DriveParams drive = options.drive();
    TrialMachine machine(drive, {}, 0);
    const TapSignals tap = machine.tap(settingsOf(drive));
    const ContourFigures figures = contourFigures(tap.spindle_rev, tap.z_mm, {}, drive.pitch_mm, drive.engage_rev);
    requireFinite(figures);
    if (options.summary) {
        Json out;
        putFigures(out, figures);
        out["samples"] = figures.samples;
        printJson(out);
        return;
    }
    CsvOutput csv("t_s,spindle_rev,z_mm,error_um");
    for (std::size_t k = 0; k < tap.z_mm.size(); ++k) {
        csv.row(static_cast<double>(k) * drive.tick_s, tap.spindle_rev[k], tap.z_mm[k],
                1000.0 * (drive.pitch_mm * tap.spindle_rev[k] - tap.z_mm[k]));
    }
    csv.flush();
}

struct TuneOptions : DriveOptions {
    std::string tuner{"default"};
    double eta{0.0};  ///< 0: the tuner's own
    bool probe{false};
    int maxTaps{8};
    TrialScatter scatter{};
    std::vector<std::string> assume;
    std::string thread;
    std::uint64_t seed{1};
};

TunerKind tunerOf(const std::string& name) {
    for (const TunerKind kind : {TunerKind::Paper, TunerKind::Signed, TunerKind::Gain}) {
        if (name == tunerKey(kind)) return kind;
    }
    return TunerKind::Default;
}

double peakTrim_um(const TapSettings& settings) {
    double peak_mm = 0.0;
    for (const double trim_mm : settings.zTrim_mm)
        peak_mm = std::max(peak_mm, std::abs(trim_mm));
    return 1000.0 * peak_mm;
}

/// The thread asked for, else the coarse one of this pitch, else the one with the least tolerance.
const ThreadPreset* threadFor(const std::string& asked, double pitch_mm) {
    if (!asked.empty()) {
        const ThreadPreset* named = findThread(asked);
        if (named == nullptr)
            throw CLI::ValidationError(
                "--thread", asked + " is unknown; expected M3 to M20, as in M8 or M8x1, or #4 to 3/4, as in 1/4-20");
        if (std::abs(named->pitch_mm - pitch_mm) > 1e-9) {
            throw CLI::ValidationError("--thread",
                                       fmt::format("{} has a pitch of {} mm", named->name, named->pitch_mm));
        }
        return named;
    }
    const ThreadPreset* found = nullptr;
    for (const ThreadPreset& thread : threadPresets()) {
        if (std::abs(thread.pitch_mm - pitch_mm) > 1e-9) continue;
        if (found == nullptr || (!found->coarse && thread.grade6_um < found->grade6_um)) found = &thread;
    }
    return found;
}

/// Whether the tolerance holds; if not why, what would help, and what that costs. Null where no tolerance is known.
void putVerdict(Json& out, const TunerSetup& setup, const Tuning& tuning, const ThreadPreset* thread) {
    Json& hole = out["hole_time_s"];
    if (thread == nullptr) {
        hole = {{"programmed", holeTime_s(setup.assumed, setup.assumed.ramp_revPerS2)}, {"proposed", nullptr}};
        for (const char* key : {"thread", "allowed_pp_um", "within_tolerance", "limited_by", "proposed_acc_rev_s2"})
            out[key] = nullptr;
        return;
    }
    const TuningVerdict verdict = judgeTuning(tuning, thread->allowedPp_um());
    hole["programmed"] = verdict.programmedHole_s;
    hole["proposed"] = verdict.proposedHole_s ? Json(*verdict.proposedHole_s) : Json();
    out["thread"] = thread->name;
    out["allowed_pp_um"] = thread->allowedPp_um();
    out["within_tolerance"] = verdict.within;
    out["limited_by"] = limitKey(verdict.limitedBy);
    out["proposed_acc_rev_s2"] = verdict.proposedRamp_revPerS2 ? Json(*verdict.proposedRamp_revPerS2) : Json();
    if (verdict.within) return;
    out["reason"] = verdict.why.english();
    out["would_help"] = verdict.help.english();
}

void tune(const TuneOptions& options) {
    const DriveParams drive = options.drive();
    const ThreadPreset* thread = threadFor(options.thread, drive.pitch_mm);
    DriveParams assumed = middlingDrive();
    applyDriveSettings(assumed, "--assume", options.assume);
    TunerSetup setup;
    setup.kind = tunerOf(options.tuner);
    setup.assumed = knownTo(drive, assumed);
    setup.initial = settingsOf(drive);
    setup.maxTaps = options.maxTaps;
    setup.probe = options.probe;
    setup.eta = options.eta > 0.0 ? options.eta : setup.kind == TunerKind::Signed ? 0.06 : 0.03;
    requireFinite(cleanFigures(drive, setup.initial));
    const Tuning tuning = runTuning(setup, drive, options.scatter, options.seed);
    if (options.csv) {
        CsvOutput csv(
            "trial,kps,kpz,ffz,faz,trim_peak_um,expected_saec_mm,highest_kpz,saec_mm,peak_um,rms_um,engaged_pp_um,"
            "accepted");
        int number = 0;
        double expected_mm = 0.0;
        for (const Trial& trial : tuning.trials) {
            csv.row(++number, trial.settings.spindleKp_perS, trial.settings.zKp_perS, trial.settings.zVelocityFf,
                    trial.settings.zAccelFf, peakTrim_um(trial.settings), expected_mm, trial.step.safe.highest_perS,
                    trial.measured.saec_mm, trial.measured.peak_um, trial.measured.rms_um, trial.measured.engagedPp_um,
                    trial.step.accepted);
            expected_mm = trial.step.expectedSaec_mm;
        }
        csv.flush();
        return;
    }
    Json out;
    putFigures(out, tuning.after);
    out["taps_used"] = tuning.trials.size();
    out["reduction_percent"] = 100.0 * tuning.reduction();
    out["saec_initial_mm"] = tuning.before.saec_mm;
    out["saec_final_mm"] = tuning.after.saec_mm;
    out["engaged_pp_initial_um"] = tuning.before.engagedPp_um;
    Json& parameters = out["parameters"];
    parameters["tuner"] = tunerKey(setup.kind);
    parameters["kps"] = tuning.final.spindleKp_perS;
    parameters["kpz"] = tuning.final.zKp_perS;
    parameters["ffz"] = tuning.final.zVelocityFf;
    parameters["faz"] = tuning.final.zAccelFf;
    parameters["trim_peak_um"] = peakTrim_um(tuning.final);
    if (const auto& measured = tuning.setup.measured) {
        out["measured_kpz"] = {{"critical", measured->critical_perS}, {"highest", measured->highest_perS}};
        out["measured_resonance_hz"] = measured->resonance_Hz > 0.0 ? Json(measured->resonance_Hz) : Json();
    }
    const SafeGains& safe = tuning.trials.back().step.safe;
    out["safe_kpz"] = {{"lowest", safe.lowest_perS}, {"highest", safe.highest_perS}, {"critical", safe.critical_perS}};
    out["reason"] = tuning.trials.back().step.reason.english();
    putVerdict(out, setup, tuning, thread);
    printJson(out);
}

struct EvaluateOptions {
    std::string file;
    double pitch_mm{1.25};
    double engage_rev{DriveParams{}.engage_rev};
    std::string thread;
    std::shared_ptr<files::ReadOptions> read{};
};

void evaluate(const EvaluateOptions& options) {
    const ThreadPreset* thread = threadFor(options.thread, options.pitch_mm);
    Table table = Table::read(options.file, *options.read);
    table.dropRowsWithGaps({"t_s", "spindle_rev", "z_mm"});  // a sample without a value is a missing tick
    if (const auto strayed = strayedSamples(table.column("spindle_rev"), table.column("z_mm"), options.pitch_mm);
        !strayed.empty()) {
        table.note(fmt::format("{}the sample is no motion of spindle or Z; {} left out.",
                               table.where(strayed.front(), "z_mm"),
                               strayed.size() == 1 ? "it is" : fmt::format("{} such samples are", strayed.size())));
        table.dropRows(strayed);
    }
    const std::span<const double> time_s(table.column("t_s"));
    const std::span<const double> spindle_rev(table.column("spindle_rev"));
    const std::span<const double> z_mm(table.column("z_mm"));
    const TapSpan tap = findTap(spindle_rev, z_mm);
    const std::size_t length = tap.end - tap.begin;
    const auto checked = checkRecord(time_s.subspan(tap.begin, length), spindle_rev.subspan(tap.begin, length),
                                     z_mm.subspan(tap.begin, length), options.pitch_mm);
    if (!checked) throw BadInput(fmt::format("{}: {}", table.file(), checked.error().english()));
    if (tap.begin > 0) {
        table.note(fmt::format(
            "{}the tap begins here, where Z begins to follow the spindle{}; {} samples before it left "
            "out.",
            table.where(tap.begin, "spindle_rev"), tap.counterReset ? " and its counter was set anew" : "", tap.begin));
    }
    if (tap.end < table.rows()) {
        table.note(fmt::format("{}the tap is back out here; {} samples behind it left out.",
                               table.where(tap.end - 1, "spindle_rev"), table.rows() - tap.end));
    }
    const ContourFigures figures =
        contourFigures(checked->spindle_rev, checked->z_mm, checked->valid, options.pitch_mm, options.engage_rev);
    Json out;
    putFigures(out, figures);
    out["samples"] = figures.samples;
    out["missing_percent"] = 100.0 * checked->missingShare;
    out["tick_s"] = checked->tick_s;
    out["found_pitch_mm"] = checked->foundPitch_mm;
    out["spindle_wrap_rev"] = checked->wrap_rev;
    out["z_mirrored"] = checked->mirrored;
    if (thread == nullptr) {
        out["verdict"] = "no tolerance known for this pitch";
    } else {
        out["thread"] = thread->name;
        out["tolerance"] = "6H";
        out["allowed_pp_um"] = thread->allowedPp_um();
        out["allowed_pp_worn_tap_um"] = thread->allowedPpWornTap_um();
        out["within_tolerance"] = figures.engagedPp_um <= thread->allowedPp_um();
        out["verdict"] = figures.engagedPp_um <= thread->allowedPpWornTap_um() ? "within tolerance with any class 2 tap"
                         : figures.engagedPp_um <= thread->allowedPp_um()
                             ? "within tolerance with a tap at its lower limit"
                             : "outside tolerance";
    }
    printJson(out);
    tellNotes(table);
}

}  // namespace

void addTappingCommands(CLI::App& kerf) {
    auto* tapping = kerf.add_subcommand("tapping", "Rigid tapping: simulate a tap, tune gains, judge a record");
    tapping->require_subcommand(1);

    auto simulateOptions = std::make_shared<DriveOptions>();
    auto* simulateCommand = tapping->add_subcommand("simulate", "One tap of the simulated drive");
    addDriveOptions(*simulateCommand, *simulateOptions);
    simulateCommand->callback([simulateOptions] { simulate(*simulateOptions); });

    auto tuneOptions = std::make_shared<TuneOptions>();
    auto* tuneCommand = tapping->add_subcommand("tune", "Learn gains from trial taps of the simulated drive");
    addDriveOptions(*tuneCommand, *tuneOptions);
    tuneCommand->add_option("--tuner", tuneOptions->tuner, "paper, signed, gain or default")
        ->check(CLI::IsMember({"paper", "signed", "gain", "default"}));
    tuneCommand->add_option("--eta", tuneOptions->eta, "step of paper (.03) and signed (.06)")
        ->check(CLI::Range(1e-6, 10.0));
    tuneCommand->add_flag("--probe", tuneOptions->probe, "paper: second tap at -3 % instead of S(-1) = 0");
    tuneCommand->add_option("--max-taps", tuneOptions->maxTaps, "taps, the first included")->check(CLI::Range(1, 100));
    tuneCommand->add_option("--noise-um", tuneOptions->scatter.noise_um, "noise on the recorded Z")
        ->check(CLI::Range(0.0, 1000.0));
    tuneCommand
        ->add_option("--encoder-spindle-counts", tuneOptions->scatter.encoderSpindle_counts, "per revolution; 0: exact")
        ->check(CLI::Range(0.0, 1e9));
    tuneCommand->add_option("--encoder-z-um", tuneOptions->scatter.encoderZ_um, "step of the recorded Z; 0: exact")
        ->check(CLI::Range(0.0, 1000.0));
    tuneCommand->add_option("--load-spread", tuneOptions->scatter.loadSpread, "load of each tap: 1 ± this")
        ->check(CLI::Range(0.0, 0.9));
    tuneCommand->add_option("--friction-spread", tuneOptions->scatter.frictionSpread, "friction of each tap: 1 ± this")
        ->check(CLI::Range(0.0, 0.9));
    tuneCommand
        ->add_option("--assume", tuneOptions->assume,
                     "KEY=VALUE: servo constant the tuner assumes; a middling servo without it")
        ->expected(1)
        ->take_all();
    tuneCommand->add_option("--thread", tuneOptions->thread, "M3 to M20, fine as in M8x1; by pitch without it");
    tuneCommand->add_option("--seed", tuneOptions->seed, "of noise and spreads");
    tuneCommand->callback([tuneOptions] { tune(*tuneOptions); });

    auto evaluateOptions = std::make_shared<EvaluateOptions>();
    auto* evaluateCommand = tapping->add_subcommand("evaluate", "Figures and tolerance verdict of a record");
    evaluateCommand->add_option("record", evaluateOptions->file, "CSV with t_s,spindle_rev,z_mm")->required();
    evaluateCommand->add_option("--pitch-mm", evaluateOptions->pitch_mm, "pitch of the thread")
        ->required()
        ->check(CLI::Range(0.1, 10.0));
    evaluateCommand->add_option("--engage-rev", evaluateOptions->engage_rev, "revolutions before the tap touches")
        ->check(CLI::Range(0.0, 100.0));
    evaluateCommand->add_option("--thread", evaluateOptions->thread, "M3 to M20, fine as in M8x1; by pitch without it");
    evaluateOptions->read = addReadOptions(*evaluateCommand);
    evaluateCommand->callback([evaluateOptions] { evaluate(*evaluateOptions); });

    auto* tableCommand = tapping->add_subcommand("table", "The table of docs/tapping.md: tuners by scenario");
    tableCommand->callback([] { printTappingTable(); });
    addTappingRobust(*tapping);
}

}  // namespace kerf::headless
