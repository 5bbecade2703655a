// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tuning_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "engine/process/tapping/tap_drive.h"

namespace kerf::tapping {
namespace {

constexpr double kWindow_s = 0.010;      ///< half width of the parabola
constexpr double kRampMargin = 0.85;     ///< proposed ramp over the acceleration held
constexpr double kWeak = 0.1;            ///< share of the ramp below which a smaller ramp is no answer
constexpr double kNoisePp = 6.6;         ///< peak-to-peak of white noise over a tap, in standard deviations
constexpr double kAtBound = 0.98;        ///< of a bound is at the bound
constexpr double kAuthorityAbove = 1.6;  ///< of the initial gain: the bound that is not one of stability

struct Motion {
    std::vector<double> speed{};
    std::vector<double> accel{};
};

/// Slope and bend of local parabolas; 0 within half a window of the ends.
Motion motionOf(std::span<const double> position, double tick_s) {
    const auto half = static_cast<std::size_t>(std::max(2.0, std::round(kWindow_s / tick_s)));
    Motion out{std::vector<double>(position.size(), 0.0), std::vector<double>(position.size(), 0.0)};
    if (position.size() <= 2 * half) return out;
    const auto reach = static_cast<double>(half);
    const double mean = reach * (reach + 1.0) / 3.0;  // of i² over the window
    double slopeNorm = 0.0;
    double bendNorm = 0.0;
    for (double i = -reach; i <= reach; i += 1.0) {
        slopeNorm += i * i;
        bendNorm += (i * i - mean) * i * i;
    }
    for (std::size_t k = half; k + half < position.size(); ++k) {
        double slope = 0.0;
        double bend = 0.0;
        for (std::size_t i = 0; i <= 2 * half; ++i) {
            const double offset = static_cast<double>(i) - reach;
            const double value = position[k - half + i] - position[k];
            slope += offset * value;
            bend += (offset * offset - mean) * value;
        }
        out.speed[k] = slope / slopeNorm / tick_s;
        out.accel[k] = 2.0 * bend / bendNorm / (tick_s * tick_s);
    }
    return out;
}

/// Mean acceleration by speed while speeding up, from `begin` on, in bins of a tenth of the peak speed; bins without a
/// sample hold nothing.
constexpr std::size_t kFirstBin = 2;
constexpr std::size_t kLastBin = 8;
using BySpeed = std::array<std::optional<double>, kLastBin + 1>;

BySpeed speedingUp(const Motion& motion, std::size_t begin, double sign, double peakSpeed) {
    std::array<double, kLastBin + 1> sum{};
    std::array<double, kLastBin + 1> count{};
    for (std::size_t k = begin; k < motion.speed.size(); ++k) {
        const double share = sign * motion.speed[k] / peakSpeed;
        const auto bin = static_cast<long>(std::lround(10.0 * share));
        if (bin > static_cast<long>(kLastBin)) break;
        if (bin < static_cast<long>(kFirstBin)) continue;
        sum[static_cast<std::size_t>(bin)] += sign * motion.accel[k];
        count[static_cast<std::size_t>(bin)] += 1.0;
    }
    BySpeed out{};
    for (std::size_t bin = kFirstBin; bin <= kLastBin; ++bin) {
        if (count[bin] > 0.0) out[bin] = sum[bin] / count[bin];
    }
    return out;
}

/// Of the acceleration: the least at any speed, and the mean.
struct Share {
    double least{1.0};
    double mean{1.0};
};

Share shareAt(const BySpeed& measured, const BySpeed& ideal) {
    Share share;
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t bin = kFirstBin; bin <= kLastBin; ++bin) {
        if (!measured[bin] || !ideal[bin] || !(*ideal[bin] > 0.0)) continue;
        const double here = std::max(*measured[bin] / *ideal[bin], 0.0);
        share.least = std::min(share.least, here);
        sum += here;
        count += 1.0;
    }
    if (count > 0.0) share.mean = std::min(sum / count, 1.0);
    return share;
}

Share shareOf(std::span<const double> measured, std::span<const double> ideal, double peakSpeed, double tick_s) {
    const auto deepest = [](std::span<const double> position) {
        return static_cast<std::size_t>(std::ranges::max_element(position) - position.begin());
    };
    const Motion is = motionOf(measured, tick_s);
    const Motion might = motionOf(ideal, tick_s);
    const Share in = shareAt(speedingUp(is, 0, 1.0, peakSpeed), speedingUp(might, 0, 1.0, peakSpeed));
    const Share out =
        shareAt(speedingUp(is, deepest(measured), -1.0, peakSpeed), speedingUp(might, deepest(ideal), -1.0, peakSpeed));
    return {std::min(in.least, out.least), std::min(in.mean, out.mean)};
}

}  // namespace

