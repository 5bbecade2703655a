// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"

namespace kerf {

/// What is kept and the engine has yet to take: sent, awaited by its number, sent again when the answer was lost among
/// others or the ring was full. A refusal is told, and tried again when the machine's program has moved on.
///
/// What the status shows was taken, whether its answer has come or not, whether that was a no or not: sent once more it
/// would undo whatever has been chosen since. What is sent again takes along what people have changed at the machine
/// since it was sent first.
class Handover {
 public:
    using Action = decltype(Command::action);
    /// The status shows what was handed over, and nothing else: asked once it has been sent.
    using Shown = std::function<bool(const Status&)>;
    /// Takes into what is sent again what the status shows as changed since; asked before each further time.
    using Renew = std::function<void(Action&, const Status&)>;
    Handover(Action action, Shown shown, Renew renew)
        : m_action(std::move(action)), m_shown(std::move(shown)), m_renew(std::move(renew)) {}

    /// Looks for the answer, sends what has none. True: there are news.
    bool poll(EngineApi& engine);
    [[nodiscard]] bool taken() const noexcept { return m_taken; }
    /// Why the engine does not take it; empty: nobody has said no.
    [[nodiscard]] const Sentence& refusal() const noexcept { return m_refusal; }
    /// The same command, with newer values.
    [[nodiscard]] bool isOf(const Action& action) const noexcept { return m_action.index() == action.index(); }
    /// What has been owed after this: whatever is sent of this again must not take back the order named since.
    void follow(const Action& newer);
    /// An order of its own, where `newer` brings one with what it loads.
    [[nodiscard]] bool isOverruledBy(const Action& newer) const;

 private:
    struct Moment {
        ProgramState program{ProgramState::Idle};
        std::uint32_t partSequence{0};
        LinkState link{LinkState::Down};
        friend bool operator==(const Moment&, const Moment&) = default;
    };
    void lookForAnswer(const Status& status);
    [[nodiscard]] bool mayTry(const Status& status);

    Action m_action;
    Shown m_shown;
    Renew m_renew;
    bool m_sent{false};
    std::optional<std::uint32_t> m_number{};
    Sentence m_refusal{};
    Moment m_refusedAt{};
    int m_waited{0};
    bool m_taken{false};
};

/// Author of what the program does by itself.
inline constexpr const char* kItself = "Kerf";

/// Whoever asked hears it, if anybody did.
inline void answer(const std::function<void(const Result<void>&)>& done, const Result<void>& result) {
    if (done) {
        done(result);
    }
}

/// A person's change, on the one way that all services take: may it be → kept → sent → taken by the engine → shown.
/// Whoever says no on the way is heard: the answer goes back to the page, and problem() says it until it is over.
/// GUI thread only; writer and engine outlive it.
class ChangeWay {
 public:
    using Done = std::function<void(const Result<void>&)>;
    using Store = std::function<void(StoreWriter::Done stored)>;
    /// `show` makes the view anew, whenever the disk or the engine has answered.
    ChangeWay(EngineApi& engine, std::function<void()> show) : m_engine(engine), m_show(std::move(show)) {}

    /// `may`: validity and rights; a no ends the change here. `store` hands it to the writer; once it is on the disk,
    /// `then` takes it over and owes it to the engine. `done` (may be empty) is told what came of it on the disk.
    void change(const Result<void>& may, const Store& store, std::function<void(const Receipt&)> then, Done done);
    /// As change(), of what has been allowed already.
    void keep(const Store& store, std::function<void(const Receipt&)> then, Done done) {
        change({}, store, std::move(then), std::move(done));
    }
    /// To be handed to the engine, in the order in which it is owed; the newest of a kind takes the place of one
    /// before. `shown`: what the status says once the engine has it. `renew`, where anything of it can be changed at
    /// the machine as well: what was changed there meanwhile stands.
    void owe(const Handover::Action& action, Handover::Shown shown, Handover::Renew renew = {});
    /// A few times per second: answers are looked for, what has none is sent again.
    void poll();

    [[nodiscard]] bool busy() const noexcept { return m_busy > 0; }
    /// The engine has everything that was owed to it.
    [[nodiscard]] bool settled() const noexcept { return m_owed.empty(); }
    /// Something is on its way to the engine, which has said no to nothing.
    [[nodiscard]] bool underWay() const noexcept;
    /// What the disk or the engine has said no to last; empty when both have what holds.
    [[nodiscard]] const Sentence& problem() const noexcept;
    void setStoreProblem(const Sentence& why) { m_storeProblem = why; }
    /// What was owed holds no longer: nothing of it is tried again.
    void forgetOwed() { m_owed.clear(); }

 private:
    EngineApi& m_engine;
    std::function<void()> m_show;
    std::vector<Handover> m_owed{};
    Sentence m_storeProblem{};
    int m_busy{0};
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
};

}  // namespace kerf
