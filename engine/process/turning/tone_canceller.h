// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <span>

#include "engine/process/turning/broadband_predictor.h"
#include "engine/process/turning/depth_path.h"
#include "engine/process/turning/tone_finder.h"
#include "engine/process/turning/tone_tracker.h"

namespace kerf::turning {

/// Where the cut is without the law: the level of x_i, learned as the mean of x_i − path(w) over the shape of the
/// entry. A law that acts on x_i minus this reference regulates the depth error and leaves the cut alone.
class CutReference {
 public:
    /// `memory` per sample: 1 s or 2 s at 5 kHz.
    double update_um(double untreated_um, double shape, double memory = kMemory) noexcept {
        m_top_um = memory * m_top_um + untreated_um * shape;
        m_bottom = memory * m_bottom + shape * shape;
        return m_bottom > 0.0 ? m_top_um / m_bottom * shape : 0.0;
    }
    void reset() noexcept { m_top_um = m_bottom = 0.0; }

    static constexpr double kMemory = 0.9998;
    static constexpr double kLongMemory = 0.9999;

 private:
    double m_top_um{0.0};
    double m_bottom{0.0};
};

/// Takes the slow mean out of a command: whatever the law, a lasting trim cannot change the mean force.
class MeanGuard {
 public:
    static constexpr double kShare = 4e-4;
    static constexpr double kHastyShare = 1e-3;
    /// `share` per sample: .5 s at 5 kHz, .2 s when hasty.
    double pass_um(double command_um, double share = kShare) noexcept {
        m_mean_um += share * (command_um - m_mean_um);
        return command_um - m_mean_um;
    }
    void reset() noexcept { m_mean_um = 0.0; }

 private:
    double m_mean_um{0.0};
};

/// The default law: a broadband prediction with tones on top of it.
///
///   m = x_i − path(w)              what x_i would be without the trim
///   m = c·s + Σ tones + noise      ToneTracker (Kalman, drifting frequencies); the tones come from ToneFinder
///   r = m − reference − β·Σ tones  what the tones leave
///   w = −β·Σ tone_j / path(ω_j) − inverse path of v(r), v the prediction of BroadbandPredictor
///
/// Two predictions run side by side, one of m as it is and one of what the tones leave. Because path is known, what
/// either would leave of x_i is known without trying it: e_m and e_r. β minimises the mean square of (1 − β) e_m + β
/// e_r over the last .1 s, 0 ≤ β ≤ 1: tones that are none (a walk, steps, coloured noise) fade out by themselves.
///
/// The level c (the cut itself) is estimated but never commanded: the prediction acts on m minus the cut's own level,
/// which is the mean of the last second (two from the force alone), so the law cannot remove the cut; on the machine
/// the slow mean (.5 s) is taken out of the prediction as well. White noise is not predicted, so nothing is fed back of
/// it.
///
/// At each tone the loop is that of an integrator in the tone's frame; the prediction is an internal-model loop of
/// bounded gain (docs/turning.md). The prediction acts from .2 s on; tones from the end of the first search on (.25 s),
/// or once known tones explain the signal. When what is left is larger than the disturbance would be without the law
/// for .2 s, the law lets go, listens and starts again: so it is not worse than open loop for long. Sign: x_i grows
/// with w by path(). Units µm. update() runs in the cycle: no allocation, lock, throw or I/O; its cost is bounded by
/// eight tones (docs/performance.md).
class ToneCanceller {
 public:
    struct Params {
        double sampleRate_Hz{kSampleRate_Hz};
        std::size_t revolutionSamples{291};
        bool meanGuard{false};  ///< take the slow mean out of the prediction too: no trim leans to one side for long
        bool forceOnly{false};  ///< x_i comes from the force: tones at spindle harmonics leak slowly
        ToneTracker::Params tracker{};
        double levelVariance_um2{100.0};
        std::array<double, kMaxTones> knownTones_Hz{};
        std::size_t knownCount{0};
    };
    ToneCanceller(const Params& params, const DepthPath& path) noexcept;

