// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/thermal_loop.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/cycle/event_sink.h"
#include "engine/process/thermal/compensation.h"
#include "engine/process/thermal/thermal_alarms.h"
#include "engine/process/thermal/thermal_words.h"
#include "engine/process/thermal/warm_up.h"

namespace kerf {
namespace {

constexpr double kMinute_ns = 60.0 * kNanosecondPerSecond;
constexpr double kForecast_min = 10.0;
constexpr double kShiftTolerance_um = 1.0;
constexpr int kMissesUntilAlarm = 2;
constexpr int kTicksUntilShifted = 2;

}  // namespace

ThermalLoop::~ThermalLoop() {
    delete m_live;
    delete m_next;
}

void ThermalLoop::setMode(LoopMode mode) noexcept {
    m_mode = mode;
    m_wishedTicks = 0;
    m_missesOfShift = 0;
}

void ThermalLoop::restart(bool clearShift) noexcept {
    m_clearShift = clearShift;
    m_started = false;
    m_prediction = {};
    m_part.reset();
    m_log.clear();
    m_nextBaseline = 0;
    m_nextMinute = 0;
    for (LiveModel* model : {m_live, m_next}) {
        if (model == nullptr) continue;
        model->estimator.reset();
        if (clearShift) model->estimator.newDay();
    }
}

LoopVerdict ThermalLoop::step(const MachineInputs& inputs, const Capabilities& capabilities, LoopOutputs& outputs,
                              EventSink& events) noexcept {
    const bool linked = inputs.link == LinkState::Up;
    watchSpeed(inputs);
    m_last_ns = inputs.time_ns;
    if (m_gauge.watch(inputs, capabilities.gapSensors, m_status)) spotDone(inputs);
    watchPart(inputs);
    takeModel();
    catchUp();
    const bool readable = linked && capabilities.temperatures.fitted && inputs.temperatures != nullptr &&
                          inputs.temperatures->revision > 0;
    if (readable && !m_started) {
        m_started = true;
        ++m_reference;
        m_due_ns = inputs.time_ns;
        m_gauge.beginReference();
    }
    const bool due = m_started && inputs.time_ns >= m_due_ns;
    if (due && readable) {
        tick(inputs, events);
    }
    if (m_started && inputs.time_ns >= m_due_ns) {
        const double period_min =
            m_log.baselineDone() ? m_setup.period_min : m_setup.period_min / static_cast<double>(ThermalLog::kBaseline);
        m_due_ns += static_cast<std::int64_t>(period_min * kMinute_ns);
        if (m_due_ns <= inputs.time_ns) m_due_ns = inputs.time_ns + static_cast<std::int64_t>(period_min * kMinute_ns);
        raiseAlarms(inputs, events);
    }
    runWarmUp(inputs, outputs);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_status.shifted_um[axis] = inputs.workOffset_um[axis];
        // Without temperatures nothing moves: the limiter keeps what stands.
        if (readable && m_targetKnown && shiftReadable(inputs)) {
            outputs.workOffset_um[axis] = m_status.target_um[axis];
        }
    }
    m_status.stage = !readable               ? ThermalStage::NoTemperatures
                     : !m_log.baselineDone() ? ThermalStage::Baseline
                     : m_live == nullptr     ? (m_next != nullptr ? ThermalStage::CatchUp : ThermalStage::NoModel)
                     : m_prediction.usable   ? ThermalStage::Following
                     : m_log.end() == 0      ? ThermalStage::Baseline
                                             : ThermalStage::Holding;
    m_status.model = m_live != nullptr ? m_live->revision : 0;
    m_status.setup = m_setup.revision;
    m_status.allowed_um = m_setup.allowed_um;
    m_status.learns = learns();
    m_status.nextUpdate_s = static_cast<double>(m_due_ns - inputs.time_ns) / kNanosecondPerSecond;
    return thermalVerdict(m_status, m_mode, m_targetKnown);
}

