// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace kerf {

/// How one signal of the simulated machine is made to fail.
enum class SignalFault : std::uint8_t { None, Unplugged, Stale, NotANumber, Saturated, Stuck, Collapsed };

/// How one thermocouple of the simulated machine is made to fail.
enum class CoupleFaultKind : std::uint8_t { None, Open, Short, Stuck, Offset, Noisy };
struct CoupleFault {
    std::uint16_t couple{0};
    CoupleFaultKind kind{CoupleFaultKind::None};
};

/// Faults that tests (and the simulator's fault panel) inject; the loops meet them as they would on a real machine.
struct InjectedFaults {
    bool linkDown{false};
    bool emergencyStop{false};
    bool machineOff{false};
    bool operatorFeedHold{false};
    bool spindleStopped{false};
    bool toolBroken{false};       ///< milling: the force collapses; turning: a chip breaks off, the force jumps
    bool fluteChipped{false};     ///< milling: one flute of several cuts no more, the next one twice as much
    double spindleOverride{1.0};  ///< factor on the programmed spindle speed
    double operatorOverride{1.0};
    SignalFault overhang{SignalFault::None};
    SignalFault spindleSpeed{SignalFault::None};
    SignalFault actualFeed{SignalFault::None};
    SignalFault force{SignalFault::None};
    SignalFault temperatures{SignalFault::None};
    SignalFault spindleAngle{SignalFault::None};
    SignalFault gaps{SignalFault::None};
    std::array<CoupleFault, 4> couples{};
    bool workOffsetIgnored{false};  ///< the control takes no external offset any more
};

}  // namespace kerf
