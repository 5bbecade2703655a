// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/turning/identifier.h"
#include "engine/process/turning/simulation.h"
#include "tests/support/cycle_guard.h"

using namespace kerf::turning;
using kerf::Random;

namespace {

struct Question {
    PlantKind plant{PlantKind::B1};
    ControllerKind controller{ControllerKind::Default};
    double depth_um{6.0};
    double gainError{1.0};
    int extraDelay{0};
    double toneShift_Hz{0.0};
};
struct Answer {
    double rms{1e9};
    double pv{1e9};
    double forceChange{0.0};  ///< of 1.44 N
};

SimulationParams paramsOf(const Question& question, std::uint64_t seed) {
    SimulationParams params;
    params.plant = question.plant;
    params.controller = question.controller;
    params.depth_um = question.depth_um;
    params.gainError = question.gainError;
    params.extraDelay = question.extraDelay;
    params.seed = seed;
    (question.plant == PlantKind::B1 ? params.positionNoise_um : params.forceNoise_N) =
        question.plant == PlantKind::B1 ? 0.02 : 0.005;
    return params;
}

Answer run(const Question& question, std::span<const double> disturbance, std::uint64_t seed) {
    SimulationParams params = paramsOf(question, seed);
    const SimulationSummary closed = summarise(simulate(params, disturbance)->rows);
    params.controller = ControllerKind::Open;
    const SimulationSummary open = summarise(simulate(params, disturbance)->rows);
    const double cut_N = question.depth_um > 0.0 ? open.meanForce_N : 1.44;
    return {100.0 * (1.0 - closed.steady.rms_um / open.steady.rms_um),
            100.0 * (1.0 - closed.steady.pv_um / open.steady.pv_um),
            std::abs(closed.meanForce_N - open.meanForce_N) / cut_N};
}

/// The paper's tones with other phases, worst of some seeds.
Answer worst(const Question& question, int seeds = 6) {
    Answer out;
    for (int i = 0; i < seeds; ++i) {
        const auto seed = static_cast<std::uint64_t>(9001 + 37 * i);
        Random phases(seed);
        std::vector<ToneSpec> tones(kPaperTones.begin(), kPaperTones.end());
        for (ToneSpec& tone : tones) {
            tone.phase_rad = phases.uniform(0.0, 6.28);
        }
        const Answer one = run(question, makeDisturbance(tones, 0.05, 10000, seed, question.toneShift_Hz), seed);
        out = {std::min(out.rms, one.rms), std::min(out.pv, one.pv), std::max(out.forceChange, one.forceChange)};
    }
    return out;
}

void demand(const Answer& answer, double rms, double pv) {
    const QString text =
        QStringLiteral("RMS %1, P-V %2, force %3").arg(answer.rms).arg(answer.pv).arg(answer.forceChange);
    QVERIFY2(answer.rms >= rms, qPrintable(text));
    QVERIFY2(answer.pv >= pv, qPrintable(text));
    QVERIFY2(answer.forceChange <= 0.02, qPrintable(text));
}

}  // namespace

