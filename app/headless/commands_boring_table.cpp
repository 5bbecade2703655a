// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "app/files/output.h"
#include "app/headless/commands_boring.h"

namespace kerf::headless {
namespace {

struct TableOptions {
    std::uint32_t runs{4000};
    std::uint64_t seed{1};
};

struct Policy {
    const char* name;
    boring::EstimatorKind kind;
    boring::FeedPolicy policy;
};

constexpr std::array<Policy, 6> kPolicies{{
    {"fixed feed .5 mm/rev", boring::EstimatorKind::Kalman, boring::FeedPolicy::FixedFeed},
    {"off-line optimum then frozen", boring::EstimatorKind::Kalman, boring::FeedPolicy::FrozenOptimum},
    {"paper (perturbation)", boring::EstimatorKind::Perturbation, boring::FeedPolicy::Estimator},
    {"ours (kalman)", boring::EstimatorKind::Kalman, boring::FeedPolicy::Estimator},
    {"ours told when it changes", boring::EstimatorKind::Kalman, boring::FeedPolicy::ToldChanges},
    {"told the truth", boring::EstimatorKind::Kalman, boring::FeedPolicy::ToldTruth},
}};

enum class World { PaperChanges, NoChange, RandomChanges, Drift };

boring::CampaignSummary campaign(const TableOptions& options, const Policy& policy, double sigma_mm, double alpha0,
                                 World world) {
    constexpr std::uint64_t kTableStream = 3;
    constexpr double kDrift_percentPerPart = 1.5;
    constexpr double kFirstFeed_mmPerRev = 0.5;
    boring::CampaignParams params;
    params.estimator = boring::estimatorParams(policy.kind, sigma_mm, boring::kTableTargetDeflection_mm, alpha0);
    params.feed = boring::feedLawParams(policy.kind, boring::kTableTargetDeflection_mm, kFirstFeed_mmPerRev);
    params.policy = policy.policy;
    params.scrapBand_mm = 3.0 * sigma_mm;
    boring::CampaignTally tally;
    for (std::uint32_t run = 1; run <= options.runs; ++run) {
        boring::TruthPlan truth =
            world == World::PaperChanges ? boring::TruthPlan::paper() : boring::TruthPlan::table();
        if (world == World::RandomChanges) {
            Random random = Random(options.seed).stream(run).stream(kTableStream);
            truth = boring::randomChanges(random, boring::kTableTargetDeflection_mm);
        } else if (world == World::Drift) {
            truth.drift_percentPerPart = kDrift_percentPerPart;
        }
        tally.add(boring::simulateLot(params, truth, options.seed, run), truth);
    }
    return tally.summary();
}

void table(const TableOptions& options) {
    struct Case {
        double sigma_mm;
        double alpha0;
    };
    CsvOutput csv(
        "policy,sigma_mm,alpha0,scrap_paper_changes,ci95,scrap_random_changes,scrap_drift,scrap_no_change,steady_rms_"
        "sigma,"
        "detections_no_change,perturbed_after_change_1,perturbed_after_change_2");
    for (const Case& one : {Case{boring::kTableSigma_mm, 0.5}, Case{0.005, 1.0}}) {
        for (const Policy& policy : kPolicies) {
            const auto run = [&](World world) { return campaign(options, policy, one.sigma_mm, one.alpha0, world); };
            const auto paper = run(World::PaperChanges);
            const auto none = run(World::NoChange);
            csv.row(policy.name, one.sigma_mm, one.alpha0, paper.scrap.value, paper.scrap.half95,
                    run(World::RandomChanges).scrap.value, run(World::Drift).scrap.value, none.scrap.value,
                    none.steadyRms, none.detectionsPerLot, paper.perturbedAfterChange[0],
                    paper.perturbedAfterChange[1]);
        }
    }
    csv.flush();
}

}  // namespace

void addBoringTable(CLI::App& boring) {
    auto options = std::make_shared<TableOptions>();
    CLI::App* command = boring.add_subcommand(
        "table", "The table of docs/boring.md: scrapped parts of 30 for each way to choose the feed, CSV.");
    command->add_option("--runs", options->runs, "lots per figure")
        ->check(CLI::Range(2U, 100000U))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "same seed, same digits")->capture_default_str();
    command->callback([options] { table(*options); });
}

}  // namespace kerf::headless
