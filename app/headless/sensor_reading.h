// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/sensors/sensor_file.h"
#include "app/sensors/sensor_session.h"

/// The sensor file and its reading process, for commands.
namespace kerf::headless {

/// @throws BadInput
[[nodiscard]] sensors::SensorFile sensorFile(const std::string& path);
/// Started. @throws BadInput
[[nodiscard]] std::unique_ptr<sensors::SensorSession> sensorSession(const std::string& path);
[[nodiscard]] std::int64_t steady_ns() noexcept;
void pause_ms(int duration_ms);

}  // namespace kerf::headless
