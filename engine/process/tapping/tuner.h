// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/sentence.h"
#include "engine/process/tapping/contour_error.h"
#include "engine/process/tapping/stability_probe.h"

namespace kerf::tapping {

enum class TunerKind : std::uint8_t {
    Paper,    ///< K(n+1) = K(n) − η (S(n) − S(n−1)), as printed
    Signed,   ///< the same with the sign of the last gain change
    Gain,     ///< one-parameter search on K_pz by the predicted SAEC
    Default,  ///< gain, feed-forward from the error record, iterative refinement
};
/// Null-terminated key, as on the command line and in the database.
[[nodiscard]] const char* tunerKey(TunerKind kind);

/// All a tuner knows before the first tap.
struct TunerSetup {
    TunerKind kind{TunerKind::Default};
    DriveParams assumed{};  ///< cycle (pitch, depth, speed, ramp, tick) as programmed; servo constants as assumed
    TapSettings initial{};
    int maxTaps{8};                          ///< the first tap with the initial gains counts
    double eta{0.03};                        ///< step of `paper` and `signed`, 1/(s·mm)
    bool probe{false};                       ///< `paper`: second tap at −3 % instead of S(−1) = 0
    std::optional<MeasuredLoop> measured{};  ///< by the probe in the air; the safe set then rests on it
    bool trim{true};  ///< `default`: the machine takes a trim of the Z command; else gain and feed-forward only
};

/// Answer to one tap.
struct TunerStep {
    bool accepted{false};  ///< the tap's settings became the ones to fall back to
    bool finished{false};  ///< no further tap; `next` holds the settings to keep
    bool counted{true};    ///< false: too many samples missing, the same tap is asked for again
    TapSettings next{};
    SafeGains safe{};
    double expectedSaec_mm{0.0};  ///< of the next tap; 0: not predicted
    Sentence reason{};
};

/// Trial-tap tuner: a state machine fed with recorded taps, each made with the settings it asked for last.
///
/// It sees the recorded signals, the initial gains and the assumed constants (moved to what the probe in the air has
/// measured), nothing of the true drive. Every proposal
/// stays inside safeGains(). observe() allocates and takes milliseconds: between taps, never in the cycle.
class Tuner {
 public:
    Tuner() = default;
    Tuner(const Tuner&) = delete;
    Tuner& operator=(const Tuner&) = delete;
    virtual ~Tuner() = default;

    /// Settings of the tap to make now; the initial ones before the first.
    [[nodiscard]] virtual const TapSettings& settings() const = 0;
    virtual TunerStep observe(const TapSignals& tap) = 0;
    /// Forget the last proposal and return to the settings last accepted.
    virtual void rollBack() = 0;
};

[[nodiscard]] std::unique_ptr<Tuner> makeTuner(const TunerSetup& setup);

/// Share of samples that may be missing before a tap no longer counts.
inline constexpr double kMaxMissingShare = 0.05;
/// Wide clamp of `paper`, which has no other bound: share of the initial gain.
inline constexpr double kPaperLowest = 0.15;
inline constexpr double kPaperHighest = 3.0;

}  // namespace kerf::tapping
