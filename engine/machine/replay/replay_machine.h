// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/port/machine_port.h"

namespace kerf {

/// One row of a recorded day.
struct ReplayRow {
    double time_min{0.0};  ///< rising
    std::optional<double> speed_rpm{};
    std::array<float, kMaxTemperatures> temp_degC{};
    std::uint64_t present{0};  ///< bit k: temperature k was read
    std::array<double, kAxisCount> drift_um{};
    bool measured{false};  ///< drift_um was measured in this row
};

/// A recorded day as a machine: its temperatures, spindle speed and gap sensors come again at the pace of machine time,
/// from the first row on. The work offset reads back what is asked for; nothing else can be commanded. At the end
/// everything is stale: yesterday is over.
class ReplayMachine final : public MachinePort {
 public:
    static constexpr double kGapAtRest_um = 500.0;

    /// @pre at least one row; times rise; count ≤ kMaxTemperatures
    ReplayMachine(std::vector<ReplayRow> rows, std::uint16_t count);

    [[nodiscard]] Result<void> connect() override { return {}; }
    void disconnect() noexcept override {}
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_capabilities; }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override;
    void write(const MachineOutputs& outputs) noexcept override;

    [[nodiscard]] bool ended() const noexcept { return m_ended; }

 private:
    std::vector<ReplayRow> m_rows;
    Capabilities m_capabilities{};
    TemperatureFrame m_frame{};
    std::optional<std::int64_t> m_start_ns{};
    std::size_t m_next{0};  ///< row that comes next
    bool m_ended{false};
    std::array<double, kAxisCount> m_workOffset_um{};
    RequestReply m_reply{};
};

}  // namespace kerf