RampReach rampReach(const DriveParams& known, const TapSettings& settings, const TapSignals& tap) {
    DriveParams ideal = withSettings(known, settings);
    ideal.spindleAccelMax_revPerS2 = 1e9;
    ideal.zAccelMax_mmPerS2 = 1e12;
    ideal.load_revPerS2 = ideal.loadOut_revPerS2 = ideal.thrust_mmPerS2 = 0.0;
    std::vector<double> spindle_rev(tap.z_mm.size());
    std::vector<double> z_mm(tap.z_mm.size());
    simulateTap(ideal, settings.zTrim_mm, spindle_rev, z_mm);
    if (ideal.slaved > 0.5) z_mm = predictZ(ideal, settings, tap.spindle_rev);  // Z follows the spindle as it was
    const TapTrajectory path(known.depth_rev, known.speed_rpm, known.ramp_revPerS2);
    const double peak_revPerS = path.peakSpeed_revPerS();
    return {shareOf(tap.spindle_rev, spindle_rev, peak_revPerS, known.tick_s).least,
            shareOf(tap.z_mm, z_mm, known.pitch_mm * peak_revPerS, known.tick_s).mean};
}

double holeTime_s(const DriveParams& programmed, double ramp_revPerS2) {
    return TapTrajectory(programmed.depth_rev, programmed.speed_rpm, ramp_revPerS2).end_s();
}

const char* limitKey(LimitedBy limit) {
    switch (limit) {
        case LimitedBy::Torque:
            return "torque";
        case LimitedBy::ZTorque:
            return "z_torque";
        case LimitedBy::Resonance:
            return "resonance";
        case LimitedBy::Sampling:
            return "sampling";
        case LimitedBy::Lag:
            return "lag";
        case LimitedBy::Noise:
            return "noise";
        case LimitedBy::Trim:
            return "trim";
        case LimitedBy::Tuner:
            return "tuner";
        case LimitedBy::Taps:
            return "taps";
        case LimitedBy::Scatter:
            return "scatter";
        case LimitedBy::None:
            break;
    }
    return "none";
}

