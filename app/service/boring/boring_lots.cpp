// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/boring_lots.h"

#include <algorithm>
#include <set>

#include "app/service/boring/shop_memory.h"

namespace kerf {
namespace {

constexpr std::uint32_t kLotsLooked = 1000;
constexpr std::size_t kLotsLookedInto = 5;
constexpr std::uint32_t kPartsLookedInto = 3;

std::optional<Sentence> whyNoWords(const std::string& author, const std::string& reason) {
    if (author.empty()) {
        return Sentence(KERF_TEXT("Sign on first: a change needs a name."));
    }
    if (reason.empty()) {
        return Sentence(KERF_TEXT("This change needs a reason."));
    }
    return std::nullopt;
}

bool blank(const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

}  // namespace

StoredBoringLots::StoredBoringLots(const StoredBoringService::Links& links, LotReader& reader, BoringLotRequest first,
                                   std::function<void()> lotOpened)
    : m_links(links),
      m_reader(reader),
      m_recipes(m_links.writer, reader, ProcessId::Boring),
      m_first(std::move(first)),
      m_lotOpened(std::move(lotOpened)) {}

Result<std::vector<LotRow>> StoredBoringLots::rows() {
    auto all = m_reader.lots(std::nullopt, kLotsLooked, ProcessId::Boring);
    if (all) {
        std::erase_if(*all, [this](const LotRow& lot) { return lot.machineName != m_first.machineName; });
    }
    return all;
}

void StoredBoringLots::start(Done done) {
    const auto active = m_reader.activeLot(ProcessId::Boring);
    const auto known = rows();
    if (!active || !known) {
        return answer(done, tl::unexpected(active ? known.error() : active.error()));
    }
    const auto current = std::ranges::find_if(*known, [&](const LotRow& lot) { return lot.id == *active; });
    if (current != known->end()) {
        return answer(done, openService(current->id));
    }
    const auto newest = std::ranges::find_if(*known, [](const LotRow& lot) { return !lot.closedUtc_ms; });
    if (newest != known->end()) {
        return activate(newest->id, m_first.author, std::move(done));
    }
    const auto opened = [this, alive = std::weak_ptr(m_alive), done = std::move(done)](const Result<LotId>& lot) {
        if (alive.lock()) {
            answer(done, lot ? openService(*lot) : Result<void>(tl::unexpected(lot.error())));
        }
    };
    openBoringLot(m_links.writer, m_first, opened);
}

Result<void> StoredBoringLots::openService(LotId lot) {
    StoredBoringService::Links links = m_links;
    links.firstRevision = m_service.open() ? m_service.view().revision : 0;
    auto service = StoredBoringService::open(links, m_reader, lot);
    if (!service) {
        return tl::unexpected(service.error());
    }
    m_current = lot;
    m_service.replace(std::move(*service));
    if (m_lotOpened) {
        m_lotOpened();
    }
    m_service.notify();
    askShop(lot);
    return {};
}

// Once for a lot: when nothing of it is cut and nothing was kept with it yet.
void StoredBoringLots::askShop(LotId lot) {
    if (m_asked == lot) {
        return;
    }
    m_asked = lot;
    m_shopAnswer = {};
    if (!m_askShop || m_links.records == nullptr || !m_service.view().parts.empty()) {
        return;
    }
    const auto kept = m_links.records->roomRecords(ProcessId::Boring, kShopLotsRecord, std::to_string(lot), 1);
    const auto revision = m_reader.recipeOf(lot);
    if (!kept || !kept->empty() || !revision || !*revision) {
        return;
    }
    const auto recipe = recipeFromJson((*revision)->parametersJson);
    if (recipe && recipe->drawsOnShop()) {
        m_shopAnswer = Sentence(KERF_TEXT("The shop is asked for lots of other machines."));
        m_askShop(m_service.view().partType, [this, lot, alive = std::weak_ptr(m_alive)](const auto& told) {
            if (alive.lock()) {
                shopTold(lot, told);
            }
        });
    }
}

void StoredBoringLots::shopTold(LotId lot, const Result<std::vector<BoringMemoryLot>>& told) {
    if (lot != m_current) {
        return;
    }
    const auto say = [this](const Sentence& answer) {
        m_shopAnswer = answer;
        m_service.notify();
    };
    if (!told) {
        return say(told.error());
    }
    if (told->empty()) {
        return say(Sentence(KERF_TEXT("The shop has no lots of this part type on other machines.")));
    }
    if (!m_service.view().parts.empty() || whyNoOther()) {
        return say(Sentence(KERF_TEXT(
            "The shop answered after the first part had begun: this lot begins without other machines' lots.")));
    }
    const AddRoomRecord record{ProcessId::Boring,   kShopLotsRecord, std::to_string(lot),
                               shopLotsJson(*told), m_first.author,  ""};
    submit(record, [this, lot, say](const Result<void>& stored) {
        if (!stored) {
            return say(stored.error());
        }
        if (lot == m_current && m_service.view().parts.empty() && !whyNoOther()) {
            m_shopAnswer = {};
            (void)openService(lot);
        }
    });
}

std::optional<Sentence> StoredBoringLots::whyUnusable(const BoringRecipeForm& form) const {
    if (form.values.size() != boringRecipeSpecs().size()) {
        return Sentence(KERF_TEXT("A recipe needs %1 numbers."),
                        SentenceArg(static_cast<double>(boringRecipeSpecs().size()), 0));
    }
    return whyInvalid(recipeOf(form));
}

Result<std::vector<BoringPartTypeView>> StoredBoringLots::partTypes() {
    const auto types = m_recipes.partTypes();
    if (!types) {
        return tl::unexpected(types.error());
    }
    std::vector<BoringPartTypeView> shown;
    for (const PartTypeRow& type : *types) {
        shown.push_back({type.id, type.name});
    }
    return shown;
}

Result<std::vector<BoringRecipeView>> StoredBoringLots::recipes(PartTypeId partType) {
    const auto revisions = m_recipes.revisions(partType);
    if (!revisions) {
        return tl::unexpected(revisions.error());
    }
    std::vector<BoringRecipeView> shown;
    for (const RecipeRevision& row : *revisions) {
        const auto recipe = recipeFromJson(row.parametersJson);
        if (!recipe) {
            return tl::unexpected(recipe.error());
        }
        shown.push_back(
            {row.revision, row.restoredFrom, row.author, row.reason, row.createdUtc_ms, recipeForm(*recipe)});
    }
    return shown;
}

Result<std::vector<BoringLotView>> StoredBoringLots::lots() {
    const auto known = rows();
    if (!known) {
        return tl::unexpected(known.error());
    }
    std::vector<boring::MemoryContext> contexts(known->size());
    if (m_links.records != nullptr) {
        auto told = memoryContextsOf(*m_links.records, *known);
        if (!told) {
            return tl::unexpected(told.error());
        }
        contexts = std::move(*told);
    }
    std::vector<BoringLotView> shown;
    for (std::size_t i = 0; i < known->size(); ++i) {
        const LotRow& lot = (*known)[i];
        shown.push_back({lot.id, lot.partType, lot.partTypeName, lot.name, lot.size, lot.estimator, lot.openedUtc_ms,
                         lot.closedUtc_ms.has_value(), lot.id == m_current, contexts[i].names[2],
                         contexts[i].names[3]});
        shown.back().partsWaiting = i < kLotsLookedInto ? partsWaiting(lot) : 0;
    }
    return shown;
}

// Of the newest parts: a bore from before them is not waited for any more.
std::uint32_t StoredBoringLots::partsWaiting(const LotRow& lot) {
    const auto history = m_reader.newestParts(lot.id, kPartsLookedInto, std::nullopt);
    if (!history || !*history) {
        return 0;
    }
    const auto recipe = recipeFromJson((*history)->recipe.parametersJson);
    if (!recipe) {
        return 0;
    }
    std::set<MeasurementId> replaced;
    for (const MeasurementRow& row : (*history)->measurements) {
        if (row.replaces) {
            replaced.insert(*row.replaces);
        }
    }
    std::uint32_t waiting = 0;
    for (const PartDetail& detail : (*history)->parts) {
        std::set<std::uint8_t> measured;
        for (const MeasurementRow& row : (*history)->measurements) {
            if (row.part == detail.part.id && row.diameter_mm && !replaced.contains(row.id)) {
                measured.insert(row.station);
            }
        }
        waiting += detail.part.complete && measured.size() < recipe->depths.size() ? 1 : 0;
    }
    return waiting;
}

std::vector<BoringRecipeChange> StoredBoringLots::compare(const BoringRecipeForm& before,
                                                          const BoringRecipeForm& after) const {
    return recipeChanges(recipeOf(before), recipeOf(after));
}

std::optional<Sentence> StoredBoringLots::whyNoOther() const {
    const Status& status = m_links.engine.status();
    const bool running = status.program == ProgramState::Running || status.program == ProgramState::Paused;
    if (running && status.programProcess == ProcessId::Boring) {
        return Sentence(KERF_TEXT("A part of this lot is being bored; change the lot when it is finished."));
    }
    if (!m_links.writer.problem().empty()) {
        return m_links.writer.problem();  // finished parts still wait to be stored in the lot they belong to
    }
    return std::nullopt;
}

Result<EnsureLot> StoredBoringLots::ensureLot(const BoringLotOrder& order) {
    if (order.author.empty()) {
        return fail(KERF_TEXT("Sign on first: a change needs a name."));
    }
    if (blank(order.name)) {
        return fail(KERF_TEXT("A lot needs a name or number."));
    }
    if (order.size > kMostParts) {
        return fail(KERF_TEXT("A lot has at most %1 parts."), SentenceArg(kMostParts, 0));
    }
    if (!boring::estimatorOf(order.estimator)) {
        return fail(KERF_TEXT("The lot asks for an estimator that this program does not have."));
    }
    const auto machines = m_reader.machines();
    const auto known = rows();
    const auto recipes = m_reader.recipes(order.partType);
    if (!machines || !known || !recipes) {
        return tl::unexpected(!machines ? machines.error() : !known ? known.error() : recipes.error());
    }
    const auto machine = std::ranges::find(*machines, m_first.machineName, &MachineRow::name);
    if (machine == machines->end() || recipes->empty()) {
        return fail(KERF_TEXT("There is no such part type."));
    }
    const auto same = [&](const LotRow& lot) { return lot.partType == order.partType && lot.name == order.name; };
    if (std::ranges::any_of(*known, same)) {
        return fail(KERF_TEXT("There is a lot of this name for the part type already; give another name."));
    }
    return EnsureLot{machine->id, order.partType,  recipes->front().id, order.name,
                     order.size,  order.estimator, order.author};
}

void StoredBoringLots::open(const BoringLotOrder& order, Done done) {
    if (const auto may = permitted(m_links.rights, order.author, Deed::BoringLot); !may) {
        return answer(done, may);
    }
    if (const auto why = whyNoOther()) {
        return answer(done, tl::unexpected(*why));
    }
    const auto lot = ensureLot(order);
    if (!lot) {
        return answer(done, tl::unexpected(lot.error()));
    }
    const auto opened = [this, alive = std::weak_ptr(m_alive), order,
                         done = changing(std::move(done))](const Result<Receipt>& receipt) {
        if (!alive.lock()) {
            return;
        }
        if (!receipt) {
            return answer(done, tl::unexpected(receipt.error()));
        }
        if (order.insertGrade.empty() && order.material.empty()) {
            return activate(receipt->id, order.author, done);
        }
        const AddRoomRecord told{ProcessId::Boring,
                                 kLotRecord,
                                 std::to_string(receipt->id),
                                 lotRecordJson(order.insertGrade, order.material),
                                 order.author,
                                 ""};
        submit(told, [this, lot = receipt->id, author = order.author, done](const Result<void>& stored) {
            stored ? activate(lot, author, done) : answer(done, stored);
        });
    };
    m_links.writer.submit(*lot, opened);
}

Result<std::vector<BoringMemoryLotView>> StoredBoringLots::memory() {
    std::vector<BoringMemoryLotView> shown;
    if (m_links.records == nullptr || !m_current) {
        return shown;
    }
    const auto history = m_reader.history(*m_current);
    if (!history || !*history) {
        return history ? Result<std::vector<BoringMemoryLotView>>(shown) : tl::unexpected(history.error());
    }
    const auto recipe = recipeFromJson((*history)->recipe.parametersJson);
    const auto basis = readBoringMemory(m_reader, *m_links.records, (*history)->lot);
    if (!recipe || !basis) {
        return tl::unexpected(recipe ? basis.error() : recipe.error());
    }
    const boring::LotBegin begin = lotBegin(*basis, *recipe);
    const boring::Memory memory(*begin.past, begin.context, recipe->estimator(boring::EstimatorKind::Kalman).kalman);
    const auto show = [&](const BoringMemoryLot& lot) {
        const auto weight = std::ranges::find(memory.weights(), lot.memoryId, &boring::MemoryWeight::lot);
        shown.push_back({lot.lot.id, lot.lot.partTypeName, lot.lot.name, lot.context.names[2], lot.context.names[3],
                         static_cast<std::uint32_t>(lot.stretches.size()),
                         weight == memory.weights().end() ? 0.0 : weight->share, lot.leftOut, lot.reason,
                         lot.store.empty() ? std::string() : lot.lot.machineName, lot.store});
    };
    std::for_each(basis->past.rbegin(), basis->past.rend(), show);
    std::ranges::for_each(basis->shop, show);
    return shown;
}

void StoredBoringLots::leaveOut(const BoringMemoryKey& lot, bool out, const std::string& author,
                                const std::string& reason, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLotEnd, reason); !may) {
        return answer(done, tl::unexpected(may.error()));
    }
    if (const auto why = whyNoWords(author, reason)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto why = whyNoOther()) {
        return answer(done, tl::unexpected(*why));
    }
    const AddRoomRecord record{ProcessId::Boring, kMemoryRecord, memorySubject(lot.console, lot.lot),
                               leftOutJson(out),  author,        reason};
    submit(record, [this, done = changing(std::move(done))](const Result<void>& stored) {
        answer(done, stored && m_current ? openService(*m_current) : stored);
    });
}

