// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/tapping_room.h"

#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "app/service/tapping/tapping_tuning_json.h"
#include "engine/machine/linuxcnc/assumed_drive.h"
#include "engine/machine/simulated/simulated_tapping.h"
#include "engine/process/tapping/tapping_loop.h"
#include "engine/process/tapping/trial_machine.h"
#include "ui/pages/tapping/tapping_page.h"

namespace kerf::console {
namespace {

constexpr const char* kBeforehand = "Kerf";
constexpr std::uint32_t kPreparedTaps = 3;
constexpr double kSlavedAbortOverAllowed = 25.0;  ///< untuned, a Z that follows the spindle lags by its whole speed

/// The recipe of a thread before anything was tuned, when a lot was opened with it or it has limits: there are no gains
/// of Kerf's in it.
constexpr const char* kMachinesOwn = R"({"machines_own":true)";

std::string machinesOwn(const TapChoice& choice) {
    nlohmann::ordered_json own;
    own["machines_own"] = true;
    own["thread"] = choice.thread;
    return own.dump();
}

/// Oldest first; one that cannot be read is left out and named in the log.
std::vector<tapping::StoredTuning> storedTunings(RecipeBook& book) {
    std::vector<tapping::StoredTuning> tunings;
    const auto recipes = book.all();
    if (!recipes) {
        spdlog::error("tunings: {}", recipes.error().english());
        return tunings;
    }
    for (const RecipeBook::Recipe& recipe : *recipes) {
        if (recipe.revision.parametersJson.starts_with(kMachinesOwn)) {
            continue;
        }
        if (auto tuning = formats::tuningFromJson(recipe.revision.parametersJson)) {
            tunings.push_back(std::move(*tuning));
            tunings.back().recipe = recipe.revision.id;
        } else {
            spdlog::error("tuning {} of {}: {}", recipe.revision.revision, recipe.partType, tuning.error().english());
        }
    }
    return tunings;
}

}  // namespace

ui::PageEntry TappingRoom::page() const {
    return ui::tappingPageEntry();
}

bool TappingRoom::fits(const std::string& machineKind) const {
    return machineKind != "diamond-lathe";
}

std::unique_ptr<SimulatedProcess> TappingRoom::makePlant(const Options& options) {
    SimulatedTapping::Params params;
    params.drive = tapping::hardDrive(options.machineSeed);
    params.noise_um = 2.0;
    params.loadSpread = 0.2;
    params.frictionSpread = 0.1;
    params.seed = options.seed;
    return std::make_unique<SimulatedTapping>(params);
}

std::unique_ptr<ProcessLoop> TappingRoom::makeLoop() {
    return std::make_unique<TappingLoop>(*m_exchange);
}

void TappingRoom::open(const Context& context) {
    m_writer = &context.writer;
    StoredTappingService::Params params;
    if (context.options.machine == "linuxcnc") {
        params.assumed = linuxcnc::assumedDrive(linuxcnc::kAssumedBandwidth_perS);
        params.abortOverAllowed = kSlavedAbortOverAllowed;
    }
    params.rights = context.rights;
    params.note = [this](const std::string& who, const char* key, const std::string& what) {
        AddAudit entry;
        entry.author = who;
        entry.action = what;
        entry.object = key;
        m_writer->submit(entry, {});
    };
    m_recipes.emplace(context.writer, context.reader, ProcessId::Tapping);
    m_history.emplace(StoredRecipeHistory::Links{
        *m_recipes, [this] { return m_service->view().choice.thread; },
        [this](const RecipeRevision& revision, const std::string& author, const std::string& reason,
               const RecipeHistory::Done& done) { restore(revision, author, reason, done); }});
    params.recipes = &*m_history;
    params.known = storedTunings(*m_recipes);
    params.store = [this](const tapping::StoredTuning& tuning, const tapping::TuningWords& words,
                          const StoredTappingService::Params::Kept& done) { keep(tuning, words, done); };
    LotBook::Links lots{context.writer, context.engine, context.reader, ProcessId::Tapping, context.rights};
    lots.partType = [this] { return m_service->view().choice.thread; };
    lots.parametersJson = [this] { return machinesOwn(m_service->view().choice); };
    lots.settled = [this, &engine = context.engine] { return m_service->loaded(engine.status()); };
    lots.machineKind = context.options.machine;
    m_lots.emplace(std::move(lots));
    params.lots = &*m_lots;
    params.order = [this](std::int64_t recipe) {
        m_lots->use(recipe);
        return m_lots->withLoad();
    };
    m_service = std::make_unique<StoredTappingService>(context.engine, *m_exchange, std::move(params));
}

bool TappingRoom::prepared(EngineApi& engine) {
    if (!m_service) {
        return true;
    }
    const TuningState state = m_service->view().state;
    if (state == TuningState::None) {
        return !m_service->begin(kBeforehand, true).has_value();
    }
    if (state != TuningState::Done) {
        return state == TuningState::Failed;
    }
    return cutBeforehand(engine, ProcessId::Tapping, engine.status().tapping.productionTaps, kPreparedTaps);
}

void TappingRoom::poll() {
    if (m_service) {
        m_service->poll();
        m_lots->send();
    }
}

RecipeHeld TappingRoom::recipe() {
    return m_service ? RecipeHeld{m_service->view().choice.thread, machinesOwn(m_service->view().choice), false}
                     : RecipeHeld{};
}

void TappingRoom::recipeRevised(RecipeRevisionId revision) {
    m_service->recipeRevised(revision);
}

void TappingRoom::keep(const tapping::StoredTuning& tuning, const tapping::TuningWords& words,
                       const StoredTappingService::Params::Kept& done) {
    m_recipes->keep(tuning.choice.thread, formats::tuningToJson(tuning), words.author, words.reason, words.restoredFrom,
                    [this, done](const Result<Receipt>& receipt) {
                        m_service->setStoreProblem(receipt ? Sentence{} : receipt.error());
                        if (done)
                            done(receipt ? Result<RecipeRevisionId>(receipt->id) : tl::unexpected(receipt.error()));
                    });
}

void TappingRoom::restore(const RecipeRevision& revision, const std::string& author, const std::string& reason,
                          const RecipeHistory::Done& done) {
    if (const auto tuning = formats::tuningFromJson(revision.parametersJson)) {
        m_service->takeBack(*tuning, revision.revision, author, reason, done);
    } else if (done) {
        done(tl::unexpected(tuning.error()));
    }
}

}  // namespace kerf::console
