// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "engine/core/latest_value.h"

/// What the console and the HAL bridge (kerf-hal, a component loaded by LinuxCNC) share: two values, one writer each,
/// in POSIX shared memory. Neither side ever waits for the other; each tells from the other's beat whether it lives.
namespace kerf::linuxcnc {

/// The control as the bridge saw it in one of its 1 kHz rounds. Lengths mm whatever the ini's units.
struct FromControl {
    std::uint64_t beat{0};     ///< rises with every round of the bridge
    double servoClock_s{0.0};  ///< rises with every servo period: stands still when motion does
    std::array<double, 3> position_mm{};
    double currentVelocity_mmPerS{0.0};
    double requestedVelocity_mmPerS{0.0};
    double spindleSpeed_rps{0.0};
    double spindleAngle_rev{0.0};
    double feedOverride{1.0};                   ///< operator's knob
    double appliedFeedScale{1.0};               ///< what motion.adaptive-feed is given, after the watchdog
    std::array<double, 3> externalOffset_mm{};  ///< as axis.N.eoffset reports
    bool machineOn{false};
    bool emergencyStop{false};
    bool programRunning{false};
    bool programPaused{false};
    bool cutting{false};   ///< M64 P0 … M65 P0 of the part program
    bool finished{false};  ///< M64 P1: the program reached its end
    bool onSoftLimit{false};
    bool consoleLost{false};  ///< the bridge's own watchdog: our last beat is too old
};

/// The console's wishes, already limited.
struct ToControl {
    std::uint64_t beat{0};
    double feedScale{1.0};
    bool feedHold{false};
    std::array<double, 3> externalOffset_um{};
    std::uint64_t beatAgain{0};  ///< equals beat in a whole value: a console killed in mid-write leaves a torn one
};

struct LinkMemory {
    static constexpr std::uint32_t kMagic = 0x4B524631;  // "KRF1": layout 1
    std::atomic<std::uint32_t> magic{0};                 ///< set last by the bridge
    LatestValue<FromControl> fromControl{};
    LatestValue<ToControl> toControl{};
};

/// Name of the shared memory; one bridge per machine.
inline constexpr const char* kLinkName = "/kerf-linuxcnc";

}  // namespace kerf::linuxcnc
