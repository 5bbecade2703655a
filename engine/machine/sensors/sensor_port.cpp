// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/sensors/sensor_port.h"

#include <algorithm>
#include <chrono>

namespace kerf {
namespace {

/// The clock of the reading process's stamps: a simulated machine's own time says nothing about its silence.
std::int64_t monotonic_ns() noexcept {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

SensorPort::SensorPort(MachinePort& machine, Params params) : m_machine(machine), m_params(std::move(params)) {
    m_params.temperatures.resize(std::min(m_params.temperatures.size(), kMaxTemperatures));
    adoptCapabilities();
}

SensorPort::~SensorPort() = default;

Result<void> SensorPort::connect() {
    m_link = std::make_unique<MemoryLink<sensors::SensorMemory>>(m_params.memoryName);
    auto connected = m_machine.connect();
    adoptCapabilities();
    return connected;
}

void SensorPort::disconnect() noexcept {
    m_machine.disconnect();
    m_link.reset();
}

/// A machine that comes back different has its capabilities elsewhere; one who still reads the old ones may go on.
void SensorPort::adoptCapabilities() noexcept {
    const Capabilities* seen = &m_machine.capabilities();
    if (seen == m_adopted) {
        return;
    }
    const std::size_t current = m_current.load(std::memory_order_relaxed);
    const std::size_t next = m_adopted == nullptr ? 0 : current + 1;
    if (next >= kMachinesSeen) {
        return;
    }
    Capabilities& capabilities = m_capabilities[next];
    capabilities = *seen;
    if (!m_params.temperatures.empty()) {
        capabilities.temperatures = {true, {}};
        capabilities.temperatureCount = static_cast<std::uint16_t>(m_params.temperatures.size());
        // Without a work offset that reads back the loop still advises, and says why it does not shift.
        capabilities.process[static_cast<std::size_t>(ProcessId::Thermal)] = {true, {}};
    }
    m_adopted = seen;
    m_current.store(next, std::memory_order_release);
}

bool SensorPort::takeFrame() noexcept {
    sensors::SensorMemory* memory = m_link != nullptr ? m_link->take() : nullptr;
    if (memory == nullptr) {
        return false;
    }
    sensors::SensorFrame& seen = m_seen;
    return memory->frames.latest(seen) && monotonic_ns() - seen.written_ns < kSilence_ns;
}

void SensorPort::read(std::int64_t now_ns, MachineInputs& inputs) noexcept {
    m_machine.read(now_ns, inputs);
    adoptCapabilities();
    const bool alive = takeFrame();
    bool asked = true;
    bool any = false;
    const auto readingOf = [&](std::uint16_t channel) -> Reading {
        if (!alive || channel >= m_seen.count || channel >= sensors::kMaxChannels) {
            return {0.0, inputs.time_ns, alive ? Quality::Missing : Quality::Stale};
        }
        const sensors::ChannelValue& value = m_seen.channel[channel];
        return {value.value, inputs.time_ns - (m_seen.written_ns - value.stamp_ns), value.quality};
    };
    if (!m_params.temperatures.empty()) {
        for (std::size_t k = 0; k < m_params.temperatures.size(); ++k) {
            const std::uint16_t channel = m_params.temperatures[k];
            m_frame.temp_degC[k] = readingOf(channel);
            any = any || m_frame.temp_degC[k].good();
            asked =
                asked && alive && m_seen.channel[channel % sensors::kMaxChannels].cause != sensors::Cause::NotYetRead;
        }
        m_frame.count = static_cast<std::uint16_t>(m_params.temperatures.size());
        m_frame.revision = alive ? m_seen.beat : m_frame.revision;
        inputs.temperatures = any && asked ? &m_frame : nullptr;
    }
    if (m_params.speed) {
        inputs.spindleSpeed_rpm = readingOf(*m_params.speed);
    }
}

}  // namespace kerf
