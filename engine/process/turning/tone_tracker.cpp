// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/tone_tracker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::turning {
namespace {

constexpr double kLastingShare = 0.01;  ///< 20 ms
constexpr double kLevelHaste = 1e-5;  ///< of the lasting innovation's square, per sample, added to the level's variance
constexpr double kNoiseMemory = 0.9995;
constexpr double kMaxFrequencyVariance_rad2 = 2e-6;  ///< (1.1 Hz at 5 kHz)²: the filter is linear no further
constexpr double kHertz_rad = 2.0 * std::numbers::pi / 5000.0;
constexpr double kSmallestOmega_rad = 8.0 * kHertz_rad;
constexpr double kLargestOmega_rad = 420.0 * kHertz_rad;
constexpr double kLargestRate_rad2 = 12.0 * kHertz_rad / 5000.0;
constexpr double kMaxRateVariance_rad2 = 4e-12;  ///< (8 Hz/s)²
constexpr double kSureFrequency_rad2 = (0.04 * kHertz_rad) * (0.04 * kHertz_rad);
constexpr double kWalkShare = 7e-4;  ///< per sample: back to the usual walk in .3 s
constexpr double kLargestSurprise = 4.0;

}  // namespace

double Tone::amplitude_um() const noexcept {
    return std::hypot(a_um, b_um);
}
double Tone::frequency_Hz(double sampleRate_Hz) const noexcept {
    return omega_radPerSample * sampleRate_Hz / (2.0 * std::numbers::pi);
}

ToneTracker::ToneTracker(const Params& params) noexcept : m_params(params) {
    reset(0.0, 100.0);
}

void ToneTracker::reset(double level_um, double levelVariance_um2) noexcept {
    m_count = 0;
    m_level_um = level_um;
    m_lasting_um = 0.0;
    m_noise_um2 = m_params.noise_um2;
    m_amplitudeWalk_um2 = m_params.amplitudeWalk_um2;
    for (auto& row : m_p) {
        row.fill(0.0);
    }
    m_p[0][0] = levelVariance_um2;
}

bool ToneTracker::add(const Tone& tone, double amplitudeVariance_um2, double frequencyVariance_rad2) noexcept {
    if (m_count == kMaxTones) {
        return false;
    }
    const std::size_t i = states();
    m_tones[m_count++] = tone;
    for (std::size_t row = i; row < i + 4; ++row) {
        for (std::size_t column = 0; column < kStates; ++column) {
            m_p[row][column] = m_p[column][row] = 0.0;
        }
    }
    m_p[i][i] = m_p[i + 1][i + 1] = amplitudeVariance_um2;
    m_p[i + 2][i + 2] = frequencyVariance_rad2;
    m_p[i + 3][i + 3] = m_params.rateVariance_rad2;
    return true;
}

void ToneTracker::remove(std::size_t index) noexcept {
    const std::size_t n = states();
    const std::size_t from = 1 + 4 * index;
    for (std::size_t j = index + 1; j < m_count; ++j) {
        m_tones[j - 1] = m_tones[j];
    }
    for (std::size_t row = from; row + 4 < n; ++row) {
        m_p[row] = m_p[row + 4];
    }
    for (std::size_t row = 0; row + 4 < n; ++row) {
        for (std::size_t column = from; column + 4 < n; ++column) {
            m_p[row][column] = m_p[row][column + 4];
        }
    }
    --m_count;
}

void ToneTracker::expectAmplitudeChange(double amplitude_samples) noexcept {
    // A random walk of variance q is followed in √(2R/q) samples.
    m_amplitudeWalk_um2 =
        std::max(m_params.amplitudeWalk_um2, 2.0 * m_noise_um2 / (amplitude_samples * amplitude_samples));
    for (std::size_t j = 0; j < m_count; ++j) {
        const std::size_t w = 3 + 4 * j;
        const double frequency_rad2 = std::min(m_p[w][w], kSureFrequency_rad2);
        for (std::size_t i = 0; i < kStates; ++i) {
            m_p[w][i] = m_p[i][w] = 0.0;
        }
        m_p[w][w] = frequency_rad2;
    }
}

void ToneTracker::freeFrequencies(double frequencyVariance_rad2) noexcept {
    for (std::size_t j = 0; j < m_count; ++j) {
        m_p[3 + 4 * j][3 + 4 * j] += frequencyVariance_rad2;
    }
}

void ToneTracker::leak(std::size_t index, double factor) noexcept {
    m_tones[index].a_um *= factor;
    m_tones[index].b_um *= factor;
}

double ToneTracker::amplitudeVariance_um2(std::size_t index) const noexcept {
    const std::size_t i = 1 + 4 * index;
    return std::max(m_p[i][i], m_p[i + 1][i + 1]);
}

double ToneTracker::frequencyVariance_rad2(std::size_t index) const noexcept {
    return m_p[3 + 4 * index][3 + 4 * index];
}