namespace {

double peakTrim_mm(const TapSettings& settings) {
    double peak_mm = 0.0;
    for (const double trim_mm : settings.zTrim_mm)
        peak_mm = std::max(peak_mm, std::abs(trim_mm));
    return peak_mm;
}

/// The gain could be clearly higher without the resonance.
bool resonanceBounds(const DriveParams& fitted) {
    constexpr double kClearly = 1.5;
    DriveParams rigid = fitted;
    rigid.zResonance_Hz = 0.0;
    return fitted.zResonance_Hz > 0.0 && criticalZKp_perS(rigid) > kClearly * criticalZKp_perS(fitted);
}

LimitedBy limitOf(const TuningEvidence& e) {
    if (e.left_um <= e.allowed_um) return LimitedBy::None;
    if (e.reach && e.reach->spindleSaturates()) return LimitedBy::Torque;
    if (e.reach && e.reach->zSaturates()) return LimitedBy::ZTorque;
    const bool stability = e.safe.highest_perS < kAtBound * kAuthorityAbove * e.setup.initial.zKp_perS;
    if (stability && e.kept.zKp_perS > kAtBound * e.safe.highest_perS) {
        if (e.setup.measured && resonanceBounds(e.setup.measured->fitted)) return LimitedBy::Resonance;
        const DriveParams& assumed = e.setup.measured ? e.setup.measured->fitted : e.setup.assumed;
        const double lags_s = assumed.zTorqueLag_s + assumed.zDelay_s + 1.0 / assumed.zBandwidth_perS;
        return 0.5 * assumed.tick_s > lags_s ? LimitedBy::Sampling : LimitedBy::Lag;
    }
    if (kNoisePp * e.noise_um > e.allowed_um) return LimitedBy::Noise;
    if (e.setup.kind != TunerKind::Default) return LimitedBy::Tuner;
    if (e.tapsUsed) return LimitedBy::Taps;
    const bool trimBound = e.safe.highestTrim_mm > 0.0 && peakTrim_mm(e.kept) > kAtBound * e.safe.highestTrim_mm;
    return trimBound || !e.setup.trim ? LimitedBy::Trim : LimitedBy::Scatter;
}

void propose(TuningVerdict& verdict, const DriveParams& programmed, double share) {
    if (share < kWeak) {
        verdict.help = Sentence(KERF_TEXT("A lower gear, or a tap that needs less torque."));
        return;
    }
    const double ramp_revPerS2 = kRampMargin * share * programmed.ramp_revPerS2;
    verdict.proposedRamp_revPerS2 = ramp_revPerS2;
    verdict.proposedHole_s = holeTime_s(programmed, ramp_revPerS2);
    verdict.help = Sentence(KERF_TEXT("Program a ramp of %1 rev/s², then tune again: %2 s per hole instead of %3 s."),
                            {ramp_revPerS2, 0}, {*verdict.proposedHole_s, 2}, {verdict.programmedHole_s, 2});
}

void explain(TuningVerdict& verdict, const TuningEvidence& e) {
    const SentenceArg left{e.left_um, 0};
    const SentenceArg allowed{e.allowed_um, 0};
    const double ramp_revPerS2 = e.setup.assumed.ramp_revPerS2;
    const auto helps = [&](const char* text) { verdict.help = Sentence(text); };
    switch (verdict.limitedBy) {
        case LimitedBy::None:
            return;
        case LimitedBy::Torque:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: the spindle reaches only %3 rev/s² and "
                                             "cannot follow the programmed ramp."),
                                   left, allowed, {e.reach->spindleShare * ramp_revPerS2, 0});
            return propose(verdict, e.setup.assumed, e.reach->spindleShare);
        case LimitedBy::ZTorque:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: Z reaches only %3 rev/s² and cannot "
                                             "follow the programmed ramp."),
                                   left, allowed, {e.reach->zShare * ramp_revPerS2, 0});
            return propose(verdict, e.setup.assumed, e.reach->zShare);
        case LimitedBy::Resonance:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: a resonance of Z bounds its gain."),
                                   left, allowed);
            return helps(KERF_TEXT("A filter at the resonance in the drive of Z, or a lower speed."));
        case LimitedBy::Sampling:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: the slow tick of the position loop "
                                             "bounds the gain of Z."),
                                   left, allowed);
            return helps(KERF_TEXT("A shorter tick of the control's position loop, or a lower speed."));
        case LimitedBy::Lag:
            verdict.why =
                Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: lag in Z bounds its gain."), left, allowed);
            return helps(KERF_TEXT("A faster velocity loop of Z, or a lower speed."));
        case LimitedBy::Noise:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: the recorded signals are too noisy "
                                             "(%3 µm) to learn from."),
                                   left, allowed, {e.noise_um, 1});
            return helps(KERF_TEXT("Finer encoders, or a filter on the recorded positions."));
        case LimitedBy::Trim:
            verdict.why =
                Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: the trim of Z cannot take more."), left, allowed);
            return helps(KERF_TEXT("A lower speed, or a control that takes a trim of the Z command."));
        case LimitedBy::Tuner:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: this tuner changes the gain alone."),
                                   left, allowed);
            return helps(KERF_TEXT("The default tuner, which learns feed-forward and trim too."));
        case LimitedBy::Taps:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: all taps are used."), left, allowed);
            return helps(KERF_TEXT("Tune again from here: it goes on with what it has learned."));
        case LimitedBy::Scatter:
            verdict.why = Sentence(KERF_TEXT("%1 µm is left, %2 µm is allowed: what is left differs from tap to tap."),
                                   left, allowed);
            return helps(KERF_TEXT("A lower speed, an even load, or a sharp tap."));
    }
}

}  // namespace

TuningVerdict judgeTuning(const TuningEvidence& evidence) {
    TuningVerdict verdict;
    verdict.limitedBy = limitOf(evidence);
    verdict.within = verdict.limitedBy == LimitedBy::None;
    verdict.programmedHole_s = holeTime_s(evidence.setup.assumed, evidence.setup.assumed.ramp_revPerS2);
    explain(verdict, evidence);
    return verdict;
}

}  // namespace kerf::tapping
