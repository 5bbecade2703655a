// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/process/milling/cut_simulation.h"
#include "tests/support/golden.h"

using namespace kerf;
using namespace kerf::milling;
using nlohmann::json;

namespace {

constexpr double kTolerance = 1e-9;
constexpr double kKgf = kNewtonPerKilogramForce;
constexpr double kPulseUnit_mmPerS =
    0.24908890999999997;  // one unit of u: a pulse of 25.4 µm per second and newton, in kgf
constexpr double kRevolution_s = 0.1;

BlankProfile stairs() {
    const double heights_mm[] = {1, 2, 3, 2, 1};
    return *BlankProfile::ofSegments(heights_mm, 20.0);
}

CutCase paperCase(LawKind law, double reference_kgf) {
    CutCase cut;
    cut.blank = stairs();
    cut.law = law;
    cut.controller.reference_N = reference_kgf * kKgf;
    cut.controller.entryGuard = false;
    return cut;
}

CutCase piCase(double kp, double ki, double reference_kgf, double floor_mmPerS = 0.0) {
    CutCase cut = paperCase(LawKind::Pi, reference_kgf);
    cut.controller.pi.kp_mmPerSPerN = kp * 0.0254;
    cut.controller.pi.ki_mmPerSPerN = ki * 0.0254;
    cut.controller.range.min_mmPerS = floor_mmPerS;
    return cut;
}

CutCase constantCase(double feed_mmPerS) {
    CutCase cut = paperCase(LawKind::Constant, 40.0);
    cut.controller.programmedFeed_mmPerS = feed_mmPerS;
    return cut;
}

/// The reference's model laws are plainer than ours: ln(C b) or ln C smoothed with a fixed weight from the feed really
/// cut, and a fixed share of deadbeat. Composed here from the same inversion the model law uses.
std::vector<CutRow> fixedWeightCut(double weight, double share, bool preview) {
    const PlantParams plant;
    const BlankProfile blank = stairs();
    const InversionModel model{plant.exponent, plant.forceAngle_deg, plant.kx_NPerMm};
    const double sin = std::sin(plant.forceAngle_deg * std::numbers::pi / 180.0);
    std::vector<CutRow> rows;
    RevolutionState tool;
    double x_mm = 0.0;
    double depth_mm = 0.0;
    std::optional<double> smoothed;
    while (x_mm < blank.end_mm()) {
        const double lastDepth_mm = depth_mm;
        depth_mm = blank.engagedDepth_mm(x_mm, plant.toolRadius_mm);
        double feed_mmPerS = 1.0;
        if (!rows.empty()) {
            const double lnCb = std::log(tool.forceY_N / sin) - plant.exponent * std::log(tool.cutFeed_mmPerRev);
            const double seen = preview ? lnCb - std::log(lastDepth_mm) : lnCb;
            smoothed = smoothed ? *smoothed + weight * (seen - *smoothed) : seen;
            const Inversion plan =
                invert(model, *smoothed + (preview ? std::log(depth_mm) : 0.0), tool.forceY_N, 40.0 * kKgf);
            feed_mmPerS = (share * plan.deadbeat_mmPerRev + (1.0 - share) * plan.steady_mmPerRev) / kRevolution_s;
        }
        feed_mmPerS = std::clamp(feed_mmPerS, 0.0, 4.0);
        tool = stepRevolution(plant, depth_mm, tool.deflectionX_mm, feed_mmPerS * kRevolution_s);
        x_mm += tool.cutFeed_mmPerRev;
        rows.push_back({static_cast<int>(rows.size()), x_mm, depth_mm, feed_mmPerS, tool.cutFeed_mmPerRev,
                        tool.forceY_N, tool.forceY_N, tool.deflectionY_mm});
    }
    return rows;
}

std::vector<CutRow> rowsOf(std::size_t index) {
    switch (index) {
        case 0:
            return simulateCut(constantCase(1.53)).rows;
        case 1:
            return simulateCut(constantCase(0.85)).rows;
        case 2:
            return simulateCut(piCase(0.75, 0.15, 40.0)).rows;
        case 3:
            return simulateCut(piCase(0.75, 0.15, 25.0)).rows;
        case 4:
            return simulateCut(piCase(0.75, 0.15, 25.0, 0.68)).rows;
        case 5:
            return simulateCut(piCase(0.13, 0.026, 40.0)).rows;
        case 6:
            return simulateCut(piCase(3.0, 0.6, 40.0)).rows;
        case 7:
            return fixedWeightCut(0.5, 0.6, false);
        default:
            return fixedWeightCut(0.1, 0.35, true);
    }
}

}  // namespace

class TestMillingGolden : public QObject {
    Q_OBJECT

