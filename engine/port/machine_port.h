// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "engine/core/force_signal.h"
#include "engine/core/process.h"
#include "engine/core/reading.h"
#include "engine/core/result.h"
#include "engine/core/sentence.h"
#include "engine/port/output_limits.h"
#include "engine/port/stop_slots.h"

/// Everything that goes into or comes out of a machine. A simulated and a real machine stand behind the same port and
/// pass the same conformance tests (tests/machine/port_conformance.h).
namespace kerf {

inline constexpr std::size_t kAxisCount = 3;        ///< X, Y, Z
inline constexpr std::size_t kMaxFastSamples = 64;  ///< force samples in one cycle
inline constexpr std::size_t kMaxTemperatures = 64;
inline constexpr std::size_t kMaxServoSamples = 64;  ///< servo periods in one cycle

/// One thing a machine can or cannot do; `why` says why not, for the operator.
struct Capability {
    bool fitted{false};
    Sentence why{};
};

/// What this machine can do, known after connect(); changes only while the link is down, when the machine that comes
/// back is another one.
struct Capabilities {
    std::array<char, 32> machineName{};
    std::int64_t cycle_ns{1'000'000};  ///< period of the cycle on machine time
    OutputLimits limits{};             ///< of what Kerf may write, as the machine's description says
    double maxFeedScale{1.0};  ///< largest factor on the programmed feed the control accepts; 1 = slow-down only
    Capability feedScale{};    ///< live scaling of the programmed feed
    Capability forceSensor{};
    ForceSignal force{};      ///< counts where forceSensor is fitted
    Capability forceReset{};  ///< a line that brings the force sensor's amplifier to zero
    Capability temperatures{};
    std::uint16_t temperatureCount{0};
    Capability workOffset{};  ///< work-origin shift that reads back
    Capability gapSensors{};  ///< of the origin, on a test bar
    Capability toolMotion{};  ///< a sensor of the turning tool's own motion
    Capability servoGains{};  ///< gains of Z servo and spindle can be set
    Capability zTrim{};       ///< addition to the Z position command while tapping
    Capability toolTrim{};    ///< fast trim of the tool's depth
    Capability gauge{};       ///< a bore gauge whose readings the port passes on
    Capability cycleStart{};  ///< Kerf may start a part program (else the operator does, at the control)
    std::array<Capability, kProcessPlaces> process{};  ///< which loops this machine can host
    bool simulated{false};
};

enum class LinkState : std::uint8_t { Down, Connecting, Up };

/// Where the part program stands. `partSequence` rises by one with every part begun.
enum class ProgramState : std::uint8_t { Idle, Running, Paused, Finished, Aborted };

/// One sample of the fast force signal.
struct FastSample {
    std::int64_t stamp_ns{0};
    double spindleAngle_rev{0.0};  ///< accumulated, never wraps
    double force_N{0.0};           ///< normal force on the tool, ≥ 0 into the work
    Quality quality{Quality::Missing};
};

/// One period of the control's own servo loop while tapping.
struct ServoSample {
    double spindle_rev{0.0};
    double z_mm{0.0};  ///< as position_mm: down into the hole is negative
};

/// Temperatures change slowly; the port refreshes the frame at its own pace and counts.
struct TemperatureFrame {
    std::uint64_t revision{0};
    std::uint16_t count{0};
    std::array<Reading, kMaxTemperatures> temp_degC{};
};

/// Progress of a numbered request (see PortRequest).
enum class RequestState : std::uint8_t { None, Accepted, Done, Refused };
struct RequestReply {
    std::uint32_t number{0};
    RequestState state{RequestState::None};
    Sentence reason{};  ///< for Refused
};

/// Gains of a position loop pair, in the machine's own units (see docs/tapping.md).
struct ServoGains {
    double spindleKp_perS{0.0};
    double zKp_perS{0.0};
    std::array<double, 6> zFeedForward{};  ///< meaning declared by the tapping room
};

/// One cycle's view of the machine. Filled whole by read(): no field keeps a value of an earlier cycle unless stale.
struct MachineInputs {
    std::int64_t time_ns{0};  ///< machine time: monotonic, simulated or real
    LinkState link{LinkState::Down};
    bool emergencyStop{false};
    bool machineOn{false};
    bool feedHold{false};          ///< operator's or ours
    double operatorOverride{1.0};  ///< the feed knob, 1 = 100 %
    ProgramState program{ProgramState::Idle};
    ProcessId programProcess{ProcessId::Boring};  ///< which loop the running program belongs to
    std::uint32_t partSequence{0};
    Reading programmedFeed_mmPerS{};
    Reading actualFeed_mmPerS{};
    Reading spindleSpeed_rpm{};
    Reading spindleAngle_rev{};  ///< accumulated
    std::array<Reading, kAxisCount> position_mm{};
    Reading overhang_mm{};       ///< boring: spindle overhang L
    Reading appliedFeedScale{};  ///< what the control really applies
    Reading
        plannedFeedScale{};  ///< scale that makes the planned feed, as declared with the program; Missing: it was not
    StopSlots stops{};       ///< stops as the machine keeps them, whether or not a console is there
    std::array<Reading, kAxisCount> workOffset_um{};  ///< shift the control reports as applied
    std::array<Reading, kAxisCount> gap_um{};
    Reading toolTrim_um{};
    Reading zTrim_um{};
    Reading toolMotion_um{};  ///< turning: x_i as a sensor at the tool sees it, positive out of the work
    ServoGains servoGains{};
    Quality servoGainsQuality{Quality::Missing};
    std::uint16_t fastCount{0};
    std::array<FastSample, kMaxFastSamples> fast{};
    bool servoRecord{false};  ///< while tapping, `servo` holds every servo period since the last cycle; else look at
                              ///< spindleAngle_rev and position_mm once per cycle
    std::uint16_t servoCount{0};
    std::array<ServoSample, kMaxServoSamples> servo{};
    const TemperatureFrame* temperatures{nullptr};  ///< owned by the port, constant during a cycle; may be null
    RequestReply reply{};
};

/// Begin a part program. On the simulator it runs the plant; a real control may refuse.
struct StartProgram {
    ProcessId process{ProcessId::Boring};
    double programmedFeed_mmPerRev{0.0};  ///< boring: the schedule's highest feed
    double plannedFeedScale{1.0};  ///< planned feed over programmed feed, (0, 1]: what is left when nobody controls
    double spindleSpeed_rpm{0.0};
    double from_mm{0.0};  ///< boring: overhang range; milling: path; tapping: top
    double to_mm{0.0};
    double pitch_mm{0.0};     ///< tapping
    double revolutions{0.0};  ///< tapping: depth in revolutions
    bool air{false};          ///< tapping: air tap
    double depth_um{0.0};     ///< turning: depth of cut
};
struct AbortProgram {};
struct SetServoGains {
    ServoGains gains{};
};
struct RetractInSync {};

/// A request outside the per-cycle values. Numbered; the port answers in MachineInputs::reply.
struct PortRequest {
    std::uint32_t number{0};  ///< 0: none
    std::variant<std::monostate, StartProgram, AbortProgram, SetServoGains, RetractInSync> action{};
};

/// One cycle's wishes. Only engine/limits makes it; the loops fill LoopOutputs.
struct MachineOutputs {
    double feedScale{1.0};  ///< factor on the programmed feed, 0…maxFeedScale
    double lossScale{
        1.0};              ///< when the console is heard no more: the scale is the lower of this and feedScale; 0: hold
    bool feedHold{false};  ///< stays in force when the console is heard no more
    StopSlots stops{};     ///< joined by the machine with those it keeps; an active FeedHold holds the feed
    std::array<double, kAxisCount> workOffset_um{};
    bool forceReset{false};  ///< the force amplifier's reset line is held; the force is none meanwhile
    double toolTrim_um{0.0};
    double zTrim_um{0.0};  ///< added to the Z position command while tapping, positive into the hole
    std::uint32_t heartbeat{0};
    PortRequest request{};
};
static_assert(std::is_trivially_copyable_v<MachineInputs>);
static_assert(std::is_trivially_copyable_v<MachineOutputs>);

/// A machine. read() and write() run in the cycle: no allocation, lock, throw, log or blocking call.
class MachinePort {
 public:
    MachinePort() = default;
    MachinePort(const MachinePort&) = delete;
    MachinePort& operator=(const MachinePort&) = delete;
    virtual ~MachinePort() = default;

    /// Before connect(): this program looks on and never commands. A machine is commanded by one program at a time.
    virtual void onlyRead() noexcept {}
    /// A person takes the machine over from the program that commands it: whoever connects next commands. Not in the
    /// cycle, @pre connected.
    [[nodiscard]] virtual Result<void> endOtherClaim() {
        return fail(KERF_TEXT("This machine is not shared: there is nobody to take it over from."));
    }
    /// Not in the cycle; may block. Called before the first read(), and again after disconnect().
    [[nodiscard]] virtual Result<void> connect() = 0;
    virtual void disconnect() noexcept = 0;
    [[nodiscard]] virtual const Capabilities& capabilities() const noexcept = 0;

    /// Cycle: fill `inputs` with the machine at `now_ns`. A simulated machine advances to that time.
    virtual void read(std::int64_t now_ns, MachineInputs& inputs) noexcept = 0;
    /// Cycle: hand over the limited outputs. A machine that hears nothing for longer than 100 ms goes on by itself,
    /// alike on every machine: the scale falls to the lower of the last one and lossScale (0: the feed is held), a feed
    /// hold stays, stops stay, offsets and trims stay. It never becomes faster.
    virtual void write(const MachineOutputs& outputs) noexcept = 0;
};

}  // namespace kerf
