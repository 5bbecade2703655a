// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/turning/turning_memory.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kerf {
namespace {

constexpr std::size_t kPartsLookedAt = 5;
constexpr double kOddGain = 1.5;

double gain(const TurningProcess& process) {
    return (process.b0 + process.b1) / (1.0 - process.a1);
}

}  // namespace

bool sameCut(const TurningSetup& a, const TurningSetup& b) noexcept {
    return a.depth_um == b.depth_um && a.spindleSpeed_rpm == b.spindleSpeed_rpm && a.feed_umPerRev == b.feed_umPerRev &&
           a.toolRadius_um == b.toolRadius_um;
}

TurningPast turningPast(std::span<const TurningPartView> parts, const TurningSetup& setup) {
    TurningPast past;
    TurningRecall& out = past.recall;
    std::vector<const TurningPartView*> same;  // newest first
    for (auto part = parts.rbegin(); part != parts.rend() && same.size() < kPartsLookedAt; ++part) {
        if (part->complete && !part->leftOut && !part->record.leftLoop && sameCut(part->record.setup, setup)) {
            same.push_back(&*part);
        }
    }
    double low = 0.0;
    double high = 0.0;
    for (const TurningPartView* part : same) {
        const TurningProcess& process = part->record.lawProcess;
        const double g = gain(process);
        if (!part->record.identification.sure || !std::isfinite(g) || g <= 0.0) {
            continue;
        }
        if (!out.processKnown) {  // the newest
            out.process = process;
            out.processKnown = true;
            past.view.part = part->number;
            low = high = g;
        }
        ++past.view.counted;
        low = std::min(low, g);
        high = std::max(high, g);
    }
    out.processKnown = out.processKnown && high <= kOddGain * low;
    if (!out.processKnown) {
        past.view.part.reset();
    }
    return past;
}

}  // namespace kerf
