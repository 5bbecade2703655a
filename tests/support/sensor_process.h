// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <new>
#include <string>
#include <vector>

#include "engine/machine/sensors/sensor_port.h"

namespace kerf::test {

/// What the reading process does, by hand; started anew as often as one likes.
class SensorProcess {
 public:
    explicit SensorProcess(std::string name) : m_name(std::move(name)) {
        (void)shm_unlink(m_name.c_str());
        const int file = shm_open(m_name.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600);
        const bool sized = ftruncate(file, sizeof(sensors::SensorMemory)) == 0;
        void* block = mmap(nullptr, sizeof(sensors::SensorMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
        m_memory = sized ? new (block) sensors::SensorMemory() : nullptr;
        m_memory->magic = sensors::SensorMemory::kMagic;
    }
    SensorProcess(const SensorProcess&) = delete;
    SensorProcess& operator=(const SensorProcess&) = delete;
    ~SensorProcess() {
        munmap(m_memory, sizeof(sensors::SensorMemory));
        (void)shm_unlink(m_name.c_str());
    }
    /// One frame, written `old_s` ago; each value was read .4 s before.
    void write(const std::vector<double>& temps_degC, Quality quality = Quality::Good, double old_s = 0.0) {
        sensors::SensorFrame frame;
        frame.beat = ++m_beat;
        frame.written_ns =
            std::chrono::steady_clock::now().time_since_epoch().count() - static_cast<std::int64_t>(old_s * 1e9);
        frame.count = static_cast<std::uint32_t>(temps_degC.size());
        for (std::size_t i = 0; i < temps_degC.size(); ++i) {
            frame.channel[i] = {temps_degC[i], frame.written_ns - 400'000'000, quality, sensors::Cause::None, 1};
        }
        m_memory->frames.push(frame);
    }

 private:
    std::string m_name;
    sensors::SensorMemory* m_memory{nullptr};
    std::uint64_t m_beat{0};
};

}  // namespace kerf::test
