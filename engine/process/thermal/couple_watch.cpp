// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/couple_watch.h"

#include <algorithm>

namespace kerf {
namespace {

using thermal::SensorState;

constexpr std::uint16_t kRepeatsUntilStuck = 20;

static_assert(static_cast<int>(CoupleState::Disagrees) == static_cast<int>(SensorState::Disagrees));

}  // namespace

const char* sickCoupleText(CoupleState state) noexcept {
    switch (state) {
        case CoupleState::Open:
            return KERF_TEXT("Thermocouple %1 is open.");
        case CoupleState::Short:
            return KERF_TEXT("Thermocouple %1 is shorted.");
        case CoupleState::Stuck:
            return KERF_TEXT("Thermocouple %1 is stuck.");
        case CoupleState::Noisy:
            return KERF_TEXT("Thermocouple %1 is noisy.");
        case CoupleState::Offset:
            return KERF_TEXT("Thermocouple %1 has jumped away from its neighbours.");
        case CoupleState::Healthy:
        case CoupleState::Suspect:
        case CoupleState::Disagrees:
        case CoupleState::Unread:
            break;
    }
    return KERF_TEXT("Thermocouple %1 disagrees with its neighbours.");
}

void CoupleWatch::report(const TemperatureFrame& frame, const LiveModel* live, ThermalStatus& status) noexcept {
    status.count = std::min<std::uint16_t>(frame.count, kMaxTemperatures);
    for (std::size_t k = 0; k < status.count; ++k) {
        const Reading& reading = frame.temp_degC[k];
        const auto value_degC = static_cast<float>(reading.value);
        CoupleState state = CoupleState::Healthy;
        if (!reading.good()) {
            state = CoupleState::Unread;
        } else {
            m_repeats[k] =
                value_degC == m_last_degC[k] ? static_cast<std::uint16_t>(m_repeats[k] + 1) : std::uint16_t{0};
            if (reading.value > thermal::kHighestTemp_degC) state = CoupleState::Open;
            if (reading.value < thermal::kLowestTemp_degC) state = CoupleState::Short;
            if (state == CoupleState::Healthy && m_repeats[k] >= kRepeatsUntilStuck) state = CoupleState::Stuck;
        }
        m_last_degC[k] = value_degC;
        status.temp_degC[k] = value_degC;
        status.couple[k] = state;
    }
    status.inModel = 0;
    if (live == nullptr) return;
    for (std::size_t i = 0; i < live->estimator.sensors(); ++i) {
        const std::uint16_t channel = live->channel[i];
        if (channel >= kMaxTemperatures) continue;
        status.inModel |= std::uint64_t{1} << channel;
        status.couple[channel] = static_cast<CoupleState>(live->estimator.health().state(i));
    }
}

}  // namespace kerf
