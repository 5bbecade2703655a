// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/process/turning/depth_control.h"

namespace kerf::turning {

std::vector<double> makeDisturbance(std::span<const ToneSpec> tones, double white_um, std::size_t samples,
                                    std::uint64_t seed, double shift_Hz, double sampleRate_Hz) {
    Random random(seed);
    std::vector<double> values(samples);
    for (std::size_t k = 0; k < samples; ++k) {
        const double time_s = static_cast<double>(k) / sampleRate_Hz;
        double sum_um = 0.0;
        for (const ToneSpec& tone : tones) {
            sum_um += tone.amplitude_um *
                      std::sin(2.0 * std::numbers::pi * (tone.frequency_Hz + shift_Hz) * time_s + tone.phase_rad);
        }
        values[k] = sum_um + white_um * random.gauss();
    }
    return values;
}

Roughness roughness(std::span<const SimulationRow> rows, bool leadingZero) {
    const double count = static_cast<double>(rows.size() + (leadingZero ? 1 : 0));
    if (count == 0.0) {
        return {};
    }
    double sum_um = 0.0;
    double high_um = leadingZero || rows.empty() ? 0.0 : rows.front().inner_um;
    double low_um = high_um;
    for (const SimulationRow& row : rows) {
        sum_um += row.inner_um;
        high_um = std::max(high_um, row.inner_um);
        low_um = std::min(low_um, row.inner_um);
    }
    const double mean_um = sum_um / count;
    double square_um2 = leadingZero ? mean_um * mean_um : 0.0;
    for (const SimulationRow& row : rows) {
        square_um2 += (row.inner_um - mean_um) * (row.inner_um - mean_um);
    }
    return {std::sqrt(square_um2 / count), high_um - low_um};
}

SimulationSummary summarise(std::span<const SimulationRow> rows) {
    SimulationSummary summary;
    const auto second = rows.subspan(rows.size() / 2);
    summary.whole = roughness(rows, true);
    summary.steady = roughness(second, false);
    for (const SimulationRow& row : second) {
        summary.meanForce_N += row.force_N / static_cast<double>(second.size());
    }
    return summary;
}

Result<SimulationResult> simulate(const SimulationParams& params, std::span<const double> disturbance_um) {
    if (params.revolutionSamples < 2 || params.revolutionSamples > kMaxRevolutionSamples) {
        return fail(KERF_TEXT("A revolution has %1 samples; expected 2 to %2."),
                    SentenceArg(static_cast<double>(params.revolutionSamples), 0),
                    SentenceArg(static_cast<double>(kMaxRevolutionSamples), 0));
    }
    if (params.extraDelay < 0 || params.extraDelay > 1) {
        return fail(KERF_TEXT("The extra delay is %1 samples; expected 0 or 1."), SentenceArg(params.extraDelay, 0));
    }
    if (!(params.gainError > 0.0 && params.gainError <= 10.0)) {
        return fail(KERF_TEXT("The gain error is %1; expected above 0, at most 10."), SentenceArg(params.gainError, 3));
    }
    // The paper's own reproductions answer within the sample and act on the motion itself (docs/turning.md).
    const bool reproduction =
        params.controller == ControllerKind::Paper && (params.plant == PlantKind::R0 || params.plant == PlantKind::R1);
    PiLaw paper(paperGains(params.plant, params.piGain));

    PlantParams plantParams;
    plantParams.kind = params.plant;
    plantParams.depth_um = params.depth_um;
    plantParams.extraDelay = reproduction ? 0 : params.extraDelay;
    plantParams.revolutionSamples = params.revolutionSamples;
    plantParams.process = params.process;
    plantParams.slidePole = params.slidePole;
    plantParams.process.b0 *= params.gainError;
    plantParams.process.b1 *= params.gainError;
    Plant plant(plantParams);

    DepthControlParams controlParams;
    controlParams.plant = params.plant;
    controlParams.kind = params.controller;
    controlParams.revolutionSamples = params.revolutionSamples;
    controlParams.piGain = params.piGain;
    DepthControl control(controlParams);

    Random sensor(params.seed + 1000);
    SimulationResult result;
    result.rows.reserve(disturbance_um.size());
    double command_um = 0.0;
    for (const double disturbance : disturbance_um) {
        if (reproduction && params.extraDelay == 0) {
            const Plant::Line line = plant.line(disturbance);
            command_um = paper.updateExact(line.offset_um, line.slope);
        }
        PlantSample sample = plant.step(disturbance, command_um);
        result.rows.push_back({disturbance, sample.command_um, sample.force_N, sample.inner_um, sample.depth_um});
        if (reproduction) {
            if (params.extraDelay > 0) {
                command_um = paper.update(sample.inner_um);
            }
            continue;
        }
        const double noise = sensor.gauss();
        command_um = control.update(
            {sample.force_N + params.forceNoise_N * noise, sample.inner_um + params.positionNoise_um * noise});
    }
    if (const ToneCanceller* canceller = control.canceller()) {
        for (std::size_t j = 0; j < canceller->tracker().count(); ++j) {
            const Tone& tone = canceller->tracker().tone(j);
            const double frequency_Hz = tone.frequency_Hz(kSampleRate_Hz);
            result.tones.push_back({frequency_Hz, tone.amplitude_um(),
                                    visibility(frequency_Hz, params.revolutionSamples, kSampleRate_Hz),
                                    canceller->blind(j)});
        }
    }
    return result;
}

}  // namespace kerf::turning
