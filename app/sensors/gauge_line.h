// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSerialPort>
#include <QTimer>
#include <functional>

#include "app/sensors/sensor_file.h"
#include "engine/machine/sensors/sensor_memory.h"

namespace kerf::sensors {

/// A gauge, or a multiplexer of gauges, on a serial line: read on its own key, or asked. Looks for its device again
/// and again, so it may be plugged in and out while the console runs.
class GaugeLine : public QObject {
    Q_OBJECT
 public:
    static constexpr int kLookAgain_ms = 1000;

    GaugeLine(const Gauge& gauge, std::uint32_t index, std::function<void(const GaugeEvent&)> take,
              QObject* parent = nullptr);

    void start() { look(); }
    /// Send the file's `ask`. False: not connected, or the gauge cannot be asked.
    bool ask();
    [[nodiscard]] bool connected() const { return m_port.isOpen(); }

 private:
    void look();
    void read();
    void take(const QByteArray& line);

    const Gauge& m_gauge;
    std::uint32_t m_index;
    std::function<void(const GaugeEvent&)> m_take;
    QSerialPort m_port;
    QTimer m_again;
    QByteArray m_text;
    bool m_noise{false};  ///< until the line ends
};

}  // namespace kerf::sensors