 private slots:
    void plantStepMatches() {
        const json golden = test::loadGolden("golden_milling.json");
        for (const json& row : golden["step"]) {
            PlantParams plant;
            plant.exponent = row["m"];
            plant.forceAngle_deg = row["theta_deg"];
            plant.kx_NPerMm = row["kx"].get<double>() * kKgf;
            plant.ky_NPerMm = row["ky"].get<double>() * kKgf;
            plant.cuttingCoefficient = row["C"].get<double>() * kKgf;
            const RevolutionState tool =
                stepRevolution(plant, row["b"], row["delta_x"], row["feed_mm_s"].get<double>() * kRevolution_s);
            KERF_CLOSE(tool.deflectionX_mm, row["expect"]["delta_x"], kTolerance);
            KERF_CLOSE(tool.cutFeed_mmPerRev, row["expect"]["l"], kTolerance);
            KERF_CLOSE(tool.forceY_N / kKgf, row["expect"]["F_y"], kTolerance);
            KERF_CLOSE(tool.deflectionY_mm, row["expect"]["delta_y"], kTolerance);
        }
    }
    void linearFormMatches() {
        const json golden = test::loadGolden("golden_milling.json");
        for (const json& row : golden["linear"]) {
            const LinearForm form = linearForm(PlantParams(), row["b"], row["l"], kPulseUnit_mmPerS * kRevolution_s);
            const json& expect = row["expect"];
            KERF_CLOSE(form.ra_NPerMm / kKgf, expect["r_a"], kTolerance);
            KERF_CLOSE(form.mu, expect["mu"], kTolerance);
            KERF_CLOSE(form.a1, expect["a1"], kTolerance);
            KERF_CLOSE(form.b0_NPerUnit / kKgf, expect["b0"], kTolerance);
            KERF_CLOSE(form.dcGain_NPerUnit / kKgf, expect["dc"], kTolerance);
            KERF_CLOSE(form.a1Tangent, expect["a1_tangent"], kTolerance);
            KERF_CLOSE(form.b0Tangent_NPerUnit / kKgf, expect["b0_tangent"], kTolerance);
        }
    }
    void engagedDepthMatches() {
        const json golden = test::loadGolden("golden_milling.json");
        for (const json& row : golden["profile_engaged_depth"]) {
            const auto heights_mm = row["heights"].get<std::vector<double>>();
            const BlankProfile blank = *BlankProfile::ofSegments(heights_mm, row["seg"]);
            KERF_CLOSE(blank.engagedDepth_mm(row["x"], row["r"]), row["expect"], kTolerance);
        }
    }
    void piVelocityFormMatches() {
        const json golden = test::loadGolden("golden_milling.json")["pi_velocity_form"];
        PiLaw law({golden["k0"], golden["k0"].get<double>() * (1.0 - golden["alpha"].get<double>()), kRevolution_s});
        const FeedRange unbounded{-1e9, 1e9};
        for (std::size_t i = 0; i < golden["e"].size(); ++i) {
            KERF_CLOSE(law.update(golden["e"][i], kRevolution_s, unbounded), golden["expect_u"][i], kTolerance);
        }
    }
    void continuousContactDepthMatches() {
        const json golden = test::loadGolden("golden_milling.json");
        for (const json& row : golden["eq31_axial_depth"]) {
            KERF_CLOSE(continuousAxialDepth_mm(row["r"], row["b"], row["beta_deg"]), row["expect"], kTolerance);
        }
    }
    void closedLoopsMatch_data() {
        QTest::addColumn<int>("index");
        const json golden = test::loadGolden("golden_milling.json")["closed_loop"];
        for (std::size_t i = 0; i < golden.size(); ++i) {
            QTest::newRow(golden[i]["name"].get<std::string>().c_str()) << static_cast<int>(i);
        }
    }
    void closedLoopsMatch() {
        QFETCH(int, index);
        const json golden = test::loadGolden("golden_milling.json")["closed_loop"][static_cast<std::size_t>(index)];
        const std::vector<CutRow> rows = rowsOf(static_cast<std::size_t>(index));
        const json& expect = golden["expect"];
        QVERIFY(rows.size() >= expect["x"].size());
        for (std::size_t i = 0; i < expect["x"].size(); ++i) {
            KERF_CLOSE(rows[i].x_mm, expect["x"][i], kTolerance);
            KERF_CLOSE(rows[i].depth_mm, expect["b"][i], kTolerance);
            KERF_CLOSE(rows[i].cutFeed_mmPerRev, expect["l"][i], kTolerance);
            KERF_CLOSE(rows[i].force_N / kKgf, expect["F_y"][i], kTolerance);
            KERF_CLOSE(rows[i].feedCommand_mmPerS / kPulseUnit_mmPerS, expect["u_units"][i], kTolerance);
        }
        std::vector<double> x_mm;
        std::vector<double> y_mm;
        double peak_kgf = 0.0;
        for (const CutRow& row : rows) {
            x_mm.push_back(row.x_mm);
            y_mm.push_back(row.deflectionY_mm);
            peak_kgf = row.x_mm >= 10.0 ? std::max(peak_kgf, row.force_N / kKgf) : peak_kgf;
        }
        const auto waviness = wallWaviness(x_mm, y_mm, WallScan());
        QVERIFY(waviness.has_value());
        if (golden["tol_waviness_um"].is_string()) {  // the limit cycle: only a band is meaningful
            QVERIFY(waviness->spot_um > 20.0 && waviness->spot_um < 45.0);
            return;
        }
        QCOMPARE(static_cast<int>(rows.size()), golden["revs"].get<int>());
        KERF_CLOSE(static_cast<double>(rows.size()) * kRevolution_s, golden["time_s"], kTolerance);
        KERF_CLOSE(waviness->spot_um, golden["waviness_spot2_um"], 1e-6);
        KERF_CLOSE(waviness->raw_um, golden["waviness_raw_um"], 1e-6);
        KERF_CLOSE(peak_kgf, golden["Fmax_after_10mm"], kTolerance);
    }
};

QTEST_APPLESS_MAIN(TestMillingGolden)
#include "tst_milling_golden.moc"
