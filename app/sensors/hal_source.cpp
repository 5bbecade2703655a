// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/hal_source.h"

#include "app/sensors/monotonic.h"

namespace kerf::sensors {

HalSource::HalSource(const SensorFile& file, std::vector<ChannelJudge>& judges, const std::string& memory)
    : m_file(file), m_judges(judges), m_link(memory) {}

void HalSource::read() {
    linuxcnc::LinkMemory* memory = m_link.take();
    if (memory == nullptr || memory->magic.load(std::memory_order_acquire) != linuxcnc::LinkMemory::kMagic) {
        return;
    }
    if (memory != m_memory) {
        m_memory = memory;
        m_written = memory->temperatures.written();  // a bridge that was killed has left its last ones behind
    }
    linuxcnc::HalTemperatures seen;
    const std::uint64_t written = memory->temperatures.written();
    if (written == m_written || !memory->temperatures.latest(seen)) {
        return;  // nothing new: the channels age
    }
    m_written = written;
    const std::int64_t now_ns = monotonic_ns();
    for (std::size_t i = 0; i < m_file.channels.size(); ++i) {
        const Channel& channel = m_file.channels[i];
        if (m_file.modules[channel.module].transport != Transport::Hal) {
            continue;
        }
        const auto pin = static_cast<std::size_t>(channel.pin);
        if ((seen.linked >> pin & 1U) == 0U) {
            m_judges[i].refuse(Cause::NotLinked, now_ns);
        } else if ((seen.fault >> pin & 1U) != 0U) {
            m_judges[i].refuse(Cause::Fault, now_ns);
        } else {
            m_judges[i].takeValue(seen.temp_degC[pin], now_ns);
        }
    }
}

}  // namespace kerf::sensors
