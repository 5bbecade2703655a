// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "engine/cycle/force_zero.h"
#include "engine/cycle/process_loop.h"
#include "engine/cycle/program_follower.h"
#include "engine/limits/stop_latch.h"
#include "engine/process/turning/cut_watch.h"
#include "engine/process/turning/depth_control.h"
#include "engine/process/turning/force_health.h"
#include "engine/process/turning/identifier.h"
#include "engine/process/turning/surface_record.h"
#include "engine/process/turning/turning_trace.h"

namespace kerf {

/// Force feedback of the diamond turning slide, at 5 kHz: takes the sensor's zero in the air, finds the touch, and
/// trims the tool against the disturbance while it cuts, by the controller the operator has chosen.
///
///   Air      the zero of the force is taken (ForceZero); a touch is four samples in a row above zero + 10 % of the
///   target Entry    the first revolution after the touch Cutting  DepthControl; the trim stays within the setup's
///   authority and the machine's limits Out      left the loop in this part: trim to zero within 2 ms, ramped
///
/// Out of the loop within 5 ms of the fault: a lost, stuck or saturated force, a force gain that jumps by a quarter
/// (chipped tool). Later: a trim that leans to one side or a mean force that falls by a quarter (mean-force check: no
/// law may take the cut away). Lost signal and chipped tool fault the loop until a person releases it. The exit of the
/// cut ends the trim the same way without an alarm. The cycle has to be .2 ms and the force's bandwidth 800 Hz, twice
/// the highest tone; on a slower machine the loop advises only. With a sensor of the tool's motion (toolMotion_um) the
/// cutting process is identified as it cuts, and the law is tuned anew when it has moved by more than 5 % and the
/// identification is sure of it. After a restart it begins with
/// the process that stored parts of the same cut have left, where the service hands it over.
class TurningLoop final : public ProcessLoop {
 public:
    /// @param exchange what the service wants to see of the surface and the force; may be null. Outlives the loop.
    explicit TurningLoop(TurningExchange* exchange = nullptr) noexcept;

    [[nodiscard]] ProcessId id() const noexcept override { return ProcessId::Turning; }
    [[nodiscard]] std::span<const AlarmSpec> alarms() const noexcept override;
    [[nodiscard]] CommandResult handle(const Command& command) noexcept override;
    void setMode(LoopMode mode) noexcept override;
    [[nodiscard]] LoopVerdict step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                                   EventSink& events) noexcept override;
    void report(Status& status) const noexcept override;
    void sample(Sample& sample) const noexcept override;

    /// Empty if this setup can be cut; else the sentence for the operator.
    [[nodiscard]] static std::optional<Sentence> whyUnusable(const TurningSetup& setup) noexcept;

 private:
    static constexpr std::uint32_t kReferenceAfter = 2000;  ///< .4 s after the touch the force is what this tool takes

    [[nodiscard]] static turning::ControllerKind kindOf(TurningController controller) noexcept;
    void beginPart(const MachineInputs& inputs) noexcept;
    void endPart(const MachineInputs& inputs, bool complete, EventSink& events) noexcept;
    void touch(const MachineInputs& inputs) noexcept;
    [[nodiscard]] ForceZeroParams zeroParams(const Capabilities& capabilities) const noexcept;
    void noteZero(EventSink& events) noexcept;
    void takeSample(const FastSample& fast, const MachineInputs& inputs, EventSink& events) noexcept;
    void cut(double force_N, const MachineInputs& inputs, EventSink& events) noexcept;
    void startCount() noexcept;
    [[nodiscard]] bool chipped(double force_N, EventSink& events) noexcept;
    [[nodiscard]] bool losesTheCut(EventSink& events) noexcept;
    void showTones(EventSink& events) noexcept;
    /// `cause`: alarm of the stop that this is; 0: the loop joins again with the next part.
    void leave(const Sentence& reason, AlarmCode cause) noexcept;
    void watchSurface(double force_N) noexcept;
    void noteForce(double force_N) noexcept;
    [[nodiscard]] Sentence cuttingReason() const noexcept;
    void identify(double force_N, const MachineInputs& inputs) noexcept;
    void retune(const turning::ProcessParams& found) noexcept;
    [[nodiscard]] turning::DepthControlParams controlParams(const TurningSetup& setup) const noexcept;
    void recall() noexcept;
    void startRequest(LoopOutputs& outputs) noexcept;

    ProgramFollower m_program{ProcessId::Turning};
    TurningExchange* m_exchange;
    LoopMode m_mode{LoopMode::Off};
    TurningSetup m_next{};
    TurningSetup m_setup{};
    TurningController m_controller{TurningController::Tones};
    turning::ProcessParams m_process{};  ///< the law is tuned to it; kept from part to part
    turning::DepthControl m_control;
    turning::ProcessIdentifier m_identifier;
    turning::RevolutionBuffer m_motion{291};
    turning::CutWatch m_watch{m_process};
    turning::TurningTrace m_trace;
    TurningStatus m_status{};
    PartRecord m_part{};
    Sentence m_outReason{};
    bool m_outFaulted{false};
    AlarmCode m_outCause{0};
    StopWatch m_stopWatch{};
    bool m_startWanted{false};

    turning::ForceHealth m_health{};
    ForceZero m_zero{};
    turning::SurfaceRecord m_surface{};
    int m_above{0};
    std::int64_t m_lastSample_ns{0};
    int m_below{0};
    std::uint32_t m_cutSamples{0};
    double m_mean_N{0.0};
    double m_reference_N{0.0};
    int m_jumped{0};
    double m_wanted_um{0.0};
    double m_trim_um{0.0};
    double m_trimMean_um{0.0};
    double m_atLimit{0.0};
    double m_forceSum_N{0.0};
    int m_moved{0};
    mutable double m_forceLow_N{0.0};  ///< since the last chart sample
    mutable double m_forceHigh_N{0.0};
    mutable bool m_forceTaken{true};
};

}  // namespace kerf
