// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/sensors/day_recorder.h"
#include "app/sensors/sensor_file.h"
#include "app/sensors/sensor_session.h"
#include "engine/core/result.h"
#include "engine/machine/sensors/sensor_port.h"
#include "ui/services/thermal_service.h"

namespace kerf::console {

/// The sensors of a real machine on the console: the sensor file, its reading process, and the machine's port with the
/// readings joined in. GUI thread; the port is the engine's.
class ConsoleSensors {
 public:
    /// The sentence says why not; what is wrong in the file, with its key, goes to the log and to standard error.
    [[nodiscard]] static Result<std::unique_ptr<ConsoleSensors>> open(const std::string& path, MachinePort& machine);

    [[nodiscard]] MachinePort& port() noexcept { return *m_port; }
    [[nodiscard]] const sensors::SensorFile& file() const noexcept { return m_file; }
    [[nodiscard]] sensors::SensorSession& session() noexcept { return *m_session; }
    /// Names and places of the temperatures, in the order of the port's.
    [[nodiscard]] std::vector<ThermalSensorView> thermalSensors() const;
    struct GaugeFrame {
        std::size_t gauge{0};
        std::string frame{};         ///< as its keyboard wedge would type it; empty: what came is no reading
        std::string sent{};          ///< as it came
        std::optional<int> depth{};  ///< number of the measured depth, from 1, where the sensor file says it
    };
    /// What a gauge on a serial line has sent next.
    [[nodiscard]] std::optional<GaugeFrame> nextGaugeFrame();
    /// From now on every minute goes into a day file of this folder, named after the time.
    void record(const std::string& folder);
    /// A few times per second.
    void poll();

 private:
    ConsoleSensors(sensors::SensorFile file, std::unique_ptr<sensors::SensorSession> session, MachinePort& machine);

    sensors::SensorFile m_file;
    std::unique_ptr<sensors::SensorSession> m_session;
    std::unique_ptr<SensorPort> m_port;
    std::unique_ptr<sensors::DayRecorder> m_recorder;
    std::int64_t m_recordSince_ns{0};
};

/// Temperatures by name that nobody has placed on a drawing yet: in rows over it.
[[nodiscard]] std::vector<ThermalSensorView> unplacedSensors(const std::vector<std::string>& names);

}  // namespace kerf::console
