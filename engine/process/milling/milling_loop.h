// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "engine/cycle/force_zero.h"
#include "engine/cycle/process_loop.h"
#include "engine/cycle/program_follower.h"
#include "engine/limits/stop_latch.h"
#include "engine/process/milling/chatter_watch.h"
#include "engine/process/milling/cut_record.h"
#include "engine/process/milling/feed_controller.h"
#include "engine/process/milling/force_watch.h"
#include "engine/process/milling/revolution_averager.h"

namespace kerf {

/// Holds the averaged cutting force at its reference: feedScale = wanted feed / programmed feed, once per revolution.
///
/// Unknown never means faster: without a force (or feed, or speed) that can be trusted the wish stays or falls to the
/// planned feed, within half a revolution. Overload, a collapsing force or a stopped spindle are a stop, which
/// holds the feed until a person releases it; what is seen while only advising forbids the next start. Advising runs
/// the same code on the live signal; the record says what control would have saved.
class MillingLoop final : public ProcessLoop {
 public:
    MillingLoop() noexcept;
    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Milling; }
    [[nodiscard]] std::span<const AlarmSpec> alarms() const noexcept override;
    [[nodiscard]] CommandResult handle(const Command& command) noexcept override;
    void setMode(LoopMode mode) noexcept override;
    [[nodiscard]] LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                                   EventSink& events) noexcept override;
    void report(Status& status) const noexcept override;
    void sample(Sample& sample) const noexcept override;

 private:
    [[nodiscard]] CommandResult load(const MillingSetup& setup) noexcept;
    [[nodiscard]] CommandResult load(const MillingBlank& blank) noexcept;
    [[nodiscard]] CommandResult load(const MillingToolState& tool) noexcept;
    [[nodiscard]] CommandResult select(MillingLaw law) noexcept;
    [[nodiscard]] CommandResult setReference(double reference_N) noexcept;
    [[nodiscard]] Sentence whyUnavailable(MillingLaw law) const noexcept;

    void requestStart(const Capabilities& capabilities, LoopOutputs& outputs) noexcept;
    void beginPart(const MachineInputs& inputs, const Capabilities& capabilities) noexcept;
    void endPart(const MachineInputs& inputs, bool complete, EventSink& events) noexcept;
    [[nodiscard]] LoopVerdict control(const MachineInputs& inputs, LoopOutputs& outputs, EventSink& events) noexcept;
    void takeSamples(const MachineInputs& inputs) noexcept;
    void takeRevolution(const milling::RevolutionForce& revolution, const MachineInputs& inputs) noexcept;
    void takePeriod(double feed_mm, const MachineInputs& inputs) noexcept;
    [[nodiscard]] milling::FeedRange reach(const MachineInputs& inputs) const noexcept;
    void beginGroup() noexcept;
    [[nodiscard]] double lnCb() const noexcept;
    void watchForStops(const MachineInputs& inputs, EventSink& events) noexcept;
    void followStop(const StopSlot& stop) noexcept;
    void stop(AlarmCode code, const Sentence& detail, EventSink& events) noexcept;
    void wish(const MachineInputs& inputs, LoopOutputs& outputs) const noexcept;
    [[nodiscard]] double gainMargin() const noexcept;

    ProgramFollower m_program{ProcessId::Milling};
    LoopMode m_mode{LoopMode::Off};
    MillingSetup m_setup{};
    MillingLaw m_law{MillingLaw::Model};  ///< wanted; the controller's may be Constant without a force sensor
    MillingBlank m_blank{};
    milling::FeedController m_controller;
    milling::RevolutionAverager m_averager{};
    milling::ForceWatch m_watch{};
    milling::ChatterWatch m_chatter{};
    milling::CutRecord m_record{};
    milling::WearTrend m_wear{};
    PartRecord m_part{};
    MillingStatus m_status{};
    milling::FeedDecision m_decision{};

    bool m_forceFitted{true};
    ForceSignal m_signal{};
    double m_rise_perS{0.0};  ///< how fast the feed scale may rise
    ForceZero m_zero{};
    bool m_startWanted{false};
    bool m_paused{true};  ///< the axis stands: pause, hold, or a stop of ours
    bool m_releaseWanted{false};
    AlarmCode m_stopAlarm{0};  ///< of the stop that stands (engine/limits keeps it); 0: none
    Sentence m_stopReason{};
    StopWatch m_stopWatch{};
    std::int64_t m_last_ns{0};
    std::int64_t m_limitedSince_ns{-1};
    double m_wanted_mmPerS{0.0};
    double m_revolution_s{0.1};
    double m_groupForce_N{0.0};  ///< sum over the revolutions of the period under way
    double m_group_s{0.0};
    int m_groupCount{0};
    bool m_groupTrusted{true};
    double m_travel_mm{0.0};      ///< of the axis in this cut
    double m_markTravel_mm{0.0};  ///< at the last revolution's mark
    bool m_spindleWas{false};     ///< up to speed in this cut
    double m_runUp_s{0.0};        ///< the axis has gone on before that
    double m_cycle_s{0.0};        ///< since the cycle before
    bool m_feedKnown{true};
    double m_made_mmPerS{0.0};  ///< feed really made, as last known in this cut
    double m_cyclePeak_N{0.0};  ///< highest sample of this cycle
    float m_rawLow_N{0.0F};     ///< since the last chart sample
    float m_rawHigh_N{0.0F};
    mutable bool m_rawTaken{true};
};

}  // namespace kerf
