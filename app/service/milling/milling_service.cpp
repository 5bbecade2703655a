// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/milling/milling_service.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "engine/process/milling/milling_setup.h"

namespace kerf {
namespace {

constexpr std::size_t kLargestFile = 1U << 20U;
constexpr const char* kAtTheMachine = "changed while cutting";
constexpr const char* kBroughtBlank = "blank profile of before";

/// Preview looks ahead on a blank; without one it is the model's law.
MillingLaw lawWith(const MillingBlank& blank, MillingLaw law) {
    return law == MillingLaw::Preview && blank.count == 0 ? MillingLaw::Model : law;
}

Sentence signOnFirst() {
    return Sentence(KERF_TEXT("Sign on first: a change needs a name."));
}

}  // namespace

StoredMillingService::StoredMillingService(Links links, RoomRecordReader& records, PartReader& parts, LotReader& lots)
    : m_links(std::move(links)),
      m_recipes(m_links.writer, lots, ProcessId::Milling),
      m_history({m_recipes, [this] { return m_type; },
                 [this](const RecipeRevision& revision, const std::string& author, const std::string& reason,
                        Done done) { restoreRevision(revision, author, reason, std::move(done)); }}),
      m_lots({m_links.writer, m_links.engine, lots, ProcessId::Milling, m_links.rights, [this] { return m_type; },
              [this] { return recipeJson(); }, [this] { return settled(); }, m_links.machineKind}) {
    restore(records, parts);
    m_partsSubscription = m_links.writer.onPartStored([this](const StoredPart& part) { partStored(part); });
    use(m_type);
    poll();
}

void StoredMillingService::restore(RoomRecordReader& records, PartReader& parts) {
    restorePartTypes(records);
    restoreTool(records, parts);
    restorePast(records);
}

void StoredMillingService::restorePartTypes(RoomRecordReader& records) {
    const PartType first = [] {
        PartType type;
        type.recipe.setup.revision = 1;
        return type;
    }();
    const auto read = [&](const char* kind) {
        return keep(records.newestRoomRecords(ProcessId::Milling, kind), std::vector<RoomRecordRow>{});
    };
    m_types.try_emplace(m_type, first);     // the one every machine begins with stays, whatever was chosen since
    const auto chosen = read("part_type");  // what was chosen last comes last
    for (const RoomRecordRow& row : chosen) {
        m_type = row.subject;
        m_types.try_emplace(m_type, first);
    }
    std::set<std::string> said;  // part types whose recipe has a blank of its own, were it none
    for (const RecipeBook::Recipe& recipe : keep(m_recipes.newest(), std::vector<RecipeBook::Recipe>{})) {
        PartType& type = m_types.try_emplace(recipe.partType, first).first->second;
        type.recipe = keep(millingRecipeFromJson(recipe.revision.parametersJson, {}), first.recipe);
        type.revision = recipe.revision.id;
        if (millingRecipeSaysBlank(recipe.revision.parametersJson)) {
            said.insert(recipe.partType);
        }
    }
    const auto blanks = read("blank");
    for (const RoomRecordRow& row : blanks) {
        m_types.try_emplace(row.subject, first);
    }
    bringBlanks(blanks, said);
}

void StoredMillingService::bringBlanks(const std::vector<RoomRecordRow>& rows, const std::set<std::string>& said) {
    for (const RoomRecordRow& row : rows) {
        const NamedBlank blank = keep(millingBlankFromJson(row.bodyJson), NamedBlank{});
        if (said.contains(row.subject) || blank.blank.count == 0) {
            continue;
        }
        PartType& type = m_types.at(row.subject);
        type.recipe.blank = blank;
        m_way.keep(
            [&](StoreWriter::Done stored) {
                m_recipes.keep(row.subject, millingRecipeJson(type.recipe), kItself, kBroughtBlank, std::nullopt,
                               std::move(stored));
            },
            [this, name = row.subject](const Receipt& revision) {
                m_types[name].revision = revision.id;
                if (name == m_type) {
                    useRecipe();
                }
            },
            {});
    }
}

std::span<const MillingField> StoredMillingService::fields() const {
    return milling::setupFields();
}

std::optional<Sentence> StoredMillingService::whyUnusable(const MillingSetup& setup) const {
    MillingSetup checked = setup;
    checked.revision = std::max(1U, checked.revision);
    return milling::whyUnusable(checked);
}

Result<MillingBlank> StoredMillingService::blankOf(std::span<const MillingBlankStep> steps, double end_mm) const {
    if (steps.size() > MillingBlank::kMaxSteps) {
        return fail(KERF_TEXT("A blank profile needs from 1 to %1 steps."),
                    SentenceArg(static_cast<double>(MillingBlank::kMaxSteps), 0));
    }
    MillingBlank blank;
    blank.count = static_cast<std::uint16_t>(steps.size());
    blank.end_mm = steps.empty() ? 0.0 : end_mm;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        blank.begin_mm[i] = steps[i].begin_mm;
        blank.height_mm[i] = steps[i].height_mm;
    }
    if (const auto why = milling::whyUnusable(blank)) {
        return tl::unexpected(*why);
    }
    return blank;
}