void ThermalLoop::takeModel() noexcept {
    if (m_next != nullptr) return;
    m_next = m_exchange.take();
    m_nextBaseline = 0;
    m_nextMinute = m_log.begin();
}

void ThermalLoop::catchUp() noexcept {
    if (m_next == nullptr) return;
    if (m_nextBaseline < m_log.baselineCount()) {
        (void)feed(*m_next, m_log.baseline(m_nextBaseline++));
        return;
    }
    if (!m_log.baselineDone()) return;
    m_nextMinute = std::max(m_nextMinute, m_log.begin());
    thermal::ThermalPrediction newest{};
    if (m_nextMinute < m_log.end()) {
        newest = feed(*m_next, m_log.minute(m_nextMinute++));
        if (m_nextMinute < m_log.end()) return;
    }
    LiveModel* old = m_live;
    m_live = m_next;
    m_next = nullptr;
    if (old != nullptr) m_exchange.retire(old);
    m_prediction = newest;
    if (newest.usable) take(newest);
}

thermal::ThermalPrediction ThermalLoop::feed(LiveModel& model, const ThermalMinute& minute) noexcept {
    std::array<Reading, thermal::kMaxModelSensors> readings{};
    const std::size_t count = model.estimator.sensors();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint16_t channel = model.channel[i];
        if (channel < kMaxTemperatures && (minute.present >> channel & 1U) != 0U) {
            readings[i] = {static_cast<double>(minute.temp_degC[channel]), minute.time_ns, Quality::Good};
        }
    }
    const std::span<const Reading> used(readings.data(), count);
    if (minute.minutes < 0.0) {
        model.estimator.baseline(minute.minutes, used);
        return {};
    }
    const auto speed_rpm =
        minute.speedKnown ? std::optional<double>(static_cast<double>(minute.speed_rpm)) : std::nullopt;
    const thermal::ThermalPrediction prediction = model.estimator.update(minute.minutes, speed_rpm, used);
    if (minute.spot) {  // used from the next minute on
        PerAxis learnt_um{};
        std::ranges::copy(minute.learnt_um, learnt_um.begin());
        model.estimator.measured(learnt_um, minute.learntKnown, static_cast<double>(minute.learntNoise_um));
    }
    return prediction;
}

bool ThermalLoop::learns() const noexcept {
    return m_live != nullptr && m_live->estimator.day().present();
}

void ThermalLoop::tellLearnt(std::size_t before) noexcept {
    const thermal::DayPosterior& day = m_live->estimator.day();
    if (day.count() > 0 && (day.count() != before || before == thermal::kMaxDayMeasurements)) {
        (void)m_exchange.learnt.tryPush(day.measurement(day.count() - 1));
    }
}

void ThermalLoop::watchSpeed(const MachineInputs& inputs) noexcept {
    const double dt_s =
        m_last_ns == 0 ? 0.0 : std::max(0.0, static_cast<double>(inputs.time_ns - m_last_ns) / kNanosecondPerSecond);
    if (!inputs.spindleSpeed_rpm.good()) {
        m_blind_s += dt_s;
        return;
    }
    const double krpm = std::abs(inputs.spindleSpeed_rpm.value) / 1000.0;
    m_heat += krpm * std::sqrt(krpm) * dt_s;
    m_heat_s += dt_s;
}

void ThermalLoop::spotDone(const MachineInputs& inputs) noexcept {
    m_status.gap.predictionKnown = m_prediction.usable;
    m_status.gap.predicted_um = predicted();
    m_status.gap.half_um = m_prediction.half_um;
    m_spotPending = true;
    if (learns() && m_log.baselineDone()) m_due_ns = inputs.time_ns;  // in the state that was measured
}

