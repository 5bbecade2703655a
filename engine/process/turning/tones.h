// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace kerf::turning {

struct ToneSpec {
    double frequency_Hz{0.0};
    double amplitude_um{0.0};
    double phase_rad{0.0};
};
/// The paper's disturbance at the slide, phases 0.
inline constexpr std::array<ToneSpec, 5> kPaperTones{
    {{17.0, 0.5}, {52.0, 0.4}, {86.0, 0.25}, {113.0, 0.25}, {120.0, 0.6}}};

}  // namespace kerf::turning
