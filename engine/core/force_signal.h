// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace kerf {

/// Where the zero of a force sensor stands (engine/cycle/force_zero.h).
enum class ForceZeroState : std::uint8_t {
    Own,       ///< the sensor keeps its zero: nothing is taken, nothing subtracted
    Taking,    ///< in the air before the cut: listened to, the amplifier is reset, or the mean is taken
    Known,     ///< subtracted, and can be trusted
    Missed,    ///< the tool was never seen in the air for long enough
    Doubtful,  ///< it may have drifted by more than can be borne, or the force shows that it has
};

/// A force signal as it comes in, for who controls on it and for who looks at it.
struct ForceSignal {
    double rate_Hz{0.0};       ///< samples per second; 0: no sensor
    double bandwidth_Hz{0.0};  ///< −3 dB of sensor, amplifier and filters together, at most half the rate; 0: not known
    bool zeroInAir{false};     ///< its zero is not kept by the sensor (piezo): taken in the air before each cut
    double drift_NPerS{0.0};  ///< how fast that zero may move, ≥ 0, as the maker states it
    double reset_s{0.0};      ///< what its reset line takes; counts where there is one
};

}  // namespace kerf
