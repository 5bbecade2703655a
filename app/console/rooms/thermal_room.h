// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/console/rooms/room.h"
#include "app/service/thermal/thermal_service.h"
#include "engine/machine/simulated/simulated_thermal.h"
#include "engine/process/thermal/thermal_exchange.h"

namespace kerf::console {

/// Thermal on the console: the heat of both built-in machines, the compensating loop and the service.
///
/// The simulated machine remembers its temperatures and its work offset over a restart of the console, as a real one
/// would: a file beside the database, written once a minute of machine time at most.
class ThermalRoom final : public Room {
 public:
    [[nodiscard]] ProcessId process() const noexcept override { return ProcessId::Thermal; }
    [[nodiscard]] ui::PageEntry page() const override;
    [[nodiscard]] bool fits(const std::string& machineKind) const override;
    [[nodiscard]] std::unique_ptr<SimulatedProcess> makePlant(const Options& options) override;
    [[nodiscard]] std::unique_ptr<ProcessLoop> makeLoop() override;
    void open(const Context& context) override;
    void serve(ui::Services& services) override;
    void poll() override;
    [[nodiscard]] bool underWay() override { return m_service->underWay(); }

    /// For tests: the machine's heat; null on a real machine.
    [[nodiscard]] const SimulatedThermal* plant() const noexcept { return m_plant; }

 private:
    std::unique_ptr<ThermalExchange> m_exchange{std::make_unique<ThermalExchange>()};
    SimulatedThermal* m_plant{nullptr};
    std::uint64_t m_machineSeed{SimulatedThermal::kMachiningCentre};
    std::string m_memoryFile;
    std::unique_ptr<StoredThermalService> m_service;
};

}  // namespace kerf::console
