// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/limits/output_limiter.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr std::size_t indexOf(ProcessId id) {
    return static_cast<std::size_t>(id);
}

constexpr bool mayScaleFeed(ProcessId id) {
    return id == ProcessId::Boring || id == ProcessId::Milling;
}

bool finite(const std::optional<double>& value) {
    return value.has_value() && std::isfinite(*value);
}

/// Moves from `from` towards `to` by at most the given steps.
double stepped(double from, double to, double up, double down) {
    return std::clamp(to, from - down, from + up);
}

}  // namespace

OutputLimiter::OutputLimiter(const OutputLimits& limits, const Capabilities& capabilities) noexcept : m_limits(limits) {
    fit(capabilities);
}

void OutputLimiter::fit(const Capabilities& capabilities) noexcept {
    m_feedScaleTop =
        std::max(m_limits.feedScaleMin, std::min(m_limits.feedScaleMax, std::max(capabilities.maxFeedScale, 0.0)));
    m_feedScaleFitted = capabilities.feedScale.fitted;
    m_workOffsetFitted = capabilities.workOffset.fitted;
    m_toolTrimFitted = capabilities.toolTrim.fitted;
    m_zTrimFitted = capabilities.zTrim.fitted;
}

void OutputLimiter::adopt(const MachineInputs& inputs, const Capabilities& capabilities) noexcept {
    fit(capabilities);
    m_last = MachineOutputs{};
    if (m_feedScaleFitted && inputs.appliedFeedScale.good()) {
        m_last.feedScale = std::clamp(inputs.appliedFeedScale.value, m_limits.feedScaleMin, m_feedScaleTop);
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        adoptOffset(axis, inputs.workOffset_um[axis]);
    }
}

void OutputLimiter::adoptOffset(std::size_t axis, const Reading& applied_um) noexcept {
    m_offsetKnown[axis] = applied_um.good();
    if (m_workOffsetFitted && applied_um.good()) {
        m_last.workOffset_um[axis] =
            std::clamp(applied_um.value, -m_limits.workOffsetMax_um, m_limits.workOffsetMax_um);
    }
}

void OutputLimiter::limitFeedScale(const LoopOutputs& owner, bool running, double dt_s, LimitReport& report) noexcept {
    double target = running ? std::min(m_last.feedScale, 1.0) : 1.0;
    if (running && finite(owner.feedScale)) {
        const double wanted = *owner.feedScale;
        target = std::clamp(wanted, m_limits.feedScaleMin, m_feedScaleTop);
        report.feedScale = target != wanted;
    }
    m_last.feedScale =
        stepped(m_last.feedScale, target, m_limits.feedScaleRise_perS * dt_s, m_limits.feedScaleFall_perS * dt_s);
}

bool OutputLimiter::admitRequest(ProcessId process, PortRequest& request, LimitReport& report) const noexcept {
    if (auto* gains = std::get_if<SetServoGains>(&request.action)) {
        if (process != ProcessId::Tapping) {
            return false;
        }
        for (double* gain : {&gains->gains.spindleKp_perS, &gains->gains.zKp_perS}) {
            if (!std::isfinite(*gain)) {
                return false;
            }
            const double clamped = std::clamp(*gain, m_limits.servoGainMin_perS, m_limits.servoGainMax_perS);
            report.request = report.request || clamped != *gain;
            *gain = clamped;
        }
        return std::ranges::all_of(gains->gains.zFeedForward, [](double value) { return std::isfinite(value); });
    }
    if (const auto* start = std::get_if<StartProgram>(&request.action)) {
        return start->process == process;
    }
    if (std::holds_alternative<RetractInSync>(request.action)) {
        return process == ProcessId::Tapping;
    }
    return true;
}

MachineOutputs OutputLimiter::apply(const std::array<LoopOutputs, kProcessCount>& wishes, const MachineInputs& inputs,
                                    double dt_s, LimitReport& report) noexcept {
    report = LimitReport{};
    const double step_s = std::isfinite(dt_s) && dt_s > 0.0 ? dt_s : 0.0;
    const bool running = inputs.program == ProgramState::Running || inputs.program == ProgramState::Paused;
    const ProcessId owner = inputs.programProcess;
    static constexpr LoopOutputs kNoWish{};
    const LoopOutputs& feedOwner = mayScaleFeed(owner) ? wishes[indexOf(owner)] : kNoWish;

    if (m_feedScaleFitted) {
        limitFeedScale(feedOwner, running, step_s, report);
    }
    // Any loop whose program runs may stop the feed; nobody may start it.
    m_last.feedHold = running && wishes[indexOf(owner)].feedHold;

    const LoopOutputs& thermal = wishes[indexOf(ProcessId::Thermal)];
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const Reading& applied_um = inputs.workOffset_um[axis];
        if (!m_offsetKnown[axis] || !applied_um.good()) {
            adoptOffset(axis, applied_um);
        }
        if (m_workOffsetFitted && finite(thermal.workOffset_um[axis])) {
            const double wanted = *thermal.workOffset_um[axis];
            const double target = std::clamp(wanted, -m_limits.workOffsetMax_um, m_limits.workOffsetMax_um);
            const double step = m_limits.workOffsetRate_umPerS * step_s;
            report.workOffset[axis] = target != wanted;
            m_last.workOffset_um[axis] = stepped(m_last.workOffset_um[axis], target, step, step);
        }
    }

    const std::optional<double>& trim = wishes[indexOf(ProcessId::Turning)].toolTrim_um;
    const double trimWanted = m_toolTrimFitted && finite(trim) ? *trim : 0.0;
    const double trimTarget = std::clamp(trimWanted, -m_limits.toolTrimMax_um, m_limits.toolTrimMax_um);
    const double trimStep = m_limits.toolTrimRate_umPerS * step_s;
    report.toolTrim = trimTarget != trimWanted;
    m_last.toolTrim_um = stepped(m_last.toolTrim_um, trimTarget, trimStep, trimStep);

    const std::optional<double>& zTrim = wishes[indexOf(ProcessId::Tapping)].zTrim_um;
    const double zTrimWanted = m_zTrimFitted && running && owner == ProcessId::Tapping && finite(zTrim) ? *zTrim : 0.0;
    const double zTrimTarget = std::clamp(zTrimWanted, -m_limits.zTrimMax_um, m_limits.zTrimMax_um);
    const double zTrimStep = m_limits.zTrimRate_umPerS * step_s;
    m_last.zTrim_um = stepped(m_last.zTrim_um, zTrimTarget, zTrimStep, zTrimStep);
    report.zTrim = m_last.zTrim_um != zTrimWanted;

    m_last.request = PortRequest{};
    for (const ProcessId id : kAllProcesses) {
        PortRequest request = wishes[indexOf(id)].request;
        if (request.number == 0 || m_last.request.number != 0) {
            continue;
        }
        if (admitRequest(id, request, report)) {
            m_last.request = request;
        } else {
            report.request = true;
        }
    }
    ++m_last.heartbeat;
    return m_last;
}

}  // namespace kerf