void ThermalLoop::watchPart(const MachineInputs& inputs) noexcept {
    const PartWatch::Edge edge = m_parts.watch(inputs);
    m_status.waitsForPart = false;
    if (edge == PartWatch::Edge::Begun && m_setup.betweenParts && m_targetKnown && shiftReadable(inputs)) {
        // Where a shift under way has got to, the part begins.
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            m_status.target_um[axis] = std::round(inputs.workOffset_um[axis].value);
    }
    if (edge == PartWatch::Edge::Finished) {
        m_part.reset();
        if (m_live != nullptr && m_prediction.usable && m_log.end() > m_log.begin() && shiftReadable(inputs)) {
            FinishedPart& part = m_part.emplace();
            part.predicted_um = predicted();
            part.half_um = m_prediction.half_um;
            for (std::size_t axis = 0; axis < kAxisCount; ++axis)
                part.shift_um[axis] = inputs.workOffset_um[axis].value;
            if (learns()) part.at = m_live->estimator.instant();
            part.model = m_live->revision;
            part.reference = m_reference;
            part.minute = m_log.end() - 1;
        }
        if (m_setup.betweenParts) command(inputs);
    }
    m_status.partToMeasure = m_part && m_part->reference == m_reference;
    m_status.waitsForPart = m_setup.betweenParts && m_parts.runs();
}

void ThermalLoop::runWarmUp(const MachineInputs& inputs, LoopOutputs& outputs) noexcept {
    m_status.warmUpRunning = inputs.program == ProgramState::Running && inputs.programProcess == ProcessId::Thermal;
    if (m_status.warmUpRunning) {
        m_status.warmUpLeft_min = std::max(0.0, static_cast<double>(m_warmUpEnd_ns - inputs.time_ns) / kMinute_ns);
    } else {
        m_status.warmUpLeft_min = 0.0;
    }
    if (m_warmUpWanted) {
        m_warmUpWanted = false;
        StartProgram program;
        program.process = ProcessId::Thermal;
        program.spindleSpeed_rpm = m_setup.warmUpSpeed_rpm;
        program.revolutions = m_setup.warmUpSpeed_rpm * m_setup.warmUp_min;
        outputs.request = {m_program.nextRequest(), program};
        m_warmUpEnd_ns = inputs.time_ns + static_cast<std::int64_t>(m_setup.warmUp_min * kMinute_ns);
    } else if (m_warmUpStopWanted) {
        m_warmUpStopWanted = false;
        if (m_status.warmUpRunning) outputs.request = {m_program.nextRequest(), AbortProgram{}};
    }
}

ThermalMinute ThermalLoop::minuteNow(const MachineInputs& inputs) noexcept {
    ThermalMinute minute;
    minute.time_ns = inputs.time_ns;
    minute.reference = m_reference;
    minute.speedKnown = m_heat_s > m_blind_s;
    if (m_heat_s > 0.0) minute.speed_rpm = static_cast<float>(1000.0 * std::pow(m_heat / m_heat_s, 2.0 / 3.0));
    m_heat = 0.0;
    m_heat_s = 0.0;
    m_blind_s = 0.0;
    const TemperatureFrame& frame = *inputs.temperatures;
    const std::size_t count = std::min<std::size_t>(frame.count, kMaxTemperatures);
    for (std::size_t k = 0; k < count; ++k) {
        if (frame.temp_degC[k].good()) {
            minute.temp_degC[k] = static_cast<float>(frame.temp_degC[k].value);
            minute.present |= std::uint64_t{1} << k;
        }
    }
    return minute;
}

