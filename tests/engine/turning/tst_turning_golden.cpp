// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/turning/admittance.h"
#include "engine/process/turning/identifier.h"
#include "engine/process/turning/overlap.h"
#include "engine/process/turning/simulation.h"
#include "tests/support/golden.h"

using namespace kerf::turning;
using nlohmann::json;

namespace {

const json& golden() {
    static const json document = kerf::test::loadGolden("golden_diamond.json");
    return document;
}

std::vector<double> numbers(const json& list) {
    return list.get<std::vector<double>>();
}

SimulationParams paperOn(PlantKind plant, double depth_um, int extraDelay) {
    SimulationParams params;
    params.plant = plant;
    params.controller = ControllerKind::Paper;
    params.depth_um = depth_um;
    params.extraDelay = extraDelay;
    return params;
}

/// x_i of a run against the reference vector.
void compare(const SimulationParams& params, const json& reference) {
    const auto disturbance = numbers(golden()["R0"]["da"]);
    const auto result = simulate(params, disturbance);
    QVERIFY(result.has_value());
    const auto expected = numbers(reference);
    QCOMPARE(result->rows.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        KERF_CLOSE(result->rows[k].inner_um, expected[k], 1e-9);
    }
}

}  // namespace

/// The reference vectors of the diamond turning page.
class TestTurningGolden : public QObject {
    Q_OBJECT
 private slots:
    void overlapFactors() {
        for (const auto& row : golden()["overlap"]) {
            const auto overlap = overlapFactor(row["R"], row["d0"], row["f"]);
            QVERIFY(overlap.has_value());
            KERF_CLOSE(*overlap, row["mu"].get<double>(), 1e-9);
        }
    }
    void stepOfTheCuttingProcess() {
        CuttingProcess process{ProcessParams{}};
        for (const double expected : numbers(golden()["P_step6"])) {
            KERF_CLOSE(process.step(6.0), expected, 1e-9);
        }
        KERF_CLOSE(ProcessParams{}.dcGain(), 0.24, 1e-9);
    }
    void invertedProcessGivesTheChipBack() {
        CuttingProcess forward{ProcessParams{}};
        CuttingProcess back{ProcessParams{}};
        kerf::Random random(4);
        for (int k = 0; k < 500; ++k) {
            const double chip_um = 6.0 + random.gauss();
            KERF_CLOSE(back.invert(forward.step(chip_um)), chip_um, 1e-9);
        }
    }
    void admittanceBothWays() {
        const json& reference = golden()["admittance"];
        const AdmittanceParams params{reference["mu"], reference["K"], reference["C"], reference["d0"], reference["T"]};
        const auto revolution = reference["d"].get<std::size_t>();
        AdmittanceForward forward(params, revolution);
        AdmittanceInverse back(params, revolution);
        AdmittanceInverse leaking(params, revolution, 0.9);
        const auto inner = numbers(reference["xi"]);
        const auto force = numbers(reference["F"]);
        const auto recovered = numbers(reference["xi_rec"]);
        const auto leaked = numbers(reference["xi_rec_leak09"]);
        for (std::size_t k = 0; k < inner.size(); ++k) {
            KERF_CLOSE(forward.force_N(inner[k]), force[k], 1e-9);
            KERF_CLOSE(back.inner_um(force[k]), recovered[k], 1e-9);
            KERF_CLOSE(leaking.inner_um(force[k]), leaked[k], 1e-9);
        }
    }
    void identification_data() {
        QTest::addColumn<int>("method");
        QTest::addColumn<QString>("key");
        QTest::newRow("plain") << static_cast<int>(Forgetting::Plain) << "plain";
        QTest::newRow("symmetric") << static_cast<int>(Forgetting::Symmetric) << "sym";
        QTest::newRow("directional") << static_cast<int>(Forgetting::Directional) << "df";
        QTest::newRow("trace limit") << static_cast<int>(Forgetting::TraceLimit) << "trace";
        QTest::newRow("constant trace") << static_cast<int>(Forgetting::ConstantTrace) << "ctrace";
        QTest::newRow("dead zone") << static_cast<int>(Forgetting::DeadZone) << "dead";
        QTest::newRow("variable factor") << static_cast<int>(Forgetting::VariableFactor) << "vff";
    }
    void identification() {
        QFETCH(int, method);
        QFETCH(QString, key);
        const json& reference = golden()["rls"];
        const json& mode = reference["modes"][key.toStdString()];
        ProcessIdentifier::Params params;
        params.method = static_cast<Forgetting>(method);
        params.forgetting = reference["lam"];
        params.initialVariance = reference["p0"];
        if (mode.contains("kw") && mode["kw"].is_object() && !mode["kw"].empty()) {
            params.limit = mode["kw"].begin()->get<double>();
        }
        ProcessIdentifier identifier(params);
        const auto chip = numbers(reference["u"]);
        const auto force = numbers(reference["F"]);
        for (std::size_t k = 0; k < chip.size(); ++k) {
            identifier.update(force[k], chip[k]);
            for (std::size_t i = 0; i < 3; ++i) {
                KERF_CLOSE(identifier.theta()[static_cast<Eigen::Index>(i)], mode["theta"][k][i].get<double>(), 1e-9);
            }
            KERF_CLOSE(identifier.trace(), mode["trace"][k].get<double>(), 1e-6);
        }
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                KERF_CLOSE(identifier.covariance()(i, j), mode["P"][i][j].get<double>(), 1e-9);
            }
        }
    }
    void readingR0() {
        SimulationParams open = paperOn(PlantKind::R0, 0.0, 0);
        open.controller = ControllerKind::Open;
        compare(open, golden()["R0"]["open"]);
        compare(paperOn(PlantKind::R0, 0.0, 0), golden()["R0"]["closed"]);
        compare(paperOn(PlantKind::R0, 0.0, 1), golden()["R0"]["closed_delay1"]);
    }
    void readingR1() {
        SimulationParams open = paperOn(PlantKind::R1, 6.0, 0);
        open.controller = ControllerKind::Open;
        compare(open, golden()["R1"]["open_step"]);
        compare(paperOn(PlantKind::R1, 0.0, 0), golden()["R1"]["closed_dist"]);
        compare(paperOn(PlantKind::R1, 6.0, 0), golden()["R1"]["closed_step"]);
        compare(paperOn(PlantKind::R1, 6.0, 1), golden()["R1"]["closed_step_delay1"]);
    }
    void readingR1WithRegeneration() {
        const json& reference = golden()["R1"]["regen_closed_step"];
        PlantParams params;
        params.kind = PlantKind::R1;
        params.depth_um = 6.0;
        params.slidePole = reference["p"];
        params.regeneration = reference["s"];
        params.revolutionSamples = reference["d"];
        Plant plant(params);
        PiGains gains;
        gains.gain = reference["g"];
        PiLaw law(gains);
        const auto disturbance = numbers(golden()["R0"]["da"]);
        const auto expected = numbers(reference["y"]);
        for (std::size_t k = 0; k < expected.size(); ++k) {
            const Plant::Line line = plant.line(disturbance[k]);
            const double command_um = law.updateExact(line.offset_um, line.slope);
            KERF_CLOSE(plant.step(disturbance[k], command_um).inner_um, expected[k], 1e-9);
        }
    }
    void plantB1UnderForeignCommands() {
        for (const char* name : {"B1_DOB_q05_step", "B1_AFC_mu01_step", "B1_LQG_q1e-5_kx03_step"}) {
            const auto commands = numbers(golden()[name]["u"]);
            const auto expected = numbers(golden()[name]["xi"]);
            const auto disturbance = makeDisturbance(kPaperTones, 0.05, expected.size(), 11);
            PlantParams params;
            params.depth_um = 6.0;
            Plant plant(params);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                KERF_CLOSE(plant.step(disturbance[k], k > 0 ? commands[k - 1] : 0.0).inner_um, expected[k], 1e-9);
            }
        }
    }
    void wholeRuns() {
        const json& reference = golden()["full_5000"];
        const auto disturbance = makeDisturbance(kPaperTones, 0.02, 5000, 1);
        KERF_CLOSE(disturbance.back(), reference["da_last"].get<double>(), 1e-9);
        const auto check = [&](SimulationParams params, ControllerKind controller, const char* key) {
            params.controller = controller;
            const Roughness whole = summarise(simulate(params, disturbance)->rows).whole;
            KERF_CLOSE(whole.rms_um, reference[key]["rms"].get<double>(), 1e-9);
            KERF_CLOSE(whole.pv_um, reference[key]["pv"].get<double>(), 1e-9);
        };
        check(paperOn(PlantKind::R0, 0.0, 0), ControllerKind::Open, "R0_open");
        check(paperOn(PlantKind::R0, 0.0, 0), ControllerKind::Paper, "R0_closed");
        check(paperOn(PlantKind::R1, 0.0, 0), ControllerKind::Open, "R1_open_dist");
        check(paperOn(PlantKind::R1, 0.0, 0), ControllerKind::Paper, "R1_closed_dist");
        check(paperOn(PlantKind::R1, 6.0, 0), ControllerKind::Open, "R1_open_step");
        check(paperOn(PlantKind::R1, 6.0, 0), ControllerKind::Paper, "R1_closed_step");
    }
};
QTEST_APPLESS_MAIN(TestTurningGolden)
#include "tst_turning_golden.moc"
