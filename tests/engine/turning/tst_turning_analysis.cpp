// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>

#include "engine/process/turning/blind.h"
#include "engine/process/turning/margins.h"
#include "engine/process/turning/overlap.h"
#include "engine/process/turning/simulation.h"
#include "engine/process/turning/spectrum.h"
#include "engine/process/turning/tone_canceller.h"
#include "tests/support/golden.h"

using namespace kerf::turning;

namespace {
struct Gain {
    double rms{0.0};
    double pv{0.0};
};
Gain improvement(PlantKind plant, double depth_um) {
    const auto disturbance = makeDisturbance(kPaperTones, 0.02, 5000, 1);
    SimulationParams params;
    params.plant = plant;
    params.depth_um = depth_um;
    params.controller = ControllerKind::Open;
    const Roughness open = summarise(simulate(params, disturbance)->rows).whole;
    params.controller = ControllerKind::Paper;
    const Roughness closed = summarise(simulate(params, disturbance)->rows).whole;
    return {100.0 * (1.0 - closed.rms_um / open.rms_um), 100.0 * (1.0 - closed.pv_um / open.pv_um)};
}
}  // namespace

/// Published figures, gain limits, blind tones, overlap errors.
class TestTurningAnalysis : public QObject {
    Q_OBJECT
 private slots:
    void paperFiguresComeOut() {
        const Gain r0 = improvement(PlantKind::R0, 0.0);
        QVERIFY(std::abs(r0.rms - 33.7) <= 0.5 && std::abs(r0.pv - 30.8) <= 2.0);
        const Gain r1 = improvement(PlantKind::R1, 0.0);
        QVERIFY(std::abs(r1.rms - 34.0) <= 0.5 && std::abs(r1.pv - 33.6) <= 2.0);
        const Gain step = improvement(PlantKind::R1, 6.0);
        QVERIFY(std::abs(step.rms - 51.4) <= 0.5 && std::abs(step.pv - 72.9) <= 2.0);
    }
    void cancellingKeepsTheMeanForceOverWholeCycles() {
        // Over a window that cuts the tones in half a cycle the mean of each is not zero by arithmetic alone.
        const auto disturbance = makeDisturbance(kPaperTones, 0.05, 20000, 1, 0.5);
        SimulationParams params;
        params.plant = PlantKind::B1;
        params.depth_um = 6.0;
        params.positionNoise_um = 0.02;
        const auto run = simulate(params, disturbance);
        const auto mean = [&](std::size_t from, std::size_t count) {
            double sum_N = 0.0;
            for (std::size_t k = from; k < from + count; ++k) {
                sum_N += run->rows[k].force_N / static_cast<double>(count);
            }
            return sum_N / 1.44 - 1.0;
        };
        QVERIFY(std::abs(mean(5000, 10000)) < 0.001);  // two seconds hold every tone in whole cycles
        QVERIFY(std::abs(mean(5000, 5000)) < 0.0225);
    }
    void spectrumShowsTonesAtTheirAmplitude() {
        std::vector<float> values(2048);
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double t_s = static_cast<double>(k) / 1250.0;
            values[k] = static_cast<float>(3.0 + 0.5 * std::sin(2.0 * std::numbers::pi * 17.3 * t_s) +
                                           0.25 * std::cos(2.0 * std::numbers::pi * 113.0 * t_s));
        }
        const auto spectrum = amplitudeSpectrum(values);
        const double step_Hz = spectrumStep_Hz(spectrum.size(), 1250.0);
        QVERIFY(std::abs(step_Hz - 1250.0 / 2048.0) < 1e-12);
        QVERIFY(std::abs(toneAmplitude(spectrum, step_Hz, 17.3) - 0.5) < 0.01);
        QVERIFY(std::abs(toneAmplitude(spectrum, step_Hz, 113.0) - 0.25) < 0.005);
        QVERIFY(toneAmplitude(spectrum, step_Hz, 60.0) < 0.001);
        QVERIFY(spectrum[0] < 0.05F);  // the mean is no tone
        QVERIFY(amplitudeSpectrum(std::span(values).first(63)).empty());
    }
    void toneMarginsAreThoseOfAnIntegratorInTheTonesFrame() {
        const std::vector<FollowedTone> one{{120.0, 0.005}};
        const Margins margins = toneMargins(one, {}, {}, kSampleRate_Hz);
        QVERIFY(std::abs(margins.phase_deg - 90.0) < 2.0);
        QVERIFY(std::abs(margins.delay_samples - kSampleRate_Hz / 480.0) < 0.5);
        QVERIFY(margins.gain > 50.0);
        QVERIFY(margins.gainLow < 1e-6);
        QVERIFY(margins.modulus > 0.95);
        // All five together and followed ten times as fast cost something, but not the loop.
        std::vector<FollowedTone> fast;
        for (const ToneSpec& tone : kPaperTones) {
            fast.push_back({tone.frequency_Hz, 0.05});
        }
        const Margins five = toneMargins(fast, {}, {}, kSampleRate_Hz);
        QVERIFY(five.phase_deg < margins.phase_deg && five.phase_deg > 45.0);
        QVERIFY(five.gain > 2.0);
    }
    void aMovedProcessEatsMarginsUntilTheLawIsTunedToIt() {
        const ProcessParams law{};
        ProcessParams truth{};
        truth.b0 *= 1.6;
        truth.b1 *= 1.6;
        const auto gains = tunedGains(PlantKind::B2);
        const double before = lawMargins(PlantKind::B2, gains, law).gain;
        QVERIFY(std::abs(lawMargins(PlantKind::B2, gains, law, truth).gain - before / 1.6) < 0.02);
        QVERIFY(std::abs(lawMargins(PlantKind::B2, gains, truth, truth).gain - before) < 0.02);
        const std::vector<FollowedTone> tones{{17.0, 0.005}, {120.0, 0.005}};
        const auto of = [&](const ProcessParams& cuts) { return toneMargins(tones, law, cuts, kSampleRate_Hz); };
        const Margins sure = of(law);
        const Margins wide = guaranteedMargins(law, {0.01, 0.02, 0.02}, of);
        QVERIFY(wide.phase_deg < sure.phase_deg && wide.gain < sure.gain && wide.delay_samples < sure.delay_samples);
    }
    void paperRemovesTheCutOnR1() {
        const auto disturbance = makeDisturbance(kPaperTones, 0.02, 5000, 1);
        SimulationParams params;
        params.plant = PlantKind::R1;
        params.controller = ControllerKind::Paper;
        params.depth_um = 6.0;
        QVERIFY(std::abs(summarise(simulate(params, disturbance)->rows).meanForce_N) < 0.05);
    }
    void gainLimitsOfThePaper() {
        const std::array<double, 5> expected{0.0960, 0.0750, 0.0230, 4.798, 25.51};
        const auto limits = paperLimits(ProcessParams{});
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QVERIFY2(std::abs(limits[i].limit / expected[i] - 1.0) < 0.01, limits[i].name.data());
        }
    }
    void gainLimitIsWhereTheLoopBlowsUp() {
        // C·z⁻¹ closed on itself by hand, just below and just above its limit.
        for (const double factor : {0.99, 1.01}) {
            PiGains gains;
            gains.gain = 0.075 * factor;
            PiLaw law(gains);
            double motion_um = 1.0;
            double early_um = 0.0;
            double late_um = 0.0;
            for (int k = 0; k < 4000; ++k) {
                motion_um = law.update(motion_um);
                (k < 200 ? early_um : late_um) =
                    std::max(k < 200 ? early_um : (k < 3800 ? 0.0 : late_um), std::abs(motion_um));
            }
            QCOMPARE(late_um > early_um, factor > 1.0);
        }
    }
    void marginsOfAnIntegratorAreKnown() {
        const Margins m = margins([](double omega) {
            const std::complex<double> back = std::polar(1.0, -omega);
            return 0.1 * back / (1.0 - back);
        });
        KERF_CLOSE(m.gain, 20.0, 1e-6);
        QVERIFY(std::abs(m.phase_deg - (90.0 - 0.05 * 180.0 / 3.14159265)) < 0.1);
    }
    void eightySixHertzIsBlindAtThePaperSpeed() {
        const std::array<double, 5> tones{17.0, 52.0, 86.0, 113.0, 120.0};
        const auto report = blindFrequencies(17.2, tones, 5000.0);
        QVERIFY(report.has_value());
        QCOMPARE(report->revolutionSamples, std::size_t{291});
        for (const auto& tone : report->tones) {
            QCOMPARE(tone.blind, tone.frequency_Hz == 86.0);
            const double angle = 2.0 * 3.14159265358979323846 * tone.frequency_Hz * 291.0 / 5000.0;
            KERF_CLOSE(tone.visibility, std::abs(1.0 - std::polar(1.0, -angle)), 1e-9);
        }
        QVERIFY(report->suggestedWorst > 10.0 * report->worst);
        const auto better = blindFrequencies(report->suggested_rps, tones, 5000.0);
        KERF_CLOSE(better->worst, report->suggestedWorst, 1e-12);
    }
    void impossibleQuestionsGetASentence() {
        const std::array<double, 1> tones{100.0};
        QVERIFY(!blindFrequencies(0.0, tones, 5000.0));
        QVERIFY(!blindFrequencies(std::nan(""), tones, 5000.0));
        QVERIFY(!blindFrequencies(17.2, {}, 5000.0));
        const std::array<double, 1> tooHigh{2600.0};
        QVERIFY(!blindFrequencies(17.2, tooHigh, 5000.0));
        QVERIFY(!overlapFactor(0.0, 6.0, 5.8));
        QVERIFY(!overlapFactor(800.0, 900.0, 5.8));
        QVERIFY(!overlapFactor(800.0, 6.0, -1.0));
        QVERIFY(!overlapFactor(800.0, 6.0, 500.0));
        QVERIFY(!overlapFactor(std::nan(""), 6.0, 5.8));
        QVERIFY(overlapFactor(800.0, 6.0, 0.0).has_value());
    }
    void overlapFallsAsInfeedGrows() {
        double last = 1.1;
        for (double infeed = 0.0; infeed < 60.0; infeed += 3.0) {
            const double overlap = *overlapFactor(800.0, 6.0, infeed);
            QVERIFY(overlap < last && overlap >= 0.0 && overlap <= 1.0);
            last = overlap;
        }
    }
};
QTEST_APPLESS_MAIN(TestTurningAnalysis)
#include "tst_turning_analysis.moc"
