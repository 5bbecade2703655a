// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/sensors/channel_judge.h"
#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/machine/memory_link.h"

namespace kerf::sensors {

/// Channels that are pins of kerf-hal, read from the memory it shares. LinuxCNC need not be there, and may come back.
class HalSource {
 public:
    HalSource(const SensorFile& file, std::vector<ChannelJudge>& judges,
              const std::string& memory = linuxcnc::kLinkName);
    void read();

 private:
    const SensorFile& m_file;
    std::vector<ChannelJudge>& m_judges;
    MemoryLink<linuxcnc::LinkMemory> m_link;
    linuxcnc::LinkMemory* m_memory{nullptr};
    std::uint64_t m_written{0};
};

}  // namespace kerf::sensors
