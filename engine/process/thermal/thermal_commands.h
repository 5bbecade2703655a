// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/core/command_list.h"
#include "engine/core/process.h"
#include "engine/core/work_order.h"
#include "engine/process/thermal/thermal_types.h"

/// What pages and services may ask of the thermal loop.
namespace kerf {

/// Limits, period and warm-up.
struct LoadThermalSetup {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    ThermalSetup setup{};
    std::optional<WorkOrder> order{};  ///< whose recipe it is; thermal makes no parts; empty: as named before
};

/// Count temperatures and drift from now on. The shift stays unless `clearShift` says the origin has been set
/// anew without it.
struct TakeThermalReference {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    bool clearShift{false};
};

/// Gap readings that mean no drift, kept from before a restart.
struct LoadGapZero {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    std::array<double, kAxisCount> zero_um{};
};

/// Measure the origin with the gap sensors.
struct MeasureOrigin {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
};

/// The part finished last has been measured; what it is off by is a measurement of the origin made when it was
/// finished.
struct MeasureByPart {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    static constexpr double kMost_um = 200.0;  ///< |deviation|; beyond it is no drift
    static constexpr double kNoise_um = 1.0;   ///< σ of a part and its gauge beyond that of the gap sensors
    /// Where the surface lies against where it should, > 0 along +axis; a diameter's deviation counts half.
    std::array<double, kAxisCount> deviation_um{};
    std::array<bool, kAxisCount> known{};
};

/// Count on from the last measurement instead of the prediction.
struct AdoptMeasurement {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
};

/// Put the gap sensors' readings into every minute, as training data.
struct RecordGaps {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
    bool on{false};
};

/// End the warm-up program.
struct StopWarmUp {
    static constexpr ProcessId kProcess = ProcessId::Thermal;
};

using ThermalCommands = CommandList<LoadThermalSetup, TakeThermalReference, LoadGapZero, MeasureOrigin, MeasureByPart,
                                    AdoptMeasurement, RecordGaps, StopWarmUp>;

}  // namespace kerf
