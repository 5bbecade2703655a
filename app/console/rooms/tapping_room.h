// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/rooms/room.h"
#include "engine/tapping/tap_exchange.h"

namespace kerf::console {

/// Tapping on the console: the built-in machine's drive and the loop that makes and records taps.
class TappingRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Tapping; }
    [[nodiscard]] bool fits(const std::string& machineKind) const override;
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const Options& options) override;
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override;

 private:
    std::unique_ptr<TapExchange> m_exchange{std::make_unique<TapExchange>()};
};

}  // namespace kerf::console
