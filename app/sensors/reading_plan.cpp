// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/reading_plan.h"

#include <algorithm>
#include <set>

namespace kerf::sensors {
namespace {

struct Wanted {
    int function;
    int address;
    int count;
    auto operator<=>(const Wanted&) const = default;
};

Place placeOf(const std::vector<Block>& blocks, const Wanted& wanted) {
    const auto found = std::ranges::find_if(blocks, [&](const Block& block) {
        return block.function == wanted.function && wanted.address >= block.address &&
               wanted.address + wanted.count <= block.address + block.count;
    });
    return {static_cast<std::size_t>(found - blocks.begin()),
            static_cast<std::size_t>(wanted.address - found->address)};
}

}  // namespace

ReadingPlan planFor(const SensorFile& file, std::size_t module, bool apart) {
    std::set<Wanted> wanted;
    const auto valueOf = [](const Channel& channel) {
        return Wanted{channel.function, channel.address, registersOf(channel.type)};
    };
    const auto statusOf = [](const Channel& channel) {
        return Wanted{channel.status->function, channel.status->address, 1};
    };
    for (const Channel& channel : file.channels) {
        if (channel.module == module) {
            wanted.insert(valueOf(channel));
            if (channel.status) {
                wanted.insert(statusOf(channel));
            }
        }
    }
    ReadingPlan plan;
    for (const Wanted& one : wanted) {  // by function, then by address
        if (!plan.blocks.empty()) {
            Block& last = plan.blocks.back();
            const int end = std::max(last.address + last.count, one.address + one.count);
            const bool touches = !apart && last.function == one.function && one.address <= last.address + last.count;
            if (touches && end - last.address <= kMostRegisters) {
                last.count = end - last.address;
                continue;
            }
        }
        plan.blocks.push_back({one.function, one.address, one.count});
    }
    for (std::size_t i = 0; i < file.channels.size(); ++i) {
        const Channel& channel = file.channels[i];
        if (channel.module != module) {
            continue;
        }
        PlannedChannel planned;
        planned.channel = i;
        planned.value = placeOf(plan.blocks, valueOf(channel));
        planned.hasStatus = channel.status.has_value();
        if (planned.hasStatus) {
            planned.status = placeOf(plan.blocks, statusOf(channel));
        }
        plan.channels.push_back(planned);
    }
    return plan;
}

}  // namespace kerf::sensors
