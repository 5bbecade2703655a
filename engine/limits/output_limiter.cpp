// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/limits/output_limiter.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace kerf {
namespace {

constexpr double kStartPatience_s = 30.0;  // a control that has been asked may begin this much later
constexpr double kSameScale = 1e-9;
constexpr double kLongestReset_s = 5.0;

constexpr std::size_t indexOf(ProcessId id) {
    return static_cast<std::size_t>(id);
}

bool finite(const std::optional<double>& value) {
    return value.has_value() && std::isfinite(*value);
}

/// Moves from `from` towards `to` by at most the given steps.
double stepped(double from, double to, double up, double down) {
    return std::clamp(to, from - down, from + up);
}

/// Scale at which the planned feed is made: declared with the program, else said by its loop.
std::optional<double> plannedScale(const LoopOutputs& owner, const MachineInputs& inputs) {
    if (inputs.plannedFeedScale.good()) {
        return std::clamp(inputs.plannedFeedScale.value, 0.0, 1.0);
    }
    return finite(owner.plannedFeedScale) ? std::optional(std::clamp(*owner.plannedFeedScale, 0.0, 1.0)) : std::nullopt;
}

/// Of the outputs that nobody's program owns: what those wish who have them; of two the first.
LoopOutputs grantedAtAnyTime(const std::array<LoopOutputs, kProcessPlaces>& wishes) {
    LoopOutputs granted;
    for (const ProcessDescriptor* process : processes()) {
        const LoopOutputs& wish = wishes[indexOf(process->id)];
        for (std::size_t axis = 0; process->may.workOffset && axis < kAxisCount; ++axis) {
            if (!granted.workOffset_um[axis]) {
                granted.workOffset_um[axis] = wish.workOffset_um[axis];
            }
        }
        if (process->may.toolTrim && !granted.toolTrim_um) {
            granted.toolTrim_um = wish.toolTrim_um;
        }
    }
    return granted;
}

bool ready(const MachineInputs& inputs) {
    return inputs.machineOn && !inputs.emergencyStop;
}

void refuse(std::uint32_t number, const Sentence& why, LimitReport& report) {
    report.request = true;
    if (report.refusedCount < report.refused.size()) {
        report.refused[report.refusedCount++] = {number, RequestState::Refused, why};
    }
}

}  // namespace

OutputLimiter::OutputLimiter(const Capabilities& capabilities) noexcept {
    fit(capabilities);
}

void OutputLimiter::fit(const Capabilities& capabilities) noexcept {
    m_limits = capabilities.limits;
    m_period_s = static_cast<double>(std::max<std::int64_t>(capabilities.cycle_ns, 1)) / kNanosecondPerSecond;
    m_feedScaleTop =
        std::max(m_limits.feedScaleMin, std::min(m_limits.feedScaleMax, std::max(capabilities.maxFeedScale, 0.0)));
    m_feedScaleFitted = capabilities.feedScale.fitted;
    m_workOffsetFitted = capabilities.workOffset.fitted;
    m_forceResetFitted = capabilities.forceReset.fitted;
    m_toolTrimFitted = capabilities.toolTrim.fitted;
    m_zTrimFitted = capabilities.zTrim.fitted;
}

void OutputLimiter::adopt(const MachineInputs& inputs, const Capabilities& capabilities) noexcept {
    fit(capabilities);
    if (m_feedScaleFitted && inputs.appliedFeedScale.good()) {
        m_last.feedScale = std::max(inputs.appliedFeedScale.value, 0.0);
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        adoptOffset(axis, inputs.workOffset_um[axis]);
    }
    if (m_toolTrimFitted && inputs.toolTrim_um.good()) {
        m_last.toolTrim_um = inputs.toolTrim_um.value;
    }
    if (m_zTrimFitted && inputs.zTrim_um.good()) {
        m_last.zTrim_um = inputs.zTrim_um.value;
    }
}

void OutputLimiter::adoptOffset(std::size_t axis, const Reading& applied_um) noexcept {
    m_offsetKnown[axis] = applied_um.good();
    if (m_workOffsetFitted && applied_um.good()) {
        m_last.workOffset_um[axis] = applied_um.value;
    }
}

