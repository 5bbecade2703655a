// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "app/sensors/sensor_file.h"

/// Which registers are asked for together. Only registers that touch are: a module may refuse a question that spans
/// one it does not have.
namespace kerf::sensors {

struct Block {
    int function{4};
    int address{0};
    int count{0};  ///< registers, or bits for functions 1 and 2
};

/// Where one channel's registers, or its status, are in the answers of a round.
struct Place {
    std::size_t block{0};
    std::size_t offset{0};
};

struct PlannedChannel {
    std::size_t channel{0};  ///< index in SensorFile::channels
    Place value{};
    bool hasStatus{false};
    Place status{};
};

struct ReadingPlan {
    std::vector<Block> blocks{};
    std::vector<PlannedChannel> channels{};
};

inline constexpr int kMostRegisters = 120;  ///< of one question; Modbus allows 125

/// `apart`: every channel by a question of its own, for a module that has refused one that spans several.
[[nodiscard]] ReadingPlan planFor(const SensorFile& file, std::size_t module, bool apart = false);

}  // namespace kerf::sensors