/// What must hold, item 3: the default law on b1 and b2 with phases, seeds and tones it was not made with.
class TestDepthControl : public QObject {
    Q_OBJECT
 private slots:
    void b1_data() {
        QTest::addColumn<double>("depth_um");
        QTest::addColumn<double>("gainError");
        QTest::addColumn<int>("extraDelay");
        QTest::addColumn<double>("toneShift_Hz");
        QTest::addColumn<double>("rms");
        QTest::addColumn<double>("pv");
        QTest::newRow("disturbance alone") << 0.0 << 1.0 << 0 << 0.0 << 91.5 << 84.5;
        QTest::newRow("with the cut") << 6.0 << 1.0 << 0 << 0.0 << 91.5 << 84.5;
        QTest::newRow("gain +30 %") << 6.0 << 1.3 << 0 << 0.0 << 91.0 << 84.0;
        QTest::newRow("gain -30 %") << 6.0 << 0.7 << 0 << 0.0 << 91.0 << 84.0;
        QTest::newRow("gain +30 %, no cut") << 0.0 << 1.3 << 0 << 0.0 << 91.0 << 84.0;
        QTest::newRow("one more delay") << 6.0 << 1.0 << 1 << 0.0 << 91.0 << 84.0;
        QTest::newRow("tones .5 Hz off") << 6.0 << 1.0 << 0 << 0.5 << 91.0 << 84.0;
        QTest::newRow("tones -.5 Hz off") << 0.0 << 1.0 << 0 << -0.5 << 91.0 << 84.0;
    }
    void b1() {
        QFETCH(double, depth_um);
        QFETCH(double, gainError);
        QFETCH(int, extraDelay);
        QFETCH(double, toneShift_Hz);
        QFETCH(double, rms);
        QFETCH(double, pv);
        demand(worst({PlantKind::B1, ControllerKind::Default, depth_um, gainError, extraDelay, toneShift_Hz}), rms, pv);
    }
    void b2_data() {
        QTest::addColumn<double>("toneShift_Hz");
        QTest::addColumn<double>("gainError");
        QTest::addColumn<double>("rms");
        QTest::newRow("exact") << 0.0 << 1.0 << 90.0;
        QTest::newRow(".1 Hz off") << 0.1 << 1.0 << 88.0;
        QTest::newRow("-.1 Hz off: 85.9 Hz is five revolutions") << -0.1 << 1.0 << 88.0;
        QTest::newRow(".5 Hz off") << 0.5 << 1.0 << 88.0;
        QTest::newRow("-.5 Hz off") << -0.5 << 1.0 << 88.0;
        QTest::newRow("gain +30 %") << 0.0 << 1.3 << 85.0;
        QTest::newRow("gain -30 %") << 0.0 << 0.7 << 85.0;
    }
    void b2() {
        QFETCH(double, toneShift_Hz);
        QFETCH(double, gainError);
        QFETCH(double, rms);
        demand(worst({PlantKind::B2, ControllerKind::Default, 6.0, gainError, 0, toneShift_Hz}), rms, 80.0);
    }
    void unknownTonesAreFound_data() {
        QTest::addColumn<int>("plant");
        QTest::newRow("b1") << static_cast<int>(PlantKind::B1);
        QTest::newRow("b2") << static_cast<int>(PlantKind::B2);
    }
    void unknownTonesAreFound() {
        QFETCH(int, plant);
        for (std::uint64_t seed = 801; seed < 809; ++seed) {
            Random random(seed);
            std::vector<ToneSpec> tones;
            double frequency_Hz = 8.0;
            for (std::uint64_t j = 0; j < 3 + seed % 4; ++j) {
                frequency_Hz += random.uniform(8.0, 35.0);
                tones.push_back({frequency_Hz, random.uniform(0.2, 0.6), random.uniform(0.0, 6.28)});
            }
            const auto disturbance = makeDisturbance(tones, 0.05, 10000, seed);
            Question question;
            question.plant = static_cast<PlantKind>(plant);
            const Answer answer = run(question, disturbance, seed);
            double power_um2 = 0.0025;
            for (const ToneSpec& tone : tones) {
                power_um2 += tone.amplitude_um * tone.amplitude_um / 2.0;
            }
            const double floor = 100.0 * (1.0 - 0.05 / std::sqrt(power_um2));  // white noise cannot be cancelled
            QVERIFY2(answer.rms > floor - 2.0, qPrintable(QStringLiteral("%1 of %2").arg(answer.rms).arg(floor)));
            QVERIFY(answer.forceChange <= 0.02);
        }
    }
    void neverWorseThanOpenLoop_data() {
        QTest::addColumn<int>("plant");
        QTest::addColumn<int>("kind");
        for (const auto& [name, plant] : {std::pair{"b1", PlantKind::B1}, {"b2", PlantKind::B2}}) {
            QTest::addRow("%s, white noise alone", name) << static_cast<int>(plant) << 0;
            QTest::addRow("%s, a slow random walk", name) << static_cast<int>(plant) << 1;
            QTest::addRow("%s, tones that jump by 3 Hz", name) << static_cast<int>(plant) << 2;
            QTest::addRow("%s, all tones at spindle harmonics", name) << static_cast<int>(plant) << 3;
            QTest::addRow("%s, a sweep", name) << static_cast<int>(plant) << 4;
        }
    }
    void neverWorseThanOpenLoop() {
        QFETCH(int, plant);
        QFETCH(int, kind);
        for (std::uint64_t seed = 701; seed < 704; ++seed) {
            auto disturbance = makeDisturbance({}, 0.05, 20000, seed);
            Random random(seed + 9);
            double walk_um = 0.0;
            double sweep_rad = 0.0;
            for (std::size_t k = 0; k < disturbance.size(); ++k) {
                const double t_s = static_cast<double>(k) / kSampleRate_Hz;
                walk_um += 0.01 * random.gauss() - 0.002 * walk_um;
                sweep_rad += 6.2831853 * (30.0 + 15.0 * t_s) / kSampleRate_Hz;
                switch (kind) {
                    case 1:
                        disturbance[k] += walk_um;
                        break;
                    case 2:
                        disturbance[k] += 0.5 * std::sin(6.2831853 * (k < 9000 ? 60.0 : 63.0) * t_s);
                        break;
                    case 3:
                        disturbance[k] += 0.3 * std::sin(6.2831853 * 5000.0 / 291.0 * 5.0 * t_s) +
                                          0.4 * std::sin(6.2831853 * 5000.0 / 291.0 * 3.0 * t_s);
                        break;
                    case 4:
                        disturbance[k] += 0.4 * std::sin(sweep_rad);
                        break;
                    default:
                        break;
                }
            }
            Question question;
            question.plant = static_cast<PlantKind>(plant);
            const Answer answer = run(question, disturbance, seed);
            QVERIFY2(answer.rms > -3.0, qPrintable(QString::number(answer.rms)));
        }
    }
    void everyControllerLeavesTheCut_data() {
        QTest::addColumn<int>("plant");
        QTest::addColumn<int>("controller");
        for (const PlantKind plant : {PlantKind::B1, PlantKind::B2}) {
            for (const ControllerKind kind : {ControllerKind::Paper, ControllerKind::Pi, ControllerKind::Default}) {
                QTest::addRow("plant %d, controller %d", static_cast<int>(plant), static_cast<int>(kind))
                    << static_cast<int>(plant) << static_cast<int>(kind);
            }
        }
    }
    void everyControllerLeavesTheCut() {
        QFETCH(int, plant);
        QFETCH(int, controller);
        const Answer answer =
            worst({static_cast<PlantKind>(plant), static_cast<ControllerKind>(controller), 6.0, 1.0, 0, 0.0}, 3);
        QVERIFY2(answer.forceChange <= 0.02, qPrintable(QString::number(answer.forceChange)));
    }
    void blindToneIsNamed() {
        Question question;
        question.plant = PlantKind::B2;
        const auto disturbance = makeDisturbance(kPaperTones, 0.05, 10000, 5);
        const auto result = simulate(paramsOf(question, 5), disturbance);
        int blind = 0;
        for (const TrackedTone& tone : result->tones) {
            blind += tone.blind ? 1 : 0;
            QVERIFY(!tone.blind || std::abs(tone.frequency_Hz - 86.0) < 0.3);
        }
        QCOMPARE(blind, 1);
    }
    void impossibleSimulationsGetASentence() {
        const std::vector<double> disturbance(10, 0.0);
        SimulationParams params;
        params.extraDelay = 2;
        QVERIFY(!simulate(params, disturbance));
        params.extraDelay = 0;
        params.gainError = std::nan("");
        QVERIFY(!simulate(params, disturbance));
        params.gainError = 1.0;
        params.revolutionSamples = 5000;
        QVERIFY(!simulate(params, disturbance));
    }
    void cycleWorkNeitherAllocatesLocksNorThrows() {
        if (!kerf::test::CycleGuard::available()) {
            QSKIP("a sanitizer owns malloc in this build");
        }
        DepthControlParams params;
        DepthControl control(params);
        ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
        PlantParams plantParams;
        plantParams.kind = PlantKind::B2;
        plantParams.depth_um = 6.0;
        Plant plant(plantParams);
        const auto disturbance = makeDisturbance(kPaperTones, 0.05, 10000, 5);
        double command_um = 0.0;
        std::uint64_t sins = 0;
        {
            const kerf::test::CycleGuard guard;
            for (const double d : disturbance) {
                const PlantSample sample = plant.step(d, command_um);
                command_um = control.update({sample.force_N, sample.inner_um});
                identifier.update(sample.force_N, sample.depth_um);
            }
            sins = guard.allocations() + guard.locks() + guard.throws();
        }
        QCOMPARE(sins, std::uint64_t{0});
        QVERIFY(control.canceller()->acting());
    }
};
QTEST_APPLESS_MAIN(TestDepthControl)
#include "tst_depth_control.moc"
