// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/tone_finder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::turning {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPeakOverNoise = 14.0;  ///< of an exponential law: by chance once in 10⁶ bins
constexpr double kLowest_Hz = 9.0;       ///< for a decimated rate of 1 kHz
constexpr double kHighest_Hz = 400.0;
constexpr double kPointRate_Hz = 1000.0;
constexpr std::size_t kMultiplicationsPerSlice = 1500;
constexpr int kSlicesPerSample = 4;
constexpr double kRidge = 1e-9;
constexpr double kNearest_rad = 2.0 * kPi * 3.0 / kPointRate_Hz;
constexpr double kLargestMove_rad = 2.0 * kPi * 2.0 / kPointRate_Hz;  ///< of a frequency in one fit

}  // namespace

ToneFinder::ToneFinder() noexcept {
    for (std::size_t i = 0; i < m_twiddle.size(); ++i) {
        m_twiddle[i] = std::polar(1.0, -2.0 * kPi * static_cast<double>(i) / static_cast<double>(kBins));
    }
}

void ToneFinder::begin() noexcept {
    m_phase = Phase::Collect;
    m_age = m_filled = m_inSum = m_count = 0;
    m_sum_um = m_sumShape = m_level_um = m_shape_um = m_noise_um2 = 0.0;
}

bool ToneFinder::step(double value_um, double levelShape) noexcept {
    if (m_phase == Phase::Done) {
        return false;
    }
    ++m_age;
    if (m_phase == Phase::Collect) {
        collect(value_um, levelShape);
        return false;
    }
    for (int i = 0; i < kSlicesPerSample; ++i) {
        if (slice()) {
            return true;
        }
    }
    return false;
}

/// One piece of the search; true when it has ended with this one.
bool ToneFinder::slice() noexcept {
    switch (m_phase) {
        case Phase::Collect:
            return false;
        case Phase::Load:
            load();
            return false;
        case Phase::Transform:
            transformStage();
            return false;
        case Phase::Pick:
            if (pick()) {
                m_index = 0;
                m_fitsLeft = kFitsPerTone;
                m_phase = Phase::Fit;
                return false;
            }
            m_phase = Phase::Done;
            return true;
        case Phase::Fit:
            fitRows();
            return false;
        case Phase::Solve:
            solve();
            return false;
        case Phase::Residual:
            residualRows();
            return false;
        case Phase::Done:
            break;
    }
    return false;
}

void ToneFinder::collect(double value_um, double levelShape) noexcept {
    m_sum_um += value_um;
    m_sumShape += levelShape;
    if (++m_inSum < kDecimation) {
        return;
    }
    m_points_um[m_filled] = m_sum_um / static_cast<double>(kDecimation);
    m_shape[m_filled] = m_sumShape / static_cast<double>(kDecimation);
    m_sum_um = m_sumShape = 0.0;
    m_inSum = 0;
    if (++m_filled < kPoints) {
        return;
    }
    const auto [low, high] = std::ranges::minmax(m_shape);
    m_shaped = high - low > 1e-3;
    // Level and shape first, then the search runs on what is left.
    m_index = 0;
    m_fitsLeft = 1;
    m_phase = Phase::Fit;
}

void ToneFinder::load() noexcept {
    double power_um2 = 0.0;
    for (std::size_t i = 0; i < kBins; ++i) {
        std::size_t reversed = 0;
        for (std::size_t bit = 0; bit < kLogBins; ++bit) {
            reversed |= ((i >> bit) & 1U) << (kLogBins - 1 - bit);
        }
        m_spectrum[reversed] = i < kPoints ? m_residual_um[i] : 0.0;
    }
    for (const double value : m_residual_um) {
        power_um2 += value * value;
    }
    const double freedom = static_cast<double>(kPoints - unknowns());
    m_noise_um2 = power_um2 / freedom * static_cast<double>(kDecimation);
    if (m_count == 0) {
        m_power_um2 = power_um2 / freedom;
    }
    m_index = 0;
    m_phase = Phase::Transform;
}

