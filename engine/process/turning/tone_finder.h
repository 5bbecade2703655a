// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>

#include "engine/process/turning/tone_tracker.h"

namespace kerf::turning {

/// Finds the sinusoids in a stretch of a signal when nothing is known about them.
///
///   collect   means of 5 samples, 200 of them: .2 s at 5 kHz
///   repeat    spectrum of what is left → highest peak → all tones, level and level shape fitted again by Gauss-Newton
///   until     the highest peak is no more than noise would show (14 times its mean power), or 8 tones
///
/// Tones from 9 to 400 Hz, 4 Hz apart or more. The work is cut into slices of about a microsecond, one per call, so
/// that it can run inside the cycle: no call allocates, and a search ends some .1 s after its stretch of signal. Unit:
/// µm in, µm out; frequencies in rad per input sample; phases hold for the sample that begin() counts as 0.
class ToneFinder {
 public:
    static constexpr std::size_t kDecimation = 5;
    static constexpr std::size_t kPoints = 200;

    ToneFinder() noexcept;
    /// Forget everything and collect from the next sample on.
    void begin() noexcept;
    /// One sample and one slice of work. True once, when a search has ended.
    bool step(double value_um, double levelShape) noexcept;

    [[nodiscard]] std::size_t count() const noexcept { return m_count; }
    /// Found tone as it stands `samples` input samples after the first one collected.
    [[nodiscard]] Tone tone(std::size_t index, std::size_t samples) const noexcept;
    /// Input samples since begin().
    [[nodiscard]] std::size_t age() const noexcept { return m_age; }
    /// Level at the end of the stretch, where the shape of the entry has become 1.
    [[nodiscard]] double level_um() const noexcept { return m_level_um + m_shape_um; }
    /// Mean square of the points about level and shape, before any tone was taken out, µm².
    [[nodiscard]] double power_um2() const noexcept { return m_power_um2; }
    /// Mean square of what the tones do not explain, of one input sample, µm².
    [[nodiscard]] double noise_um2() const noexcept { return m_noise_um2; }

 private:
    static constexpr std::size_t kLogBins = 9;
    static constexpr std::size_t kBins = std::size_t{1} << kLogBins;
    static constexpr std::size_t kUnknowns = 2 + 3 * kMaxTones;
    static constexpr int kFitsPerTone = 2;
    enum class Phase : std::uint8_t { Collect, Load, Transform, Pick, Fit, Solve, Residual, Done };

    struct Candidate {
        double omega_rad{0.0};  ///< per decimated point
        double cosine_um{0.0};
        double sine_um{0.0};
    };

    bool slice() noexcept;
    void collect(double value_um, double levelShape) noexcept;
    void load() noexcept;
    void transformStage() noexcept;
    bool pick() noexcept;
    void fitRows() noexcept;
    void solve() noexcept;
    void residualRows() noexcept;
    [[nodiscard]] std::size_t unknowns() const noexcept { return 2 + 3 * m_count; }

    Phase m_phase{Phase::Done};
    std::size_t m_age{0};
    std::size_t m_filled{0};
    std::size_t m_index{0};
    int m_fitsLeft{0};
    double m_sum_um{0.0};
    double m_sumShape{0.0};
    std::size_t m_inSum{0};
    double m_level_um{0.0};
    double m_shape_um{0.0};
    double m_noise_um2{0.0};
    double m_power_um2{0.0};
    bool m_shaped{false};
    std::size_t m_count{0};
    std::array<Candidate, kMaxTones> m_tones{};
    std::array<double, kPoints> m_points_um{};
    std::array<double, kPoints> m_shape{};
    std::array<double, kPoints> m_residual_um{};
    std::array<std::complex<double>, kBins> m_spectrum{};
    std::array<std::complex<double>, kBins / 2> m_twiddle{};
    std::array<std::array<double, kUnknowns + 1>, kUnknowns> m_normal{};
};

}  // namespace kerf::turning
