// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands_boring.h"
#include "app/headless/data_file.h"
#include "app/service/boring/boring_memory.h"

namespace kerf::headless {
namespace {

constexpr double kTwoSided95 = 1.959963984540054;
constexpr std::uint32_t kMostLots = 1000;

struct MemoryOptions {
    std::string folder{};
    std::int64_t lot{0};
    std::string partType{}, grade{}, material{};
    bool json{false};
};

template <class Value>
Value must(Result<Value> result) {
    if (!result) {
        throw BadInput(result.error().english());
    }
    return std::move(*result);
}

/// The lot in question (the newest one of boring when none is named), for its machine and recipe.
LotRow lotOf(db::DatabaseReader& reader, const MemoryOptions& options) {
    const auto lots = must(reader.lots(std::nullopt, kMostLots));
    for (const LotRow& lot : lots) {
        const bool wanted =
            options.lot == 0 ? options.partType.empty() || lot.partTypeName == options.partType : lot.id == options.lot;
        if (lot.process == ProcessId::Boring && wanted) {
            return lot;
        }
    }
    throw BadInput(options.lot != 0 ? fmt::format("--lot {}: there is no such lot of boring.", options.lot)
                   : options.partType.empty()
                       ? std::string("There is no lot of boring in this data file yet.")
                       : fmt::format("--part-type {}: there is no lot of it yet; without one no recipe is known.",
                                     options.partType));
}

struct Depth {
    double overhang_mm, feed_mmPerRev, deflection_mm, diameter_mm, half95_mm;
};

struct Answer {
    BoringMemoryBasis basis;
    BoringRecipe recipe;
    boring::Memory memory;
    bool uses{false};  ///< the next lot really begins from it
    boring::MemoryStart start;
    std::vector<Depth> depths;
};

std::vector<Depth> depthsOf(const BoringRecipe& recipe, const boring::MemoryStart& start) {
    const boring::EstimatorParams params = recipe.estimator(boring::EstimatorKind::Kalman);
    const boring::EstimatorState state = boring::stateFrom(start, params.kalman);
    const BoringSchedule schedule = boring::adviseFeed(state, recipe.feedLaw(boring::EstimatorKind::Kalman)).schedule;
    std::vector<Depth> depths;
    for (const DepthView& depth : recipe.depths) {
        const double feed_mmPerRev = schedule.feed_mmPerRev(depth.overhang_mm);
        const auto expected = boring::predict(state, params, feed_mmPerRev, depth.overhang_mm);
        const double diameter_mm = boring::diameterFromDeflection_mm(expected->deflection_mm, recipe.targetDiameter_mm,
                                                                     recipe.targetDeflection_mm, recipe.phi_deg);
        const double further_mm =
            boring::diameterFromDeflection_mm(expected->deflection_mm + expected->half95_mm, recipe.targetDiameter_mm,
                                              recipe.targetDeflection_mm, recipe.phi_deg);
        depths.push_back({depth.overhang_mm, feed_mmPerRev, expected->deflection_mm, diameter_mm,
                          std::abs(further_mm - diameter_mm)});
    }
    return depths;
}

Answer answerOf(const MemoryOptions& options) {
    const QtForSql qt;
    const auto reader = openReader(checkedDataFile(options.folder));
    const LotRow lot = lotOf(*reader, options);
    // A named lot keeps the recipe it was opened with; the next one takes the newest.
    const auto recipes = must(reader->recipes(lot.partType));
    const auto own = std::ranges::find(recipes, lot.recipe, &RecipeRevision::id);
    const BoringRecipe recipe = must(recipeFromJson(
        options.lot != 0 && own != recipes.end() ? own->parametersJson : recipes.front().parametersJson));
    BoringMemoryBasis basis;
    if (options.lot != 0) {
        basis = must(readBoringMemory(*reader, *reader, lot));
    } else {
        boring::MemoryContext context = must(memoryContextsOf(*reader, {&lot, 1})).front();
        if (!options.grade.empty()) {
            context.names[2] = options.grade;
        }
        if (!options.material.empty()) {
            context.names[3] = options.material;
        }
        basis = must(readBoringMemory(*reader, *reader, context));
    }
    const boring::LotBegin begin = lotBegin(basis, recipe);
    const auto params = recipe.estimator(boring::EstimatorKind::Kalman).kalman;
    boring::Memory memory(*begin.past, begin.context, params);
    const boring::MemoryStart start = memory.start();
    Answer answer{std::move(basis), recipe, std::move(memory), false, start, {}};
    answer.uses = begin.memory && answer.memory.usable();
    if (answer.memory.usable()) {
        answer.depths = depthsOf(recipe, start);
    }
    return answer;
}

double shareOf(const Answer& answer, LotId lot) {
    const auto found = std::ranges::find(answer.memory.weights(), lot, &boring::MemoryWeight::lot);
    return found == answer.memory.weights().end() ? 0.0 : found->share;
}

std::string whyOf(const Answer& answer) {
    if (!answer.recipe.usesMemory()) {
        return "The recipe says that lots begin from the wide prior (boring.memory is 0).";
    }
    if (answer.memory.weights().empty()) {
        return "No measured lot of this machine is there to begin from: the wide prior holds.";
    }
    if (!answer.memory.usable()) {
        return "The past is too odd or too little: it says less than the wide prior, which holds.";
    }
    return fmt::format("The next lot begins from {} lots; a new tool differs by {:.0f} % (1 sigma) in bending.",
                       answer.memory.weights().size(), 100.0 * answer.start.spread[0]);
}

void printMemory(const MemoryOptions& options) {
    const Answer answer = answerOf(options);
    const auto& names = answer.basis.context.names;
    if (!options.json) {
        fmt::print("{}\nmachine {}, part type {}, insert grade {}, material {}\n", whyOf(answer), names[0], names[1],
                   names[2].empty() ? "not told" : names[2], names[3].empty() ? "not told" : names[3]);
        if (answer.memory.usable()) {
            fmt::print(
                "bending {:.4f} mm at {:.3f} mm/rev and {:.0f} mm, alpha {:.3f} ± {:.3f}, beta {:.3f} ± {:.3f} "
                "(1 sigma)\n",
                std::exp(answer.start.level), std::exp(answer.start.lnFeed), std::exp(answer.start.lnOverhang),
                answer.start.law.alpha, answer.start.spread[1], answer.start.law.beta, answer.start.spread[2]);
        }
        for (const Depth& depth : answer.depths) {
            fmt::print("at {:.0f} mm: feed {:.3f} mm/rev, diameter {:.3f} ± {:.3f} mm (95 %)\n", depth.overhang_mm,
                       depth.feed_mmPerRev, depth.diameter_mm, depth.half95_mm);
        }
        for (const BoringMemoryLot& lot : answer.basis.past) {
            fmt::print("lot {} ({}, {}): {} tools, counts {:.1f} %{}\n", lot.lot.id, lot.lot.partTypeName, lot.lot.name,
                       lot.stretches.size(), 100.0 * shareOf(answer, lot.lot.id),
                       lot.leftOut ? fmt::format(", left out by {}: {}", lot.author, lot.reason) : std::string());
        }
        fmt::print("wide prior: counts {:.1f} %\n", 100.0 * answer.memory.priorShare());
        return;
    }
    nlohmann::ordered_json json;
    json["begins_from_memory"] = answer.uses;
    json["why"] = whyOf(answer);
    json["machine"] = names[0];
    json["part_type"] = names[1];
    json["insert_grade"] = names[2];
    json["material"] = names[3];
    if (answer.memory.usable()) {
        const auto& start = answer.start;
        json["ln_c"] = start.law.lnC;
        json["alpha"] = start.law.alpha;
        json["beta"] = start.law.beta;
        json["covariance"] = start.covariance;
        json["level"] = start.level;
        json["level_at_feed_mm_per_rev"] = std::exp(start.lnFeed);
        json["level_at_overhang_mm"] = std::exp(start.lnOverhang);
        json["spread"] = {{"level", start.spread[0]}, {"alpha", start.spread[1]}, {"beta", start.spread[2]}};
        json["half95"] = {{"level", kTwoSided95 * start.spread[0]},
                          {"alpha", kTwoSided95 * start.spread[1]},
                          {"beta", kTwoSided95 * start.spread[2]}};
    }
    json["expected"] = nlohmann::ordered_json::array();
    for (const Depth& depth : answer.depths) {
        json["expected"].push_back({{"overhang_mm", depth.overhang_mm},
                                    {"feed_mm_per_rev", depth.feed_mmPerRev},
                                    {"deflection_mm", depth.deflection_mm},
                                    {"diameter_mm", depth.diameter_mm},
                                    {"half95_mm", depth.half95_mm}});
    }
    json["spreads"] = nlohmann::ordered_json::array();
    for (const boring::MemorySpread& spread : answer.memory.spreads()) {
        json["spreads"].push_back({{"between", boring::memoryStepKey(spread.step)},
                                   {"branches", spread.branches},
                                   {"level", spread.tau[0]},
                                   {"alpha", spread.tau[1]},
                                   {"beta", spread.tau[2]}});
    }
    json["prior_share"] = answer.memory.priorShare();
    json["lots"] = nlohmann::ordered_json::array();
    for (const BoringMemoryLot& lot : answer.basis.past) {
        json["lots"].push_back({{"lot", lot.lot.id},
                                {"name", lot.lot.name},
                                {"part_type", lot.context.names[1]},
                                {"insert_grade", lot.context.names[2]},
                                {"material", lot.context.names[3]},
                                {"tools", lot.stretches.size()},
                                {"share", shareOf(answer, lot.lot.id)},
                                {"left_out", lot.leftOut},
                                {"reason", lot.reason}});
    }
    printJson(json);
}

}  // namespace

void addBoringMemory(CLI::App& boring) {
    auto options = std::make_shared<MemoryOptions>();
    CLI::App* command = boring.add_subcommand(
        "memory",
        "What the next lot would begin from, and why: the expected law with its spreads, the diameters it means, and "
        "how "
        "much\neach earlier lot counts. Computed from the stored bores each time; nothing is changed.");
    command->add_option("--data", options->folder, "folder of the data file; default: the console's own");
    command->add_option("--lot", options->lot, "what this stored lot began from, instead of the next one")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 60));
    command->add_option("--part-type", options->partType,
                        "for the next lot of this part type; default: as the newest lot");
    command->add_option("--insert-grade", options->grade, "for the next lot; default: as the newest lot");
    command->add_option("--material", options->material, "for the next lot; default: as the newest lot");
    command->add_flag("--json", options->json, "all of it as JSON");
    command->callback([options] { printMemory(*options); });
}

}  // namespace kerf::headless
