// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/rooms/room.h"
#include "app/service/turning/turning_service.h"

namespace kerf::console {

/// Diamond turning on the console: a lathe of its own, because its cycle is .2 ms.
class TurningRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Turning; }
    [[nodiscard]] ui::PageEntry page() const override;
    [[nodiscard]] bool fits(const std::string& machineKind) const override;
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const Options& options) override;
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override;
    void open(const Context& context) override;
    void serve(ui::Services& services) override;
    void poll() override;
    [[nodiscard]] bool underWay() override { return m_service->underWay(); }
    [[nodiscard]] RecipeHeld recipe() override;
    void recipeRevised(RecipeRevisionId revision) override;
    [[nodiscard]] bool prepared(EngineApi& engine) override;
    [[nodiscard]] const StoredTurningService& service() const { return *m_service; }

 private:
    std::unique_ptr<TurningExchange> m_exchange{std::make_unique<TurningExchange>()};
    std::unique_ptr<StoredTurningService> m_service;
};

}  // namespace kerf::console
