// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "engine/core/broadcast.h"
#include "engine/core/latest_value.h"
#include "engine/machine/linuxcnc/ini_file.h"
#include "engine/machine/linuxcnc/machine_claim.h"
#include "engine/port/stop_slots.h"

/// What the console and the HAL bridge (kerf-hal, a component loaded by LinuxCNC) share: two values, one writer each,
/// and the servo periods, in POSIX shared memory. Neither side ever waits for the other; each tells from the
/// other's beat whether it lives.
namespace kerf::linuxcnc {

/// What the bridge found fitted: pins that are linked or set in HAL, the version. Constant while the bridge runs but
/// for pins that are linked later.
struct Fitted {
    bool externalOffsets{false};    ///< kerf.offset-counts-z is linked and kerf.offset-ratio is above 0
    bool originShift{false};        ///< kerf.origin-shift-z is linked: the shift goes by G10 L2 (kerf_shift.ngc)
    bool servoGains{false};         ///< kerf.z-pgain is linked
    bool servoRecord{false};        ///< a sampler brings every servo period
    bool shiftWord{false};          ///< kerf.word-15 is linked: the paper's digital word
    bool programDeclared{false};    ///< kerf.program-process is linked: a program says whose it is
    bool lossScale{false};          ///< kerf.loss-scale is linked: HAL knows what is left without the bridge
    bool forceLinked{false};        ///< kerf.force is linked
    bool force{false};              ///< … and the sampler's pin 6 to the same signal
    bool forceReset{false};         ///< kerf.force-reset is linked
    double forceBandwidth_Hz{0.0};  ///< as kerf.force-bandwidth says; 0: it does not
    double servoPeriod_s{0.001};    ///< [EMCMOT]SERVO_PERIOD of the ini
    bool simulator{false};          ///< kerf.simulator is set: drives and cutting forces are simulated
    MachineUnits units{MachineUnits::Unknown};  ///< [TRAJ]LINEAR_UNITS of the control's ini file
    double maxFeedScale{1.0};  ///< 2.9 clips motion.adaptive-feed to 1; later versions allow [DISPLAY]MAX_FEED_OVERRIDE
    friend bool operator==(const Fitted&, const Fitted&) = default;
};

/// The pid component of Z: gains as its pins show them.
struct ZGains {
    double pGain_perS{0.0};
    double ff1{0.0};
    double ff2_s{0.0};
};

/// The control as the bridge saw it in one of its 1 kHz rounds. Lengths mm whatever the ini's units.
struct FromControl {
    std::uint64_t beat{0};          ///< rises with every round of the bridge
    std::uint64_t servoPeriods{0};  ///< rises with every servo period: stands still when motion does
    std::array<double, 3> position_mm{};
    double currentVelocity_mmPerS{0.0};
    double requestedVelocity_mmPerS{0.0};
    double spindleSpeed_rps{0.0};
    double spindleAngle_rev{0.0};
    double feedOverride{1.0};                   ///< operator's knob
    double appliedFeedScale{1.0};               ///< what motion.adaptive-feed is given, after the watchdog
    std::array<double, 3> externalOffset_mm{};  ///< as axis.N.eoffset reports
    std::uint32_t offsetEpoch{0};               ///< rises whenever the control has zeroed its offsets: machine on
    std::array<double, 3> originShift_um{};     ///< as kerf_shift.ngc reports over M68
    bool originKnown{false};                    ///< it has reported since the control was started
    ZGains gains{};
    double driveBandwidth_perS{0.0};  ///< of Z's velocity loop, from HAL: kerf.z-bandwidth
    Fitted fitted{};
    bool machineOn{false};
    bool emergencyStop{false};
    bool programRunning{false};
    bool programPaused{false};
    bool cutting{false};        ///< M64 P0 … M65 P0 of the part program
    bool finished{false};       ///< M64 P1: the program reached its end
    std::uint32_t declared{0};  ///< M68 E3, as the program declares whose it is (programs.h); 0: it does not
    bool onSoftLimit{false};
    bool consoleLost{false};      ///< the bridge's own watchdog: our last beat is too old
    std::uint8_t requestWord{0};  ///< CNC → PC of the digital word
    bool commandsReady{false};    ///< the bridge reaches LinuxCNC's own command channel
    StopSlots stops{};            ///< as the bridge keeps them, over the console's and its own restart
    double plannedScale{0.0};     ///< of the running program, as a console has declared it; 0: nobody has
    std::uint32_t feedEpoch{0};   ///< rises whenever the feed was let go (feed_keeper.h)
};

/// The console's wishes, already limited.
struct ToControl {
    std::uint64_t beat{0};
    double feedScale{1.0};
    bool feedHold{false};
    double lossScale{1.0};     ///< what is left when the console is heard no more; 0: the feed is held
    double plannedScale{0.0};  ///< declared with the running program; 0: it was not
    std::uint32_t feedEpoch{
        0};  ///< of the read-back this follows on; of another one nothing but holds and stops counts
    StopSlots stops{};
    std::array<double, 3> externalOffset_um{};
    std::uint32_t offsetEpoch{0};    ///< of the read-back the offsets follow on; of another epoch they are ignored
    std::uint32_t gainsRevision{0};  ///< a new one: set `gains`; 0: leave the machine's own
    ZGains gains{};
    std::uint16_t shiftWord{0};  ///< PC → CNC of the digital word
    bool forceReset{false};      ///< the force amplifier's reset line
    std::uint64_t beatAgain{0};  ///< equals beat in a whole value: a console killed in mid-write leaves a torn one
};

/// One servo period as HAL's sampler took it.
struct ServoPeriod {
    std::uint32_t number{0};  ///< counts every period, also those the sampler had no room for
    double spindle_rev{0.0};
    double z_mm{0.0};          ///< where the axis is
    double zCommand_mm{0.0};   ///< where motion wants it
    std::int32_t late_ns{0};   ///< time since the period before, less the nominal period
    std::int64_t stamp_ns{0};  ///< when it was, on CLOCK_MONOTONIC (period_clock.h)
    double force{0.0};         ///< in the pin's own unit; counts where Fitted::force says so
    bool forceFault{false};    ///< the amplifier's own status: overload, not ready
    bool cutting{false};
    bool finished{false};
};

/// Temperatures on pins of the bridge, ten times a second.
struct HalTemperatures {
    std::uint64_t beat{0};
    std::uint64_t linked{0};  ///< bit N: kerf.temperature-N has a signal
    std::uint64_t fault{0};   ///< bit N: kerf.temperature-fault-N is set
    std::array<double, 64> temp_degC{};
};

/// A command for LinuxCNC, in the words of linuxcncrsh, and the answer to it. But for an abort, one that is found later
/// than kOldest_ns is refused: whoever asked has given it up, or soon will.
struct CommandLine {
    static constexpr std::int64_t kOldest_ns = 1'000'000'000;
    std::uint32_t number{0};   ///< of this line; 0: none
    std::int64_t asked_ns{0};  ///< on CLOCK_MONOTONIC
    std::array<char, 240> text{};
    std::uint32_t numberAgain{0};  ///< equals number in a whole value
};
struct CommandAnswer {
    std::uint32_t number{0};
    bool taken{false};
};

struct LinkMemory {
    static constexpr std::uint32_t kMagic = 0x4B524637;  // "KRF7": layout 7
    std::atomic<std::uint32_t> magic{0};                 ///< set last by the bridge
    Broadcast<FromControl, 16> fromControl{};            ///< for any number of readers
    Claim owner{0};                                      ///< who commands (machine_claim.h); everybody else reads
    LatestValue<ToControl> toControl{};                  ///< of the owner alone
    LatestValue<CommandLine> commandLine{};              ///< of the owner alone
    LatestValue<CommandAnswer> commandAnswer{};
    Broadcast<ServoPeriod, 8192> servo{};  ///< 8 s at 1 kHz
    Broadcast<HalTemperatures, 8> temperatures{};
};

/// Name of the shared memory; one bridge per machine. Every bridge makes a new one, so that a console that still holds
/// the last one notices.
inline constexpr const char* kLinkName = "/kerf-linuxcnc";

/// What outlives the bridge, until the computer is switched off (the console's data file has it for longer).
struct KeptStops {
    static constexpr std::uint32_t kMagic = 0x4B535431;  // "KST1"
    std::uint32_t magic{0};                              ///< 0 while being written
    StopSlots stops{};
};
inline constexpr const char* kStopsName = "/kerf-linuxcnc-stops";

}  // namespace kerf::linuxcnc
