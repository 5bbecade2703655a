// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <span>

#include "engine/process/turning/depth_path.h"
#include "engine/process/turning/tone_finder.h"
#include "engine/process/turning/tone_tracker.h"

namespace kerf::turning {

/// The default law: cancels the tones of the disturbance and nothing else.
///
///   m = x_i − path(w)              what x_i would be without the trim
///   m = c·s + Σ tones + noise      ToneTracker (Kalman, frequencies tracked); unknown tones come from ToneFinder
///   w = −Σ tone_j / path(ω_j)      path with its delay: the command meets the tone when it acts
///
/// The level c (the cut itself) is estimated but never commanded, and noise is not fed back: the mean of w is zero by
/// construction, so the law cannot remove the cut, and it adds no noise of its own between the tones.
///
/// At each tone the loop is that of an integrator in the tone's frame: stable for any path gain between 0 and ∞ times
/// the model's and any phase error below 90°; for tones that are far apart against the filter's bandwidth
/// (docs/turning.md). It listens until known tones explain the signal (.1 s at the earliest) or a search has ended (.3
/// s), then acts. When what is left is as large as the disturbance would be without it for .2 s, it lets go, listens
/// and starts again: so it is not worse than open loop for long. Sign: x_i grows with w by path(). Units
/// µm. update() runs in the cycle: no allocation, lock, throw or I/O; its cost is bounded by eight tones
/// (docs/performance.md).
class ToneCanceller {
 public:
    struct Params {
        double sampleRate_Hz{kSampleRate_Hz};
        std::size_t revolutionSamples{291};
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
    /// Tone j would not be seen by the force: |1 − exp(−jωd)| < .05.
    [[nodiscard]] bool blind(std::size_t index) const noexcept;

 private:
    void startKnown() noexcept;
    [[nodiscard]] bool settled() const noexcept;
    void begin() noexcept;
    void adopt() noexcept;
    void tidy() noexcept;
    void judge(double inner_um, double disturbance_um, double innovation_um) noexcept;
    [[nodiscard]] double trust(std::size_t index) const noexcept;
    void refreshInverse() noexcept;

    Params m_params;
    DepthPath m_freshPath;
    DepthPath m_path;
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
    double m_authority{0.0};
    double m_command_um{0.0};
    double m_reference_um{0.0};
    double m_remaining_um2{0.0};
    double m_untreated_um2{0.0};
    double m_untreatedNow_um{0.0};
    double m_innovation_um2{0.0};
    double m_innovation_um{0.0};
    double m_baseline_um2{0.0};
};

/// |1 − exp(−jωd)|: how much of a tone the force sees, 0 blind to 2.
[[nodiscard]] double visibility(double frequency_Hz, std::size_t revolutionSamples, double sampleRate_Hz) noexcept;
inline constexpr double kBlindBelow = 0.05;

}  // namespace kerf::turning
