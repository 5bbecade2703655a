// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/force_bounds.h"

#include <algorithm>

namespace kerf::milling {
namespace {

constexpr double kShortestPeriod_s = 0.06;
constexpr double kValuesPerRevolution = 8.0;  // RevolutionAverager::Params::maxGap_rev
constexpr double kValuesPerTooth = 4.0;
constexpr double kToothShare = 0.5;
constexpr double kBiteShare = 0.05;
constexpr double kTrustShare = 0.02;

}  // namespace

double shortestPeriod_s(const ForceSignal& signal) noexcept {
    return std::max(kShortestPeriod_s, signal.bandwidth_Hz > 0.0 ? 0.5 / signal.bandwidth_Hz : 0.0);
}

Sentence whyTooSlow(const ForceSignal& signal, double speed_rpm) noexcept {
    const double values = signal.rate_Hz * 60.0 / std::max(speed_rpm, 1.0);
    if (signal.rate_Hz <= 0.0 || values >= kValuesPerRevolution) {
        return {};
    }
    return Sentence(KERF_TEXT("At %1 rpm this force signal brings %2 values per revolution; 8 are needed."),
                    SentenceArg(speed_rpm, 0), SentenceArg(values, 1));
}

bool teethSeen(const ForceSignal& signal, double speed_rpm, int flutes) noexcept {
    const double tooth_Hz = speed_rpm / 60.0 * std::max(flutes, 1);
    return signal.rate_Hz >= kValuesPerTooth * tooth_Hz && signal.bandwidth_Hz >= kToothShare * tooth_Hz;
}

ForceZeroParams zeroParams(const Capabilities& capabilities, const MillingSetup& setup) noexcept {
    return {capabilities.force, capabilities.forceReset.fitted, kBiteShare * setup.reference_N,
            kTrustShare * setup.reference_N};
}

Sentence forceDetail(Quality quality) noexcept {
    switch (quality) {
        case Quality::Missing:
            return Sentence(KERF_TEXT("The force sensor is not plugged in."));
        case Quality::Stale:
            return Sentence(KERF_TEXT("The force signal is old."));
        case Quality::Saturated:
            return Sentence(KERF_TEXT("The force signal is at the end of its range."));
        case Quality::Bad:
        case Quality::Good:
            break;
    }
    return Sentence(KERF_TEXT("The force signal is stuck or not a number."));
}

Sentence zeroDetail(const ForceZero& zero) noexcept {
    return zero.state() == ForceZeroState::Missed
               ? Sentence(KERF_TEXT("The tool was not in the air for long enough before the cut."))
               : Sentence(KERF_TEXT("It may be wrong by %1 N."), SentenceArg(zero.doubt_N(), 1));
}

}  // namespace kerf::milling
