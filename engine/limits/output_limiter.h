// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/limits/loop_outputs.h"
#include "engine/limits/stop_latch.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// Which limits were at work in this cycle.
struct LimitReport {
    static constexpr std::size_t kMaxRefused = 8;
    bool feedScale{false};
    std::array<bool, kAxisCount> workOffset{};
    bool toolTrim{false};
    bool zTrim{false};
    bool request{false};                              ///< a request was refused or its gains clamped
    std::array<RequestReply, kMaxRefused> refused{};  ///< requests that never reach the machine, with the reason
    std::uint8_t refusedCount{0};
};

/// The one place every output passes.
///
/// Authority (ProcessDescriptor::may): the feed scale belongs to the process whose program runs, if it has it (boring,
/// milling), as the hold does; the work offset to thermal; the tool trim to turning; servo gains, Z trim and
/// synchronous retract to tapping. A wish from anybody else, or one that is not finite, does not exist.
///
/// Without a wish: the feed scale stays where it is while a program runs, or falls to the one that makes the planned
/// feed, and returns to 1 between programs; the work offset keeps its last value; tool and Z trim go to zero. So a loop
/// that stops, faults or loses its sensor leaves the machine at or below its planned feed, with its last offset.
///
/// Time counts at most a few periods, so a cycle that comes late moves no output further than one in time. What the
/// machine reports as applied at (re)connect is kept, also outside the limits, and led back at the rate when asked.
///
/// Stops live here (StopLatch). A feed hold is written in every mode, whatever program runs; while something stands in
/// the work no program is started and offset and trims do not move. A start waits until the feed scale is that of its
/// planned feed. One request goes out per cycle, an abort first; every other one waits its turn or is refused.
class OutputLimiter {
 public:
    static constexpr int kMostPeriods = 3;  ///< that a late cycle counts for

    /// The limits are those of the machine's description.
    explicit OutputLimiter(const Capabilities& capabilities) noexcept;

    /// Take over what the machine reports as applied; after connect and reconnect, so that nothing jumps.
    /// What the machine can do may be another thing than before.
    void adopt(const MachineInputs& inputs, const Capabilities& capabilities) noexcept;

    /// One cycle. `wishes[p]` are the outputs of process p that may act (empty but for stops for loops that do not
    /// control).
    [[nodiscard]] MachineOutputs apply(const std::array<LoopOutputs, kProcessPlaces>& wishes,
                                       const MachineInputs& inputs, double dt_s, LimitReport& report) noexcept;

    [[nodiscard]] StopLatch& stops() noexcept { return m_stops; }
    [[nodiscard]] const StopLatch& stops() const noexcept { return m_stops; }
    [[nodiscard]] const OutputLimits& limits() const noexcept { return m_limits; }

 private:
    struct Waiting {
        ProcessId process{ProcessId::Boring};
        PortRequest request{};
    };

    void fit(const Capabilities& capabilities) noexcept;
    void adoptOffset(std::size_t axis, const Reading& applied_um) noexcept;
    void limitFeedScale(const LoopOutputs& owner, const MachineInputs& inputs, bool running, double step_s,
                        LimitReport& report) noexcept;
    void limitOffsets(const LoopOutputs& granted, const MachineInputs& inputs, double step_s, bool frozen,
                      LimitReport& report) noexcept;
    void limitTrims(const LoopOutputs& granted, const LoopOutputs& servoOwner, double step_s,
                    LimitReport& report) noexcept;
    void limitReset(bool wished, double step_s) noexcept;
    [[nodiscard]] bool admitRequest(ProcessId process, PortRequest& request, LimitReport& report) const noexcept;
    void takeRequest(ProcessId process, PortRequest request, LimitReport& report) noexcept;
    void callOffStart(ProcessId process, LimitReport& report) noexcept;
    void sendRequest(const MachineInputs& inputs, LimitReport& report) noexcept;
    [[nodiscard]] Sentence whyNotNow(const PortRequest& request, const MachineInputs& inputs) const noexcept;

    OutputLimits m_limits;
    double m_period_s{0.001};
    double m_feedScaleTop{1.0};
    bool m_feedScaleFitted{false};
    bool m_workOffsetFitted{false};
    bool m_toolTrimFitted{false};
    bool m_zTrimFitted{false};
    bool m_forceResetFitted{false};
    double m_reset_s{0.0};                         ///< the reset has been wished for so long
    std::array<bool, kAxisCount> m_offsetKnown{};  ///< a control that has zeroed its offsets is taken over again
    bool m_scaled{false};                          ///< a loop has scaled the feed of the running program
    std::optional<double> m_startScale{};          ///< of the program that is about to begin
    std::uint32_t m_startNumber{0};
    double m_startWait_s{0.0};
    std::array<Waiting, LimitReport::kMaxRefused> m_waiting{};
    std::size_t m_waitingCount{0};
    StopLatch m_stops{};
    MachineOutputs m_last{};
};

}  // namespace kerf
