// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/service/asked_recipe.h"
#include "app/service/change_way.h"
#include "app/service/lot_book.h"
#include "app/service/rights.h"
#include "app/service/stored_recipe_history.h"
#include "app/service/turning/turning_records.h"
#include "db/api/room_records.h"
#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"
#include "engine/core/listeners.h"
#include "engine/process/turning/turning_exchange.h"
#include "ui/services/turning_service.h"

namespace kerf {

/// The turning service on the database: setup and law are a recipe, every part is a room record ("part", and "memory"
/// of a part that is left out; a "controller" of before the law stood in the recipe is brought into it); stored first
/// and then sent to the engine. A restart reads them again and goes on where it was: the next part begins with the
/// process and the tones of the stored ones
/// (turning_memory.h).
///
/// Spectra are made from the surfaces that the loop hands over, margins on a worker. GUI thread only.
class StoredTurningService final : public TurningService {
 public:
    struct Links {
        StoreWriter& writer;
        EngineApi& engine;
        TurningExchange& exchange;
        RoomRecordReader& reader;
        LotReader& lots;
        Rights rights{};
        std::string machineKind{"simulator"};  ///< as --machine names it
    };
    static constexpr const char* kPartType = "Face";

    /// Reads what was kept and sends the engine its setup with the next poll(). Links must outlive the service.
    explicit StoredTurningService(const Links& links);
    ~StoredTurningService() override;

    [[nodiscard]] const TurningServiceView& view() const override { return m_view; }
    [[nodiscard]] std::span<const ParamSpec> setupSpecs() const override;
    [[nodiscard]] const ParamSpec& toneSpec() const override;
    [[nodiscard]] double setupValue(const TurningSetup& setup, std::size_t field) const override;
    void changeSetup(TurningSetup& setup, std::size_t field, double value) const override;
    [[nodiscard]] std::optional<Sentence> whyUnusable(const TurningSetup& setup) const override;
    [[nodiscard]] Result<double> overlap(double toolRadius_um, double depth_um, double feed_umPerRev) const override;
    void loadSetup(const TurningSetup& setup, const std::string& author, const std::string& reason, Done done) override;
    [[nodiscard]] RecipeHistory* recipes() override { return &m_history; }
    [[nodiscard]] LotService* lots() override { return &m_lots; }
    /// What holds, as it is stored.
    [[nodiscard]] std::string recipeJson() const { return turningRecipeJson({m_view.setup, m_view.controller}); }
    /// Limits have made this revision of the recipe.
    void recipeRevised(RecipeRevisionId revision) { m_lots.use(revision); }
    /// What the next part is turned with is on its way to the disk or to the engine.
    [[nodiscard]] bool underWay() const { return m_asked.open() || m_lots.underWay(m_way); }
    void setController(TurningController controller, const std::string& author, Done done) override;
    void leaveOut(std::int64_t part, bool out, const std::string& author, const std::string& reason,
                  Done done) override;
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override;

    /// A few times per second: sends what the engine has not got yet, takes surfaces, follows margins and tones.
    void poll();

 private:
    /// Mean power of the spectra of one part.
    struct SurfaceSum {
        std::uint32_t partSequence{0};
        std::size_t count{0};
        bool settled{false};  ///< of surfaces after the first one of the part
        double step_Hz{0.0};
        std::vector<double> treated_um2{};
        std::vector<double> untreated_um2{};
        [[nodiscard]] TurningSpectrum mean() const;
    };
    /// What the margins were computed from.
    struct MarginBasis {
        TurningController controller{TurningController::Open};
        TurningProcess law{};
        bool identified{false};
        std::array<double, 3> value{};
        std::array<double, 3> half95{};
        std::vector<std::pair<double, double>> tones{};  ///< frequency, share
        double toneShare{0.0};
        std::array<double, kTurningFilters> plain{};
        std::array<double, kTurningFilters> underTones{};
    };

    void restore();
    void restoreParts();
    /// Checked, stored as a revision of the recipe, then sent.
    void accept(const Result<void>& may, const TurningRecipe& recipe, const std::string& author,
                const std::string& reason, std::optional<std::uint32_t> restoredFrom, Done done);
    /// What the recipe was asked to be last.
    [[nodiscard]] TurningRecipe asked() const { return m_asked.from({m_view.setup, m_view.controller}); }
    /// A law of before it stood in the recipe.
    void bringLaw();
    void restoreRevision(const RecipeRevision& revision, const std::string& author, const std::string& reason,
                         Done done);
    [[nodiscard]] Result<void> mayAccept(const TurningSetup& setup, const std::string& author,
                                         const std::string& reason) const;
    void store(const char* kind, std::string subject, std::string json, const std::string& author,
               const std::string& reason, Done done, std::function<void()> stored);
    void send();
    [[nodiscard]] bool takeSurface();
    [[nodiscard]] bool followMargins(const Status& status);
    [[nodiscard]] bool followBlindTones(const Status& status);
    void partStored(const StoredPart& stored);
    void recall();
    void compare();
    void changed();
    [[nodiscard]] static MarginBasis marginBasis(const TurningStatus& status);
    [[nodiscard]] static TurningMargins computeMargins(const MarginBasis& basis);

    Links m_links;
    ChangeWay m_way{m_links.engine, [this] { changed(); }};
    RecipeBook m_recipes;
    StoredRecipeHistory m_history;
    LotBook m_lots;
    TurningServiceView m_view{};
    AskedRecipe<TurningRecipe> m_asked{};
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
    std::uint32_t m_sentSetup{0};
    std::optional<TurningController> m_sentController{};
    SurfaceSum m_sum{};
    std::future<TurningMargins> m_marginsToCome{};
    std::optional<MarginBasis> m_marginBasis{};
    bool m_cutSinceStart{false};
    /// What the loop goes by rests on other parts than those that count now: the part after this one, in the machine's
    /// own count, begins anew.
    std::optional<std::uint32_t> m_anewAfter{};
    std::vector<double> m_blindTones_Hz{};
    double m_blindSpeed_rpm{0.0};
    Listeners<> m_listeners{};
    std::unique_ptr<Subscription> m_parts{};
    std::unique_ptr<Subscription> m_problems{};
};

}  // namespace kerf
