// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/service/asked_recipe.h"
#include "app/service/change_way.h"
#include "app/service/rights.h"
#include "app/service/stored_recipe_history.h"
#include "app/service/thermal/thermal_records.h"
#include "app/service/thermal/thermal_trainer.h"
#include "db/api/room_records.h"
#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"
#include "engine/process/thermal/thermal_exchange.h"
#include "ui/services/thermal_service.h"

namespace kerf {

/// The thermal service on the database: the limits are a recipe of the machine; models, sessions, shifts and gap
/// measurements are room records.
///
/// Limits and models are stored first, then given to the loop. On a simulated machine without a model one is trained on
/// simulated days of it, so that the loop has something to work with; a real machine starts with none. GUI thread only;
/// training runs on its own worker.
class StoredThermalService final : public ThermalService {
 public:
    struct Links {
        EngineApi& engine;
        StoreWriter& writer;
        ThermalExchange& exchange;
        std::string dayFolder{};       ///< history files (CSV) are looked for here
        std::uint64_t machineSeed{1};  ///< of the simulated machine
        std::uint64_t hardSeed{0};     ///< > 0: of one that bites
        std::uint64_t daysSeed{1};
        Rights rights{};
        std::vector<ThermalSensorView> sensors{};  ///< of the machine's sensor file; empty: those of the machine itself
    };
    /// Loads what was kept and offers the live model. `reader` is used here only; the others outlive the service.
    StoredThermalService(const Links& links, RoomRecordReader& reader, LotReader& lots);

    [[nodiscard]] const ThermalServiceView& view() const override { return m_view; }
    [[nodiscard]] std::vector<std::pair<double, double>> temperatures(std::size_t sensor) const override;
    [[nodiscard]] ThermalErrorMap errorMap(double z_mm, bool exact) const override;
    void findDays() override;
    [[nodiscard]] Result<void> train(const std::string& kind, const std::vector<std::string>& dayIds) override;
    void cancelTraining() override { m_trainer.cancel(); }
    void leaveOut(const std::string& dayId, bool out, const std::string& author, const std::string& reason,
                  RecipeHistory::Done done) override;
    [[nodiscard]] Result<void> goLive(const std::string& author) override;
    [[nodiscard]] Result<void> rollBack(const std::string& author) override;
    [[nodiscard]] RecipeHistory* recipes() override { return &m_history; }
    void changeSetup(const ThermalSetup& setup, const std::string& author, const std::string& reason,
                     RecipeHistory::Done done) override;
    [[nodiscard]] Result<void> measureByPart(const std::array<std::optional<double>, kAxisCount>& deviation_um,
                                             const std::string& author) override;
    [[nodiscard]] Result<void> beginSession(const std::string& author) override;
    [[nodiscard]] Result<void> endSession(const std::string& author) override;
    void poll() override;
    /// Limits and warm-up are on their way to the disk or to the engine.
    [[nodiscard]] bool underWay() const { return m_asked.open() || m_way.underWay(); }

 private:
    struct KeptModel {
        thermal::ThermalModel model{};
        ThermalModelCard card{};
    };
    /// The temperatures are those of the simulated machine, whose days and error elements are known.
    [[nodiscard]] bool builtInHeat() const;
    void load(RoomRecordReader& reader);
    void loadModels(RoomRecordReader& reader);
    void loadSessions(const std::vector<RoomRecordRow>& rows);
    /// Which days are left out, by whom and why.
    void loadMemory(RoomRecordReader& reader);
    /// On simulated days of the simulated machine, when nothing is live.
    void trainFirst();
    void loadSetup();
    /// Checked, stored as a revision of the recipe, then sent.
    void accept(const ThermalSetup& setup, const std::string& author, const std::string& reason,
                std::optional<std::uint32_t> restoredFrom, RecipeHistory::Done done);
    [[nodiscard]] Result<void> mayAccept(const ThermalSetup& setup, const std::string& author,
                                         const std::string& reason) const;
    void restoreRevision(const RecipeRevision& revision, const std::string& author, const std::string& reason,
                         RecipeHistory::Done done);
    [[nodiscard]] std::string recipeName() const;
    void oweSetup();
    void keep(const char* kind, std::string body, const std::string& author, std::string reason,
              std::function<void(const Receipt&)> stored = {});
    [[nodiscard]] Result<void> makeLive(KeptModel model, const std::string& author, std::string reason);
    void install(KeptModel model);
    void takeMinutes();
    void takeLearnt();
    void takeMinute(const ThermalMinute& minute);
    void takeGap(const ThermalStatus& status);
    void takeTraining();
    void writeShifts(bool now);
    [[nodiscard]] thermal::ThermalHistory sessionDay() const;
    [[nodiscard]] Result<void> send(const decltype(Command::action)& action);
    [[nodiscard]] std::vector<std::string> channelNames() const;
    void changed() {
        m_view.storeProblem = m_way.problem();
        ++m_view.revision;
    }

    Links m_links;
    ChangeWay m_way{m_links.engine, [this] { changed(); }};
    RecipeBook m_recipes;
    StoredRecipeHistory m_history;
    RecipeRevisionId m_recipe{0};  ///< of the setup; 0: none was kept
    AskedRecipe<ThermalSetup> m_asked{};
    ThermalServiceView m_view{};
    std::shared_ptr<std::vector<std::string>>
        m_trainingNotes{};  ///< what was left out of the days; written by the worker
    ThermalTrainer m_trainer{};
    std::deque<ThermalMinute> m_minutes{};
    std::vector<ThermalMinute> m_session{};
    std::uint32_t m_sessionReference{0};
    std::string m_sessionAuthor{};
    std::vector<std::pair<std::string, thermal::ThermalHistory>> m_sessions{};  ///< id and day, newest first
    std::map<std::string, RoomRecordRow> m_told{};  ///< by day: left out or taken in again, with reason and author
    std::optional<KeptModel> m_live{};
    std::optional<KeptModel> m_previous{};
    std::optional<KeptModel> m_candidate{};
    std::vector<ThermalShiftRow> m_unwritten{};
    std::int64_t m_lastWrite_ms{0};
    std::uint32_t m_gapSeen{0};
    std::string m_partAuthor{};                           ///< who measured the part the loop is being told of
    std::array<double, kAxisCount> m_partDeviation_um{};  ///< and what he found
    std::uint32_t m_modelNumber{0};
    std::uint32_t m_reference{0};
    bool m_zeroSent{false};
    std::optional<std::array<double, kAxisCount>> m_keptZero{};
    std::vector<thermal_records::Learnt> m_recalled{};  ///< of this day, from before this start; oldest first
    bool m_firstModel{false};  ///< the training under way is that of the first start: goes live by itself
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
};

}  // namespace kerf
