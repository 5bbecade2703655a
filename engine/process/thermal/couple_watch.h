// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/process/thermal/thermal_exchange.h"
#include "engine/process/thermal/thermal_types.h"

namespace kerf {

/// State of every thermocouple of the machine for the page: those of the model as its estimator sees them, the others
/// by their readings alone (open, short, stuck). Runs in the cycle.
class CoupleWatch {
 public:
    /// Once a period. `live` may be null.
    void report(const TemperatureFrame& frame, const LiveModel* live, ThermalStatus& status) noexcept;

 private:
    std::array<float, kMaxTemperatures> m_last_degC{};
    std::array<std::uint16_t, kMaxTemperatures> m_repeats{};
};

/// What is wrong with a thermocouple; %1 is its name.
[[nodiscard]] const char* sickCoupleText(CoupleState state) noexcept;

}  // namespace kerf
