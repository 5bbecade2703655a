// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/rooms/room.h"

namespace kerf::console {

/// Milling on the console: the built-in machine's plant and the force loop.
class MillingRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Milling; }
    [[nodiscard]] bool fits(const std::string& machineKind) const override;
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const Options& options) override;
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override;
};

}  // namespace kerf::console
