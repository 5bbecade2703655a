// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

namespace kerf::turning {
namespace {

constexpr std::size_t kFewest = 64;
constexpr double kHannMean = 0.5;
constexpr double kHannNoise = 1.5;  // equivalent noise bandwidth in lines

void transform(std::vector<std::complex<double>>& x) {
    const std::size_t n = x.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) {
            j ^= bit;
        }
        j ^= bit;
        if (i < j) {
            std::swap(x[i], x[j]);
        }
    }
    for (std::size_t length = 2; length <= n; length *= 2) {
        const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi / static_cast<double>(length));
        for (std::size_t begin = 0; begin < n; begin += length) {
            std::complex<double> factor{1.0, 0.0};
            for (std::size_t k = begin; k < begin + length / 2; ++k) {
                const std::complex<double> even = x[k];
                const std::complex<double> odd = factor * x[k + length / 2];
                x[k] = even + odd;
                x[k + length / 2] = even - odd;
                factor *= turn;
            }
        }
    }
}

}  // namespace

std::vector<float> amplitudeSpectrum(std::span<const float> values) {
    if (values.size() < kFewest) {
        return {};
    }
    const std::size_t n = std::bit_floor(values.size());
    double mean = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
        mean += static_cast<double>(values[k]) / static_cast<double>(n);
    }
    std::vector<std::complex<double>> x(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double window =
            0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
        x[k] = window * (static_cast<double>(values[k]) - mean);
    }
    transform(x);
    std::vector<float> lines(n / 2);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        lines[k] = static_cast<float>(2.0 * std::abs(x[k]) / (kHannMean * static_cast<double>(n)));
    }
    return lines;
}

double spectrumStep_Hz(std::size_t lines, double sampleRate_Hz) {
    return lines == 0 ? 0.0 : sampleRate_Hz / (2.0 * static_cast<double>(lines));
}

double toneAmplitude(std::span<const float> spectrum, double step_Hz, double frequency_Hz) {
    if (spectrum.empty() || !(step_Hz > 0.0)) {
        return 0.0;
    }
    const auto middle = static_cast<std::ptrdiff_t>(std::lround(frequency_Hz / step_Hz));
    double power = 0.0;
    for (std::ptrdiff_t k = middle - 2; k <= middle + 2; ++k) {
        if (k >= 0 && k < static_cast<std::ptrdiff_t>(spectrum.size())) {
            const auto line = static_cast<double>(spectrum[static_cast<std::size_t>(k)]);
            power += line * line;
        }
    }
    return std::sqrt(power / kHannNoise);
}

}  // namespace kerf::turning
