// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/boring/boring_types.h"

/// A feed schedule as a part program, for controls that Kerf has no live link to.
namespace kerf::boring {

enum class GcodeDialect : std::uint8_t {
    LinuxCnc,  ///< o<name> sub … endsub
    Macro,     ///< % O<number> … M99 %, macro variables #101…#149, which every control of that family has
};

struct GcodeParams {
    GcodeDialect dialect{GcodeDialect::LinuxCnc};
    std::string name{"kerf_schedule"};  ///< LinuxCNC: name of the subroutine, letters, digits, underscore
    std::uint32_t number{9010};         ///< Macro: number of the subroutine, 1…9999
    double deviation{0.008};            ///< largest share by which a segment's feed misses S(L), .001….1
};

inline constexpr std::size_t kMostGcodeSegments = 99;

/// One line per element, without line ends: feeds in mm/rev as macro variables, which a person may change, then one
/// straight cut per segment from Z = 0 (overhang `overhangFrom_mm`) downwards, in G95 so that the spindle's override
/// does not change the feed per revolution.
///
/// A segment is as long as its constant feed stays within `deviation` of S(L); where the schedule is clamped, one
/// segment does. The macro dialect has no % but in its first and last line, capitals, and a whole spindle speed; it
/// sets its 49 variables anew where there are more segments. Numbers have a point in every locale. Refused: values out
/// of range, or a schedule that would need more than 99 segments.
[[nodiscard]] Result<std::vector<std::string>> boringSubroutine(const BoringSchedule& schedule,
                                                                const GcodeParams& params);

}  // namespace kerf::boring
