// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace kerf::turning {

/// Amplitude spectrum of a signal, Hann window, its mean taken off: a sine of amplitude A in the middle of a line shows
/// A. Lines from 0 to half the rate in steps of rate/n, n the largest power of two that the signal fills (at least 64;
/// shorter signals give nothing). Not in the cycle.
[[nodiscard]] std::vector<float> amplitudeSpectrum(std::span<const float> values);
/// Steps between the lines of amplitudeSpectrum().
[[nodiscard]] double spectrumStep_Hz(std::size_t lines, double sampleRate_Hz);
/// Amplitude of the sine near a frequency: the energy of five lines, so that it does not matter where between two lines
/// it stands.
[[nodiscard]] double toneAmplitude(std::span<const float> spectrum, double step_Hz, double frequency_Hz);

}  // namespace kerf::turning
