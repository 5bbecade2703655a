// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/disturbances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"

namespace kerf::turning {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Second-order band from `low_Hz` to `high_Hz`: a one-pole high pass and a one-pole low pass, each twice.
class Band {
 public:
    Band(double low_Hz, double high_Hz) noexcept
        : m_low(1.0 - std::exp(-kTurn * low_Hz / kSampleRate_Hz)),
          m_high(1.0 - std::exp(-kTurn * high_Hz / kSampleRate_Hz)) {}
    double step(double value) noexcept {
        for (int i = 0; i < 2; ++i) {
            m_slow[i] += m_low * (value - m_slow[i]);
            value -= m_slow[i];
            m_fast[i] += m_high * (value - m_fast[i]);
            value = m_fast[i];
        }
        return value;
    }

 private:
    double m_low;
    double m_high;
    std::array<double, 2> m_slow{};
    std::array<double, 2> m_fast{};
};

}  // namespace

std::vector<double> drawDisturbance(DisturbanceKind kind, std::size_t samples, std::uint64_t seed, double white_um) {
    Random draw = Random(seed).stream(1);
    Random noise = Random(seed).stream(2);
    Random white = Random(seed).stream(3);
    std::vector<double> out(samples);
    switch (kind) {
        case DisturbanceKind::Tones: {
            const int count = 3 + static_cast<int>(draw.uniform(0.0, 4.0));
            std::vector<double> used_Hz;
            while (static_cast<int>(used_Hz.size()) < count) {
                const double frequency_Hz = draw.uniform(12.0, 250.0);
                if (std::ranges::any_of(used_Hz, [&](double f) { return std::abs(f - frequency_Hz) < 8.0; })) {
                    continue;
                }
                used_Hz.push_back(frequency_Hz);
                const double amplitude_um = draw.uniform(0.2, 0.6);
                const double phase_rad = draw.uniform(0.0, kTurn);
                for (std::size_t k = 0; k < samples; ++k) {
                    out[k] += amplitude_um *
                              std::sin(kTurn * frequency_Hz * static_cast<double>(k) / kSampleRate_Hz + phase_rad);
                }
            }
            break;
        }
        case DisturbanceKind::Drift: {
            const double rate_HzPerS = draw.uniform(1.0, 8.0) * (draw.uniform() < 0.5 ? -1.0 : 1.0);
            const double start_Hz = draw.uniform(40.0, 120.0);
            const double amplitude_um = draw.uniform(0.3, 0.6);
            for (std::size_t k = 0; k < samples; ++k) {
                const double t_s = static_cast<double>(k) / kSampleRate_Hz;
                out[k] = amplitude_um * std::sin(kTurn * (start_Hz * t_s + 0.5 * rate_HzPerS * t_s * t_s));
            }
            break;
        }
        case DisturbanceKind::Walk: {
            const double step_um = draw.uniform(0.001, 0.008);
            double at_um = 0.0;
            for (double& value : out) {
                at_um += step_um * noise.gauss();
                value = at_um;
            }
            break;
        }
        case DisturbanceKind::Coloured: {
            Band band(draw.uniform(15.0, 25.0), draw.uniform(55.0, 65.0));
            const double rms_um = draw.uniform(0.3, 0.5);
            double sum_um2 = 0.0;
            for (double& value : out) {
                value = band.step(noise.gauss());
                sum_um2 += value * value;
            }
            const double scale = rms_um / std::sqrt(sum_um2 / static_cast<double>(std::max<std::size_t>(samples, 1)));
            for (double& value : out) {
                value *= scale;
            }
            break;
        }
        case DisturbanceKind::Steps: {
            const double size_um = draw.uniform(0.2, 0.4);
            const double perSecond = draw.uniform(2.0, 4.0);
            double at_um = 0.0;
            for (double& value : out) {
                if (noise.uniform() < perSecond / kSampleRate_Hz) {
                    at_um += noise.uniform() < 0.5 ? -size_um : size_um;
                }
                value = at_um;
            }
            break;
        }
        case DisturbanceKind::NewTone: {
            const double frequency_Hz = draw.uniform(40.0, 200.0);
            const double amplitude_um = draw.uniform(0.3, 0.6);
            for (std::size_t k = samples / 2; k < samples; ++k) {
                out[k] = amplitude_um *
                         std::sin(kTurn * frequency_Hz * static_cast<double>(k - samples / 2) / kSampleRate_Hz);
            }
            break;
        }
    }
    for (double& value : out) {
        value += white_um * white.gauss();
    }
    return out;
}

}  // namespace kerf::turning
