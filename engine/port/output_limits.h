// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf {

/// Range and rate of every value that leaves Kerf, as the machine's description declares them. No loop can widen it.
struct OutputLimits {
    double feedScaleMin{0.05};            ///< lowest factor a loop may ask, (0, 1]; a stop is a feed hold
    double feedScaleMax{1.0};             ///< ≥ 1; the machine's own maxFeedScale is applied as well
    double feedScaleRise_perS{2.0};       ///< > 0
    double feedScaleFall_perS{20.0};      ///< > 0: backs off faster than it recovers
    double workOffsetMax_um{200.0};       ///< size of the whole shift per axis, ≥ 0
    double workOffsetRate_umPerS{1.0};    ///< > 0
    double toolTrimMax_um{2.0};           ///< ≥ 0
    double toolTrimRate_umPerS{1'000.0};  ///< > 0: from the end of its range to zero in 2 ms
    double zTrimMax_um{1000.0};           ///< ≥ 0
    double zTrimRate_umPerS{100'000.0};   ///< > 0
    double zTrimReturn_umPerS{2'000.0};   ///< > 0: without a wish; a tap may stand in its thread
    double servoGainMin_perS{5.0};        ///< > 0
    double servoGainMax_perS{200.0};      ///< ≥ min
};

}  // namespace kerf