void ToneFinder::transformStage() noexcept {
    const std::size_t half = std::size_t{1} << m_index;
    const std::size_t stride = kBins / (2 * half);
    for (std::size_t group = 0; group < kBins; group += 2 * half) {
        for (std::size_t i = 0; i < half; ++i) {
            const std::complex<double> w = m_twiddle[i * stride];
            const std::complex<double> x = m_spectrum[group + half + i];
            const std::complex<double> odd{w.real() * x.real() - w.imag() * x.imag(),
                                           w.real() * x.imag() + w.imag() * x.real()};
            m_spectrum[group + half + i] = m_spectrum[group + i] - odd;
            m_spectrum[group + i] += odd;
        }
    }
    if (++m_index == kLogBins) {
        m_phase = Phase::Pick;
    }
}

bool ToneFinder::pick() noexcept {
    constexpr double kBin_Hz = kPointRate_Hz / static_cast<double>(kBins);
    const auto first = static_cast<std::size_t>(std::ceil(kLowest_Hz / kBin_Hz));
    const auto last = static_cast<std::size_t>(kHighest_Hz / kBin_Hz);
    // What is left near a tone already found is its own unrest; two tones there would only fight each other.
    const auto owned = [&](std::size_t bin) {
        const double omega_rad = 2.0 * kPi * static_cast<double>(bin) / static_cast<double>(kBins);
        return std::any_of(m_tones.begin(), m_tones.begin() + static_cast<std::ptrdiff_t>(m_count),
                           [&](const Candidate& tone) { return std::abs(tone.omega_rad - omega_rad) < kNearest_rad; });
    };
    std::size_t best = 0;
    for (std::size_t i = first; i <= last; ++i) {
        const bool higher = best == 0 || std::norm(m_spectrum[i]) > std::norm(m_spectrum[best]);
        best = higher && !owned(i) ? i : best;
    }
    if (best == 0) {
        return false;
    }
    const double power = std::norm(m_spectrum[best]);
    const double noise = static_cast<double>(kPoints) * m_noise_um2 / static_cast<double>(kDecimation);
    if (m_count == kMaxTones || !(power > kPeakOverNoise * noise) || power <= 1e-18) {
        return false;
    }
    const double left = std::abs(m_spectrum[best - 1]);
    const double right = std::abs(m_spectrum[best + 1]);
    const double middle = std::abs(m_spectrum[best]);
    const double bend = left - 2.0 * middle + right;
    const double shift = bend < 0.0 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0.0;
    const double omega_rad = 2.0 * kPi * (static_cast<double>(best) + shift) / static_cast<double>(kBins);
    m_tones[m_count++] = {omega_rad, 0.0, 0.0};
    return true;
}

/// Adds rows of the normal equations. Unknowns: level, shape, then cosine, sine and frequency of each tone. A tone that
/// has no amplitude yet keeps its frequency in the first fit.
void ToneFinder::fitRows() noexcept {
    const std::size_t n = unknowns();
    if (m_index == 0) {
        for (auto& row : m_normal) {
            row.fill(0.0);
        }
    }
    const std::size_t rows = std::max<std::size_t>(1, kMultiplicationsPerSlice / (n * n / 2 + 20 * m_count + 1));
    const std::size_t end = std::min(kPoints, m_index + rows);
    std::array<double, kUnknowns> h{};
    for (; m_index < end; ++m_index) {
        const double time = static_cast<double>(m_index);
        double residual_um = m_points_um[m_index] - m_level_um - m_shape_um * m_shape[m_index];
        h[0] = 1.0;
        h[1] = m_shaped ? m_shape[m_index] : 0.0;
        for (std::size_t j = 0; j < m_count; ++j) {
            const Candidate& tone = m_tones[j];
            const double c = std::cos(tone.omega_rad * time);
            const double s = std::sin(tone.omega_rad * time);
            residual_um -= tone.cosine_um * c + tone.sine_um * s;
            h[2 + 3 * j] = c;
            h[3 + 3 * j] = s;
            h[4 + 3 * j] = time * (tone.sine_um * c - tone.cosine_um * s);
        }
        for (std::size_t row = 0; row < n; ++row) {
            for (std::size_t column = row; column < n; ++column) {
                m_normal[row][column] += h[row] * h[column];
            }
            m_normal[row][kUnknowns] += h[row] * residual_um;
        }
    }
    if (m_index == kPoints) {
        m_phase = Phase::Solve;
    }
}

