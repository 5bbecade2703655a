// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/service/change_way.h"
#include "app/service/rights.h"
#include "db/api/lot_reader.h"
#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"
#include "engine/core/listeners.h"
#include "engine/core/work_order.h"
#include "ui/services/lot_service.h"

namespace kerf {

/// The lots of one process, the same way for milling, turning and tapping, in the tables boring's lots stand in. What a
/// lot is cut with belongs to the service, which says here which part type and which revision are in force; the book
/// makes the order of it that goes to the engine and comes back with each part.
///
/// Thermal has none: it makes no parts.
class LotBook final : public LotService {
 public:
    struct Links {
        StoreWriter& writer;
        EngineApi& engine;
        LotReader& reader;
        ProcessId process{ProcessId::Milling};
        Rights rights{};
        std::function<std::string()> partType{};        ///< in force
        std::function<std::string()> parametersJson{};  ///< its recipe, should no revision of it have been kept yet
        std::function<bool()> settled{};       ///< the engine has loaded what is in force: nothing is on its way
        std::string machineKind{"simulator"};  ///< as --machine names it
    };
    /// Goes on with the lot that was chosen when the console ended, unless it is closed. Links outlive the book.
    explicit LotBook(Links links);

    /// Which revision is in force (0: none was kept).
    void use(RecipeRevisionId recipe);
    [[nodiscard]] RecipeRevisionId recipe() const noexcept { return m_recipe; }
    [[nodiscard]] WorkOrder order() const;
    /// The order, to be sent with what the engine is to load.
    [[nodiscard]] WorkOrder withLoad() { return m_sent = order(); }
    /// Names the order where it alone has changed. A few times per second; what waits for a load goes with it.
    void send();
    /// Whose work the next part is, is on its way to the disk or to the engine; `way`: that of what it is made with.
    [[nodiscard]] bool underWay(const ChangeWay& way) const;

    [[nodiscard]] Result<std::vector<LotView>> lots() const override;
    [[nodiscard]] std::optional<LotView> current() const override;
    [[nodiscard]] std::string partType() const override { return m_links.partType(); }
    void open(const NewLot& lot, const std::string& author, Done done) override;
    void choose(std::int64_t lot, const std::string& author, Done done) override;
    void leave(const std::string& author, Done done) override;
    void close(const std::string& author, const std::string& reason, Done done) override;
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        return m_listeners.add(std::move(changed));
    }

 private:
    [[nodiscard]] std::optional<LotView> find(LotId lot) const;
    [[nodiscard]] std::string machineName() const;
    void activate(std::optional<LotView> lot, const std::string& author, Done done);
    void store(StoreCommand command, Done failed, std::function<void(const Receipt&)> then);

    Links m_links;
    std::optional<LotView> m_lot{};
    RecipeRevisionId m_recipe{0};
    WorkOrder m_sent{};
    int m_storing{0};
    Listeners<> m_listeners;
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
};

}  // namespace kerf
