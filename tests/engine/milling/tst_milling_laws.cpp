// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/milling/cut_simulation.h"
#include "engine/process/milling/drawn_blank.h"
#include "engine/process/milling/hard_machine.h"

using namespace kerf;
using namespace kerf::milling;

namespace {

constexpr double kKgf = kNewtonPerKilogramForce;

BlankProfile stairs() {
    const double heights_mm[] = {1, 2, 3, 2, 1};
    return *BlankProfile::ofSegments(heights_mm, 20.0);
}

BlankProfile randomBlank(std::uint64_t seed) {
    Random random(seed);
    double heights_mm[8];
    for (double& height_mm : heights_mm) {
        height_mm = random.uniform(1.0, 3.0);
    }
    return *BlankProfile::ofSegments(heights_mm, 12.0);
}

CutCase bare(LawKind law) {
    CutCase cut;
    cut.blank = stairs();
    cut.law = law;
    cut.controller.entryGuard = false;
    return cut;
}

CutCase noisy(LawKind law, std::uint64_t seed) {
    CutCase cut = bare(law);
    cut.controller.entryGuard = true;
    cut.wholePulses = true;
    cut.forceNoise_N = 0.5 * kKgf;
    cut.seed = seed;
    return cut;
}

CutCase pi(double kp, double ki, double reference_kgf) {
    CutCase cut = bare(LawKind::Pi);
    cut.controller.pi = {kp * 0.0254, ki * 0.0254, 0.1};
    cut.controller.reference_N = reference_kgf * kKgf;
    return cut;
}

double waviness_um(const CutResult& result) {
    return result.summary.waviness ? result.summary.waviness->spot_um : 1e9;
}

struct Worst {
    double waviness_um{0.0};
    double mean_um{0.0};
    double peak_kgf{0.0};
    double time_s{0.0};
};

/// Worst and mean over `count` seeds of a case made from a seed.
template <class MakeCase>
Worst campaign(int count, const MakeCase& make) {
    Worst worst;
    for (int i = 0; i < count; ++i) {
        const CutResult result = simulateCut(make(static_cast<std::uint64_t>(i)));
        worst.waviness_um = std::max(worst.waviness_um, waviness_um(result));
        worst.mean_um += waviness_um(result) / count;
        worst.peak_kgf = std::max(worst.peak_kgf, result.summary.peakForce_N / kKgf);
        worst.time_s = std::max(worst.time_s, result.summary.finished ? result.summary.time_s : 1e9);
    }
    return worst;
}

}  // namespace

class TestMillingLaws : public QObject {
    Q_OBJECT

 private slots:
    // The paper's figures on the calibrated plant.
    void constantFeedIsAsWavyAsThePaper() {
        CutCase cut = bare(LawKind::Constant);
        QVERIFY(std::abs(waviness_um(simulateCut(cut)) - 285.0) < 1.0);
        cut.controller.programmedFeed_mmPerS = 0.85;
        QVERIFY(std::abs(waviness_um(simulateCut(cut)) - 173.0) < 1.0);
    }
    void paperLawFlattensTheWall() {
        QVERIFY(std::abs(waviness_um(simulateCut(pi(0.75, 0.15, 40.0))) - 52.0) < 2.0);
        CutCase withFloor = pi(0.75, 0.15, 25.0);
        withFloor.controller.range.min_mmPerS = 0.68;
        QVERIFY(std::abs(waviness_um(simulateCut(withFloor)) - 59.0) < 2.0);
    }
    void slowGainsLeaveTheWallWavy() { QVERIFY(waviness_um(simulateCut(pi(0.13, 0.026, 40.0))) >= 150.0); }
    void highGainsMakeTheFeedRestless() {
        const CutResult calm = simulateCut(pi(0.75, 0.15, 40.0));
        const CutResult restless = simulateCut(pi(3.0, 0.6, 40.0));
        QVERIFY(restless.summary.feedUnrest_mmPerS >= 20.0 * calm.summary.feedUnrest_mmPerS);
        QVERIFY(waviness_um(restless) <= 60.0);
    }

