// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/core/process.h"
#include "engine/limits/loop_outputs.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// Range, rate and authority of every value that leaves Kerf. Declared per machine; no loop can widen it.
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
    double servoGainMin_perS{5.0};        ///< > 0
    double servoGainMax_perS{200.0};      ///< ≥ min
};

/// Which limits were at work in this cycle.
struct LimitReport {
    bool feedScale{false};
    std::array<bool, kAxisCount> workOffset{};
    bool toolTrim{false};
    bool zTrim{false};
    bool request{false};  ///< a request was refused or its gains clamped
};

/// The one place every output passes.
///
/// Authority: feed scale and hold belong to the process whose program runs (boring, milling); the work offset to
/// thermal; the tool trim to turning; servo gains, Z trim and
/// synchronous retract to tapping. A wish from anybody else, or one
/// that is not finite, does not exist.
///
/// Without a wish: the feed scale stays where it is while a program runs (never rising, at most 1) and returns to 1
/// between programs; the work offset keeps its last value; tool and Z trim go to zero. So a loop that stops, faults or
/// loses its sensor leaves the machine at or below its programmed feed, with its last offset, without a bump.
class OutputLimiter {
 public:
    OutputLimiter(const OutputLimits& limits, const Capabilities& capabilities) noexcept;

    /// Take over what the machine reports as applied; after connect and reconnect, so that nothing jumps.
    /// What the machine can do may be another thing than before.
    void adopt(const MachineInputs& inputs, const Capabilities& capabilities) noexcept;

    /// One cycle. `wishes[p]` are the outputs of process p that may act (empty ones for loops that do not control).
    [[nodiscard]] MachineOutputs apply(const std::array<LoopOutputs, kProcessCount>& wishes,
                                       const MachineInputs& inputs, double dt_s, LimitReport& report) noexcept;

    [[nodiscard]] const OutputLimits& limits() const noexcept { return m_limits; }

 private:
    void fit(const Capabilities& capabilities) noexcept;
    void adoptOffset(std::size_t axis, const Reading& applied_um) noexcept;
    void limitFeedScale(const LoopOutputs& owner, bool running, double dt_s, LimitReport& report) noexcept;
    [[nodiscard]] bool admitRequest(ProcessId process, PortRequest& request, LimitReport& report) const noexcept;

    OutputLimits m_limits;
    double m_feedScaleTop{1.0};
    bool m_feedScaleFitted{false};
    bool m_workOffsetFitted{false};
    bool m_toolTrimFitted{false};
    bool m_zTrimFitted{false};
    std::array<bool, kAxisCount> m_offsetKnown{};  ///< a control that has zeroed its offsets is taken over again
    MachineOutputs m_last{};
};

}  // namespace kerf