/// Cholesky on the normal equations, scaled to unit diagonal; unknowns without any effect stay where they are.
void ToneFinder::solve() noexcept {
    const std::size_t n = unknowns();
    std::array<double, kUnknowns> scale{};
    std::array<double, kUnknowns> x{};
    for (std::size_t i = 0; i < n; ++i) {
        scale[i] = m_normal[i][i] > 1e-12 ? 1.0 / std::sqrt(m_normal[i][i]) : 0.0;
    }
    auto& a = m_normal;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i; j < n; ++j) {
            a[i][j] *= scale[i] * scale[j];
        }
        a[i][i] = scale[i] > 0.0 ? a[i][i] + kRidge : 1.0;
        x[i] = a[i][kUnknowns] * scale[i];
    }
    for (std::size_t i = 0; i < n; ++i) {  // upper triangle becomes Uᵀ·U
        for (std::size_t k = 0; k < i; ++k) {
            for (std::size_t j = i; j < n; ++j) {
                a[i][j] -= a[k][i] * a[k][j];
            }
            x[i] -= a[k][i] * x[k];
        }
        const double pivot = std::sqrt(std::max(a[i][i], kRidge));
        for (std::size_t j = i; j < n; ++j) {
            a[i][j] /= pivot;
        }
        x[i] /= pivot;
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) {
            x[i] -= a[i][j] * x[j];
        }
        x[i] /= a[i][i];
    }
    m_level_um += x[0] * scale[0];
    m_shape_um += x[1] * scale[1];
    for (std::size_t j = 0; j < m_count; ++j) {
        Candidate& tone = m_tones[j];
        tone.cosine_um += x[2 + 3 * j] * scale[2 + 3 * j];
        tone.sine_um += x[3 + 3 * j] * scale[3 + 3 * j];
        tone.omega_rad += std::clamp(x[4 + 3 * j] * scale[4 + 3 * j], -kLargestMove_rad, kLargestMove_rad);
    }
    m_index = 0;
    m_phase = --m_fitsLeft > 0 ? Phase::Fit : Phase::Residual;
}

void ToneFinder::residualRows() noexcept {
    const std::size_t end = std::min(kPoints, m_index + 4 + 40 / (m_count + 1));
    for (; m_index < end; ++m_index) {
        const double time = static_cast<double>(m_index);
        double residual_um = m_points_um[m_index] - m_level_um - m_shape_um * m_shape[m_index];
        for (std::size_t j = 0; j < m_count; ++j) {
            const Candidate& tone = m_tones[j];
            residual_um -=
                tone.cosine_um * std::cos(tone.omega_rad * time) + tone.sine_um * std::sin(tone.omega_rad * time);
        }
        m_residual_um[m_index] = residual_um;
    }
    if (m_index == kPoints) {
        m_phase = Phase::Load;
    }
}

Tone ToneFinder::tone(std::size_t index, std::size_t samples) const noexcept {
    const Candidate& found = m_tones[index];
    Tone tone;
    constexpr double kDecimationReal = static_cast<double>(kDecimation);
    tone.omega_radPerSample = found.omega_rad / kDecimationReal;
    // A point stands for the middle of its five samples; their mean is a little smaller than the tone.
    const double half_rad = tone.omega_radPerSample / 2.0;
    const double droop = std::sin(kDecimationReal * half_rad) / (kDecimationReal * std::sin(half_rad));
    const double ahead = static_cast<double>(samples) - (kDecimationReal - 1.0) / 2.0;
    tone.a_um = found.cosine_um / droop;
    tone.b_um = found.sine_um / droop;
    tone.phase_rad = std::remainder(tone.omega_radPerSample * ahead, 2.0 * kPi);
    return tone;
}

}  // namespace kerf::turning
