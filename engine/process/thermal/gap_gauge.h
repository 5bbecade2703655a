// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/api/command.h"
#include "engine/port/machine_port.h"
#include "engine/process/thermal/thermal_types.h"

namespace kerf {

/// The gap sensors: what they read now, what they read without drift, and one spot measurement of the origin at a time.
/// What others see of it (gap, zero, readable, recording) stands in the status that it is given. Runs in the cycle: no
/// allocation, lock, throw or I/O.
class GapGauge {
 public:
    using PerAxis = std::array<double, kAxisCount>;

    /// Once a cycle. True when a spot measurement is complete: its mean stands in status.gap.measured_um.
    [[nodiscard]] bool watch(const MachineInputs& inputs, const Capability& fitted, ThermalStatus& status) noexcept;

    /// Begin a spot measurement, or say why not.
    [[nodiscard]] CommandResult measure(ThermalStatus& status) noexcept;
    [[nodiscard]] CommandResult record(bool on, ThermalStatus& status) const noexcept;
    /// A zero from before a restart; it holds until the next reference.
    [[nodiscard]] CommandResult loadZero(const PerAxis& zero_um, ThermalStatus& status) noexcept;

    /// The next reference takes its own zero.
    void forgetZero() noexcept { m_zeroLoaded = false; }
    void beginReference() noexcept;
    /// One reading of the baseline.
    void addReference(const ThermalStatus& status) noexcept;
    /// `carried_um`: drift the reference itself stands for.
    void endReference(const PerAxis& carried_um, ThermalStatus& status) const noexcept;

    [[nodiscard]] const PerAxis& now_um() const noexcept { return m_now_um; }

 private:
    static constexpr std::size_t kReadings = 5;

    Capability m_fitted{};
    PerAxis m_now_um{};
    PerAxis m_sum_um{};
    std::size_t m_count{0};
    std::int64_t m_stamp_ns{0};
    std::int64_t m_since_ns{0};
    std::int64_t m_last_ns{0};
    PerAxis m_zeroSum_um{};
    std::size_t m_zeroCount{0};
    bool m_zeroLoaded{false};
};

}  // namespace kerf
