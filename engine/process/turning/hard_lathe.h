// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/process/turning/disturbances.h"

namespace kerf::turning {

/// A lathe that bites, drawn from a seed; seed 0 is the reference lathe. The laws stay tuned to the reference process.
///
///   process      dc gain .7 to 1.4 times (log-uniform), pole a1 uniform .86-.885, zero −b1/b0 uniform .952-.965
///   slide        pole uniform .992-.996 (R1, B1)
///   path         one more sample of delay in every second lathe
///   spindle      uniform 10-30 rev/s
///   sensors      noise .5 to 3 times (log-uniform) of 20 nm and 5 mN
///   cut          uniform 2-10 µm
///   disturbance  one of the six kinds (disturbances.h), in every second lathe two; white part uniform .02-.1 µm
struct HardLathe {
    std::uint64_t seed{0};
    ProcessParams process{};
    double slidePole{0.994};
    int extraDelay{0};
    double spindle_rps{17.2};
    double positionNoise_um{0.02};
    double forceNoise_N{0.005};
    double depth_um{6.0};
    double white_um{0.05};
    std::array<DisturbanceKind, 2> kinds{};
    std::size_t kindCount{0};  ///< 0: the paper's tones
};
[[nodiscard]] HardLathe hardLathe(std::uint64_t seed);

/// Its d_a in µm at 5 kHz. @pre lathe.kindCount > 0
[[nodiscard]] std::vector<double> disturbanceOf(const HardLathe& lathe, std::size_t samples);

}  // namespace kerf::turning
