// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/api/status.h"
#include "engine/cycle/process_loop.h"
#include "engine/cycle/program_follower.h"
#include "engine/limits/stop_latch.h"
#include "engine/process/tapping/drift_watch.h"
#include "engine/process/tapping/tap_exchange.h"
#include "engine/process/tapping/tap_recorder.h"

namespace kerf {

/// Makes taps and records them: gains to the drive and back-read, the first tap of a job in the air, spindle and Z at
/// the cycle's rate into a buffer made beforehand, abort in sync, recovery out of the hole, drift of production taps.
///
/// The tuner is not here: it takes the record from the exchange, and sends gains and trim for the next tap. Gains
/// change only between taps. An abort (error limit, lost signal, wrong pitch, AbortTap) turns the tap out in sync and
/// then restores the accepted gains. Unless the mode is Control, taps run with the machine's own gains and without
/// trim, and only AbortTap ends them (in Off nothing of Kerf's does). A tap during which the mode changed does not
/// count.
class TappingLoop final : public ProcessLoop {
 public:
    /// `exchange` outlives the loop.
    explicit TappingLoop(TapExchange& exchange) noexcept : m_exchange(exchange), m_tap(exchange.records) {}

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Tapping; }
    [[nodiscard]] std::span<const AlarmSpec> alarms() const noexcept override;
    [[nodiscard]] CommandResult handle(const Command& command) noexcept override;
    void setMode(LoopMode mode) noexcept override;
    [[nodiscard]] LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                                   EventSink& events) noexcept override;
    void report(Status& status) const noexcept override { status.tapping = m_status; }
    void sample(Sample&) const noexcept override {}

 private:
    [[nodiscard]] CommandResult start() noexcept;
    [[nodiscard]] CommandResult abortTap() noexcept;
    void noTap(const Sentence& why) noexcept;
    [[nodiscard]] bool refused(const MachineInputs& inputs) const noexcept;
    void beginRestore() noexcept;
    void recover(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept;
    [[nodiscard]] bool gainsInForce(const MachineInputs& inputs) const noexcept;
    void request(LoopOutputs& outputs, const decltype(PortRequest::action)& action) noexcept;
    void setGains(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept;
    void startProgram(const MachineInputs& inputs, LoopOutputs& outputs) noexcept;
    void record(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept;
    void watch(LoopOutputs& outputs, EventSink& events) noexcept;
    void abortInSync(LoopOutputs& outputs) noexcept;
    void endTap(TapOutcome outcome, EventSink& events) noexcept;
    void restoreAccepted() noexcept;
    void finishPart(TapOutcome outcome, EventSink& events) noexcept;
    void stopInHole(EventSink& events) noexcept;
    void followStop(const StopSlot& stop) noexcept;
    [[nodiscard]] Sentence inHole() const noexcept;
    [[nodiscard]] LoopVerdict describe() const noexcept;

    TapExchange& m_exchange;
    TapRecorder m_tap;
    StopWatch m_stopWatch{};
    LoopMode m_mode{LoopMode::Off};
    TappingStatus m_status{};
    TappingJob m_job{};
    TapGains m_next{};
    TapGains m_accepted{};
    TapKind m_wantedKind{TapKind::Trial};
    bool m_startWanted{false};
    bool m_abortWanted{false};
    bool m_recoverWanted{false};
    bool m_tapAfterGains{false};  ///< SettingGains leads to a tap, else to Idle
    bool m_restoreWanted{false};  ///< the drive may still have a trial's gains
    bool m_interrupted{false};    ///< the loop was stopped during this tap
    bool m_gainsSent{false};
    bool m_startSent{false};
    ProgramFollower m_program{ProcessId::Tapping};
    std::uint32_t m_requestNumber{0};
    std::uint32_t m_lastSequence{0};
    std::int64_t m_phaseSince_ns{0};
    std::int64_t m_tick_ns{1'000'000};
    std::int64_t m_now_ns{0};
    DriftWatch m_drift{};
};

}  // namespace kerf
