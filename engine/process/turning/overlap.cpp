// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/overlap.h"

#include <cmath>

namespace kerf::turning {

Result<double> overlapFactor(double toolRadius_um, double depth_um, double infeed_umPerRev) {
    if (!std::isfinite(toolRadius_um) || toolRadius_um <= 0.0 || toolRadius_um > 1e6) {
        return fail(KERF_TEXT("The tool radius is %1 um; expected above 0, at most 1000000 um."),
                    SentenceArg(toolRadius_um, 3));
    }
    if (!std::isfinite(depth_um) || depth_um <= 0.0 || depth_um > toolRadius_um) {
        return fail(KERF_TEXT("The depth of cut is %1 um; expected above 0, at most the tool radius %2 um."),
                    SentenceArg(depth_um, 3), SentenceArg(toolRadius_um, 3));
    }
    if (!std::isfinite(infeed_umPerRev) || infeed_umPerRev < 0.0) {
        return fail(KERF_TEXT("The infeed is %1 um per revolution; expected 0 or more."),
                    SentenceArg(infeed_umPerRev, 3));
    }
    const double halfAngle_rad = std::acos((toolRadius_um - depth_um) / toolRadius_um);
    const double segment_um2 = toolRadius_um * toolRadius_um * halfAngle_rad -
                               toolRadius_um * (toolRadius_um - depth_um) * std::sin(halfAngle_rad);
    const double overlap = (segment_um2 - depth_um * infeed_umPerRev) / segment_um2;
    if (overlap < 0.0) {
        return fail(KERF_TEXT("An infeed of %1 um per revolution leaves no overlap; at this depth at most %2 um."),
                    SentenceArg(infeed_umPerRev, 3), SentenceArg(segment_um2 / depth_um, 3));
    }
    return overlap;
}

}  // namespace kerf::turning