    // The default law, with whole pulses and 0.5 kgf of noise at 40 kgf.
    void defaultLawHoldsTheWall() {
        const Worst worst = campaign(40, [](std::uint64_t seed) { return noisy(LawKind::Model, 7000 + seed); });
        QVERIFY2(worst.waviness_um <= 14.5, qPrintable(QString::number(worst.waviness_um)));
        QVERIFY2(worst.mean_um <= 10.5, qPrintable(QString::number(worst.mean_um)));
        QVERIFY2(worst.time_s <= 65.0, qPrintable(QString::number(worst.time_s)));
        QVERIFY2(worst.peak_kgf <= 45.0, qPrintable(QString::number(worst.peak_kgf)));
    }
    void defaultLawBearsOneRevolutionOfLag() {
        const Worst worst = campaign(40, [](std::uint64_t seed) {
            CutCase cut = noisy(LawKind::Model, 100 + seed);
            cut.lag = true;
            return cut;
        });
        QVERIFY2(worst.waviness_um <= 30.0, qPrintable(QString::number(worst.waviness_um)));
    }
    void defaultLawHoldsRandomBlanks() {
        const Worst worst = campaign(60, [](std::uint64_t seed) {
            CutCase cut = noisy(LawKind::Model, 300 + seed);
            cut.blank = randomBlank(40 + seed);
            return cut;
        });
        QVERIFY2(worst.mean_um <= 10.0, qPrintable(QString::number(worst.mean_um)));
        QVERIFY2(worst.waviness_um <= 20.0, qPrintable(QString::number(worst.waviness_um)));
    }
    void defaultLawHoldsOnSoftAndStiffTools_data() {
        QTest::addColumn<double>("kx_kgfPerMm");
        for (const double kx_kgfPerMm : {20.0, 25.0, 35.0, 60.0, 90.0, 120.0, 150.0}) {
            QTest::addRow("kx %g kgf/mm", kx_kgfPerMm) << kx_kgfPerMm;
        }
    }
    void defaultLawHoldsOnSoftAndStiffTools() {
        QFETCH(double, kx_kgfPerMm);
        const Worst worst = campaign(15, [&](std::uint64_t seed) {
            CutCase cut = noisy(LawKind::Model, 900 + seed);
            cut.plant.kx_NPerMm = kx_kgfPerMm * kKgf;
            cut.blank = seed % 2 == 0 ? stairs() : randomBlank(seed);
            return cut;
        });
        QVERIFY2(worst.waviness_um <= 30.0, qPrintable(QString::number(worst.waviness_um)));
    }
    void noiseAndLatenessDoNotMakeTheDefaultTheWorseChoice_data() {
        QTest::addColumn<int>("blank");
        QTest::addColumn<double>("noise_kgf");
        QTest::addColumn<bool>("late");
        for (int blank = 0; blank < 3; ++blank) {
            for (const double noise_kgf : {0.5, 1.0, 2.0, 3.0, 5.0}) {
                for (const bool late : {false, true}) {
                    QTest::addRow("blank %d, %g kgf, late %d", blank, noise_kgf, late) << blank << noise_kgf << late;
                }
            }
        }
    }
    void noiseAndLatenessDoNotMakeTheDefaultTheWorseChoice() {
        QFETCH(int, blank);
        QFETCH(double, noise_kgf);
        QFETCH(bool, late);
        std::vector<double> heights_mm{1, 2, 3, 2, 1};
        if (blank > 0) {
            heights_mm.assign(blank == 1 ? 200 : 100, 0.0);
            for (std::size_t i = 0; i < heights_mm.size(); ++i) {
                heights_mm[i] = blank == 1 ? 1.0 + (static_cast<double>(i) + 0.5) / 100.0 : i % 2 == 0 ? 1.0 : 3.0;
            }
        }
        const auto cutBy = [&](LawKind law) {
            Worst mean;
            for (std::uint64_t seed = 0; seed < 6; ++seed) {
                CutCase cut = bare(law);
                cut.blank = *BlankProfile::ofSegments(heights_mm, 100.0 / static_cast<double>(heights_mm.size()));
                cut.wholePulses = true;
                cut.forceNoise_N = noise_kgf * kKgf;
                cut.lag = late;
                cut.seed = seed;
                const CutResult result = simulateCut(cut);
                mean.mean_um += waviness_um(result) / 6.0;
                mean.peak_kgf += result.summary.peakForce_N / kKgf / 6.0;
            }
            return mean;
        };
        const Worst ours = cutBy(LawKind::Model);
        const Worst paper = cutBy(LawKind::Pi);
        QVERIFY2(ours.mean_um <= 1.03 * paper.mean_um,
                 qPrintable(QString("%1 µm, paper %2").arg(ours.mean_um).arg(paper.mean_um)));
        QVERIFY2(ours.peak_kgf <= (noise_kgf < 1.0 ? 1.01 : 1.0) * paper.peak_kgf,
                 qPrintable(QString("%1 kgf, paper %2").arg(ours.peak_kgf).arg(paper.peak_kgf)));
    }
    // What exponent and k_x leave wrong is an offset of the force that comes and goes with the depth, unless it is
    // trimmed away.
    void aDepthThatChangesSlowlyIsHeldAsThePaperHoldsIt_data() {
        QTest::addColumn<int>("blank");
        QTest::addColumn<bool>("late");
        for (const int blank : {0, 1, 4, 7, 9}) {  // sines, saws and a walk
            for (const bool late : {false, true}) {
                QTest::addRow("blank %d, late %d", blank, late) << blank << late;
            }
        }
    }
    void aDepthThatChangesSlowlyIsHeldAsThePaperHoldsIt() {
        QFETCH(int, blank);
        QFETCH(bool, late);
        const auto cutBy = [&](LawKind law) {
            CutCase cut = bare(law);
            cut.blank = drawnBlank(1, static_cast<std::uint64_t>(blank)).blank;
            cut.wholePulses = true;
            cut.lag = late;
            return waviness_um(simulateCut(cut));
        };
        const double ours_um = cutBy(LawKind::Model);
        const double paper_um = cutBy(LawKind::Pi);
        QVERIFY2(ours_um <= 1.1 * paper_um, qPrintable(QString("%1 µm, paper %2").arg(ours_um).arg(paper_um)));
    }
    void aForceThatAloneComesLateDoesNotPeakInTheEntry() {
        std::vector<double> ramp_mm(200);
        for (std::size_t i = 0; i < ramp_mm.size(); ++i) {
            ramp_mm[i] = 1.0 + (static_cast<double>(i) + 0.5) / 100.0;
        }
        CutCase cut = bare(LawKind::Model);
        cut.blank = *BlankProfile::ofSegments(ramp_mm, 0.5);
        cut.wholePulses = true;
        cut.forceLate_rev = 1;
        const double ours_N = simulateCut(cut).summary.peakForce_N;
        cut.law = LawKind::Pi;
        const double paper_N = simulateCut(cut).summary.peakForce_N;
        QVERIFY2(ours_N <= paper_N, qPrintable(QString::number(ours_N / kKgf)));
    }
    void latenessIsLearntFromTheFeed() {
        for (const std::size_t late : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            AxisFollow axis;
            std::vector<double> decided_mm(late, 0.0);
            for (int i = 0; i < 12; ++i) {
                axis.measured(decided_mm.size() > late ? decided_mm[decided_mm.size() - 1 - late] : 0.0);
                decided_mm.push_back(0.1 + 0.01 * (i % 3));
                axis.decided(decided_mm.back());
            }
            QCOMPARE(axis.late(), late);
            QCOMPARE(axis.pending_mm().size(), late);
        }
    }
    void timeConstantOfTheAxisIsLearnt() {
        constexpr double kLag_periods = 2.0;
        const double decay = std::exp(-1.0 / kLag_periods);
        const double share = kLag_periods * (1.0 - decay);
        AxisFollow axis;
        double feed_mm = 0.1;
        double decided_mm = 0.1;
        for (int i = 0; i < 60; ++i) {
            axis.measured(decided_mm + (feed_mm - decided_mm) * share);
            feed_mm = decided_mm + (feed_mm - decided_mm) * decay;
            decided_mm = 0.1 + 0.02 * std::sin(0.9 * i);
            axis.decided(decided_mm);
        }
        QCOMPARE(axis.lag_periods(), kLag_periods);
        QCOMPARE(axis.late(), std::size_t{0});
    }
    void aForceThatAloneComesLateIsLearnt_data() {
        QTest::addColumn<int>("late");
        QTest::newRow("prompt") << 0;
        QTest::newRow("one revolution") << 1;
        QTest::newRow("two revolutions") << 2;
    }
    void aForceThatAloneComesLateIsLearnt() {
        QFETCH(int, late);
        std::vector<double> ramp_mm(200);
        for (std::size_t i = 0; i < ramp_mm.size(); ++i) {
            ramp_mm[i] = 1.0 + (static_cast<double>(i) + 0.5) / 100.0;
        }
        CutCase cut = bare(LawKind::Model);
        cut.blank = *BlankProfile::ofSegments(ramp_mm, 0.5);
        cut.wholePulses = true;
        cut.forceLate_rev = late;
        const double wavy_um = waviness_um(simulateCut(cut));
        QVERIFY2(wavy_um <= 3.1, qPrintable(QString::number(wavy_um)));  // the paper's law, one revolution late
    }
    void latenessOfTheForceIsTheSensorsAndNotTheTools() {
        FeedController controller(FeedController::Params(), LawKind::Model);
        RevolutionState tool;
        double feed_mmPerS = 0.0;
        double force_N = 0.0;
        for (int i = 0; i < 120; ++i) {
            feed_mmPerS = controller.update({force_N, feed_mmPerS * 0.1, 0.0, 0.1}).feed_mmPerS;
            force_N = tool.forceY_N;  // of the revolution before
            tool = stepRevolution(PlantParams(), 1.0 + 0.01 * i, tool.deflectionX_mm, feed_mmPerS * 0.1);
        }
        QCOMPARE(controller.forceLate(), std::size_t{1});
        controller.newTool();
        controller.beginCut();
        QCOMPARE(controller.forceLate(), std::size_t{1});
    }
    void anotherReferenceCountsTheSameNoiseAnew() {
        CutCase cut = noisy(LawKind::Constant, 3);
        cut.forceNoise_N = 1.0 * kKgf;
        FeedController changed(cut.controller, LawKind::Constant);
        for (const CutRow& row : simulateCut(cut).rows) {
            (void)changed.update({row.forceMeasured_N, 0.153, row.x_mm, 0.1});
        }
        const double before = changed.stiffness().quiet;
        changed.setReference(2.0 * cut.controller.reference_N);
        QVERIFY2(changed.stiffness().quiet > before + 0.3, qPrintable(QString::number(before)));
        changed.setReference(0.25 * cut.controller.reference_N);
        QVERIFY(changed.stiffness().quiet < 0.01);
        QVERIFY(changed.stiffness().valid);
    }
    void noiseIsLearnt() {
        for (const double noise_kgf : {0.3, 1.0, 4.0}) {
            CutCase cut = noisy(LawKind::Constant, 3);
            cut.forceNoise_N = noise_kgf * kKgf;
            FeedController observer(cut.controller, LawKind::Constant);
            for (const CutRow& row : simulateCut(cut).rows) {
                (void)observer.update({row.forceMeasured_N, 0.153, row.x_mm, 0.1});
            }
            const double ratio = observer.stiffness().noise_N / cut.forceNoise_N;
            QVERIFY2(ratio > 0.5 && ratio < 2.0, qPrintable(QString("%1: %2").arg(noise_kgf).arg(ratio)));
        }
    }
    void machineSeedZeroIsTheReference() {
        const HardMachine machine = hardMachine(0);
        CutCase cut = bare(LawKind::Model);
        putOn(machine, cut);
        QCOMPARE(waviness_um(simulateCut(cut)), waviness_um(simulateCut(bare(LawKind::Model))));
        QVERIFY(hardMachine(7).plant.kx_NPerMm != hardMachine(8).plant.kx_NPerMm);
    }
    void defaultIsStableOnHardMachines() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            CutCase cut;
            putOn(hardMachine(seed), cut);
            cut.wholePulses = true;
            cut.fromAir_mm = 5.0;
            QVERIFY2(!unstable(simulateCut(cut), cut.controller.reference_N), qPrintable(QString::number(seed)));
        }
    }
    void entryFromAirDoesNotOvershoot() {
        const Worst worst = campaign(40, [](std::uint64_t seed) {
            CutCase cut = noisy(LawKind::Model, 500 + seed);
            cut.fromAir_mm = 1.0 + 0.17 * static_cast<double>(seed);
            return cut;
        });
        QVERIFY2(worst.peak_kgf <= 45.0, qPrintable(QString::number(worst.peak_kgf)));
        QVERIFY2(worst.waviness_um <= 15.0, qPrintable(QString::number(worst.waviness_um)));
    }
    void paperLawEntersWithoutWindUp() {
        CutCase cut = pi(0.75, 0.15, 40.0);
        cut.controller.entryGuard = true;
        cut.fromAir_mm = 8.0;
        const double guarded_N = simulateCut(cut).summary.peakForce_N;
        cut.controller.entryGuard = false;  // what the guard is for
        const double bare_N = simulateCut(cut).summary.peakForce_N;
        QVERIFY2(guarded_N <= 48.0 * kKgf, qPrintable(QString::number(guarded_N / kKgf)));
        QVERIFY2(bare_N > guarded_N, qPrintable(QString::number(bare_N / kKgf)));
    }
    void previewWithErrorsHoldsTheWall() {
        const Worst worst = campaign(40, [](std::uint64_t seed) {
            CutCase cut = noisy(LawKind::Preview, 1500 + seed);
            cut.believedBlank = cut.blank.distorted(seed % 2 == 0 ? 0.3 : -0.3, seed % 4 < 2 ? 1.05 : 0.95);
            return cut;
        });
        QVERIFY2(worst.waviness_um <= 18.0, qPrintable(QString::number(worst.waviness_um)));
    }
    void modelGoesByTheForceWhateverBlankIsLoaded() {
        CutCase cut = bare(LawKind::Model);
        const double alone_um = waviness_um(simulateCut(cut));
        cut.believedBlank = cut.blank.distorted(6.0, 1.5);
        QCOMPARE(waviness_um(simulateCut(cut)), alone_um);
    }
    void exactPreviewBeatsNoPreviewWithoutNoise() {
        CutCase cut = bare(LawKind::Preview);
        cut.believedBlank = cut.blank;
        QVERIFY(waviness_um(simulateCut(cut)) < waviness_um(simulateCut(bare(LawKind::Model))));
    }

    // The estimate.
    void stiffnessIntervalCoversTheTruth() {
        int inside = 0;
        int seen = 0;
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            CutCase cut = noisy(LawKind::Constant, seed);
            FeedController observer(cut.controller, LawKind::Constant);
            for (const CutRow& row : simulateCut(cut).rows) {
                (void)observer.update({row.forceMeasured_N, 0.153, row.x_mm, 0.1});
                const double truth = std::log(cut.plant.cuttingCoefficient * row.depth_mm);
                const bool steady =
                    std::fmod(row.x_mm, 20.0) > 3.0 && std::fmod(row.x_mm, 20.0) < 14.0 && row.x_mm > 4.0;
                seen += steady;
                inside += steady && std::abs(observer.stiffness().lnCb - truth) <= observer.stiffness().half95;
            }
        }
        QVERIFY(seen > 1000);
        QVERIFY2(inside >= seen * 93 / 100, qPrintable(QString("%1 of %2").arg(inside).arg(seen)));
    }
    void toolStiffnessIsLearnt_data() { defaultLawHoldsOnSoftAndStiffTools_data(); }
    void toolStiffnessIsLearnt() {
        QFETCH(double, kx_kgfPerMm);
        CutCase cut = noisy(LawKind::Model, 3);
        cut.plant.kx_NPerMm = kx_kgfPerMm * kKgf;
        const CutResult result = simulateCut(cut);
        FeedController observer(cut.controller, LawKind::Model);
        double rest = 0.0;
        for (const CutRow& row : result.rows) {
            const double pulses = row.feedCommand_mmPerS * 0.1 / cut.pulse_mm + rest;
            rest = pulses - std::floor(pulses);
            (void)observer.update({row.forceMeasured_N, std::floor(pulses) * cut.pulse_mm, row.x_mm, 0.1});
        }
        const double ratio = observer.stiffness().kx_NPerMm / cut.plant.kx_NPerMm;
        QVERIFY2(ratio > 0.45 && ratio < 2.2, qPrintable(QString::number(ratio)));
    }

    // Manners of the controller.
    void changeOfLawIsBumpless() {
        const PlantParams plant;
        for (const LawKind from : {LawKind::Constant, LawKind::Pi, LawKind::Model}) {
            for (const LawKind to : {LawKind::Constant, LawKind::Pi, LawKind::Model, LawKind::Preview}) {
                FeedController::Params params;
                params.programmedFeed_mmPerS = 1.0;
                FeedController controller(params, from);
                RevolutionState tool;
                double feed_mmPerS = 0.0;
                for (int i = 0; i < 80; ++i) {
                    if (i == 60) {
                        controller.select(to);
                    }
                    const double before_mmPerS = feed_mmPerS;
                    feed_mmPerS = controller.update({tool.forceY_N, before_mmPerS * 0.1, 0.0, 0.1}).feed_mmPerS;
                    if (i == 60) {
                        QVERIFY2(
                            std::abs(feed_mmPerS - before_mmPerS) < 0.02,
                            qPrintable(QString("law %1 to %2").arg(static_cast<int>(from)).arg(static_cast<int>(to))));
                    }
                    tool = stepRevolution(plant, 1.5, tool.deflectionX_mm, feed_mmPerS * 0.1);
                }
            }
        }
    }
    void withoutTrustedForceTheFeedNeverRises() {
        for (const LawKind law : {LawKind::Constant, LawKind::Pi, LawKind::Model, LawKind::Preview}) {
            for (const double depth_mm : {0.4, 1.0, 3.0}) {
                FeedController::Params params;
                FeedController controller(params, law);
                controller.setBlank(stairs());
                RevolutionState tool;
                double feed_mmPerS = 0.0;
                for (int i = 0; i < 60; ++i) {
                    const bool blind = i >= 40;
                    const double before_mmPerS = feed_mmPerS;
                    const std::optional<double> force_N = blind ? std::nullopt : std::optional(tool.forceY_N);
                    const FeedDecision decision = controller.update({force_N, before_mmPerS * 0.1, 0.0, 0.1});
                    feed_mmPerS = decision.feed_mmPerS;
                    QCOMPARE(decision.blind, blind);
                    if (blind) {
                        QVERIFY(feed_mmPerS <= before_mmPerS);
                        QVERIFY(feed_mmPerS <= params.programmedFeed_mmPerS);
                    }
                    tool = stepRevolution(PlantParams(), depth_mm, tool.deflectionX_mm, feed_mmPerS * 0.1);
                }
            }
        }
    }
    void backsOffFasterThanItRecovers() {
        const auto firstMove_mmPerS = [](double from_mm, double to_mm) {
            FeedController controller(FeedController::Params(), LawKind::Model);
            RevolutionState tool;
            double feed_mmPerS = 0.0;
            double settled_mmPerS = 0.0;
            for (int i = 0; i < 103; ++i) {
                feed_mmPerS = controller.update({tool.forceY_N, feed_mmPerS * 0.1, 0.0, 0.1}).feed_mmPerS;
                settled_mmPerS = i == 99 ? feed_mmPerS : settled_mmPerS;
                tool = stepRevolution(PlantParams(), i < 99 ? from_mm : to_mm, tool.deflectionX_mm, feed_mmPerS * 0.1);
            }
            return std::abs(std::log(feed_mmPerS / settled_mmPerS));
        };
        QVERIFY(firstMove_mmPerS(1.5, 1.5 * 1.2) > firstMove_mmPerS(1.5, 1.5 / 1.2));
    }
    void piGainsFollowTheRevolution() {
        // Per revolution the same plant: the same cut at 3000 rpm and at 600 rpm, only five times faster.
        CutCase slow = pi(0.75, 0.15, 40.0);
        CutCase fast = slow;
        fast.spindle_rpm = 3000.0;
        slow.controller.range.max_mmPerS = 4.0;
        fast.controller.range.max_mmPerS = 20.0;
        const CutResult a = simulateCut(slow);
        const CutResult b = simulateCut(fast);
        QCOMPARE(a.rows.size(), b.rows.size());
        QVERIFY(std::abs(waviness_um(a) - waviness_um(b)) < 1e-6);
    }
    void deeperThanTheRangeIsReportedAsLimited() {
        FeedController::Params params;
        params.range.min_mmPerS = 0.68;
        FeedController controller(params, LawKind::Model);
        RevolutionState tool;
        FeedDecision decision;
        for (int i = 0; i < 80; ++i) {
            decision = controller.update({tool.forceY_N, decision.feed_mmPerS * 0.1, 0.0, 0.1});
            tool = stepRevolution(PlantParams(), 8.0, tool.deflectionX_mm, decision.feed_mmPerS * 0.1);
        }
        QVERIFY(decision.limited);
        QCOMPARE(decision.feed_mmPerS, 0.68);
    }
    void badBlanksAreRefusedInWords() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const double height_mm : {-0.1, 51.0, nan}) {
            const double heights_mm[] = {1.0, height_mm};
            const auto blank = BlankProfile::ofSegments(heights_mm, 20.0);
            QVERIFY(!blank && !blank.error().english().empty());
        }
        const double heights_mm[] = {1.0, 2.0};
        for (const double segment_mm : {0.0, -1.0, nan}) {
            QVERIFY(!BlankProfile::ofSegments(heights_mm, segment_mm));
        }
        QVERIFY(!BlankProfile::ofSegments({}, 20.0));
        const double backwards_mm[] = {5.0, 4.0};
        QVERIFY(!BlankProfile::ofSteps(backwards_mm, heights_mm, 20.0));
    }
};

QTEST_APPLESS_MAIN(TestMillingLaws)
#include "tst_milling_laws.moc"
