// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/console/rooms/room.h"
#include "app/console/shop_memory_link.h"
#include "app/service/boring/boring_lots.h"
#include "engine/core/subscription.h"

namespace kerf::console {

/// Boring on the console: the loop and the lots with their service. The built-in machine's bores and the gauge in them
/// are the simulator's.
class BoringRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Boring; }
    [[nodiscard]] ui::PageEntry page() const override;
    /// The diamond turning lathe and a recorded day have no boring spindle.
    [[nodiscard]] bool fits(const std::string& machineKind) const override;
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const Options&) override { return nullptr; }
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override;
    void open(const Context& context) override;
    void whenOpen(Opened then) override;
    void serve(ui::Services& services) override;
    void poll() override;
    [[nodiscard]] bool underWay() override { return m_lots->underWay(); }
    void toolIsNew(const std::string& author) override;

    /// @pre opened
    [[nodiscard]] StoredBoringLots& lots() noexcept { return *m_lots; }

 private:
    void lotIsOpen();
    void announceAccepted();

    std::unique_ptr<StoredBoringLots> m_lots;
    std::unique_ptr<ShopMemoryLink> m_shopMemory;
    std::unique_ptr<Subscription> m_changes;
    std::function<void(const QString& line)> m_accepted;
    MeasurementId m_lastAnnounced{0};
};

}  // namespace kerf::console
