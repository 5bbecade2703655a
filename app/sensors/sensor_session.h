// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/machine/memory_link.h"
#include "engine/machine/sensors/sensor_memory.h"

namespace kerf::sensors {

/// The reading process of one sensor file, started beside this program and started again when it dies or hangs, and the
/// memory it hands its values over in. One thread; keep() a few times per second.
class SensorSession {
 public:
    static constexpr std::int64_t kHung_ns = 5'000'000'000;
    static constexpr std::int64_t kRestart_ns = 1'000'000'000;

    explicit SensorSession(std::string file);
    SensorSession(const SensorSession&) = delete;
    SensorSession& operator=(const SensorSession&) = delete;
    ~SensorSession();

    /// The sentence says why the program beside this one cannot be started.
    [[nodiscard]] Result<void> start();
    void keep();
    /// The newest frame; false when there is none, or it is older than a second.
    [[nodiscard]] bool latest(SensorFrame& frame) noexcept;
    /// Readings of gauges since the last call, one by one.
    [[nodiscard]] bool nextGauge(GaugeEvent& event) noexcept;
    [[nodiscard]] bool gaugeConnected(std::size_t gauge) noexcept;
    void askGauge(std::size_t gauge) noexcept;

    [[nodiscard]] const std::string& memoryName() const noexcept { return m_memoryName; }
    [[nodiscard]] pid_t process() const noexcept { return m_process; }
    /// How often it had to be started again.
    [[nodiscard]] int restarts() const noexcept { return m_restarts; }

 private:
    [[nodiscard]] bool spawn();
    void end();

    std::string m_file;
    std::string m_memoryName;
    std::unique_ptr<MemoryLink<SensorMemory>> m_link;
    pid_t m_process{-1};
    int m_toProcess{-1};
    int m_restarts{0};
    std::int64_t m_startAt_ns{0};
    std::int64_t m_lastBeat_ns{0};
    std::uint64_t m_beat{0};
    SensorMemory* m_gaugeMemory{nullptr};
    std::uint64_t m_nextGauge{0};
};

}  // namespace kerf::sensors