    /// x_i of this sample (measured or observed); returns the command for the next sample, µm.
    double update(double inner_um) noexcept;
    void reset() noexcept;
    /// The command that really acts from now on (trim limits); call after update() when it differs.
    void setApplied(double command_um) noexcept { m_command_um = command_um; }
    /// The command that acts in the sample to come.
    [[nodiscard]] double applied_um() const noexcept { return m_command_um; }
    void setProcess(const ProcessParams& process) noexcept;
    /// No trim but keep listening (advise, entry of the cut).
    void setSilent(bool silent) noexcept { m_silent = silent; }

    [[nodiscard]] const ToneTracker& tracker() const noexcept { return m_tracker; }
    [[nodiscard]] bool acting() const noexcept { return m_acting; }
    /// Level, c·s: where the cut would be without tones.
    [[nodiscard]] double level_um() const noexcept { return m_reference_um; }
    /// Mean square of x_i about its level, and what it would be without the law, over the last ~.1 s.
    [[nodiscard]] double remaining_um2() const noexcept { return m_remaining_um2; }
    [[nodiscard]] double untreated_um2() const noexcept { return m_untreated_um2; }
    /// Of this sample: x_i about its level as it would be without the law, µm.
    [[nodiscard]] double untreatedNow_um() const noexcept { return m_untreatedNow_um; }
    /// Of this sample: x_i beyond what the tones foresaw.
    [[nodiscard]] double innovation_um() const noexcept { return m_innovation_um; }
    /// β: how far the tones are trusted, 0 … 1.
    [[nodiscard]] double toneShare() const noexcept { return m_share; }
    /// The prediction of what the tones leave, and the one without tones.
    [[nodiscard]] const BroadbandPredictor& underTones() const noexcept { return m_underTones; }
    [[nodiscard]] const BroadbandPredictor& plain() const noexcept { return m_plain; }
    /// Tone j would not be seen by the force: |1 − exp(−jωd)| < .05.
    [[nodiscard]] bool blind(std::size_t index) const noexcept;

 private:
    void startKnown() noexcept;
    [[nodiscard]] bool settled() const noexcept;
    void begin() noexcept;
    void adopt() noexcept;
    void tidy() noexcept;
    void drop(std::size_t index) noexcept;
    void letGo() noexcept;
    void judge(double inner_um, double disturbance_um, double innovation_um) noexcept;
    void weigh() noexcept;
    double toneCommand_um() noexcept;
    [[nodiscard]] double trust(std::size_t index) const noexcept;
    void refreshInverse() noexcept;

    Params m_params;
    DepthPath m_freshPath;
    DepthPath m_path;
    InversePath m_freshBack;
    InversePath m_back;
    ToneTracker m_tracker;
    ToneFinder m_finder;
    std::array<std::complex<double>, kMaxTones> m_inverse{};
    std::size_t m_nextInverse{0};
    std::size_t m_samples{0};
    std::size_t m_worse{0};
    std::size_t m_pause{0};
    std::size_t m_pauseLength{0};
    bool m_acting{false};
    bool m_silent{false};
    CutReference m_reference{};
    MeanGuard m_guard{};
    BroadbandPredictor m_plain{};       ///< predicts m
    BroadbandPredictor m_underTones{};  ///< predicts what the tones leave
    double m_toneNext_um{0.0};          ///< what the tones foresee of the sample to come
    double m_share{0.0};                ///< β
    double m_cross_um2{0.0};
    double m_apart_um2{0.0};
    double m_plainLeft_um2{0.0};
    double m_underLeft_um2{0.0};
    double m_underLeft_um{0.0};
    double m_plainLeft_um{0.0};
    double m_underNext_um{0.0};
    double m_plainNext_um{0.0};
    double m_slow_um{0.0};
    double m_slowPlain_um{0.0};
    MeanGuard m_underGuard{};
    double m_authority{0.0};
    double m_command_um{0.0};
    double m_reference_um{0.0};
    double m_remaining_um2{0.0};
    double m_untreated_um2{0.0};
    double m_untreatedNow_um{0.0};
    double m_innovation_um2{0.0};
    double m_innovation_um{0.0};
};

/// |1 − exp(−jωd)|: how much of a tone the force sees, 0 blind to 2.
[[nodiscard]] double visibility(double frequency_Hz, std::size_t revolutionSamples, double sampleRate_Hz) noexcept;
inline constexpr double kBlindBelow = 0.05;

}  // namespace kerf::turning
