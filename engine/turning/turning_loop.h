// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/api/status.h"
#include "engine/loop/process_loop.h"
#include "engine/turning/depth_control.h"
#include "engine/turning/identifier.h"

namespace kerf {

/// Force feedback of the diamond turning slide, at 5 kHz: takes the sensor's zero in the air, finds the touch, and
/// trims the tool against the tones of the disturbance while it cuts.
///
///   Air      zero of the force = its slow mean; a touch is four samples in a row above zero + 10 % of the target
///   Entry    the first revolution after the touch
///   Cutting  DepthControl (default law); the trim stays within the setup's authority and the machine's limits
///   Out      left the loop in this part: trim to zero within 4 ms, ramped
///
/// Out of the loop: a lost, stuck or saturated force, a force gain that jumps by a quarter (chipped tool), a trim that
/// leans to one side (mean check). Lost signal and chipped tool fault the loop until a person releases it. The exit of
/// the cut ends the trim the same way without an alarm. The cycle has to be .2 ms; on a slower machine the loop advises
/// only. With a sensor of the tool's motion (gap_um[0]) the cutting process is identified as it cuts.
class TurningLoop final : public ProcessLoop {
 public:
    TurningLoop() noexcept;

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
    enum class ForceState : std::uint8_t { Good, Lost, Saturated };

    void beginPart(const MachineInputs& inputs) noexcept;
    void endPart(const MachineInputs& inputs, EventSink& events) noexcept;
    void touch(const MachineInputs& inputs) noexcept;
    void takeZero(double raw_N, EventSink& events) noexcept;
    void cut(double force_N, const MachineInputs& inputs, EventSink& events) noexcept;
    void leave(const Sentence& reason, bool faulted) noexcept;
    [[nodiscard]] ForceState judge(const FastSample& sample) noexcept;
    void watchSurface(double error_um, double untreated_um) noexcept;
    void identify(double force_N, const MachineInputs& inputs) noexcept;
    void startRequest(LoopOutputs& outputs) noexcept;

    LoopMode m_mode{LoopMode::Off};
    TurningSetup m_next{};
    TurningSetup m_setup{};
    turning::DepthControl m_control;
    turning::ProcessIdentifier m_identifier;
    turning::RevolutionBuffer m_motion{291};
    TurningStatus m_status{};
    PartRecord m_part{};
    Sentence m_outReason{};
    bool m_outFaulted{false};
    bool m_inPart{false};
    bool m_startWanted{false};
    std::uint32_t m_requestCount{0};
    std::uint32_t m_lastSequence{0};

    double m_zero_N{0.0};
    double m_zeroBefore_N{0.0};
    std::uint32_t m_airSamples{0};
    bool m_zeroKnown{false};
    int m_above{0};
    int m_below{0};
    double m_lastRaw_N{0.0};
    int m_same{0};
    std::uint32_t m_cutSamples{0};
    double m_mean_N{0.0};
    double m_reference_N{0.0};
    int m_jumped{0};
    double m_wanted_um{0.0};
    double m_trim_um{0.0};
    double m_trimMean_um{0.0};
    double m_atLimit{0.0};
    double m_surface_um2{0.0};
    double m_untreated_um2{0.0};
    double m_revolutionHigh_um{0.0};
    double m_revolutionLow_um{0.0};
    std::uint32_t m_revolutionSamples{0};
    double m_forceSum_N{0.0};
    double m_surfaceSum_um2{0.0};
    double m_untreatedSum_um2{0.0};
    std::uint64_t m_surfaceCount{0};
};

}  // namespace kerf
