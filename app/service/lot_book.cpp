// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/lot_book.h"

#include <algorithm>

namespace kerf {
namespace {

constexpr std::uint32_t kLotsShown = 500;
constexpr const char* kNamelessMachine = "machine";

LotView viewOf(const LotRow& row) {
    return {row.id,    row.name,     row.partTypeName, row.recipeRevision, row.size,    row.tool,
            row.gauge, row.openedBy, row.openedUtc_ms, row.closedUtc_ms,   row.closedBy};
}

}  // namespace

LotBook::LotBook(Links links) : m_links(std::move(links)) {
    if (const auto active = m_links.reader.activeLot(m_links.process); active && *active) {
        m_lot = find(**active);
        if (m_lot && m_lot->closedUtc_ms) {
            m_lot.reset();
        }
    }
}

std::string LotBook::machineName() const {
    const std::string name(m_links.engine.capabilities().machineName.data());
    return name.empty() ? kNamelessMachine : name;
}

std::optional<LotView> LotBook::find(LotId lot) const {
    const auto known = lots();
    if (!known) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(*known, lot, &LotView::id);
    return found == known->end() ? std::nullopt : std::optional(*found);
}

Result<std::vector<LotView>> LotBook::lots() const {
    const auto rows = m_links.reader.lots(std::nullopt, kLotsShown, m_links.process);
    if (!rows) {
        return tl::unexpected(rows.error());
    }
    std::vector<LotView> shown;
    for (const LotRow& row : *rows) {
        if (row.machineName == machineName()) {
            shown.push_back(viewOf(row));
        }
    }
    return shown;
}

std::optional<LotView> LotBook::current() const {
    return m_lot && m_lot->partType == partType() ? m_lot : std::nullopt;
}

WorkOrder LotBook::order() const {
    const auto lot = current();
    return {lot ? lot->id : 0, m_recipe, 0};
}

void LotBook::use(RecipeRevisionId recipe) {
    if (m_recipe != recipe) {
        m_recipe = recipe;
        m_listeners.tell();  // it may be of another part type, and the lot with it
    }
}

void LotBook::send() {
    const WorkOrder wanted = order();
    if (m_sent == wanted || !m_links.settled()) {
        return;
    }
    Command command;
    command.action = NameOrder{m_links.process, wanted};
    if (m_links.engine.send(command)) {
        m_sent = wanted;  // else its ring is full: the next poll tries again
    }
}

bool LotBook::underWay(const ChangeWay& way) const {
    return m_storing > 0 || way.underWay() || (m_sent != order() && m_links.settled());
}

void LotBook::store(StoreCommand command, Done failed, std::function<void(const Receipt&)> then) {
    ++m_storing;
    m_links.writer.submit(std::move(command), [this, failed = std::move(failed), then = std::move(then),
                                               alive = std::weak_ptr(m_alive)](const Result<Receipt>& receipt) {
        if (!alive.lock()) {
            return;
        }
        --m_storing;
        receipt ? then(*receipt) : answer(failed, tl::unexpected(receipt.error()));
    });
}

void LotBook::activate(std::optional<LotView> lot, const std::string& author, Done done) {
    const std::optional<LotId> id = lot ? std::optional(lot->id) : std::nullopt;
    store(SetActiveLot{m_links.process, id, author}, done, [this, lot = std::move(lot), done](const Receipt&) {
        m_lot = lot;
        send();
        answer(done, {});
        m_listeners.tell();
    });
}

void LotBook::open(const NewLot& lot, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLot); !may) {
        return answer(done, may);
    }
    if (lot.name.empty()) {
        return answer(done, fail(KERF_TEXT("A lot needs a name.")));
    }
    const auto known = lots();
    if (!known) {
        return answer(done, tl::unexpected(known.error()));
    }
    const std::string type = partType();
    if (std::ranges::any_of(*known,
                            [&](const LotView& other) { return other.name == lot.name && other.partType == type; })) {
        return answer(done, fail(KERF_TEXT("There is a lot of this name already.")));
    }
    store(EnsureMachine{machineName(), m_links.machineKind}, done, [=, this](const Receipt& machine) {
        const EnsurePartType recipe{m_links.process, type, m_links.parametersJson(), author};
        store(recipe, done, [=, this, machine = machine.id](const Receipt& found) {
            if (partType() != type) {  // another one has been chosen meanwhile
                return answer(done, fail(KERF_TEXT("The part type has changed: nothing was opened.")));
            }
            m_recipe = m_recipe != 0 ? m_recipe : found.second;
            const EnsureLot ensure{machine, found.id, m_recipe, lot.name, lot.size, {}, author, lot.tool, lot.gauge};
            store(ensure, done, [=, this](const Receipt& opened) { activate(find(opened.id), author, done); });
        });
    });
}

void LotBook::choose(std::int64_t lot, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLot); !may) {
        return answer(done, may);
    }
    auto found = find(lot);
    if (!found || found->closedUtc_ms) {
        return answer(done, fail(KERF_TEXT("This lot is closed already, or there is none of that number.")));
    }
    if (found->partType != partType()) {
        return answer(done,
                      fail(KERF_TEXT("This lot is of %1: choose that part type first."), SentenceArg(found->partType)));
    }
    activate(std::move(found), author, std::move(done));
}

void LotBook::leave(const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLot); !may) {
        return answer(done, may);
    }
    activate(std::nullopt, author, std::move(done));
}

void LotBook::close(const std::string& author, const std::string& reason, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringLotEnd, reason); !may) {
        return answer(done, may);
    }
    const auto lot = current();
    if (!lot) {
        return answer(done, fail(KERF_TEXT("No lot is open.")));
    }
    store(CloseLot{lot->id, author, reason}, done,
          [this, author, done](const Receipt&) { activate(std::nullopt, author, done); });
}

}  // namespace kerf
