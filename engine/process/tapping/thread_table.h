// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace kerf::tapping {

/// One thread with the tolerances of its nut thread: metric, or unified inch (UNC, UNF).
///
/// Source: ISO 965-1, tolerance T_D2 of the pitch diameter of internal threads, grades 5 and 6, by pitch and diameter
/// range (over 2.8 to 5.6, 5.6 to 11.2, 11.2 to 22.4 mm). Position H: the lower deviation is 0.
///
/// Unified: ASME B1.1, T_D2 of class 2B = 1.3 (.0015 D^1/3 + .0015 D^1/2 + .015 P^2/3) in, length of engagement D;
/// basic size is the lower limit. Ground taps end .001 in above it to #8, .0015 in to 1/2, .0025 in beyond (H2, H3,
/// H5).
struct ThreadPreset {
    const char* name{""};  ///< "M8", "M8x1", "1/4-20"
    double diameter_mm{0.0};
    double pitch_mm{0.0};
    bool coarse{true};
    double grade5_um{0.0};  ///< unified: twice the upper limit of a ground tap
    double grade6_um{0.0};  ///< 6H; unified: 2B

    [[nodiscard]] bool metric() const noexcept { return name[0] == 'M'; }

    /// Largest engaged peak-to-peak of E_r: an axial slip s opens the pitch diameter by √3·s (60° flanks).
    [[nodiscard]] double allowedPp_um() const noexcept { return grade6_um / kSlipToDiameter; }
    /// The same with a tap at its upper limit: class 2 taps (ISO 2857) end at half of T_D2 grade 5.
    [[nodiscard]] double allowedPpWornTap_um() const noexcept {
        return (grade6_um - 0.5 * grade5_um) / kSlipToDiameter;
    }
    static constexpr double kSlipToDiameter = 1.7320508075688772;
};

/// M3 to M20, coarse then fine; then #4 to 3/4, UNC then UNF.
[[nodiscard]] std::span<const ThreadPreset> threadPresets();
/// Null when there is no such thread.
[[nodiscard]] const ThreadPreset* findThread(std::string_view name);

}  // namespace kerf::tapping