void ThermalLoop::tick(const MachineInputs& inputs, EventSink&) noexcept {
    ThermalMinute minute = minuteNow(inputs);
    if (!m_log.baselineDone()) {
        const double step_min = m_setup.period_min / static_cast<double>(ThermalLog::kBaseline);
        minute.minutes = -step_min * static_cast<double>(ThermalLog::kBaseline - m_log.baselineCount());
        m_log.addBaseline(minute);
        if (m_live != nullptr) (void)feed(*m_live, minute);
        m_gauge.addReference(m_status);
        if (m_log.baselineDone()) {
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                const bool known = !m_clearShift && inputs.workOffset_um[axis].good();
                m_carried_um[axis] = known ? -inputs.workOffset_um[axis].value : 0.0;
            }
            m_referenceEnd_ns = inputs.time_ns + static_cast<std::int64_t>(step_min * kMinute_ns);
            endBaseline();
        }
        m_couples.report(*inputs.temperatures, m_live, m_status);
        (void)m_exchange.minutes.tryPush(minute);
        return;
    }
    minute.minutes = static_cast<double>(inputs.time_ns - m_referenceEnd_ns) / kMinute_ns;
    minute.minutes = std::max(minute.minutes, 0.0);
    if (m_spotPending) {
        minute.spot = true;
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            minute.learnt_um[axis] = static_cast<float>(m_status.gap.measured_um[axis] - m_carried_um[axis]);
        }
    }
    if (m_live != nullptr) {
        const std::size_t before = m_live->estimator.day().count();
        const thermal::ThermalPrediction prediction = feed(*m_live, minute);
        if (minute.spot) tellLearnt(before);
        m_prediction = prediction;
        if (prediction.usable) take(prediction);
    }
    minute.predicted = m_prediction.usable;
    const PerAxis now_um = predicted();
    const bool measured = m_status.gapZeroKnown && m_status.gapsReadable && (m_status.recording || m_spotPending);
    minute.measured = measured;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        minute.drift_um[axis] = static_cast<float>(now_um[axis]);
        minute.half_um[axis] = static_cast<float>(m_prediction.half_um[axis]);
        minute.shift_um[axis] = static_cast<float>(inputs.workOffset_um[axis].value);
        if (measured) {
            const double drift_um =
                m_spotPending ? m_status.gap.measured_um[axis] : m_gauge.now_um()[axis] - m_status.gapZero_um[axis];
            minute.measured_um[axis] = static_cast<float>(drift_um);
        }
    }
    m_spotPending = false;
    m_log.add(minute);
    ++m_status.updates;
    m_status.minutes = minute.minutes;
    command(inputs);
    forecast();
    m_couples.report(*inputs.temperatures, m_live, m_status);
    (void)m_exchange.minutes.tryPush(minute);
}

void ThermalLoop::endBaseline() noexcept {
    m_trusted_um = m_carried_um;
    m_status.updates = 0;
    m_status.warmUp = WarmUpState::Unknown;
    m_gauge.endReference(m_carried_um, m_status);
    m_clearShift = false;
}

ThermalLoop::PerAxis ThermalLoop::predicted() const noexcept {
    PerAxis out = m_trusted_um;
    if (m_prediction.usable) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            out[axis] = m_carried_um[axis] + m_prediction.drift_um[axis];
        }
    }
    return out;
}

void ThermalLoop::take(const thermal::ThermalPrediction& prediction) noexcept {
    const double share = thermal::holdShare(prediction.outside);
    const PerAxis now_um = predicted();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_trusted_um[axis] += share * (now_um[axis] - m_trusted_um[axis]);
    }
    m_status.drift_um = now_um;
    m_status.half_um = prediction.half_um;
    m_status.outside = prediction.outside;
    m_status.speedShare = prediction.speedShare;
    m_status.lostSensors = prediction.lostSensors;
    m_status.differs = prediction.changed >= thermal::kDayDiffers;
}

bool ThermalLoop::shiftReadable(const MachineInputs& inputs) const noexcept {
    return std::ranges::all_of(inputs.workOffset_um, [](const Reading& offset) { return offset.good(); });
}

