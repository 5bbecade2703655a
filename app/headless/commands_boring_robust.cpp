// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/files/output.h"
#include "app/headless/commands_boring.h"
#include "app/headless/robust_table.h"

namespace kerf::headless {
namespace {

struct BoringRobustOptions {
    RobustOptions shared{};
    double sigma_mm{0.005};
};

/// One machine under one law: what its lot of 30 came to.
struct Outcome {
    double scrap{0.0}, rms_um{0.0};
    bool unstable{false};
    double sigmaFactor{1.0};
};

Outcome boredBy(boring::EstimatorKind kind, const boring::HardMachine& machine, const BoringRobustOptions& options) {
    constexpr double kFirstFeed_mmPerRev = 0.5;
    constexpr std::size_t kSettled = 2;  // parts 1 and 2 are the same guess for both laws
    boring::CampaignParams params;
    params.estimator = boring::estimatorParams(kind, options.sigma_mm, boring::kTableTargetDeflection_mm, 0.5);
    params.feed = boring::feedLawParams(kind, boring::kTableTargetDeflection_mm, kFirstFeed_mmPerRev);
    params.scrapBand_mm = 3.0 * options.sigma_mm;
    params.hard = machine;
    params.learnSigma = true;
    const boring::LotResult lot = boring::simulateLot(params, machine.truth, options.shared.seed, 1);
    Outcome outcome;
    double squares = 0.0;
    for (std::size_t part = 0; part < lot.scrap.size(); ++part) {
        outcome.scrap += lot.scrap[part] ? 1.0 : 0.0;
        squares += part < kSettled ? 0.0 : lot.squaredError[part];
    }
    constexpr double kMicrometre = 1000.0;
    outcome.rms_um =
        kMicrometre * options.sigma_mm * std::sqrt(squares / static_cast<double>(lot.scrap.size() - kSettled));
    outcome.unstable = lot.unstable;
    outcome.sigmaFactor = lot.sigmaFactor;
    return outcome;
}

void boringRobust(const BoringRobustOptions& options) {
    CsvOutput csv(
        "machine_seed,scrap_default,scrap_simple,rms_default_um,rms_simple_um,ratio,worse,unstable_default,"
        "unstable_simple,sigma_factor_true,sigma_factor_found");
    RobustTally tally;
    double scrapDefault = 0.0;
    double scrapSimple = 0.0;
    double found = 0.0;
    double off = 0.0;
    for (std::uint32_t i = 1; i <= options.shared.machines; ++i) {
        const std::uint64_t seed = options.shared.machineSeed(i);
        const auto machine = boring::hardMachine(seed, boring::kTableTargetDeflection_mm);
        const Outcome ours = boredBy(boring::EstimatorKind::Kalman, machine, options);
        const Outcome simple = boredBy(boring::EstimatorKind::Perturbation, machine, options);
        const double ratio = ours.rms_um / simple.rms_um;
        const bool isWorse = ratio > 1.0;
        csv.row(seed, ours.scrap, simple.scrap, ours.rms_um, simple.rms_um, ratio, isWorse, ours.unstable,
                simple.unstable, machine.sigmaFactor, ours.sigmaFactor);
        tally.add({ratio, isWorse, ours.unstable, simple.unstable});
        scrapDefault += ours.scrap / options.shared.machines;
        scrapSimple += simple.scrap / options.shared.machines;
        if (std::abs(std::log2(machine.sigmaFactor)) > 0.75) {
            off += 1.0;
            found += std::log2(machine.sigmaFactor) * std::log2(ours.sigmaFactor) > 0.0 ? 1.0 : 0.0;
        }
    }
    if (options.shared.csv) {
        csv.flush();
        return;
    }
    nlohmann::ordered_json json{{"machines", options.shared.machines},
                                {"seed", options.shared.seed},
                                {"sigma_mm", options.sigma_mm},
                                {"scrap_mean_default", scrapDefault},
                                {"scrap_mean_simple", scrapSimple}};
    for (const auto& [name, value] : tally.figures()) {
        json[name] = value;
    }
    json["share_wrong_sigma_noticed"] = off > 0.0 ? found / off : 1.0;
    printJson(json);
}

}  // namespace

void addBoringRobust(CLI::App& boring) {
    auto options = std::make_shared<BoringRobustOptions>();
    CLI::App* command = boring.add_subcommand(
        "robust",
        "Hard machines, each drawn from a seed of its own (docs/boring.md): the default against the paper's law on the "
        "same lot of 30.\n"
        "--csv: machine_seed (for simulate --machine-seed),scrap_default,scrap_simple,rms_default_um,rms_simple_um (of "
        "d - d0\n"
        "  from part 3 on),ratio,worse,unstable_default,unstable_simple (the last ten parts scrap though a feed was "
        "there),\n"
        "  sigma_factor_true,sigma_factor_found. Without it, JSON: share_worse, worst_ratio, share_unstable and "
        "means.");
    options->shared.addTo(*command);
    command->add_option("--sigma-mm", options->sigma_mm, "assumed standard deviation of a measured deflection, mm")
        ->check(CLI::Range(1e-6, 10.0))
        ->capture_default_str();
    command->callback([options] { boringRobust(*options); });
}

}  // namespace kerf::headless
