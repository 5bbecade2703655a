// SPDX-License-Identifier: GPL-3.0-or-later
// Begin and end of a part, and what the turning loop says of itself.
#include "engine/cycle/event_sink.h"
#include "engine/process/turning/overlap.h"
#include "engine/process/turning/turning_alarms.h"
#include "engine/process/turning/turning_loop.h"

namespace kerf {

void TurningLoop::beginPart(const MachineInputs& inputs) noexcept {
    recall();
    m_setup = m_next;
    m_control = turning::DepthControl(controlParams(m_setup));
    m_motion = turning::RevolutionBuffer(controlParams(m_setup).revolutionSamples);
    m_identifier.reset();
    const std::uint32_t partsCut = m_status.partsCut;
    const std::uint32_t retuned = m_status.retuned;
    m_status = TurningStatus{};
    m_status.partsCut = partsCut;
    m_status.retuned = retuned;
    m_status.controller = m_controller;
    m_status.lawProcess = {m_process.a1, m_process.b0, m_process.b1};
    m_status.stage = TurningStage::Air;
    m_status.activeSetup = m_setup.revision;
    m_status.nextSetup = m_next.revision;
    m_status.depth_um = m_setup.depth_um;
    m_status.forceTarget_N = m_process.dcGain() * m_setup.depth_um;
    m_status.overlap =
        turning::overlapFactor(m_setup.toolRadius_um, m_setup.depth_um, m_setup.feed_umPerRev).value_or(0.0);
    m_part = beginRecord(inputs);
    m_part.turning.setup = m_setup;
    m_health.begin();
    m_surface = turning::SurfaceRecord{};
    m_above = 0;
    m_forceSum_N = m_atLimit = m_trim_um = m_wanted_um = 0.0;
    m_forceTaken = true;
    startCount();
    m_trace.beginPart(inputs.partSequence, m_setup.spindleSpeed_rpm / 60.0);
}

void TurningLoop::endPart(const MachineInputs& inputs, bool complete, EventSink& events) noexcept {
    m_part.forceMean_N = m_cutSamples > 0 ? m_forceSum_N / static_cast<double>(m_cutSamples) : 0.0;
    m_part.forcePeak_N = m_status.forcePeak_N;
    TurningRecord& record = m_part.turning;
    record.valid = true;
    m_surface.fill(record);
    record.controller = m_controller;
    record.controlled = record.controlled && !record.leftLoop;
    record.tones = m_status.tones;
    record.toneCount = m_status.toneCount;
    record.identification = m_status.identification;
    record.lawProcess = m_status.lawProcess;
    record.forceTarget_N = m_status.forceTarget_N;
    m_trace.endPart();
    finishRecord(m_part, inputs.time_ns, complete, events);
    for (const AlarmCode code : {turning_alarm::kForceSaturated, turning_alarm::kToolChipped,
                                 turning_alarm::kMeanForceOff, turning_alarm::kTrimAtLimit, turning_alarm::kBlindTone,
                                 turning_alarm::kForceLost, turning_alarm::kZeroUnknown}) {
        events.clear(code);
    }
    m_status.partsCut += complete ? 1U : 0U;
}

void TurningLoop::report(Status& status) const noexcept {
    status.turning = m_status;
}

void TurningLoop::sample(Sample& sample) const noexcept {
    if (m_status.stage != TurningStage::Idle) {
        sample.force_N = static_cast<float>(m_status.force_N.value);
        sample.depthError_um = static_cast<float>(m_control.error_um());
        sample.trim_um = static_cast<float>(m_status.appliedTrim_um);
        sample.forceLow_N = static_cast<float>(m_forceLow_N);
        sample.forceHigh_N = static_cast<float>(m_forceHigh_N);
        m_forceTaken = true;
    }
}

}  // namespace kerf
