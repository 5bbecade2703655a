// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/sensor_poller.h"

#include <algorithm>
#include <map>

#include "app/sensors/hal_source.h"
#include "app/sensors/monotonic.h"

namespace kerf::sensors {
namespace {

constexpr std::int64_t kShortestPatience_ns = 500 * kMillisecond_ns;

}  // namespace

std::int64_t staleAfter_ns(const Module& module) {
    if (module.transport == Transport::Hal) {
        return kShortestPatience_ns;
    }
    return std::max(kShortestPatience_ns, (3 * module.period_ms + module.timeout_ms) * kMillisecond_ns);
}

SensorPoller::SensorPoller(SensorFile file, SensorMemory& memory, QObject* parent)
    : QObject(parent), m_file(std::move(file)), m_memory(memory) {
    m_judges.reserve(m_file.channels.size());
    for (const Channel& channel : m_file.channels) {
        m_judges.emplace_back(channel);
        m_stale_ns.push_back(staleAfter_ns(m_file.modules[channel.module]));
    }
    makeLines();
    for (std::size_t i = 0; i < m_file.gauges.size(); ++i) {
        m_gauges.push_back(
            std::make_unique<GaugeLine>(m_file.gauges[i], static_cast<std::uint32_t>(i),
                                        [this](const GaugeEvent& event) { m_memory.gauges.push(event); }));
    }
    m_publish.setInterval(static_cast<int>(kPublishEvery_ns / kMillisecond_ns));
    connect(&m_publish, &QTimer::timeout, this, &SensorPoller::publish);
}

SensorPoller::~SensorPoller() = default;

/// A line per TCP module and per serial device.
void SensorPoller::makeLines() {
    std::map<std::string, std::vector<std::size_t>> onDevice;
    bool hal = false;
    for (std::size_t m = 0; m < m_file.modules.size(); ++m) {
        const Module& module = m_file.modules[m];
        if (std::ranges::none_of(m_file.channels, [m](const Channel& channel) { return channel.module == m; })) {
            continue;
        }
        if (module.transport == Transport::Tcp) {
            m_lines.push_back(std::make_unique<ModbusLine>(m_file, std::vector{m}, m_judges));
        } else if (module.transport == Transport::Rtu) {
            onDevice[module.device].push_back(m);
        } else {
            hal = true;
        }
    }
    for (const auto& [device, modules] : onDevice) {
        m_lines.push_back(std::make_unique<ModbusLine>(m_file, modules, m_judges));
    }
    if (hal) {
        m_hal = std::make_unique<HalSource>(m_file, m_judges);
    }
}

void SensorPoller::start() {
    for (const auto& line : m_lines) {
        line->start();
    }
    for (const auto& gauge : m_gauges) {
        gauge->start();
    }
    publish();
    m_publish.start();
}

void SensorPoller::publish() {
    if (m_hal) {
        m_hal->read();
    }
    const std::int64_t now_ns = monotonic_ns();
    ++m_frame.beat;
    m_frame.written_ns = now_ns;
    m_frame.count = static_cast<std::uint32_t>(std::min(m_judges.size(), kMaxChannels));
    for (std::size_t i = 0; i < m_frame.count; ++i) {
        m_judges[i].age(now_ns, m_stale_ns[i]);
        m_frame.channel[i] = m_judges[i].value();
    }
    m_memory.frames.push(m_frame);
    for (std::size_t i = 0; i < std::min(m_gauges.size(), m_memory.gaugeConnected.size()); ++i) {
        m_memory.gaugeConnected[i].store(m_gauges[i]->connected(), std::memory_order_relaxed);
    }
}

}  // namespace kerf::sensors
