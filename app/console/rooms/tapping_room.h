// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/console/rooms/room.h"
#include "app/service/lot_book.h"
#include "app/service/stored_recipe_history.h"
#include "app/service/tapping/tapping_service.h"
#include "engine/process/tapping/tap_exchange.h"

namespace kerf::console {

/// Tapping on the console: the built-in machine's drive, the loop that makes and records taps, the service that tunes.
/// Accepted tunings are revisions of their thread's recipe; at a start they come back in the order they were made.
class TappingRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Tapping; }
    [[nodiscard]] ui::PageEntry page() const override;
    [[nodiscard]] bool fits(const std::string& machineKind) const override;
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const Options& options) override;
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override;
    void open(const Context& context) override;
    void serve(ui::Services& services) override { services.tappingService = m_service.get(); }
    void poll() override;
    [[nodiscard]] bool underWay() override {
        return m_service && (m_service->way().busy() || m_lots->underWay(m_service->way()));
    }
    [[nodiscard]] RecipeHeld recipe() override;
    void recipeRevised(RecipeRevisionId revision) override;
    [[nodiscard]] bool prepared(EngineApi& engine) override;

 private:
    void keep(const tapping::StoredTuning& tuning, const tapping::TuningWords& words,
              const StoredTappingService::Params::Kept& done);
    void restore(const RecipeRevision& revision, const std::string& author, const std::string& reason,
                 const RecipeHistory::Done& done);

    std::unique_ptr<TapExchange> m_exchange{std::make_unique<TapExchange>()};
    StoreWriter* m_writer{nullptr};
    std::optional<RecipeBook> m_recipes{};
    std::optional<StoredRecipeHistory> m_history{};
    std::optional<LotBook> m_lots{};
    std::unique_ptr<StoredTappingService> m_service;
};

}  // namespace kerf::console
