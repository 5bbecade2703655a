// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// LinuxCNC's HAL for a user-space component. Only kerf-hal includes this.
#define ULAPI
extern "C" {
#include <rtapi.h>
//
#include <hal.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "engine/machine/linuxcnc/link_memory.h"

/// Pins of the bridge. HAL moves a pin's pointer when the pin is linked: that is how the bridge knows what is fitted.
namespace kerf::linuxcnc {

template <class Value>
class Pin {
 public:
    [[nodiscard]] volatile Value& operator*() const noexcept { return **m_slot; }
    /// A signal is linked to it.
    [[nodiscard]] bool linked() const noexcept { return *m_slot != m_own; }
    /// … which is the one whose value stands there.
    [[nodiscard]] bool linkedTo(const volatile void* value) const noexcept { return linked() && *m_slot == value; }
    /// `slot` is HAL's memory and has just been filled by hal_pin_…_newf.
    void take(volatile Value** slot) noexcept {
        m_slot = slot;
        m_own = *slot;
    }

 private:
    volatile Value** m_slot{nullptr};
    volatile Value* m_own{nullptr};
};
using FloatPin = Pin<double>;
using BitPin = Pin<bool>;
using IntPin = Pin<std::int32_t>;

struct Pins {
    // from the control
    FloatPin currentVelocity, requestedVelocity, spindleSpeed, spindleRevs, feedOverride, driveBandwidth, offsetRatio,
        maxFeedOverride, programProcess, force, forceBandwidth;
    std::array<FloatPin, 3> position, offsetActual, originShift;
    BitPin machineOn, emergencyStop, programRunning, programPaused, cutting, finished, softLimit, simulator,
        originKnown;
    std::array<BitPin, 5> requestWord;
    std::array<FloatPin, 64> temperature;     ///< kerf.temperature-0 …, °C, from mb2hal or a driver
    std::array<BitPin, 64> temperatureFault;  ///< kerf.temperature-fault-0 …
    // to the control
    BitPin forceReset;
    FloatPin feedScale;
    FloatPin lossScale;  ///< what HAL gives in its place when this component is late or gone
    BitPin feedHold;
    BitPin holdIfGone;                   ///< … and whether it holds the feed then
    std::array<IntPin, 3> offsetCounts;  ///< 1 count = 1 µm: set axis.N.eoffset-scale to .001
    std::array<BitPin, 16> word;
    BitPin heartbeat;  ///< toggles every round: for HAL's own watchdog
    BitPin consoleLost;
    // both ways: the control's own value stands until the console sets another
    FloatPin pGain, ff1, ff2;
    // settings of the bridge
    FloatPin timeout_s;
    BitPin holdOnLoss;

    [[nodiscard]] bool make(int component);
};

}  // namespace kerf::linuxcnc
