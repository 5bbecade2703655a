// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/service/boring/current_boring_service.h"
#include "app/service/recipe_book.h"
#include "ui/services/boring_lots.h"

namespace kerf {

/// The lots of one machine on the database, and the service of the current one.
class StoredBoringLots final : public BoringLots {
 public:
    /// `first`: the machine, and the lot that is made when the machine has none. Links, reader and `lotOpened` (called
    /// whenever another lot is current) must outlive it.
    StoredBoringLots(const StoredBoringService::Links& links, LotReader& reader, BoringLotRequest first,
                     std::function<void()> lotOpened = {});

    /// Asks the shop for lots of a part type on other machines, elsewhere; `told` comes on the GUI thread, at once or
    /// whenever the shop answers.
    using ShopLotsTold = std::function<void(const Result<std::vector<BoringMemoryLot>>&)>;
    using AskShop = std::function<void(const std::string& partType, ShopLotsTold told)>;
    /// Where recipes say so, lots draw on the shop from now on. A lot is open at once and the shop's lots are taken in
    /// while nothing of it is cut yet: nobody waits for the shop, and no feed changes in the middle of a lot.
    void drawOnShop(AskShop ask) { m_askShop = std::move(ask); }

    /// Goes on with the lot that was current when the console ended; else with the newest open one; else makes the
    /// first.
    void start(Done done);
    [[nodiscard]] CurrentBoringService& service() noexcept { return m_service; }
    /// A few times per second.
    void poll() { m_service.poll(); }
    /// Another lot, or what the next part is cut with, is on its way to the disk or to the engine.
    [[nodiscard]] bool underWay() { return m_changing > 0 || (m_service.open() && m_service.stored().underWay()); }

    [[nodiscard]] std::span<const ParamSpec> recipeSpecs() const override { return boringRecipeSpecs(); }
    [[nodiscard]] BoringRecipeForm standardRecipe() const override { return recipeForm(BoringRecipe{}); }
    [[nodiscard]] std::optional<Sentence> whyUnusable(const BoringRecipeForm& form) const override;
    [[nodiscard]] Result<std::vector<BoringPartTypeView>> partTypes() override;
    [[nodiscard]] Result<std::vector<BoringRecipeView>> recipes(PartTypeId partType) override;
    [[nodiscard]] Result<std::vector<BoringLotView>> lots() override;
    [[nodiscard]] std::vector<BoringRecipeChange> compare(const BoringRecipeForm& before,
                                                          const BoringRecipeForm& after) const override;
    [[nodiscard]] std::optional<Sentence> whyNoOther() const override;
    void open(const BoringLotOrder& order, Done done) override;
    void choose(LotId lot, const std::string& author, Done done) override;
    [[nodiscard]] Result<std::vector<BoringMemoryLotView>> memory() override;
    void leaveOut(const BoringMemoryKey& lot, bool out, const std::string& author, const std::string& reason,
                  Done done) override;
    [[nodiscard]] Sentence shopAnswer() const override { return m_shopAnswer; }
    void close(const std::string& author, const std::string& reason, Done done) override;
    void addPartType(const std::string& name, const BoringRecipeForm& form, const std::string& author,
                     PartTypeDone done) override;
    void saveRecipe(PartTypeId partType, const BoringRecipeForm& form, const std::string& author,
                    const std::string& reason, Done done) override;
    void restoreRecipe(PartTypeId partType, std::uint32_t revision, const std::string& author,
                       const std::string& reason, Done done) override;

 private:
    /// Boring lots of this machine, newest first.
    [[nodiscard]] Result<std::vector<LotRow>> rows();
    [[nodiscard]] std::uint32_t partsWaiting(const LotRow& lot);
    [[nodiscard]] Result<EnsureLot> ensureLot(const BoringLotOrder& order);
    void activate(LotId lot, const std::string& author, Done done);
    [[nodiscard]] Result<void> openService(LotId lot);
    void submit(StoreCommand command, Done done);
    /// Until `done` has its answer, the next part may come to be another lot's, or cut otherwise.
    [[nodiscard]] Done changing(Done done);
    /// The writer's answer, as the page is told of it.
    [[nodiscard]] StoreWriter::Done answered(Done done) const;
    void askShop(LotId lot);
    void shopTold(LotId lot, const Result<std::vector<BoringMemoryLot>>& told);

    StoredBoringService::Links m_links;
    LotReader& m_reader;
    RecipeBook m_recipes;
    BoringLotRequest m_first;
    std::function<void()> m_lotOpened;
    std::optional<LotId> m_current{};
    int m_changing{0};
    AskShop m_askShop{};
    std::optional<LotId> m_asked{};  ///< the lot that the shop was asked for last
    Sentence m_shopAnswer{};
    CurrentBoringService m_service{};
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
};

}  // namespace kerf