void ThermalLoop::command(const MachineInputs& inputs) noexcept {
    if (!shiftReadable(inputs) || m_live == nullptr || !m_prediction.usable) return;
    if (m_mode == LoopMode::Control && m_targetKnown && ++m_wishedTicks > kTicksUntilShifted) {
        bool missed = false;
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const double off_um = inputs.workOffset_um[axis].value - m_status.target_um[axis];
            missed = missed || std::abs(off_um) > kShiftTolerance_um;
        }
        m_missesOfShift = missed ? m_missesOfShift + 1 : 0;
    }
    const bool waits = m_setup.betweenParts && m_parts.runs() && m_targetKnown;
    const thermal::ShiftLimits limits{1.0, m_setup.maxShift_um,
                                      std::max(1.0, m_setup.maxStep_umPerMin * m_setup.period_min)};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const thermal::ShiftCommand shift =
            thermal::nextShift(m_trusted_um[axis], inputs.workOffset_um[axis].value, limits);
        if (!waits) m_status.target_um[axis] = shift.total_um;
        m_status.sizeLimited[axis] = shift.sizeLimited;
        m_status.rateLimited[axis] = shift.rateLimited;
    }
    m_targetKnown = true;
}

void ThermalLoop::forecast() noexcept {
    m_status.warmUp = WarmUpState::Unknown;
    m_status.ready_min = 0.0;
    const auto back = static_cast<std::size_t>(std::max(2.0, std::round(kForecast_min / m_setup.period_min)));
    if (!m_prediction.usable || m_log.end() < m_log.begin() + 2 * back + 1) return;
    const std::size_t now = m_log.end() - 1;
    std::array<thermal::WarmUpAxis, kAxisCount> axes{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        axes[axis].half_um = m_prediction.half_um[axis];
        for (std::size_t k = 0; k < 3; ++k) {
            const ThermalMinute& minute = m_log.minute(now - (2 - k) * back);
            if (!minute.predicted) return;
            axes[axis].drift_um[k] = static_cast<double>(minute.drift_um[axis]);
        }
    }
    const double compensated_min = m_mode == LoopMode::Control ? m_setup.period_min : 0.0;
    const thermal::WarmUpForecast out = thermal::warmUpForecast(axes, static_cast<double>(back) * m_setup.period_min,
                                                                m_setup.allowed_um, compensated_min);
    m_status.warmUp = out.state;
    m_status.ready_min = out.ready_min;
}

void ThermalLoop::raiseAlarms(const MachineInputs& inputs, EventSink& events) noexcept {
    const bool running = m_log.baselineDone();
    events.set(thermal_alarm::kNoTemperatures, running && inputs.temperatures == nullptr);
    int sick = 0;
    Sentence which;
    if (m_live != nullptr) {
        for (std::size_t i = 0; i < m_live->estimator.sensors(); ++i) {
            const auto state = static_cast<CoupleState>(m_live->estimator.health().state(i));
            if (isSick(state)) {
                ++sick;
                which = Sentence(sickCoupleText(state), m_live->name[i]);
            }
        }
    }
    if (sick > m_reportedSick) events.clear(thermal_alarm::kSensorLeftOut);  // another one: said anew
    m_reportedSick = sick;
    events.set(thermal_alarm::kSensorLeftOut, sick > 0, which);
    const bool lost = running && m_live != nullptr && m_log.end() > 0 && !m_prediction.usable;
    events.set(thermal_alarm::kTooManyLost, lost);
    const bool following = running && m_prediction.usable;
    const bool acting = m_mode == LoopMode::Control && following;
    const auto any = [](const std::array<bool, kAxisCount>& flags) {
        return std::ranges::any_of(flags, [](bool flag) { return flag; });
    };
    events.set(thermal_alarm::kShiftAtLimit, acting && any(m_status.sizeLimited));
    events.set(thermal_alarm::kShiftTooFast, acting && any(m_status.rateLimited));
    events.set(thermal_alarm::kShiftNotTaken, acting && m_missesOfShift >= kMissesUntilAlarm);
    events.set(thermal_alarm::kOutside, following && m_prediction.outside > kThermalOutside);
    events.set(thermal_alarm::kDayDiffers, following && m_prediction.changed >= thermal::kDayDiffers);
    const bool tooWide =
        std::ranges::any_of(m_prediction.half_um, [this](double half_um) { return half_um > m_setup.allowed_um; });
    m_status.measureNow = following && tooWide;
    events.set(thermal_alarm::kMeasureNow, m_status.measureNow);
}

}  // namespace kerf
