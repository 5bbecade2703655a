// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/gap_gauge.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace kerf {
namespace {

constexpr double kPatience_s = 20.0;

}  // namespace

bool GapGauge::watch(const MachineInputs& inputs, const Capability& fitted, ThermalStatus& status) noexcept {
    m_fitted = fitted;
    m_last_ns = inputs.time_ns;
    status.gapsReadable = std::ranges::all_of(inputs.gap_um, [](const Reading& gap) { return gap.good(); });
    if (status.gapsReadable) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            m_now_um[axis] = inputs.gap_um[axis].value;
    }
    if (status.gap.phase != GapPhase::Measuring) return false;
    if (static_cast<double>(inputs.time_ns - m_since_ns) / kNanosecondPerSecond > kPatience_s) {
        status.gap.phase = GapPhase::Failed;
        status.gap.reason = Sentence(KERF_TEXT("The gap sensors stopped reading during the measurement."));
        return false;
    }
    if (!status.gapsReadable || inputs.gap_um[0].stamp_ns == m_stamp_ns) return false;
    m_stamp_ns = inputs.gap_um[0].stamp_ns;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        m_sum_um[axis] += m_now_um[axis];
    if (++m_count < kReadings) return false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        status.gap.measured_um[axis] = m_sum_um[axis] / kReadings - status.gapZero_um[axis];
    }
    status.gap.phase = GapPhase::Done;
    status.gap.time_ns = inputs.time_ns;
    return true;
}

CommandResult GapGauge::measure(ThermalStatus& status) noexcept {
    if (!m_fitted.fitted) return CommandResult::refused(m_fitted.why);
    if (!status.gapsReadable) {
        return CommandResult::refused(
            Sentence(KERF_TEXT("The gap sensors read nothing: end the program and put the test bar in the spindle.")));
    }
    if (!status.gapZeroKnown) {
        return CommandResult::refused(Sentence(KERF_TEXT("The gap sensors have no zero yet: take a reference first.")));
    }
    if (status.gap.phase == GapPhase::Measuring) {
        return CommandResult::refused(Sentence(KERF_TEXT("The origin is being measured.")));
    }
    const std::uint32_t number = status.gap.number + 1;
    status.gap = {};
    status.gap.number = number;
    status.gap.phase = GapPhase::Measuring;
    m_sum_um = {};
    m_count = 0;
    m_since_ns = m_last_ns;
    return CommandResult::ok();
}

CommandResult GapGauge::record(bool on, ThermalStatus& status) const noexcept {
    if (on && !m_fitted.fitted) return CommandResult::refused(m_fitted.why);
    status.recording = on;
    return CommandResult::ok();
}

CommandResult GapGauge::loadZero(const PerAxis& zero_um, ThermalStatus& status) noexcept {
    if (!std::ranges::all_of(zero_um, [](double value) { return std::isfinite(value); })) {
        return CommandResult::refused(Sentence(KERF_TEXT("A gap sensor's zero is not a number.")));
    }
    status.gapZero_um = zero_um;
    status.gapZeroKnown = true;
    m_zeroLoaded = true;
    return CommandResult::ok();
}

void GapGauge::beginReference() noexcept {
    m_zeroSum_um = {};
    m_zeroCount = 0;
}

void GapGauge::addReference(const ThermalStatus& status) noexcept {
    if (!status.gapsReadable) return;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        m_zeroSum_um[axis] += m_now_um[axis];
    ++m_zeroCount;
}

void GapGauge::endReference(const PerAxis& carried_um, ThermalStatus& status) const noexcept {
    if (m_zeroLoaded || m_zeroCount == 0) return;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        status.gapZero_um[axis] = m_zeroSum_um[axis] / static_cast<double>(m_zeroCount) - carried_um[axis];
    }
    status.gapZeroKnown = true;
}

}  // namespace kerf
