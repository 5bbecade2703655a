// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/rooms/room.h"
#include "app/service/milling/milling_service.h"
#include "engine/machine/simulated/simulated_milling.h"

namespace kerf::console {

/// Milling on the console: the built-in machine's plant, the force loop, and its service.
class MillingRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Milling; }
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
    void toolIsNew(const std::string& author) override;
    [[nodiscard]] bool prepared(EngineApi& engine) override;

 private:
    SimulatedMilling* m_plant{nullptr};  ///< null: a real machine
    std::unique_ptr<StoredMillingService> m_service;
};

}  // namespace kerf::console