void StoredBoringLots::choose(LotId lot, const std::string& author, Done done) {
    if (lot == m_current) {
        return answer(done, {});
    }
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLot); !may) {
        return answer(done, may);
    }
    if (const auto why = whyNoOther()) {
        return answer(done, tl::unexpected(*why));
    }
    activate(lot, author, changing(std::move(done)));
}

// A part that begins between the question and the answer is stored where the writer then stands, with the schedule it
// was really cut with: the estimate stays right.
void StoredBoringLots::activate(LotId lot, const std::string& author, Done done) {
    m_links.writer.submit(
        SetActiveLot{ProcessId::Boring, lot, author},
        [this, lot, alive = std::weak_ptr(m_alive), done = std::move(done)](const Result<Receipt>& receipt) {
            if (alive.lock()) {
                answer(done, receipt ? openService(lot) : Result<void>(tl::unexpected(receipt.error())));
            }
        });
}

void StoredBoringLots::close(const std::string& author, const std::string& reason, Done done) {
    if (const auto why = whyNoWords(author, reason)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLotEnd, reason); !may) {
        return answer(done, may);
    }
    if (const auto why = whyNoOther()) {
        return answer(done, tl::unexpected(*why));
    }
    submit(CloseLot{*m_current, author, reason},
           [this, lot = *m_current, done = changing(std::move(done))](const auto& closed) {
               answer(done, closed && lot == m_current ? openService(lot) : closed);
           });
}

