// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "engine/cycle/process_loop.h"
#include "engine/cycle/program_follower.h"

namespace kerf {

/// Follows the feed schedule along the bore: feedScale = S(L) / programmed feed, and records what was really cut.
///
/// A part keeps the schedule it began with; a schedule loaded meanwhile waits for the next part. Off or advising, the
/// program runs at its own constant feed. Without a good overhang or spindle speed the loop asks for nothing, and
/// engine/limits keeps the last scale.
class BoringLoop final : public ProcessLoop {
 public:
    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Boring; }
    [[nodiscard]] std::span<const AlarmSpec> alarms() const noexcept override;
    [[nodiscard]] CommandResult handle(const Command& command) noexcept override;
    void setMode(LoopMode mode) noexcept override { m_mode = mode; }
    [[nodiscard]] LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                                   EventSink& events) noexcept override;
    void report(Status& status) const noexcept override;
    void sample(Sample& sample) const noexcept override;

 private:
    void beginPart(const MachineInputs& inputs) noexcept;
    void endPart(const MachineInputs& inputs, bool complete, EventSink& events) noexcept;
    [[nodiscard]] LoopVerdict follow(const MachineInputs& inputs, const Capabilities& capabilities,
                                     LoopOutputs& outputs, EventSink& events) noexcept;
    [[nodiscard]] bool standsStill(const MachineInputs& inputs) noexcept;
    void trace(double overhang_mm, double feed_mmPerRev) noexcept;

    ProgramFollower m_program{ProcessId::Boring};
    LoopMode m_mode{LoopMode::Off};
    BoringSchedule m_next{};
    PartRecord m_part{};
    double m_lowestFeed_mmPerRev{0.0};  ///< of its schedule: two ends, each a logarithm and a power, once a part
    double m_lnTarget{0.0};             ///< of its schedule, the same
    bool m_startWanted{false};
    std::int64_t m_offScheduleSince_ns{-1};
    std::int64_t m_lookedAt_ns{0};
    double m_stands_mm{0.0};  ///< the overhang as it was seen last
    double m_unseen_mm{0.0};  ///< what has been fed since it changed
    BoringStatus m_status{};
};

}  // namespace kerf
