// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands_boring.h"
#include "app/service/boring/shop_memory.h"

namespace kerf::headless {
namespace {

constexpr std::uint64_t kTruthStream = 3;

struct SimulateOptions {
    BoringOptions common{};
    std::uint32_t parts{30};
    std::uint32_t runs{1};
    std::uint32_t lots{1};
    std::string memory{"off"};
    std::uint32_t shopMachines{1};
    std::string shop{"on"};
    std::string firstPart{"fixed"};
    std::string announcedFile{};
    std::uint64_t machineSeed{0};
    bool learnSigma{false};
    std::uint64_t seed{1};
    double feed0_mmPerRev{0.5};
    std::optional<double> minFeed_mmPerRev{};
    std::optional<double> maxFeed_mmPerRev{};
    std::vector<std::string> changes{};
    std::vector<double> measureAt_mm{boring::CampaignParams{}.measureAt_mm};
    std::vector<double> evaluateAt_mm{boring::CampaignParams{}.evaluateAt_mm};
    std::string noiseFile{};
    std::string truthFile{};
    double drift_percent{0.0};
    bool randomChanges{false};
    double typoRate{0.0};
    bool noGate{false};
    std::string policy{"estimator"};
    bool csv{false};
    bool summary{false};
};

boring::TruthChange changeOf(const std::string& text) {
    std::array<double, 4> value{};
    const char* at = text.data();
    const char* end = text.data() + text.size();
    constexpr std::array<char, 4> kBehind{':', ',', ',', '\0'};
    bool good = true;
    for (std::size_t i = 0; i < value.size() && good; ++i) {
        const auto [stop, error] = std::from_chars(at, end, value[i]);
        good = error == std::errc{} && std::isfinite(value[i]) &&
               (i + 1 < value.size() ? stop != end && *stop == kBehind[i] : stop == end);
        at = good && stop != end ? stop + 1 : stop;
    }
    const bool sane = good && value[0] >= 1.0 && value[0] <= 1e6 && value[0] == std::floor(value[0]) &&
                      value[1] > 0.0 && value[3] > 0.0;
    if (!sane) {
        throw CLI::ValidationError("--change",
                                   "'" + text + "' is no PART:ALPHA,BETA,C with PART from 1, ALPHA and C above 0");
    }
    return {static_cast<std::uint32_t>(value[0]), {std::log(value[3]), value[1], value[2]}};
}

boring::FeedPolicy policyOf(const std::string& key) {
    if (key == "fixed") {
        return boring::FeedPolicy::FixedFeed;
    }
    if (key == "frozen") {
        return boring::FeedPolicy::FrozenOptimum;
    }
    if (key == "told-changes") {
        return boring::FeedPolicy::ToldChanges;
    }
    return key == "told-truth" ? boring::FeedPolicy::ToldTruth : boring::FeedPolicy::Estimator;
}

boring::TruthPlan basePlan(const SimulateOptions& options) {
    boring::TruthPlan plan = boring::TruthPlan::table();
    for (const std::string& text : options.changes) {
        const boring::TruthChange change = changeOf(text);
        if (change.fromPart == 1) {
            plan.changes.front() = change;
        } else if (change.fromPart > plan.changes.back().fromPart) {
            plan.changes.push_back(change);
        } else {
            throw CLI::ValidationError("--change", "'" + text + "' does not come after the change before it");
        }
    }
    plan.drift_percentPerPart = options.drift_percent;
    return plan;
}

boring::TruthPlan randomPlan(const SimulateOptions& options, std::uint32_t run, std::uint32_t lot) {
    const Random ofRun = Random(options.seed).stream(run).stream(kTruthStream);
    Random random = lot == 1 ? ofRun : ofRun.stream(lot);
    boring::TruthPlan truth = boring::randomChanges(random, options.common.targetDeflection_mm);
    truth.drift_percentPerPart = options.drift_percent;
    return truth;
}

void checkDepths(const char* option, const std::vector<double>& overhangs_mm, std::size_t most) {
    if (overhangs_mm.empty() || overhangs_mm.size() > most) {
        throw CLI::ValidationError(option, fmt::format("expects 1 to {} overhangs", most));
    }
    for (std::size_t i = 0; i < overhangs_mm.size(); ++i) {
        const bool twice = std::count(overhangs_mm.begin(), overhangs_mm.end(), overhangs_mm[i]) > 1;
        if (!(overhangs_mm[i] > 0.0) || !std::isfinite(overhangs_mm[i]) || twice) {
            throw CLI::ValidationError(option, "expects different overhangs above 0 mm");
        }
    }
}

nlohmann::ordered_json summaryJson(const SimulateOptions& options, std::uint32_t runs, std::uint32_t lots,
                                   const boring::CampaignSummary& s) {
    return {{"estimator", options.common.estimator},
            {"policy", options.policy},
            {"parts", options.parts},
            {"runs", runs},
            {"lots", lots},
            {"memory", options.memory},
            {"first_part", options.firstPart},
            {"seed", options.seed},
            {"sigma_mm", options.common.sigma_mm},
            {"alpha0", options.common.alpha0},
            {"feed0_mm_per_rev", options.feed0_mmPerRev},
            {"scrap_mean", s.scrap.value},
            {"scrap_ci95", s.scrap.half95},
            {"scrap_per_lot", s.scrapPerLot},
            {"scrap_from_part_4_mean", s.scrapFromPart4.value},
            {"false_alarm", s.falseAlarm},
            {"detections_mean", s.detectionsPerLot},
            {"in_band_from_part_4", s.inBandFromPart4},
            {"steady_rms_sigma", s.steadyRms},
            {"perturbed_after_change", s.perturbedAfterChange},
            {"bad_parts_after_change", s.badPartsAfterChange},
            {"feed_error_percent_mean", s.feedErrorMean_percent},
            {"asked_mean", s.asked},
            {"asked_wrongly_mean", s.askedWrongly},
            {"refused_mean", s.refused}};
}

/// A machine's newest lots as the other machines of its shop see them.
void addForOthers(std::vector<boring::PastLot>& shop, std::span<const boring::PastLot> lots, std::uint32_t run) {
    for (const boring::PastLot& lot : lots.last(std::min<std::size_t>(lots.size(), kShopLotsPerMachine))) {
        shop.push_back(lot);
        shop.back().id = -1 - static_cast<std::int64_t>(shop.size());
        shop.back().context.names[0] = "run " + std::to_string(run);
    }
}

void simulate(const SimulateOptions& options, bool runsGiven, bool lotsGiven) {
    if (options.randomChanges && (!options.changes.empty() || !options.truthFile.empty())) {
        throw CLI::ValidationError("--random-changes", "cannot be combined with --change or --truth");
    }
    if (!options.truthFile.empty() && (!options.changes.empty() || options.drift_percent != 0.0)) {
        throw CLI::ValidationError("--truth", "cannot be combined with --change or --drift-percent");
    }
    if (options.policy == "told-changes" && options.common.estimator != "kalman") {
        throw CLI::ValidationError("--policy", "told-changes needs --estimator kalman");
    }
    if (options.machineSeed != 0 && (options.randomChanges || !options.changes.empty() || !options.truthFile.empty())) {
        throw CLI::ValidationError("--machine-seed",
                                   "brings its own truth: not with --change, --random-changes, --truth");
    }
    if (options.learnSigma && (options.memory == "on" || options.common.estimator != "kalman")) {
        throw CLI::ValidationError("--learn-sigma", "needs --estimator kalman and --memory off");
    }
    if (options.memory == "on" && options.common.estimator != "kalman") {
        throw CLI::ValidationError("--memory", "on needs --estimator kalman");
    }
    if (options.shopMachines > 1 && options.memory == "off") {
        throw CLI::ValidationError("--shop-machines", "needs --memory on");
    }
    checkDepths("--measure-at", options.measureAt_mm, kMaxBoreDepths);
    checkDepths("--evaluate-at", options.evaluateAt_mm, 1000);
    const boring::TruthPlan plan =
        options.machineSeed != 0 ? boring::hardMachine(options.machineSeed, options.common.targetDeflection_mm).truth
                                 : basePlan(options);

    boring::CampaignParams params;
    params.estimator = options.common.params();
    params.feed =
        boring::feedLawParams(params.estimator.kind, options.common.targetDeflection_mm, options.feed0_mmPerRev);
    params.feed.minFeed_mmPerRev = options.minFeed_mmPerRev.value_or(params.feed.minFeed_mmPerRev);
    params.feed.maxFeed_mmPerRev = options.maxFeed_mmPerRev.value_or(params.feed.maxFeed_mmPerRev);
    if (!(params.feed.minFeed_mmPerRev < params.feed.maxFeed_mmPerRev)) {
        throw CLI::ValidationError("--min-feed", "must be below --max-feed");
    }
    params.policy = policyOf(options.policy);
    params.parts = options.parts;
    params.measureAt_mm = options.measureAt_mm;
    params.evaluateAt_mm = options.evaluateAt_mm;
    params.scrapBand_mm = 3.0 * options.common.sigma_mm;
    params.typoRate = options.typoRate;
    params.gated = !options.noGate;
    params.memory = options.memory == "on";
    params.teach = options.firstPart == "teach";
    params.learnSigma = options.learnSigma;
    params.hard = boring::hardMachine(options.machineSeed, options.common.targetDeflection_mm);

    std::uint32_t runs = options.runs;
    std::uint32_t firstRun = 1;
    std::optional<NoiseFile> noise;
    std::uint32_t lots = options.lots;
    std::uint32_t firstLot = 1;
    std::vector<std::vector<boring::TruthPlan>> plans;
    if (!options.noiseFile.empty()) {
        noise.emplace(options.noiseFile);
        runs = runsGiven ? runs : noise->runs();
        firstRun = noise->firstRun();
    }
    if (!options.truthFile.empty()) {
        const TruthFile truth(options.truthFile);
        runs = runsGiven || noise ? runs : truth.runs();
        firstRun = noise ? firstRun : truth.firstRun();
        lots = lotsGiven ? lots : truth.lots();
        firstLot = truth.firstLot();
        plans = truth.plans(runs, lots, options.parts);
    }
    if (runs % options.shopMachines != 0) {
        throw CLI::ValidationError("--shop-machines", "the runs (" + std::to_string(runs) + ") are not whole shops");
    }
    if (noise) {
        const auto first_mm = params.teach ? boring::teachDepths_mm(params) : options.measureAt_mm;
        noise->require({runs, lots, options.parts, first_mm, options.measureAt_mm});
        params.noise = [&noise](std::uint32_t run, std::uint32_t lot, std::uint32_t part, std::size_t depth) {
            return noise->z(run, lot, part, depth);
        };
    }
    std::optional<AnnouncedFile> announced;
    if (!options.announcedFile.empty()) {
        announced.emplace(options.announcedFile, firstRun, firstLot);
    }

    CsvOutput csv(
        "run,part,overhang_mm,measured,feed_mm_per_rev,deflection_true_mm,deflection_measured_mm,ln_c,alpha,beta,"
        "perturbed,lot");
    std::function<void(const boring::CampaignRow&)> sink;
    if (options.csv) {
        sink = [&](const boring::CampaignRow& row) {
            const auto& after = row.outcome.after;
            const auto cells = [&](const auto& measured, const auto& lnC, const auto& alpha, const auto& beta) {
                csv.row(row.run + firstRun - 1U, row.part, row.overhang_mm, row.measured, row.feed_mmPerRev,
                        row.deflectionTrue_mm, measured, lnC, alpha, beta, row.outcome.perturbed,
                        row.lot + firstLot - 1U);
            };
            const auto estimate = [&](const auto& measured) {
                after.ready ? cells(measured, after.law.lnC, after.law.alpha, after.law.beta)
                            : cells(measured, "", "", "");
            };
            row.measured ? estimate(row.deflectionMeasured_mm) : estimate("");
        };
    }
    boring::CampaignTally tally;
    std::vector<boring::PastLot> shop;  // lots of the machines before in the same shop
    for (std::uint32_t run = 1; run <= runs; ++run) {
        const std::uint32_t machine = (run - 1U) % options.shopMachines + 1U;
        const bool counts = machine == options.shopMachines;
        std::vector<boring::PastLot> past;
        if (counts && options.shop == "on") {
            past = shop;
        }
        for (std::uint32_t lot = 1; lot <= lots; ++lot) {
            const boring::TruthPlan truth = options.randomChanges ? randomPlan(options, run, lot)
                                            : plans.empty()       ? plan
                                                                  : plans[run - 1U][lot - 1U];
            const auto changes = announced ? announced->changes(run, lot) : std::vector<boring::AnnouncedChange>{};
            boring::LotResult result =
                boring::simulateLot(params, truth, options.seed, run, sink, {lot, past, changes});
            if (counts) {
                tally.add(result, truth, lot);
            }
            past.push_back({lot, {}, std::move(result.stretches)});
        }
        if (counts) {
            shop.clear();
        } else {
            addForOthers(shop, past, run);
        }
    }
    if (options.csv) {
        csv.flush();
    } else {
        nlohmann::ordered_json summary = summaryJson(options, runs, lots, tally.summary());
        if (options.shopMachines > 1) {
            summary["shop_machines"] = options.shopMachines;
            summary["shop"] = options.shop;
        }
        printJson(summary);
    }
}

}  // namespace

void addBoringSimulate(CLI::App& boring) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command = boring.add_subcommand(
        "simulate",
        "Simulated lots: cut, measure, estimate, next feed. Part 1 is cut at --feed0. A part is scrap when its true "
        "deflection\n"
        "is more than 3σ off d0 at any --evaluate-at overhang.\n"
        "--csv: "
        "run,part,overhang_mm,measured,feed_mm_per_rev,deflection_true_mm,deflection_measured_mm,ln_c,alpha,beta,\n"
        "  perturbed,lot; per part the measured depths in measuring order, then those only evaluated; estimate after "
        "the "
        "row.\n"
        "--summary (default), JSON: scrap_mean per lot and scrap_ci95 (half width of its 95 % interval); "
        "scrap_per_lot[] "
        "(mean over runs, lot by lot);\n  false_alarm "
        "(share\n"
        "  of lots that perturbed between part 4 and the first change); perturbed_after_change[] (share of lots, per "
        "change,\n"
        "  before the next one); bad_parts_after_change[] (mean scrap likewise); feed_error_percent_mean[] (per part,\n"
        "  |S − S_opt(true)|/S_opt(true)); in_band_from_part_4 and steady_rms_sigma up to the first change; "
        "asked_mean\n"
        "  (plausibility questions per lot).");
    auto* app = command;
    app->add_option("--parts", options->parts, "parts per lot")->check(CLI::Range(1U, 100000U))->capture_default_str();
    CLI::Option* runs =
        app->add_option("--runs", options->runs, "lots; default: as many as the noise or truth file has, else 1")
            ->check(CLI::Range(1U, 1000000U));
    CLI::Option* lots = app->add_option("--lots", options->lots,
                                        "lots per run, one after the other; default: as many as the truth file has")
                            ->check(CLI::Range(1U, 1000U));
    app->add_option("--memory", options->memory,
                    "on: a lot begins from the lots of its run before it, and an announced change draws on them; off: "
                    "each lot\n"
                    "begins from the wide prior and announcements are not used")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    app->add_option(
           "--shop-machines", options->shopMachines,
           "with --memory on: so many runs after one another are the machines of one shop, and only the last of "
           "each\nshop is counted in the summary")
        ->check(CLI::Range(1U, 20U))
        ->capture_default_str();
    app->add_option(
           "--shop", options->shop,
           "on: the last machine of a shop draws on the newest 6 lots of each other one; off: on its own alone")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    app->add_option("--first-part", options->firstPart,
                    "teach: without a past the feed varies along the first part, which is measured in the middle too; "
                    "fixed: --feed0")
        ->check(CLI::IsMember({"teach", "fixed"}))
        ->capture_default_str();
    app->add_option("--machine-seed", options->machineSeed,
                    "a hard machine drawn from this seed (docs/boring.md); 0: the reference machine")
        ->capture_default_str();
    app->add_flag("--learn-sigma", options->learnSigma, "the gauge's σ is learnt from the bores instead of --sigma-mm");
    app->add_option("--announced", options->announcedFile,
                    "CSV run,lot,part: the first part cut with a new insert, as the operator announces it");
    app->add_option("--seed", options->seed, "same seed, same digits")->capture_default_str();
    options->common.addTo(*app);
    app->add_option("--feed0", options->feed0_mmPerRev, "constant feed of part 1, mm/rev")
        ->check(CLI::Range(1e-4, 100.0))
        ->capture_default_str();
    app->add_option("--min-feed", options->minFeed_mmPerRev, "lowest feed of the schedule, mm/rev; default .005")
        ->check(CLI::Range(1e-6, 100.0));
    app->add_option("--max-feed", options->maxFeed_mmPerRev, "highest feed of the schedule, mm/rev; default 2")
        ->check(CLI::Range(1e-6, 100.0));
    app->add_option("--change", options->changes,
                    "PART:ALPHA,BETA,C, the true law from that part on; may stand several times")
        ->allow_extra_args(false)
        ->take_all();
    app->add_option("--drift-percent", options->drift_percent, "the true C grows by this per part")
        ->check(CLI::Range(-50.0, 50.0));
    app->add_flag(
        "--random-changes", options->randomChanges,
        "two changes per lot, at random parts 5-15 and 16-26: α .3-.8, β .1-.5, deflection at (.114 mm/rev, 175 mm)\n"
        "times e^-.8 to e^.8 of the target");
    app->add_option("--measure-at", options->measureAt_mm, "overhangs measured, mm, in this order (1 to 8)")
        ->delimiter(',');
    app->add_option("--evaluate-at", options->evaluateAt_mm, "overhangs that decide over scrap, mm")->delimiter(',');
    app->add_option("--noise", options->noiseFile,
                    "CSV run,[lot,]part,overhang_mm,z: the standard normal noise to use");
    app->add_option("--truth", options->truthFile, "CSV run,[lot,]part,alpha,beta,c_mm: the true law of every part");
    app->add_option("--typo-rate", options->typoRate, "share of entries that slip by a decade, up or down")
        ->check(CLI::Range(0.0, 1.0));
    app->add_flag("--no-gate", options->noGate, "accept implausible entries without asking (d ≤ 0 stays refused)");
    app->add_option("--policy", options->policy,
                    "who chooses the feed: estimator; fixed (feed0); frozen (true optimum of part 1); told-changes "
                    "(kalman told\n"
                    "when the process changed); told-truth (true optimum)")
        ->check(CLI::IsMember({"estimator", "fixed", "frozen", "told-changes", "told-truth"}))
        ->capture_default_str();
    CLI::Option* csv = app->add_flag("--csv", options->csv, "print every row");
    app->add_flag("--summary", options->summary, "print the figures (default)")->excludes(csv);
    app->callback([options, runs, lots] { simulate(*options, runs->count() > 0, lots->count() > 0); });
}

}  // namespace kerf::headless
