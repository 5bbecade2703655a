// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/files/table.h"

namespace kerf::files {

struct NoTemperature {
    std::size_t column{0};
    std::string why{};  ///< "is in %", "counts up evenly like a counter or a clock", …
};

struct TemperatureColumns {
    std::vector<std::size_t> columns{};
    std::vector<NoTemperature> leftOut{};
};

/// Which columns of a recorded day are temperatures. A unit in the name decides; else how the column behaves:
///   a clock or counter   moves by the same step in every row, in whole numbers from 0, or along a straight line
///   a load, a switch     steps by 10 K or more again and again, or once by half of all it ever changes (a machine's
///                        temperature has inertia)
///   a load, a current    begins 10 K below the others, or above 50, the machine at rest; or never moves
///   something else       is beyond -30…150 for most of the day, or is words
/// `known`: not asked for here (time, speed, drifts). `wanted`: taken whatever they do; their health is judged
/// elsewhere. @throws BadInput when the day looks like kelvin
[[nodiscard]] TemperatureColumns temperatureColumns(const Table& table, const std::vector<std::size_t>& known,
                                                    const std::vector<std::size_t>& wanted);

}  // namespace kerf::files
