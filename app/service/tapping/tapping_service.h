// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/service/change_way.h"
#include "app/service/rights.h"
#include "app/service/tapping/stored_tuning.h"
#include "engine/api/engine_api.h"
#include "engine/process/tapping/tuning_session.h"

namespace kerf {

/// The tapping service over tuning sessions on one engine. GUI thread; asking the tuner takes some milliseconds.
///
/// It knows nothing of a database: tunings of earlier runs come in, accepted ones go out. A thread's tunings are the
/// revisions of its recipe.
class StoredTappingService final : public TappingService {
 public:
    struct Params {
        /// Servo constants the tuner starts from, and the drive's ramp and tail.
        tapping::DriveParams assumed{tapping::middlingDrive()};
        double abortOverAllowed{10.0};  ///< abort limit over the allowed peak-to-peak: an untuned drive must pass
        int maxTaps{8};
        std::vector<tapping::StoredTuning> known{};  ///< oldest first
        /// Keeps a tuning for ever, as a revision of its thread's recipe, whose number `done` is told. May be empty.
        using Kept = std::function<void(const Result<std::int64_t>&)>;
        std::function<void(const tapping::StoredTuning&, const tapping::TuningWords&, Kept done)> store{};
        RecipeHistory* recipes{nullptr};  ///< where they are; null: nowhere
        LotService* lots{nullptr};        ///< null: taps are of no lot
        /// That recipe is in force; gives whose work the next taps are. May be empty.
        std::function<WorkOrder(std::int64_t recipe)> order{};
        Rights rights{};
        /// A change that is no tuning: author, key of the deed, what; for the audit log. May be empty.
        std::function<void(const std::string& author, const char* key, const std::string& what)> note{};
    };
    /// Engine and exchange outlive the service.
    StoredTappingService(EngineApi& engine, TapExchange& exchange, Params params);

    [[nodiscard]] const TappingServiceView& view() const override { return m_view; }
    [[nodiscard]] const std::vector<TapThreadView>& threads() const override { return m_threads; }
    [[nodiscard]] Result<void> load(const TapChoice& choice, const std::string& author) override;
    [[nodiscard]] Result<void> begin(const std::string& author, bool automatic) override;
    [[nodiscard]] RecipeHistory* recipes() override { return m_params.recipes; }
    /// Limits have made this revision of the thread's recipe; the tuning in force stands in it as it was.
    void recipeRevised(std::int64_t revision);
    [[nodiscard]] LotService* lots() override { return m_params.lots; }
    /// The engine has taken the job that was loaded last.
    [[nodiscard]] bool loaded(const Status& status) const { return m_jobs > 0 && status.tapping.job == m_jobs; }
    /// Tunings and jobs on their way to the disk and to the engine.
    [[nodiscard]] const ChangeWay& way() const noexcept { return m_way; }
    /// A tuning of before, revision `revision` of its thread's recipe, is in force again: stored first, then loaded
    /// where the present job is one that it serves. `done` is told of both.
    void takeBack(const tapping::StoredTuning& tuning, std::uint32_t revision, const std::string& author,
                  const std::string& reason, const RecipeHistory::Done& done);
    [[nodiscard]] Result<void> leaveOut(bool out, const std::string& author, const std::string& reason) override;
    void setAutomatic(bool automatic, const std::string& author) override;
    void oneMore(const std::string& author) override;
    void accept(const std::string& author) override;
    void rollBack(const std::string& author) override;
    void abort() override;
    void recover() override;
    void poll() override;

    /// Answer of the store: empty when the tuning is on the disk.
    void setStoreProblem(const Sentence& why);

 private:
    [[nodiscard]] bool busy() const;
    [[nodiscard]] std::optional<Sentence> whyNotNow();
    [[nodiscard]] std::optional<Sentence> whyNot(const TapChoice& choice);
    [[nodiscard]] TappingJob jobFor(const TapChoice& choice);
    [[nodiscard]] const tapping::StoredTuning* newestFor(const TapChoice& choice, GainsSource& how) const;
    [[nodiscard]] tapping::TapSettings machinesOwn();
    void send(const decltype(Command::action)& action);
    void showStored();
    void watchProduction();
    void rebuild();
    void refused(const Sentence& why);
    void note(const std::string& author, Deed deed, const std::string& what) const;
    void decided(const std::string& author, bool rolledBack);
    /// One more that is known; once it is stored, it is what parts are cut with (unless it `isWord` about another).
    void keep(const tapping::StoredTuning& tuning, const tapping::TuningWords& words, bool isWord);
    [[nodiscard]] ChangeWay::Store storing(const tapping::StoredTuning& tuning,
                                           const tapping::TuningWords& words) const;
    void show();
    void useRecipe(std::int64_t recipe);

    EngineApi& m_engine;
    TapExchange& m_exchange;
    Params m_params;
    ChangeWay m_way{m_engine, [this] { show(); }};
    std::vector<TapThreadView> m_threads{};
    std::unique_ptr<TuningSession> m_session{};
    std::optional<tapping::TapSettings> m_own{};  ///< the machine's, before anything was tuned
    tapping::TapSettings m_inForce{};
    tapping::TapSettings m_before{};  ///< of the tuning
    TuningSession::State m_shownState{TuningSession::State::Air};
    std::size_t m_shownTrials{0};
    std::uint32_t m_jobs{0};
    std::uint32_t m_gains{0};  ///< newest revision handed over
    std::uint32_t m_seenTaps{0};
    std::vector<std::uint32_t> m_sent{};
    std::string m_author{};
    TappingServiceView m_view{};
};

}  // namespace kerf
