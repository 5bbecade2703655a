// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/turning/depth_control.h"
#include "engine/process/turning/plant.h"
#include "engine/process/turning/tones.h"

namespace kerf::turning {

/// Sum of sines plus white noise: d(k) = Σ A·sin(2πf·k/f_s + φ) + σ·gauss.
[[nodiscard]] std::vector<double> makeDisturbance(std::span<const ToneSpec> tones, double white_um, std::size_t samples,
                                                  std::uint64_t seed, double shift_Hz = 0.0,
                                                  double sampleRate_Hz = kSampleRate_Hz);

struct SimulationParams {
    PlantKind plant{PlantKind::B1};
    ControllerKind controller{ControllerKind::Default};
    double depth_um{0.0};
    double positionNoise_um{0.0};  ///< of the sensor of x_i (R0, R1, B1)
    double forceNoise_N{0.0};      ///< of the force sensor
    ProcessParams process{};       ///< the plant's P; the law is tuned to the reference one
    double slidePole{0.994};       ///< the plant's; the law's is the reference one
    double gainError{1.0};         ///< factor on the plant's P that the law does not know
    int extraDelay{0};
    std::uint64_t seed{1};  ///< of the sensors: seed + 1000
    double piGain{0.0};     ///< of `paper` and `pi`; 0 = the plant's own
    std::size_t revolutionSamples{291};
};

struct SimulationRow {
    double disturbance_um{0.0};
    double command_um{0.0};  ///< that acted in this sample
    double force_N{0.0};     ///< true
    double inner_um{0.0};    ///< true
    double depth_um{0.0};    ///< chip that made the force
};

/// Tone the default law followed at the end.
struct TrackedTone {
    double frequency_Hz{0.0};
    double amplitude_um{0.0};
    double visibility{0.0};
    bool blind{false};
};

struct SimulationResult {
    std::vector<SimulationRow> rows{};
    std::vector<TrackedTone> tones{};
};

/// The paper's metric: one leading zero sample, RMS about the mean, peak to valley.
struct Roughness {
    double rms_um{0.0};
    double pv_um{0.0};
};
[[nodiscard]] Roughness roughness(std::span<const SimulationRow> rows, bool leadingZero);

struct SimulationSummary {
    Roughness whole{};
    Roughness steady{};       ///< second half
    double meanForce_N{0.0};  ///< second half
};
[[nodiscard]] SimulationSummary summarise(std::span<const SimulationRow> rows);

/// Runs one plant with one controller over a disturbance. The laws see what their sensors show and know
/// nothing of d0.
[[nodiscard]] Result<SimulationResult> simulate(const SimulationParams& params, std::span<const double> disturbance_um);

}  // namespace kerf::turning