Result<MillingBlank> StoredMillingService::readBlank(const std::string& file) const {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf())) {
        return fail(KERF_TEXT("The file cannot be read. Check its name and folder."));
    }
    if (text.view().size() > kLargestFile) {
        return fail(KERF_TEXT("The file is too large for a blank profile."));
    }
    return millingBlankFromCsv(text.view());
}

void StoredMillingService::store(const std::string& kind, const std::string& subject, const std::string& body,
                                 const std::string& author, const std::string& reason, Done done,
                                 std::function<void()> then) {
    if (author.empty()) {
        return answer(done, tl::unexpected(signOnFirst()));
    }
    m_way.keep(
        [&](StoreWriter::Done stored) {
            m_links.writer.submit(AddRoomRecord{ProcessId::Milling, kind, subject, body, author, reason},
                                  std::move(stored));
        },
        [then = std::move(then)](const Receipt&) {
            if (then) {
                then();
            }
        },
        std::move(done));
    rebuild();
}

std::optional<Sentence> StoredMillingService::whyBusy() const {
    if (m_links.engine.status().milling.cutting) {
        return Sentence(KERF_TEXT("A part is being cut: law and reference can be changed now, the rest after it."));
    }
    return std::nullopt;
}

const MillingRecipe& StoredMillingService::asked() const {
    const PartType& type = m_types.at(m_type);
    return type.asked.from(type.recipe);
}

void StoredMillingService::saveSetup(const MillingSetup& setup, const std::string& author, const std::string& reason,
                                     Done done) {
    accept(mayAccept(setup, author, reason), {setup, asked().blank}, author, reason, std::nullopt, std::move(done));
}

void StoredMillingService::saveBlank(const MillingBlank& blank, const std::string& source, const std::string& author,
                                     Done done) {
    accept(mayAccept(blank, author), {asked().setup, {blank, source}}, author,
           source.empty() ? "typed" : "from " + source, std::nullopt, std::move(done));
}

void StoredMillingService::restoreRevision(const RecipeRevision& revision, const std::string& author,
                                           const std::string& reason, Done done) {
    const auto recipe = millingRecipeFromJson(revision.parametersJson, asked().blank);
    if (!recipe) {
        return answer(done, tl::unexpected(recipe.error()));
    }
    const auto may = mayAccept(recipe->setup, author, reason);
    accept(may ? mayAccept(recipe->blank.blank, author) : may, *recipe, author, reason, revision.revision,
           std::move(done));
}

ChangeWay::Store StoredMillingService::storing(const MillingRecipe& recipe, const std::string& author,
                                               const std::string& reason, std::optional<std::uint32_t> restoredFrom) {
    return [=, this](StoreWriter::Done stored) {
        PartType& type = m_types[m_type];
        type.asked.ask(recipe);
        m_recipes.begin(m_type, millingRecipeJson(type.recipe), kItself);
        m_recipes.keep(m_type, millingRecipeJson(recipe), author, reason, restoredFrom,
                       [this, name = m_type, alive = std::weak_ptr(m_alive),
                        stored = std::move(stored)](const Result<Receipt>& receipt) {
                           if (alive.lock()) {
                               m_types[name].asked.answered();
                               stored(receipt);
                           }
                       });
    };
}

void StoredMillingService::accept(const Result<void>& may, const MillingRecipe& recipe, const std::string& author,
                                  const std::string& reason, std::optional<std::uint32_t> restoredFrom, Done done) {
    m_way.change(
        may, storing(recipe, author, reason, restoredFrom),
        [this, recipe, type = m_type](const Receipt& revision) {
            m_types[type].recipe = recipe;
            m_types[type].revision = revision.id;
            use(m_type);
        },
        std::move(done));
    rebuild();
}

Result<void> StoredMillingService::mayAccept(const MillingSetup& setup, const std::string& author,
                                             const std::string& reason) const {
    if (const auto why = whyBusy()) {
        return tl::unexpected(*why);
    }
    if (const auto why = whyUnusable(setup)) {
        return tl::unexpected(*why);
    }
    const bool limits = setup.overload_N > m_setup.overload_N || setup.highestFeed_mmPerS > m_setup.highestFeed_mmPerS;
    const bool far = raisedFar(m_setup.overload_N, setup.overload_N) ||
                     raisedFar(m_setup.highestFeed_mmPerS, setup.highestFeed_mmPerS);
    return permittedLimit(m_links.rights, author, limits ? Deed::MillingLimits : Deed::MillingSetup, reason, far);
}

Result<void> StoredMillingService::mayAccept(const MillingBlank& blank, const std::string& author) const {
    if (const auto why = whyBusy()) {
        return tl::unexpected(*why);
    }
    if (const auto why = milling::whyUnusable(blank)) {
        return tl::unexpected(*why);
    }
    return permitted(m_links.rights, author, Deed::MillingBlank);
}

