// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace kerf::turning {

inline constexpr std::size_t kMaxTones = 8;

/// One sinusoid of the disturbance: a·cos φ + b·sin φ with φ(k+1) = φ(k) + ω, ω(k+1) = ω(k) + r.
struct Tone {
    double omega_radPerSample{0.0};
    double rate_radPerSample2{0.0};  ///< r: how fast the frequency drifts
    double phase_rad{0.0};           ///< φ at the sample to come
    double a_um{0.0};
    double b_um{0.0};
    double cosine{1.0};  ///< of φ at the last sample, as used by update()
    double sine{0.0};

    [[nodiscard]] double amplitude_um() const noexcept;
    [[nodiscard]] double frequency_Hz(double sampleRate_Hz) const noexcept;
};

/// Extended Kalman filter for a level and up to eight sinusoids whose frequencies are only roughly known.
///
///   m(k) = c·s(k) + Σ (a_j cos φ_j + b_j sin φ_j) + white noise of variance R
///   a, b, c, the frequencies and their rates walk at random with small variances
///
/// s(k) is the shape of the level (1, or how the entry of the cut builds up). Each sinusoid is kept in a frame that
/// turns with its estimated frequency, so the filter's states change slowly; the errors of frequency and rate are
/// states too, so that a tone that drifts steadily is followed without a lag. The whole covariance is kept: two tones 7
/// Hz apart are told apart as soon as the data allow. Sign and unit: µm in, µm out. update() does not allocate; it
/// costs about (1 + 4·tones)² multiplications.
class ToneTracker {
 public:
    struct Params {
        double amplitudeWalk_um2{3e-8};  ///< per sample
        double levelWalk_um2{1e-9};
        double frequencyWalk_rad2{1e-13};
        double rateWalk_rad2{2e-18};      ///< of ω's change per sample: (3 Hz/s)² in a second
        double rateVariance_rad2{1e-12};  ///< of a new tone: (4 Hz/s)²
        double noise_um2{0.003};          ///< R at the start; then adapted between the two limits
        double noiseLow_um2{2e-4};
        double noiseHigh_um2{0.05};
    };
    explicit ToneTracker(const Params& params) noexcept;

    /// Forget the tones; the level starts again at this value.
    void reset(double level_um, double levelVariance_um2) noexcept;
    /// False when all places are taken.
    bool add(const Tone& tone, double amplitudeVariance_um2, double frequencyVariance_rad2) noexcept;
    void remove(std::size_t index) noexcept;
    /// The law begins to act, and an error of its path will change every amplitude: follow amplitudes in about
    /// `amplitude_samples` from now on, and let the frequencies rest where they are.
    void expectAmplitudeChange(double amplitude_samples) noexcept;
    /// Let the frequencies move from now on: at first only amplitudes and phases are learned, for with a frequency that
    /// is free at once the filter's linearisation may settle on a wrong one.
    void freeFrequencies(double frequencyVariance_rad2) noexcept;
    /// Pull one amplitude towards zero by this factor (blind tones must not be held for ever).
    void leak(std::size_t index, double factor) noexcept;

    /// Takes m(k) and s(k), returns the innovation m − prediction in µm.
    double update(double measured_um, double levelShape, bool adaptNoise) noexcept;

    [[nodiscard]] std::size_t count() const noexcept { return m_count; }
    [[nodiscard]] const Tone& tone(std::size_t index) const noexcept { return m_tones[index]; }
    [[nodiscard]] double amplitudeVariance_um2(std::size_t index) const noexcept;
    [[nodiscard]] double frequencyVariance_rad2(std::size_t index) const noexcept;
    /// Variance of the last prediction, without the noise.
    [[nodiscard]] double predictedVariance_um2() const noexcept { return m_predictedVariance_um2; }
    [[nodiscard]] double level_um() const noexcept { return m_level_um; }
    [[nodiscard]] double noise_um2() const noexcept { return m_noise_um2; }

 private:
    static constexpr std::size_t kStates = 1 + 4 * kMaxTones;
    [[nodiscard]] std::size_t states() const noexcept { return 1 + 4 * m_count; }
    void predict() noexcept;
    void bound(std::size_t state, double most) noexcept;

    Params m_params;
    std::array<Tone, kMaxTones> m_tones{};
    std::size_t m_count{0};
    double m_level_um{0.0};
    double m_noise_um2{0.0};
    double m_lasting_um{0.0};  ///< mean of the innovation over the last 20 ms
    double m_predictedVariance_um2{0.0};
    double m_amplitudeWalk_um2{0.0};
    /// Covariance: level, then a, b, errors of frequency and rate of each tone.
    std::array<std::array<double, kStates>, kStates> m_p{};
};

}  // namespace kerf::turning
