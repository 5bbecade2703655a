// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/change_way.h"

#include <algorithm>

namespace kerf {
namespace {
constexpr int kPatience_polls = 20;  // after which a refused command is tried again, whatever the machine does

ProcessId processOf(const Handover::Action& action) {
    Command command;
    command.action = action;
    return kerf::processOf(command);
}

/// The order that an action brings with what it loads; null: none.
WorkOrder* orderIn(Handover::Action& action) {
    return std::visit(
        [](auto& one) -> WorkOrder* {
            if constexpr (requires { one.kProcess, one.order->lot; }) {
                return one.order ? &*one.order : nullptr;
            } else {
                return nullptr;
            }
        },
        action);
}
}  // namespace

bool Handover::poll(EngineApi& engine) {
    const Status status = engine.status();
    const bool wasTaken = m_taken;
    const Sentence before = m_refusal;
    if (m_number) {
        lookForAnswer(status);
    }
    m_taken = m_taken || (m_sent && m_shown(status));
    if (!m_taken && !m_number && mayTry(status)) {
        if (m_sent && m_renew) {
            m_renew(m_action, status);
        }
        Command command;
        command.action = m_action;
        m_number = engine.send(command);  // none: its ring is full
        m_sent = m_sent || m_number;
    }
    return m_taken != wasTaken || m_refusal.english() != before.english();
}

void Handover::lookForAnswer(const Status& status) {
    std::uint32_t oldest = 0;
    for (const CommandResult& result : status.recentCommands) {  // newest first
        if (result.number == 0) {
            break;
        }
        oldest = result.number;
        if (result.number != *m_number) {
            continue;
        }
        m_number.reset();
        m_taken = result.done;
        m_refusal = result.done ? Sentence() : result.reason;
        m_refusedAt = {status.program, status.partSequence, status.link};
        m_waited = 0;
        return;
    }
    if (oldest > *m_number) {  // lost among later ones: what came of it nobody can say
        m_number.reset();
    }
}

bool Handover::mayTry(const Status& status) {
    const Moment now{status.program, status.partSequence, status.link};
    return m_refusal.empty() || now != m_refusedAt || ++m_waited >= kPatience_polls;
}

void Handover::follow(const Action& newer) {
    const auto* name = std::get_if<NameOrder>(&newer);
    WorkOrder* mine = orderIn(m_action);
    if (name != nullptr && mine != nullptr && processOf(m_action) == name->process) {
        *mine = name->order;
    }
}

bool Handover::isOverruledBy(const Action& newer) const {
    const auto* name = std::get_if<NameOrder>(&m_action);
    Action loads = newer;
    return name != nullptr && orderIn(loads) != nullptr && processOf(newer) == name->process;
}

void ChangeWay::change(const Result<void>& may, const Store& store, std::function<void(const Receipt&)> then,
                       Done done) {
    if (!may) {
        return answer(done, may);
    }
    ++m_busy;
    store([this, then = std::move(then), done = std::move(done),
           alive = std::weak_ptr(m_alive)](const Result<Receipt>& receipt) {
        if (alive.expired()) {
            return;
        }
        --m_busy;
        m_storeProblem = receipt ? Sentence() : receipt.error();
        if (receipt && then) {
            then(*receipt);
        }
        m_show();
        answer(done, receipt ? Result<void>() : Result<void>(tl::unexpected(receipt.error())));
    });
}

void ChangeWay::owe(const Handover::Action& action, Handover::Shown shown, Handover::Renew renew) {
    std::erase_if(m_owed, [&action](const Handover& one) { return one.isOf(action) || one.isOverruledBy(action); });
    for (Handover& before : m_owed) {
        before.follow(action);
    }
    m_owed.emplace_back(action, std::move(shown), std::move(renew));
    (void)m_owed.back().poll(m_engine);
}

void ChangeWay::poll() {
    bool news = false;
    for (Handover& one : m_owed) {
        news = one.poll(m_engine) || news;
    }
    std::erase_if(m_owed, [](const Handover& one) { return one.taken(); });
    if (news) {
        m_show();
    }
}

bool ChangeWay::underWay() const noexcept {
    return !m_owed.empty() && std::ranges::all_of(m_owed, [](const Handover& one) { return one.refusal().empty(); });
}

const Sentence& ChangeWay::problem() const noexcept {
    if (!m_storeProblem.empty()) {
        return m_storeProblem;
    }
    static const Sentence kNone{};
    const auto refused = std::ranges::find_if(m_owed, [](const Handover& one) { return !one.refusal().empty(); });
    return refused == m_owed.end() ? kNone : refused->refusal();
}

}  // namespace kerf
