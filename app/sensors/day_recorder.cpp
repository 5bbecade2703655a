// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/day_recorder.h"

#include <fmt/format.h>

namespace kerf::sensors {

DayRecorder::DayRecorder(const std::string& path, const SensorFile& file, double period_s)
    : m_out(path, std::ios::binary | std::ios::trunc),
      m_temperatures(channelsOf(file, Quantity::Temperature)),
      m_speed(channelsOf(file, Quantity::Speed)),
      m_period_s(period_s) {
    m_out << "t_min" << (m_speed.empty() ? "" : ",rpm");
    for (const std::size_t channel : m_temperatures) {
        m_out << ',' << file.channels[channel].name;
    }
    m_out << '\n' << std::flush;
}

void DayRecorder::look(double time_s, const SensorFrame* frame) {
    if (time_s < m_rows * m_period_s) {
        return;
    }
    const auto field = [frame](std::size_t channel) {
        const bool good =
            frame != nullptr && channel < frame->count && frame->channel[channel].quality == Quality::Good;
        return good ? fmt::format(",{:.6g}", frame->channel[channel].value) : std::string(",");
    };
    std::string row = fmt::format("{:.6g}", (m_rows - kBaselineRows) * m_period_s / 60.0);
    for (const std::size_t channel : m_speed) {
        row += field(channel);
    }
    for (const std::size_t channel : m_temperatures) {
        row += field(channel);
    }
    m_out << row << '\n' << std::flush;
    // A row that was slept through is not invented: time goes on, the file has a gap.
    m_rows = static_cast<int>(time_s / m_period_s) + 1;
}

}  // namespace kerf::sensors
