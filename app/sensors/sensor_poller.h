// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/sensors/channel_judge.h"
#include "app/sensors/gauge_line.h"
#include "app/sensors/modbus_line.h"
#include "app/sensors/sensor_file.h"
#include "engine/machine/sensors/sensor_memory.h"

namespace kerf::sensors {

class HalSource;

/// Reads everything of one sensor file, each line for itself, and publishes all channels every 100 ms. Needs an event
/// loop; nothing in it blocks.
class SensorPoller : public QObject {
    Q_OBJECT
 public:
    /// `memory` outlives the poller.
    SensorPoller(SensorFile file, SensorMemory& memory, QObject* parent = nullptr);
    ~SensorPoller() override;

    void start();
    [[nodiscard]] const SensorFile& file() const noexcept { return m_file; }
    [[nodiscard]] const std::vector<std::unique_ptr<ModbusLine>>& lines() const noexcept { return m_lines; }
    /// As it stands now, published or not.
    [[nodiscard]] const ChannelValue& value(std::size_t channel) const { return m_judges.at(channel).value(); }
    /// Ask gauge `index` for a reading.
    bool askGauge(std::size_t index) { return index < m_gauges.size() && m_gauges[index]->ask(); }

 private:
    void makeLines();
    void publish();

    SensorFile m_file;
    SensorMemory& m_memory;
    std::vector<ChannelJudge> m_judges{};
    std::vector<std::int64_t> m_stale_ns{};  ///< per channel: how long without an answer is too long
    std::vector<std::unique_ptr<ModbusLine>> m_lines{};
    std::vector<std::unique_ptr<GaugeLine>> m_gauges{};
    std::unique_ptr<HalSource> m_hal;
    QTimer m_publish;
    SensorFrame m_frame{};
};

/// How long a module may be silent before its channels are stale: three periods and a time-out, half a second at least.
[[nodiscard]] std::int64_t staleAfter_ns(const Module& module);

}  // namespace kerf::sensors