void StoredBoringLots::addPartType(const std::string& name, const BoringRecipeForm& form, const std::string& author,
                                   PartTypeDone done) {
    const auto refuse = [&done](const Sentence& why) { done(tl::unexpected(why)); };
    const auto known = m_recipes.partTypes();
    if (!known) {
        return refuse(known.error());
    }
    if (const auto may = permitted(m_links.rights, author, Deed::BoringPartType); !may) {
        return refuse(may.error());
    }
    if (blank(name)) {
        return refuse(Sentence(KERF_TEXT("A part type needs a name.")));
    }
    if (std::ranges::any_of(*known, [&](const PartTypeRow& type) { return type.name == name; })) {
        return refuse(Sentence(KERF_TEXT("There is a part type of this name already; give another name.")));
    }
    if (const auto why = whyUnusable(form)) {
        return refuse(*why);
    }
    m_recipes.add(name, recipeJson(recipeOf(form)), author,
                  [alive = std::weak_ptr(m_alive), done = std::move(done)](const Result<Receipt>& receipt) {
                      if (alive.lock()) {
                          done(receipt ? Result<PartTypeId>(receipt->id) : tl::unexpected(receipt.error()));
                      }
                  });
}

void StoredBoringLots::saveRecipe(PartTypeId partType, const BoringRecipeForm& form, const std::string& author,
                                  const std::string& reason, Done done) {
    if (const auto why = whyNoWords(author, reason)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto why = whyUnusable(form)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::BoringRecipe, reason); !may) {
        return answer(done, may);
    }
    m_recipes.save(partType, recipeJson(recipeOf(form)), author, reason, answered(std::move(done)));
}

void StoredBoringLots::restoreRecipe(PartTypeId partType, std::uint32_t revision, const std::string& author,
                                     const std::string& reason, Done done) {
    if (const auto why = whyNoWords(author, reason)) {
        return answer(done, tl::unexpected(*why));
    }
    if (const auto may = permitted(m_links.rights, author, Deed::BoringRecipe, reason); !may) {
        return answer(done, may);
    }
    m_recipes.restore(partType, revision, author, reason, answered(std::move(done)));
}

BoringLots::Done StoredBoringLots::changing(Done done) {
    ++m_changing;
    return [this, done = std::move(done)](const Result<void>& result) {  // called only while this is alive
        --m_changing;
        answer(done, result);
    };
}

void StoredBoringLots::submit(StoreCommand command, Done done) {
    m_links.writer.submit(std::move(command), answered(std::move(done)));
}

StoreWriter::Done StoredBoringLots::answered(Done done) const {
    return [alive = std::weak_ptr(m_alive), done = std::move(done)](const Result<Receipt>& receipt) {
        if (alive.lock()) {
            answer(done, receipt ? Result<void>() : Result<void>(tl::unexpected(receipt.error())));
        }
    };
}

}  // namespace kerf
