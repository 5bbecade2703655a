// SPDX-License-Identifier: GPL-3.0-or-later
// What the thermal loop is told: setup, reference, measurements of the origin, warm-up.
#include <cmath>

#include "engine/process/thermal/thermal_alarms.h"
#include "engine/process/thermal/thermal_loop.h"
#include "engine/process/thermal/thermal_setup.h"

namespace kerf {

std::span<const AlarmSpec> ThermalLoop::alarms() const noexcept {
    return thermal_alarm::kSpecs;
}

CommandResult ThermalLoop::handle(const Command& command) noexcept {
    if (const auto* load = std::get_if<LoadThermalSetup>(&command.action)) {
        if (const auto why = thermal::whyUnusable(load->setup)) {
            return CommandResult::refused(*why);
        }
        m_setup = load->setup;
        return CommandResult::ok();
    }
    if (const auto* reference = std::get_if<TakeThermalReference>(&command.action)) {
        m_gauge.forgetZero();
        restart(reference->clearShift);
        return CommandResult::ok();
    }
    if (const auto* zero = std::get_if<LoadGapZero>(&command.action)) {
        return m_gauge.loadZero(zero->zero_um, m_status);
    }
    if (std::holds_alternative<MeasureOrigin>(command.action)) return measure();
    if (const auto* part = std::get_if<MeasureByPart>(&command.action)) return measureByPart(*part);
    if (std::holds_alternative<AdoptMeasurement>(command.action)) return adopt();
    if (const auto* record = std::get_if<RecordGaps>(&command.action)) return m_gauge.record(record->on, m_status);
    if (std::holds_alternative<StartPart>(command.action)) return startWarmUp();
    if (std::holds_alternative<StopWarmUp>(command.action)) {
        m_warmUpStopWanted = m_status.warmUpRunning;
        return CommandResult::ok();
    }
    return CommandResult::refused(Sentence(KERF_TEXT("The thermal loop does not know this command.")));
}

CommandResult ThermalLoop::measure() noexcept {
    const CommandResult begun = m_gauge.measure(m_status);
    m_adopted = m_adopted && !begun.done;
    return begun;
}

CommandResult ThermalLoop::measureByPart(const MeasureByPart& part) noexcept {
    const auto stops = [](const char* why) { return CommandResult::refused(Sentence(why)); };
    if (m_status.gap.phase == GapPhase::Measuring) return stops(KERF_TEXT("The origin is being measured."));
    if (!m_part || m_part->reference != m_reference || m_part->minute < m_log.begin()) {
        return stops(KERF_TEXT("No part has been finished since the reference that has not been measured yet."));
    }
    bool any = false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (!part.known[axis]) continue;
        any = true;
        if (!(std::abs(part.deviation_um[axis]) <= MeasureByPart::kMost_um)) {
            return stops(KERF_TEXT("A deviation of more than 200 µm is no thermal drift: look at the part."));
        }
    }
    if (!any) return stops(KERF_TEXT("Nothing of the part has been measured."));
    if (learns() && m_part->model != m_live->revision) {
        return stops(KERF_TEXT("The model has changed since that part was cut: measure the next one."));
    }
    const std::uint32_t number = m_status.gap.number + 1;
    GapMeasurement& gap = m_status.gap;
    gap = {};
    gap.number = number;
    gap.phase = GapPhase::Done;
    gap.byPart = true;
    gap.known = part.known;
    gap.time_ns = m_last_ns;
    gap.predictionKnown = true;
    gap.predicted_um = m_part->predicted_um;
    gap.half_um = m_part->half_um;
    PerAxis learnt_um{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (!part.known[axis]) continue;
        gap.measured_um[axis] = part.deviation_um[axis] - m_part->shift_um[axis];
        learnt_um[axis] = gap.measured_um[axis] - m_carried_um[axis];
    }
    m_adopted = false;
    if (learns()) {
        const std::size_t before = m_live->estimator.day().count();
        m_live->estimator.measuredAt(m_part->at, learnt_um, part.known, MeasureByPart::kNoise_um);
        tellLearnt(before);
        m_log.learn(m_part->minute, learnt_um, part.known, MeasureByPart::kNoise_um);
        m_due_ns = m_last_ns;
    }
    m_part.reset();
    m_status.partToMeasure = false;
    return CommandResult::ok();
}

CommandResult ThermalLoop::adopt() noexcept {
    const GapMeasurement& gap = m_status.gap;
    if (gap.phase != GapPhase::Done || !gap.predictionKnown) {
        return CommandResult::refused(Sentence(KERF_TEXT("There is no measurement beside a prediction yet.")));
    }
    if (learns()) {
        return CommandResult::refused(Sentence(KERF_TEXT("The model has learnt from this measurement already.")));
    }
    if (m_adopted) return CommandResult::refused(Sentence(KERF_TEXT("This measurement has been taken over already.")));
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (!gap.known[axis]) continue;
        const double difference_um = gap.measured_um[axis] - gap.predicted_um[axis];
        m_carried_um[axis] += difference_um;
        m_trusted_um[axis] += difference_um;
    }
    m_adopted = true;
    m_due_ns = m_last_ns;
    return CommandResult::ok();
}

CommandResult ThermalLoop::startWarmUp() noexcept {
    m_warmUpWanted = true;
    return CommandResult::ok();
}

}  // namespace kerf
