// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/tapping_robust.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "app/files/output.h"
#include "app/headless/robust_table.h"
#include "app/headless/tapping_table.h"
#include "engine/process/tapping/thread_table.h"
#include "engine/process/tapping/trial_machine.h"

namespace kerf::headless {
namespace {

using namespace tapping;

struct TapOutcome {
    Tuning tuning{};
    TuningVerdict verdict{};
    bool oscillates{false};  ///< in any trial, or with what was kept
};

TapOutcome tuned(const DriveParams& drive, double allowedPp_um, std::uint64_t seed) {
    TunerSetup setup;
    setup.assumed = knownTo(drive, middlingDrive());
    setup.initial = settingsOf(drive);
    setup.maxTaps = kMaxTaps;
    TapOutcome out;
    out.tuning = runTuning(setup, drive, kShopFloor, seed);
    out.verdict = judgeTuning(out.tuning, allowedPp_um);
    const double critical_perS = criticalZKp_perS(drive);
    out.oscillates = oscillates(drive, out.tuning.final) ||
                     std::ranges::any_of(out.tuning.trials,
                                         [&](const Trial& trial) { return trial.settings.zKp_perS >= critical_perS; });
    return out;
}

void tappingRobust(const RobustOptions& options) {
    CsvOutput csv(
        "machine_seed,pp_default_um,pp_simple_um,saec_default_mm,saec_simple_mm,ratio,worse,unstable_default,"
        "unstable_simple,within_default,within_simple,limited_by,proposed_acc_rev_s2,pp_proposed_um,within_proposed,"
        "taps");
    const double allowed_um = findThread("M8")->allowedPp_um();
    RobustTally tally;
    double within = 0.0;
    double withinSimple = 0.0;
    double proposed = 0.0;
    double withinProposed = 0.0;
    double resonances = 0.0;
    for (std::uint32_t i = 1; i <= options.machines; ++i) {
        const std::uint64_t seed = options.machineSeed(i);
        const DriveParams drive = hardDrive(seed);
        const TapOutcome ours = tuned(drive, allowed_um, seed);
        const ContourFigures& before = ours.tuning.before;
        const ContourFigures& after = ours.tuning.after;
        const double ratio = std::max(after.engagedPp_um / before.engagedPp_um, after.saec_mm / before.saec_mm);
        const bool simpleWithin = before.engagedPp_um <= allowed_um;
        const bool simpleOscillates = oscillates(drive, settingsOf(drive));
        std::optional<TapOutcome> eased;
        if (ours.verdict.proposedRamp_revPerS2) {
            DriveParams slower = drive;
            slower.ramp_revPerS2 = *ours.verdict.proposedRamp_revPerS2;
            eased = tuned(slower, allowed_um, seed);
            proposed += 1.0;
            withinProposed += eased->verdict.within ? 1.0 : 0.0;
        }
        const auto field = [](bool there, double value) { return there ? fmt::format("{}", value) : std::string{}; };
        csv.row(seed, after.engagedPp_um, before.engagedPp_um, after.saec_mm, before.saec_mm, ratio, ratio > 1.0,
                ours.oscillates || (eased && eased->oscillates), simpleOscillates, ours.verdict.within, simpleWithin,
                limitKey(ours.verdict.limitedBy),
                field(eased.has_value(), ours.verdict.proposedRamp_revPerS2.value_or(0.0)),
                field(eased.has_value(), eased ? eased->tuning.after.engagedPp_um : 0.0),
                std::string(eased ? (eased->verdict.within ? "1" : "0") : ""), ours.tuning.trials.size());
        tally.add({ratio, ratio > 1.0, ours.oscillates || (eased && eased->oscillates), simpleOscillates});
        within += ours.verdict.within ? 1.0 : 0.0;
        withinSimple += simpleWithin ? 1.0 : 0.0;
        resonances += ours.tuning.setup.measured && ours.tuning.setup.measured->resonance_Hz > 0.0 ? 1.0 : 0.0;
    }
    if (options.csv) {
        csv.flush();
        return;
    }
    nlohmann::ordered_json json{{"machines", options.machines}, {"seed", options.seed}};
    for (const auto& [name, value] : tally.figures())
        json[name] = value;
    const auto machines = static_cast<double>(options.machines);
    json["share_within_default"] = within / machines;
    json["share_within_simple"] = withinSimple / machines;
    json["share_ramp_proposed"] = proposed / machines;
    json["share_within_at_proposed_ramp"] =
        proposed > 0.0 ? nlohmann::ordered_json(withinProposed / proposed) : nullptr;
    json["share_resonance_found"] = resonances / machines;
    printJson(json);
}

}  // namespace

void addTappingRobust(CLI::App& tapping) {
    auto options = std::make_shared<RobustOptions>();
    CLI::App* command = tapping.add_subcommand(
        "robust",
        "Hard machines, each drawn from a seed of its own (docs/tapping.md): tuned by the default against the gains as "
        "programmed.\n"
        "--csv: machine_seed (for simulate and tune --machine-seed), engaged p-p and SAEC of both, ratio (the larger "
        "of "
        "the two\n"
        "  ratios), worse, unstable, inside the tolerance (M8, 6H), limited_by, the ramp proposed and the p-p tuned "
        "again with\n"
        "  it, taps. Without it, JSON: share_worse, worst_ratio, share_unstable and more.");
    options->addTo(*command);
    command->callback([options] { tappingRobust(*options); });
}

}  // namespace kerf::headless
