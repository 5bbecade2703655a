// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands_boring.h"
#include "app/headless/data_file.h"
#include "app/service/boring/shop_memory.h"
#include "db/shop/pg_connection.h"
#include "db/statement.h"

namespace kerf::headless {
namespace {

constexpr double kTwoSided95 = 1.959963984540054;
constexpr std::uint32_t kMostLots = 1000;

struct MemoryOptions {
    std::string folder{};
    std::int64_t lot{0};
    std::string partType{}, grade{}, material{};
    std::string shop{};
    bool json{false};
};

template <class Value>
Value must(Result<Value> result) {
    if (!result) {
        throw BadInput(result.error().english());
    }
    if constexpr (!std::is_void_v<Value>) {
        return std::move(*result);
    }
}

/// The lot in question (the newest one of boring when none is named), for its machine and recipe.
LotRow lotOf(db::DatabaseReader& reader, const MemoryOptions& options) {
    const auto lots = must(reader.lots(std::nullopt, kMostLots, ProcessId::Boring));
    for (const LotRow& lot : lots) {
        const bool wanted =
            options.lot == 0 ? options.partType.empty() || lot.partTypeName == options.partType : lot.id == options.lot;
        if (wanted) {
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
    std::optional<std::string> withoutShop;  ///< why it was asked and has not answered; empty text: it has
};

constexpr db::PgConnection::Timeouts kPatience{5000, 20000};

/// Lots of other machines into the basis; why there are none when the shop does not answer, else an empty text.
std::string drawOnShop(db::DatabaseReader& reader, const std::string& file, const LotRow& lot,
                       const std::string& conninfo, BoringMemoryBasis& basis) {
    const auto machines = must(reader.machines());
    const auto machine = std::ranges::find(machines, lot.machine, &MachineRow::id);
    const bool simulated = machine != machines.end() && machine->kind == "simulator";
    const db::Interrupt interrupt;
    try {
        db::PgConnection server(conninfo, interrupt, kPatience);
        basis.shop = askShopLots(server, lot.partTypeName, storeOf(file), simulated);
    } catch (const db::PgFailure& failure) {
        return failure.kind() == db::PgFailure::Kind::NoSchema ? std::string("there is no shop in this database")
                                                               : std::string(failure.what());
    } catch (const db::SqlFailure& failure) {
        throw BadInput(failure.sentence().english());
    }
    must(applyLeftOut(reader, basis.shop));
    return {};
}

std::vector<Depth> depthsOf(const BoringRecipe& recipe, const boring::MemoryStart& start) {
    const boring::EstimatorParams params = recipe.estimator(boring::EstimatorKind::Kalman);
    const boring::EstimatorState state = boring::stateFrom(start, params.kalman);
    const BoringSchedule schedule = boring::adviseFeed(state, recipe.feedLawWithMemory()).schedule;
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
    const std::string file = checkedDataFile(options.folder);
    const auto reader = openReader(file);
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
    std::optional<std::string> withoutShop;
    if (!options.shop.empty()) {
        withoutShop = drawOnShop(*reader, file, lot, checkedConninfo("--shop", options.shop), basis);
        if (!withoutShop->empty()) {
            fmt::print(stderr, "kerf: the shop cannot be read ({}); this is memory without it.\n", *withoutShop);
        }
    }
    const boring::LotBegin begin = lotBegin(basis, recipe);
    const auto params = recipe.estimator(boring::EstimatorKind::Kalman).kalman;
    boring::Memory memory(*begin.past, begin.context, params);
    const boring::MemoryStart start = memory.start();
    Answer answer{std::move(basis), recipe, std::move(memory), false, start, {}, std::move(withoutShop)};
    answer.uses = begin.memory && answer.memory.usable();
    if (answer.memory.usable()) {
        answer.depths = depthsOf(recipe, start);
    }
    return answer;
}

double shareOf(const Answer& answer, const BoringMemoryLot& lot) {
    const auto found = std::ranges::find(answer.memory.weights(), lot.memoryId, &boring::MemoryWeight::lot);
    return found == answer.memory.weights().end() ? 0.0 : found->share;
}

std::size_t shopLotsUsed(const Answer& answer) {
    return static_cast<std::size_t>(
        std::ranges::count_if(answer.basis.shop, [](const BoringMemoryLot& lot) { return !lot.leftOut; }));
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
    const std::size_t shop = shopLotsUsed(answer);
    const std::string others = shop > 0 ? fmt::format(" and {} of other machines", shop) : std::string();
    return fmt::format("The next lot begins from {} lots{}; a new tool differs by {:.0f} % (1 sigma) in bending.",
                       answer.memory.weights().size() - shop, others, 100.0 * answer.start.spread[0]);
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
                       lot.stretches.size(), 100.0 * shareOf(answer, lot),
                       lot.leftOut ? fmt::format(", left out by {}: {}", lot.author, lot.reason) : std::string());
        }
        for (const BoringMemoryLot& lot : answer.basis.shop) {
            fmt::print("machine {}, lot {} of console {} ({}, {}): {} tools, counts {:.1f} %{}\n", lot.lot.machineName,
                       lot.lot.id, lot.store, lot.lot.partTypeName, lot.lot.name, lot.stretches.size(),
                       100.0 * shareOf(answer, lot),
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
                                {"share", shareOf(answer, lot)},
                                {"left_out", lot.leftOut},
                                {"reason", lot.reason}});
    }
    if (answer.withoutShop) {
        json["shop"] = {{"reached", answer.withoutShop->empty()}, {"why", *answer.withoutShop}};
    }
    json["shop_lots"] = nlohmann::ordered_json::array();
    for (const BoringMemoryLot& lot : answer.basis.shop) {
        json["shop_lots"].push_back({{"machine", lot.lot.machineName},
                                     {"console", lot.store},
                                     {"lot", lot.lot.id},
                                     {"name", lot.lot.name},
                                     {"part_type", lot.lot.partTypeName},
                                     {"insert_grade", lot.context.names[2]},
                                     {"material", lot.context.names[3]},
                                     {"tools", lot.stretches.size()},
                                     {"share", shareOf(answer, lot)},
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
    CLI::Option* lot =
        command->add_option("--lot", options->lot, "what this stored lot began from, instead of the next one")
            ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 60));
    command->add_option("--part-type", options->partType,
                        "for the next lot of this part type; default: as the newest lot");
    command->add_option("--insert-grade", options->grade, "for the next lot; default: as the newest lot");
    command->add_option("--material", options->material, "for the next lot; default: as the newest lot");
    command
        ->add_option(
            "--shop", options->shop,
            "PostgreSQL of the shop as libpq takes it: draw on lots of the same part type on other machines, too; "
            "out of\nreach: memory without them, and a sentence that says so")
        ->excludes(lot);
    command->add_flag("--json", options->json, "all of it as JSON");
    command->callback([options] { printMemory(*options); });
}

}  // namespace kerf::headless
