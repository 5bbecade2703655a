// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/process/turning/cutting_process.h"

namespace kerf::turning {

/// Disturbances of the slide that are no steady tones, beside those that are. None of their numbers is known to a law.
enum class DisturbanceKind : std::uint8_t {
    Tones,     ///< three to six tones of 12 to 250 Hz, 8 Hz apart or more, .2 to .6 µm
    Drift,     ///< one tone of .3 to .6 µm that moves by 1 to 8 Hz/s, up or down
    Walk,      ///< random walk, .001 to .008 µm per sample
    Coloured,  ///< white noise through a band of 20-60 Hz (each edge ± 5 Hz), .3 to .5 µm RMS
    Steps,     ///< steps of .2 to .4 µm up or down, two to four a second at random times
    NewTone,   ///< nothing, then from half time on one tone of 40 to 200 Hz, .3 to .6 µm
};
inline constexpr std::size_t kDisturbanceKinds = 6;
inline constexpr std::array<std::string_view, kDisturbanceKinds> kDisturbanceNames{"tones",    "drift", "walk",
                                                                                   "coloured", "steps", "new-tone"};

/// d_a of one kind in µm at 5 kHz, with white noise on top. Same arguments, same digits.
[[nodiscard]] std::vector<double> drawDisturbance(DisturbanceKind kind, std::size_t samples, std::uint64_t seed,
                                                  double white_um = 0.05);

}  // namespace kerf::turning