void StoredMillingService::choosePartType(const std::string& name, const std::string& author, Done done) {
    if (const auto why = whyBusy()) {
        return answer(done, tl::unexpected(*why));
    }
    if (name.empty()) {
        return answer(done, fail(KERF_TEXT("A part type needs a name.")));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::MillingPartType); !may) {
        return answer(done, may);
    }
    PartType like;
    like.recipe.setup = m_types[m_type].recipe.setup;
    const auto known = m_types.find(name);
    const MillingRecipe& recipe = known == m_types.end() ? like.recipe : known->second.recipe;
    // The setup it begins with is its first revision; who has chosen it is kept once that is on the disk.
    m_recipes.begin(name, millingRecipeJson(recipe), author,
                    [this, name, like, author, done = std::move(done),
                     alive = std::weak_ptr(m_alive)](const Result<Receipt>& begun) mutable {
                        if (!alive.lock()) {
                            return;
                        }
                        if (!begun) {
                            return answer(done, tl::unexpected(begun.error()));
                        }
                        if (begun->second > 0) {
                            like.revision = begun->second;
                        }
                        store("part_type", name, "{}", author, "chosen", std::move(done), [this, name, like] {
                            m_types.try_emplace(name, like);
                            m_type = name;
                            use(name);
                        });
                    });
}

void StoredMillingService::use(const std::string& partType) {
    const PartType& type = m_types[partType];
    m_setup = type.recipe.setup;
    m_blank = type.recipe.blank.blank;
    m_setup.revision = ++m_revision;
    m_blank.revision = m_revision;
    m_setup.law = lawWith(m_blank, m_setup.law);
    useRecipe();
    m_way.owe(LoadMillingBlank{m_blank},
              [wanted = m_revision](const Status& status) { return status.milling.blank == wanted; });
    m_way.owe(
        LoadMillingSetup{m_setup, m_lots.withLoad()},
        [wanted = m_revision](const Status& status) { return status.milling.setup == wanted; },
        [this, then = m_links.engine.status()](Handover::Action& action, const Status& now) {
            if (then.cycle > 0 && now.milling.setup == then.milling.setup) {
                takeAlong(std::get<LoadMillingSetup>(action).setup, then.milling, now.milling);
            }
        });
    beginFromMemory();  // a tool of another kind may belong to this part type
    rebuild();
}

// poll() keeps it as changed at the machine, once the engine has the setup.
void StoredMillingService::takeAlong(MillingSetup& setup, const MillingStatus& then, const MillingStatus& now) const {
    const bool blankGone = then.law == MillingLaw::Preview && m_blank.count == 0;  // it takes its law away by itself
    if (now.law != then.law && !(blankGone && now.law == MillingLaw::Model)) {
        setup.law = lawWith(m_blank, now.law);
    }
    if (now.reference_N != then.reference_N) {
        setup.reference_N = now.reference_N;
    }
}

void StoredMillingService::useRecipe() {
    const RecipeRevisionId recipe = m_types[m_type].revision;
    m_lots.use(recipe);
    m_used[recipe] = {m_type, m_setup.toolRadius_mm, m_setup.flutes};
}

void StoredMillingService::recipeRevised(RecipeRevisionId revision) {
    m_types[m_type].revision = revision;
    useRecipe();
}

bool StoredMillingService::settled() {
    return m_way.settled() && m_links.engine.status().milling.setup == m_setup.revision;
}

void StoredMillingService::poll() {
    m_way.poll();
    m_lots.send();
    const Status& status = m_links.engine.status();
    const MillingStatus& now = status.milling;
    if (!now.cutting) {
        tellTool();
    }
    if (m_way.busy() || now.setup != m_setup.revision ||
        (now.law == m_setup.law && now.reference_N == m_setup.reference_N)) {
        return;
    }
    m_setup.law = now.law;
    m_setup.reference_N = now.reference_N;
    const std::string author = m_links.author();
    m_way.keep(storing({m_setup, m_types[m_type].recipe.blank}, author.empty() ? kItself : author, kAtTheMachine, {}),
               [this, type = m_type](const Receipt& revision) {
                   m_types[type].revision = revision.id;
                   if (type == m_type) {
                       useRecipe();
                       m_lots.send();
                   }
               },
               {});
    m_types[m_type].recipe.setup = m_setup;  // in force already, whatever the disk says
    rebuild();
}

void StoredMillingService::rebuild() {
    m_view.partType = m_type;
    m_view.partTypes.clear();
    for (const auto& [name, type] : m_types) {
        m_view.partTypes.push_back(name);
    }
    m_view.setup = m_setup;
    m_view.blank = m_blank;
    m_view.blankSource = m_types[m_type].recipe.blank.source;
    m_view.cuts.assign(m_cuts.begin(), m_cuts.end());
    for (MillingCutView& cut : m_view.cuts) {
        cut.withThisTool = cut.id > m_tool.after;
    }
    m_view.memory = memoryView();
    m_view.busy = m_way.busy();
    m_view.problem = m_way.problem().empty() ? m_links.writer.problem() : m_way.problem();
    ++m_view.revision;
    m_listeners.tell();
}

}  // namespace kerf