double ToneTracker::update(double measured_um, double levelShape, bool adaptNoise) noexcept {
    const std::size_t n = states();
    std::array<double, kStates> gain{};
    double predicted_um = m_level_um * levelShape;
    for (std::size_t j = 0; j < m_count; ++j) {
        Tone& tone = m_tones[j];
        tone.cosine = std::cos(tone.phase_rad);
        tone.sine = std::sin(tone.phase_rad);
        predicted_um += tone.a_um * tone.cosine + tone.b_um * tone.sine;
    }
    // P·h with h = [s, cos φ, sin φ, 0, …]: rows of the symmetric P, added up.
    for (std::size_t i = 0; i < n; ++i) {
        gain[i] = m_p[0][i] * levelShape;
    }
    for (std::size_t j = 0; j < m_count; ++j) {
        const Tone& tone = m_tones[j];
        const auto& rowA = m_p[1 + 4 * j];
        const auto& rowB = m_p[2 + 4 * j];
        for (std::size_t i = 0; i < n; ++i) {
            gain[i] += rowA[i] * tone.cosine + rowB[i] * tone.sine;
        }
    }
    double predictedVariance_um2 = gain[0] * levelShape;
    for (std::size_t j = 0; j < m_count; ++j) {
        predictedVariance_um2 += gain[1 + 4 * j] * m_tones[j].cosine + gain[2 + 4 * j] * m_tones[j].sine;
    }
    m_predictedVariance_um2 = predictedVariance_um2;
    const double innovation_um = measured_um - predicted_um;
    const double variance_um2 = predictedVariance_um2 + m_noise_um2;
    const double scale = 1.0 / variance_um2;
    for (std::size_t i = 0; i < n; ++i) {
        const double factor = gain[i] * scale;
        auto& row = m_p[i];
        for (std::size_t column = 0; column < n; ++column) {
            row[column] -= factor * gain[column];
        }
    }
    // A jump is not a sinusoid: no sample moves the filter by more than four times what it expects.
    const double bound_um = kLargestSurprise * std::sqrt(variance_um2);
    const double step = std::clamp(innovation_um, -bound_um, bound_um) * scale;
    m_level_um += gain[0] * step;
    for (std::size_t j = 0; j < m_count; ++j) {
        Tone& tone = m_tones[j];
        tone.a_um += gain[1 + 4 * j] * step;
        tone.b_um += gain[2 + 4 * j] * step;
        tone.omega_radPerSample =
            std::clamp(tone.omega_radPerSample + gain[3 + 4 * j] * step, kSmallestOmega_rad, kLargestOmega_rad);
        tone.rate_radPerSample2 =
            std::clamp(tone.rate_radPerSample2 + gain[4 + 4 * j] * step, -kLargestRate_rad2, kLargestRate_rad2);
    }
    if (adaptNoise) {
        // A level that lags leaves a lasting innovation, which every tone would take for its own.
        m_lasting_um += kLastingShare * (innovation_um - m_lasting_um);
        m_p[0][0] += kLevelHaste * m_lasting_um * m_lasting_um;
        const double sample_um2 = std::max(0.0, innovation_um * innovation_um - predictedVariance_um2);
        m_noise_um2 = std::clamp(kNoiseMemory * m_noise_um2 + (1.0 - kNoiseMemory) * sample_um2, m_params.noiseLow_um2,
                                 m_params.noiseHigh_um2);
    }
    predict();
    return innovation_um;
}

/// No state is less sure than this: its row and column are scaled, so that P stays a covariance.
void ToneTracker::bound(std::size_t state, double most) noexcept {
    if (m_p[state][state] <= most) {
        return;
    }
    const double shrink = std::sqrt(most / m_p[state][state]);
    for (std::size_t i = 0; i < states(); ++i) {
        m_p[state][i] *= shrink;
        m_p[i][state] *= shrink;
    }
}

/// φ += ω, ω += r; a frequency error turns (a, b): a += b·δ, b −= a·δ.
void ToneTracker::predict() noexcept {
    const std::size_t n = states();
    m_p[0][0] += m_params.levelWalk_um2;
    m_amplitudeWalk_um2 += kWalkShare * (m_params.amplitudeWalk_um2 - m_amplitudeWalk_um2);
    for (std::size_t j = 0; j < m_count; ++j) {
        Tone& tone = m_tones[j];
        tone.phase_rad += tone.omega_radPerSample;
        tone.omega_radPerSample =
            std::clamp(tone.omega_radPerSample + tone.rate_radPerSample2, kSmallestOmega_rad, kLargestOmega_rad);
        if (tone.phase_rad > std::numbers::pi) {
            tone.phase_rad -= 2.0 * std::numbers::pi;
        }
        const std::size_t a = 1 + 4 * j;
        auto& rowA = m_p[a];
        auto& rowB = m_p[a + 1];
        auto& rowW = m_p[a + 2];
        auto& rowR = m_p[a + 3];
        for (std::size_t i = 0; i < n; ++i) {
            rowA[i] += tone.b_um * rowW[i];
            rowB[i] -= tone.a_um * rowW[i];
            rowW[i] += rowR[i];
        }
        for (std::size_t i = 0; i < n; ++i) {
            auto& row = m_p[i];
            row[a] += tone.b_um * row[a + 2];
            row[a + 1] -= tone.a_um * row[a + 2];
            row[a + 2] += row[a + 3];
        }
        rowA[a] += m_amplitudeWalk_um2;
        rowB[a + 1] += m_amplitudeWalk_um2;
        rowW[a + 2] += m_params.frequencyWalk_rad2;
        rowR[a + 3] += m_params.rateWalk_rad2;
        bound(a + 2, kMaxFrequencyVariance_rad2);
        bound(a + 3, kMaxRateVariance_rad2);
    }
}

}  // namespace kerf::turning
