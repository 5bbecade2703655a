// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/sensor_reading.h"

#include <chrono>
#include <thread>

#include "app/files/table.h"
#include "app/sensors/monotonic.h"

namespace kerf::headless {

sensors::SensorFile sensorFile(const std::string& path) {
    try {
        return sensors::readSensorFile(path);
    } catch (const sensors::SensorFileFault& fault) {
        throw BadInput(fault.what());
    }
}

std::unique_ptr<sensors::SensorSession> sensorSession(const std::string& path) {
    auto session = std::make_unique<sensors::SensorSession>(path);
    if (const auto started = session->start(); !started) {
        throw BadInput(started.error().english());
    }
    return session;
}

std::int64_t steady_ns() noexcept {
    return sensors::monotonic_ns();
}

void pause_ms(int duration_ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(duration_ms));
}

}  // namespace kerf::headless
