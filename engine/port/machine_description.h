// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/core/process.h"
#include "engine/port/output_limits.h"

namespace kerf {

/// What a machine counts in, as its description says; compared with what the control itself says.
enum class DescribedUnits : std::uint8_t { Unsaid, Millimetre, Inch };

/// Travel of one axis in machine coordinates, low_mm < high_mm.
struct AxisTravel {
    double low_mm{0.0};
    double high_mm{0.0};
};

/// A force sensor on the control's pins, as a person has described it.
struct DescribedForce {
    std::optional<double> bandwidth_Hz{};  ///< −3 dB of sensor, amplifier and filters together, > 0
    double scale_NPerUnit{1.0};           ///< newtons per unit of the pin, not 0; its sign makes into the work positive
    std::optional<double> range_N{};      ///< from here on the signal is at the end of its range, > 0
    std::optional<double> drift_NPerS{};  ///< how fast its zero may move, ≥ 0
    bool zeroInAir{true};                 ///< false: the sensor keeps its zero (strain gauges)
    double reset_s{0.2};                  ///< what its reset line takes, > 0
};

/// A machine as a person has described it (docs/linuxcnc.md, "The machine file"). Nothing said is nothing assumed: what
/// is empty is asked of the control or of the program.
struct MachineDescription {
    std::string name{};  ///< at most 22 bytes; empty: the control's own
    DescribedUnits units{DescribedUnits::Unsaid};
    /// Boring: spindle overhang L where the machine's Z is zero; L = overhangAtZ0_mm − Z, so down is more. Empty: the
    /// overhang counts from where a program of Kerf's begins, which is what the recipe says.
    std::optional<double> overhangAtZ0_mm{};
    std::array<std::optional<AxisTravel>, 3> axes{};  ///< X, Y, Z
    std::optional<double> highestSpeed_rpm{};         ///< of the spindle
    OutputLimits limits{};                            ///< of what Kerf may write
    DescribedForce force{};
    /// By ProcessId: Kerf may do it here.
    std::array<bool, kProcessPlaces> hosts{true, true, true, true, true, true, true, true};
    std::string commandHost{"127.0.0.1"};  ///< of linuxcncrsh; this computer only
    std::uint16_t commandPort{5007};
    std::string passwordFile{};  ///< two words, mode 0600; empty: KERF_LINUXCNC_PASSWORDS, else the well-known ones
};

}  // namespace kerf
