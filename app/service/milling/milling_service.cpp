// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/milling/milling_service.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "engine/process/milling/milling_setup.h"

namespace kerf {
namespace {

constexpr const char* kItself = "Kerf";
constexpr std::size_t kLargestFile = 1U << 20U;
constexpr const char* kAtTheMachine = "changed while cutting";

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
              [this] { return millingSetupJson(m_types[m_type].setup); }, [this] { return settled(); },
              m_links.machineKind}) {
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
        type.setup.revision = 1;
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
    for (const RecipeBook::Recipe& recipe : keep(m_recipes.newest(), std::vector<RecipeBook::Recipe>{})) {
        PartType& type = m_types.try_emplace(recipe.partType, first).first->second;
        type.setup = keep(millingSetupFromJson(recipe.revision.parametersJson), first.setup);
        type.recipe = recipe.revision.id;
    }
    for (const RoomRecordRow& row : read("blank")) {
        m_types.try_emplace(row.subject, first).first->second.blank =
            keep(millingBlankFromJson(row.bodyJson), NamedBlank{});
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

void StoredMillingService::saveSetup(const MillingSetup& setup, const std::string& author, const std::string& reason,
                                     Done done) {
    accept(setup, author, reason, std::nullopt, std::move(done));
}

void StoredMillingService::restoreRevision(const RecipeRevision& revision, const std::string& author,
                                           const std::string& reason, Done done) {
    const auto setup = millingSetupFromJson(revision.parametersJson);
    if (!setup) {
        return answer(done, tl::unexpected(setup.error()));
    }
    accept(*setup, author, reason, revision.revision, std::move(done));
}

void StoredMillingService::accept(const MillingSetup& setup, const std::string& author, const std::string& reason,
                                  std::optional<std::uint32_t> restoredFrom, Done done) {
    const auto store = [&](StoreWriter::Done stored) {
        m_recipes.begin(m_type, millingSetupJson(m_types[m_type].setup), kItself);
        m_recipes.keep(m_type, millingSetupJson(setup), author, reason, restoredFrom, std::move(stored));
    };
    m_way.change(
        mayAccept(setup, author, reason), store,
        [this, setup, type = m_type](const Receipt& revision) {
            m_types[type].setup = setup;
            m_types[type].recipe = revision.id;
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

void StoredMillingService::saveBlank(const MillingBlank& blank, const std::string& source, const std::string& author,
                                     Done done) {
    if (const auto why = whyBusy()) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto why = milling::whyUnusable(blank)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::MillingBlank); !may) {
        return answer(done, may);
    }
    const NamedBlank named{blank, source};
    store("blank", m_type, millingBlankJson(named), author, source.empty() ? "typed" : "from " + source,
          std::move(done), [this, named, type = m_type] {
              m_types[type].blank = named;
              use(m_type);
          });
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
    like.setup = m_types[m_type].setup;
    const auto known = m_types.find(name);
    const MillingSetup& setup = known == m_types.end() ? like.setup : known->second.setup;
    // The setup it begins with is its first revision; who has chosen it is kept once that is on the disk.
    m_recipes.begin(name, millingSetupJson(setup), author,
                    [this, name, like, author, done = std::move(done),
                     alive = std::weak_ptr(m_alive)](const Result<Receipt>& begun) mutable {
                        if (!alive.lock()) {
                            return;
                        }
                        if (!begun) {
                            return answer(done, tl::unexpected(begun.error()));
                        }
                        if (begun->second > 0) {
                            like.recipe = begun->second;
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
    m_setup = type.setup;
    m_blank = type.blank.blank;
    m_setup.revision = ++m_revision;
    m_blank.revision = m_revision;
    if (m_setup.law == MillingLaw::Preview && m_blank.count == 0) {
        m_setup.law = MillingLaw::Model;
    }
    useRecipe();
    m_way.owe(LoadMillingBlank{m_blank},
              [wanted = m_revision](const Status& status) { return status.milling.blank == wanted; });
    m_way.owe(LoadMillingSetup{m_setup, m_lots.withLoad()},
              [wanted = m_revision](const Status& status) { return status.milling.setup == wanted; });
    beginFromMemory();  // a tool of another kind may belong to this part type
    rebuild();
}

void StoredMillingService::useRecipe() {
    const RecipeRevisionId recipe = m_types[m_type].recipe;
    m_lots.use(recipe);
    m_used[recipe] = {m_type, m_setup.toolRadius_mm, m_setup.flutes};
}

void StoredMillingService::recipeRevised(RecipeRevisionId revision) {
    m_types[m_type].recipe = revision;
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
    if (now.setup != m_setup.revision || (now.law == m_setup.law && now.reference_N == m_setup.reference_N)) {
        return;
    }
    m_setup.law = now.law;
    m_setup.reference_N = now.reference_N;
    m_recipes.begin(m_type, millingSetupJson(m_types[m_type].setup), kItself);
    m_types[m_type].setup = m_setup;
    const std::string author = m_links.author();
    m_way.keep(
        [&](StoreWriter::Done stored) {
            m_recipes.keep(m_type, millingSetupJson(m_setup), author.empty() ? kItself : author, kAtTheMachine,
                           std::nullopt, std::move(stored));
        },
        [this, type = m_type](const Receipt& revision) {
            m_types[type].recipe = revision.id;
            if (type == m_type) {
                useRecipe();
                m_lots.send();
            }
        },
        {});
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
    m_view.blankSource = m_types[m_type].blank.source;
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
