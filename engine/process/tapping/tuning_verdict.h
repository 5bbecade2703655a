// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "engine/core/sentence.h"
#include "engine/process/tapping/tuner.h"

namespace kerf::tapping {

/// How far an axis follows the programmed ramp: its acceleration against the one of an ideal axis with the same gains,
/// no load and no torque limit, at equal speed (20 to 80 % of the programmed one), speeding up into the hole and out of
/// it. The smallest share counts; of Z, which is recorded with more noise and may swing, the mean over the speeds.
///
/// Speeds and accelerations from local parabolas over ±10 ms: 2 µm noise is ±30 mm/s² of Z.
struct RampReach {
    double spindleShare{1.0};
    double zShare{1.0};
    [[nodiscard]] bool spindleSaturates() const noexcept { return spindleShare < kHeld; }
    [[nodiscard]] bool zSaturates() const noexcept { return zShare < kZHeld; }
    [[nodiscard]] RampReach lesser(const RampReach& other) const noexcept {
        return {std::min(spindleShare, other.spindleShare), std::min(zShare, other.zShare)};
    }
    static constexpr double kHeld = 0.9;  ///< a smaller share is a torque limit, not a lag
    static constexpr double kZHeld = 0.93;
};
/// @pre the tap was made with `settings` on the programmed cycle of `known`
[[nodiscard]] RampReach rampReach(const DriveParams& known, const TapSettings& settings, const TapSignals& tap);

/// Time of the command there and back.
[[nodiscard]] double holeTime_s(const DriveParams& programmed, double ramp_revPerS2);

/// What keeps a tuning out of the tolerance.
enum class LimitedBy : std::uint8_t {
    None,       ///< inside the tolerance
    Torque,     ///< the spindle cannot follow the ramp
    ZTorque,    ///< Z cannot follow the ramp
    Resonance,  ///< a structural resonance bounds the gain
    Sampling,   ///< the tick of the position loop bounds the gain
    Lag,        ///< other lags of Z bound the gain
    Noise,      ///< noise of the recorded signals exceeds the tolerance
    Trim,       ///< the learned trim is at its bound, or the machine takes none
    Tuner,      ///< the tuner asked for learns no feed-forward and no trim
    Taps,       ///< all taps are used
    Scatter,    ///< what is left differs from tap to tap
};
/// Null-terminated key, as in `kerf tapping tune --summary`.
[[nodiscard]] const char* limitKey(LimitedBy limit);

/// All that is known when a tuning has ended.
struct TuningEvidence {
    TunerSetup setup{};
    std::optional<RampReach> reach{};  ///< of the air tap and the first tap in the work, the lesser
    TapSettings kept{};
    SafeGains safe{};
    double left_um{0.0};      ///< engaged peak-to-peak with the kept settings
    double allowed_um{92.0};  ///< of the thread
    double noise_um{0.0};     ///< standard deviation of the recorded error's white part
    bool tapsUsed{false};     ///< it ended because no tap was left
};

/// Whether a tuning holds the tolerance; if not, why and what would help.
struct TuningVerdict {
    bool within{false};
    LimitedBy limitedBy{LimitedBy::None};
    std::optional<double> proposedRamp_revPerS2{};  ///< empty: the programmed one holds, or another would not help
    double programmedHole_s{0.0};                   ///< command there and back with the programmed ramp …
    std::optional<double> proposedHole_s{};         ///< … and with the proposed one
    Sentence why{};                                 ///< empty when within
    Sentence help{};                                ///< empty when within
};
/// The proposed ramp is 85 % of the acceleration that the axes reached: the rest is for scatter and overshoot.
[[nodiscard]] TuningVerdict judgeTuning(const TuningEvidence& evidence);

}  // namespace kerf::tapping
