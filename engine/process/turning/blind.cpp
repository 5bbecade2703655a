// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/blind.h"

#include <algorithm>
#include <cmath>

#include "engine/process/turning/tone_canceller.h"

namespace kerf::turning {
namespace {

double worstVisibility(std::span<const double> tones_Hz, std::size_t samples, double sampleRate_Hz) {
    double worst = 2.0;
    for (const double tone : tones_Hz) {
        worst = std::min(worst, visibility(tone, samples, sampleRate_Hz));
    }
    return worst;
}

}  // namespace

Result<BlindReport> blindFrequencies(double spindle_rps, std::span<const double> tones_Hz, double sampleRate_Hz,
                                     double span) {
    const double slowest = sampleRate_Hz / static_cast<double>(kMaxRevolutionSamples);
    const double fastest = sampleRate_Hz / 10.0;
    if (!(spindle_rps >= slowest && spindle_rps <= fastest)) {
        return fail(KERF_TEXT("The spindle speed is %1 rev/s; expected %2 to %3."), SentenceArg(spindle_rps, 3),
                    SentenceArg(slowest, 1), SentenceArg(fastest, 0));
    }
    if (tones_Hz.empty()) {
        return fail(KERF_TEXT("No tone is given; expected one frequency in Hz or more."));
    }
    BlindReport report;
    report.spindle_rps = spindle_rps;
    report.revolutionSamples = samplesPerRevolution(spindle_rps, sampleRate_Hz);
    for (const double tone : tones_Hz) {
        if (!(tone > 0.0 && tone < sampleRate_Hz / 2.0)) {
            return fail(KERF_TEXT("A tone is at %1 Hz; expected above 0 and below %2 Hz."), SentenceArg(tone, 3),
                        SentenceArg(sampleRate_Hz / 2.0, 0));
        }
        const double seen = visibility(tone, report.revolutionSamples, sampleRate_Hz);
        report.tones.push_back({tone, seen, seen < kBlindBelow});
    }
    report.worst = worstVisibility(tones_Hz, report.revolutionSamples, sampleRate_Hz);
    report.suggestedSamples = report.revolutionSamples;
    report.suggestedWorst = report.worst;
    const auto first = samplesPerRevolution(std::min(fastest, spindle_rps * (1.0 + span)), sampleRate_Hz);
    const auto last = std::min(kMaxRevolutionSamples, samplesPerRevolution(spindle_rps * (1.0 - span), sampleRate_Hz));
    for (std::size_t samples = first; samples <= last; ++samples) {
        const double worst = worstVisibility(tones_Hz, samples, sampleRate_Hz);
        if (worst > report.suggestedWorst) {
            report.suggestedWorst = worst;
            report.suggestedSamples = samples;
        }
    }
    report.suggested_rps = report.suggestedSamples == report.revolutionSamples
                               ? spindle_rps
                               : sampleRate_Hz / static_cast<double>(report.suggestedSamples);
    return report;
}

}  // namespace kerf::turning