void OutputLimiter::limitFeedScale(const LoopOutputs& owner, const MachineInputs& inputs, bool running, double step_s,
                                   LimitReport& report) noexcept {
    const std::optional<double> planned = running ? plannedScale(owner, inputs) : m_startScale;
    double target = running ? std::min(m_last.feedScale, 1.0) : 1.0;
    if (planned) {
        target = std::min(target, *planned);
    }
    m_scaled = running && (m_scaled || finite(owner.feedScale));
    if (running && finite(owner.feedScale)) {
        const double wanted = *owner.feedScale;
        target = std::clamp(wanted, m_limits.feedScaleMin, m_feedScaleTop);
        report.feedScale = target != wanted;
    }
    m_last.feedScale =
        stepped(m_last.feedScale, target, m_limits.feedScaleRise_perS * step_s, m_limits.feedScaleFall_perS * step_s);
    // A program that somebody scales and nobody has declared a feed for can only be held when we are gone.
    m_last.lossScale = planned ? *planned : m_scaled ? 0.0 : 1.0;
}

void OutputLimiter::limitOffsets(const LoopOutputs& granted, const MachineInputs& inputs, double step_s, bool frozen,
                                 LimitReport& report) noexcept {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const Reading& applied_um = inputs.workOffset_um[axis];
        if (!m_offsetKnown[axis] || !applied_um.good()) {
            adoptOffset(axis, applied_um);
        }
        if (m_workOffsetFitted && !frozen && finite(granted.workOffset_um[axis])) {
            const double wanted = *granted.workOffset_um[axis];
            const double target = std::clamp(wanted, -m_limits.workOffsetMax_um, m_limits.workOffsetMax_um);
            const double step = m_limits.workOffsetRate_umPerS * step_s;
            report.workOffset[axis] = target != wanted;
            m_last.workOffset_um[axis] = stepped(m_last.workOffset_um[axis], target, step, step);
        }
    }
}

void OutputLimiter::limitTrims(const LoopOutputs& granted, const LoopOutputs& servoOwner, double step_s,
                               LimitReport& report) noexcept {
    const double trimWanted = m_toolTrimFitted && finite(granted.toolTrim_um) ? *granted.toolTrim_um : 0.0;
    const double trimTarget = std::clamp(trimWanted, -m_limits.toolTrimMax_um, m_limits.toolTrimMax_um);
    const double trimStep = m_limits.toolTrimRate_umPerS * step_s;
    report.toolTrim = trimTarget != trimWanted;
    m_last.toolTrim_um = stepped(m_last.toolTrim_um, trimTarget, trimStep, trimStep);

    const bool wished = m_zTrimFitted && finite(servoOwner.zTrim_um);
    const double zTrimWanted = wished ? *servoOwner.zTrim_um : 0.0;
    const double zTrimTarget = std::clamp(zTrimWanted, -m_limits.zTrimMax_um, m_limits.zTrimMax_um);
    const double zTrimStep = (wished ? m_limits.zTrimRate_umPerS : m_limits.zTrimReturn_umPerS) * step_s;
    m_last.zTrim_um = stepped(m_last.zTrim_um, zTrimTarget, zTrimStep, zTrimStep);
    report.zTrim = m_last.zTrim_um != zTrimWanted;
}

/// A reset that lasts has no force behind it: after its longest time the line falls, whatever is wished.
void OutputLimiter::limitReset(bool wished, double step_s) noexcept {
    m_reset_s = wished ? m_reset_s + step_s : 0.0;
    m_last.forceReset = wished && m_forceResetFitted && m_reset_s <= kLongestReset_s;
}

bool OutputLimiter::admitRequest(ProcessId process, PortRequest& request, LimitReport& report) const noexcept {
    if (auto* gains = std::get_if<SetServoGains>(&request.action)) {
        if (!authorityOf(process).servo) {
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
        return start->process == process && start->plannedFeedScale > 0.0 && start->plannedFeedScale <= 1.0;
    }
    if (std::holds_alternative<RetractInSync>(request.action)) {
        return authorityOf(process).servo;
    }
    return true;
}

void OutputLimiter::callOffStart(ProcessId process, LimitReport& report) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_waitingCount; ++i) {
        if (m_waiting[i].process == process && std::holds_alternative<StartProgram>(m_waiting[i].request.action)) {
            refuse(m_waiting[i].request.number, Sentence(KERF_TEXT("Called off before it began.")), report);
        } else {
            m_waiting[kept++] = m_waiting[i];
        }
    }
    m_waitingCount = kept;
}

void OutputLimiter::takeRequest(ProcessId process, PortRequest request, LimitReport& report) noexcept {
    if (!admitRequest(process, request, report)) {
        refuse(request.number, Sentence(KERF_TEXT("This loop may not ask the machine for that.")), report);
        return;
    }
    const bool abort = std::holds_alternative<AbortProgram>(request.action);
    if (abort) {
        callOffStart(process, report);
    }
    if (m_waitingCount == m_waiting.size()) {
        refuse(request.number, Sentence(KERF_TEXT("Too many requests wait for the machine.")), report);
        return;
    }
    m_waiting[m_waitingCount++] = {process, request};
    if (abort) {
        std::rotate(m_waiting.begin(), m_waiting.begin() + static_cast<std::ptrdiff_t>(m_waitingCount) - 1,
                    m_waiting.begin() + static_cast<std::ptrdiff_t>(m_waitingCount));
    }
}

Sentence OutputLimiter::whyNotNow(const PortRequest& request, const MachineInputs& inputs) const noexcept {
    if (inputs.link != LinkState::Up) {
        return Sentence(KERF_TEXT("No connection to the machine: nothing was asked of it."));
    }
    const bool starts = std::holds_alternative<StartProgram>(request.action);
    if ((starts || std::holds_alternative<RetractInSync>(request.action)) && !ready(inputs)) {
        return Sentence(KERF_TEXT("The machine is not ready."));
    }
    return starts ? m_stops.whyNoStart() : Sentence{};
}

void OutputLimiter::sendRequest(const MachineInputs& inputs, LimitReport& report) noexcept {
    m_last.request = PortRequest{};
    std::size_t next = 0;
    while (next < m_waitingCount && m_last.request.number == 0) {
        const PortRequest& request = m_waiting[next].request;
        const auto* start = std::get_if<StartProgram>(&request.action);
        if (const Sentence why = whyNotNow(request, inputs); !why.empty()) {
            refuse(request.number, why, report);
            m_startScale.reset();
            ++next;
            continue;
        }
        if (start != nullptr && authorityOf(start->process).feedScale && m_feedScaleFitted) {
            m_startScale = start->plannedFeedScale;
            m_startNumber = request.number;
            m_startWait_s = 0.0;
            m_last.lossScale = std::min(m_last.lossScale, start->plannedFeedScale);
            if (m_last.feedScale > start->plannedFeedScale + kSameScale) {
                break;  // until the scale is that of the planned feed
            }
        }
        m_last.request = request;
        ++next;
    }
    std::move(m_waiting.begin() + static_cast<std::ptrdiff_t>(next),
              m_waiting.begin() + static_cast<std::ptrdiff_t>(m_waitingCount), m_waiting.begin());
    m_waitingCount -= next;
}

MachineOutputs OutputLimiter::apply(const std::array<LoopOutputs, kProcessPlaces>& wishes, const MachineInputs& inputs,
                                    double dt_s, LimitReport& report) noexcept {
    report = LimitReport{};
    const double step_s = std::isfinite(dt_s) ? std::clamp(dt_s, 0.0, kMostPeriods * m_period_s) : 0.0;
    const bool running = inputs.program == ProgramState::Running || inputs.program == ProgramState::Paused;
    const ProcessId owner = inputs.programProcess;
    static constexpr LoopOutputs kNoWish{};
    const ProcessAuthority may = authorityOf(owner);
    const LoopOutputs& feedOwner = may.feedScale ? wishes[indexOf(owner)] : kNoWish;
    const LoopOutputs& servoOwner = running && may.servo ? wishes[indexOf(owner)] : kNoWish;
    const LoopOutputs granted = grantedAtAnyTime(wishes);

    for (const ProcessId id : allProcesses()) {
        m_stops.set(id, wishes[indexOf(id)].stop, inputs.time_ns);
        if (wishes[indexOf(id)].outOfWork) {
            m_stops.turnedOut(id);
        }
    }
    const bool frozen = anyStopOf(m_stops.all(), StopKind::InWork);

    m_startWait_s += step_s;
    const bool refused = inputs.reply.number == m_startNumber && inputs.reply.state == RequestState::Refused;
    if (running || refused || m_startWait_s > kStartPatience_s) {
        m_startScale.reset();
    }
    if (m_feedScaleFitted) {
        limitFeedScale(feedOwner, inputs, running, step_s, report);
    }
    m_last.feedHold = anyStopOf(m_stops.all(), StopKind::FeedHold) || (running && wishes[indexOf(owner)].feedHold);
    limitReset(running && wishes[indexOf(owner)].forceReset, step_s);
    limitOffsets(granted, inputs, step_s, frozen, report);
    if (!frozen) {
        limitTrims(granted, servoOwner, step_s, report);
    }
    for (const ProcessId id : allProcesses()) {
        if (const PortRequest& request = wishes[indexOf(id)].request; request.number != 0) {
            takeRequest(id, request, report);
        }
    }
    sendRequest(inputs, report);
    m_last.stops = m_stops.all();
    ++m_last.heartbeat;
    return m_last;
}

}  // namespace kerf
