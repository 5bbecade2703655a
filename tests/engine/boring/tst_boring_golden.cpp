// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "engine/process/boring/feed_law.h"
#include "engine/process/boring/perturbation_estimator.h"
#include "engine/process/boring/plant.h"
#include "tests/support/golden.h"

namespace {

using namespace kerf::boring;
using nlohmann::json;

constexpr double kTolerance = 1e-9;
constexpr std::array<double, 2> kOverhangs_mm{40.0, 310.0};

Eigen::Vector3d vectorFrom(const json& j) {
    return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

Eigen::Matrix3d matrixFrom(const json& j) {
    Eigen::Matrix3d m;
    for (int row = 0; row < 3; ++row) {
        m.row(row) = vectorFrom(j[static_cast<std::size_t>(row)]);
    }
    return m;
}

PerturbationParams::Trigger triggerFrom(const std::string& name) {
    return name == "seq"   ? PerturbationParams::Trigger::Consecutive
           : name == "pos" ? PerturbationParams::Trigger::SameOverhang
                           : PerturbationParams::Trigger::Either;
}

PerturbationParams paramsFrom(const json& scenario) {
    PerturbationParams params;
    params.sigma_mm = scenario["sigma"];
    params.alpha0 = scenario["alpha0"];
    const std::string form = scenario["form"];
    params.noise = form == "K"    ? PerturbationParams::Noise::Consistent
                   : form == "S1" ? PerturbationParams::Noise::Unit
                                  : PerturbationParams::Noise::LiteralPrint;
    params.trigger = triggerFrom(scenario["trigger"]);
    params.timing = scenario["timing"] == "before" ? PerturbationParams::Timing::BeforeUpdate
                                                   : PerturbationParams::Timing::AfterUpdate;
    params.firstPartUpdates = scenario["part1_update"];
    return params;
}

}  // namespace

class TestBoringGolden : public QObject {
    Q_OBJECT
    json m_golden;

 private slots:
    void initTestCase() {
        m_golden = kerf::test::loadGolden("golden_boring.json");
        QVERIFY(m_golden["scenarios"].size() >= 7);
    }

    void firstPartGivesAlphaBetaAndC() {
        for (const auto& one : m_golden["init"]) {
            const Measurement first{one["L1"], one["S0"], one["d1"], false};
            const Measurement second{one["L2"], one["S0"], one["d2"], false};
            const LawConstants law = firstEstimate(one["alpha0"], first, second);
            KERF_CLOSE(law.lnC, one["expect"]["lnC"].get<double>(), kTolerance);
            KERF_CLOSE(law.alpha, one["expect"]["alpha"].get<double>(), kTolerance);
            KERF_CLOSE(law.beta, one["expect"]["beta"].get<double>(), kTolerance);
        }
    }

    void feedHoldsTheDeflectionAtEveryOverhang() {
        for (const auto& one : m_golden["s_opt"]) {
            const LawConstants law{std::log(one["C"].get<double>()), one["alpha"], one["beta"]};
            const double feed_mmPerRev = optimalFeed_mmPerRev(law, kTableTargetDeflection_mm, one["L"]);
            KERF_CLOSE(feed_mmPerRev, one["expect"].get<double>(), kTolerance);
            KERF_CLOSE(deflection_mm(law, feed_mmPerRev, one["L"]), kTableTargetDeflection_mm, 1e-12);
        }
    }

    void depthOfCutGivesTheTablesC() {
        const double c = constantC(1.0 / kTableInverseK_perMm, kTableGamma, kTableDepthOfCut_mm);
        QVERIFY(std::abs(c - kTableC) < 5e-5);  // the table rounds to four decimals
        KERF_CLOSE(deflection_mm(1.0 / kTableInverseK_perMm, 0.5, 0.3, kTableGamma, 0.2, 100.0, kTableDepthOfCut_mm),
                   deflection_mm({std::log(c), 0.5, 0.3}, 0.2, 100.0), 1e-12);
    }

    void diameterBecomesDeflectionAndBack() {
        for (const auto& one : m_golden["eq11"]) {
            const double target_mm = 50.0;
            const double measured_mm = target_mm - one["delta"].get<double>();
            const double d_mm =
                deflectionFromDiameter_mm(measured_mm, target_mm, kTableTargetDeflection_mm, one["phi_deg"]);
            KERF_CLOSE(d_mm, one["expect"].get<double>(), kTolerance);
            KERF_CLOSE(diameterFromDeflection_mm(d_mm, target_mm, kTableTargetDeflection_mm, one["phi_deg"]),
                       measured_mm, 1e-12);
        }
    }

    void oneStepOfLeastSquaresInEveryForm() {
        for (const auto& one : m_golden["rls_step"]) {
            Eigen::Vector3d theta = vectorFrom(one["theta"]);
            Eigen::Matrix3d p = matrixFrom(one["P"]);
            const Eigen::Vector3d x = vectorFrom(one["x"]);
            KERF_CLOSE(x.dot(p * x), one["expect"]["xPx"].get<double>(), kTolerance);
            const double innovation = recursiveLeastSquaresStep(theta, p, x, one["y"], one["A"], one["B"]);
            KERF_CLOSE(innovation, one["expect"]["innovation"].get<double>(), kTolerance);
            const Eigen::Vector3d expectedTheta = vectorFrom(one["expect"]["theta"]);
            const Eigen::Matrix3d expectedP = matrixFrom(one["expect"]["P"]);
            for (int i = 0; i < 3; ++i) {
                KERF_CLOSE(theta(i), expectedTheta(i), kTolerance);
                for (int k = 0; k < 3; ++k) {
                    KERF_CLOSE(p(i, k), expectedP(i, k), kTolerance);
                }
            }
        }
    }

    void threeInARowFireWhereTheReferenceFires() {
        for (const auto& one : m_golden["trigger"]) {
            for (const std::string name : {"seq", "pos", "either"}) {
                PerturbationParams params;
                params.sigma_mm = one["sigma"];
                params.trigger = triggerFrom(name);
                PerturbationState state;
                json fires = json::array();
                int part = one["first_part"].get<int>();
                for (const auto& pair : one["d_meas"]) {
                    for (std::size_t i = 0; i < pair.size(); ++i) {
                        if (noticeOutside(state, params, {kOverhangs_mm[i], 0.1, pair[i], false})) {
                            fires.push_back({part, i + 1});
                        }
                    }
                    ++part;
                }
                QCOMPARE(QString::fromStdString(fires.dump()),
                         QString::fromStdString(one["expect_fires_part_measurement"][name].dump()));
            }
        }
    }

    void wholeLotsFollowTheReference_data() {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const auto& scenario : m_golden["scenarios"]) {
            QTest::newRow(scenario["name"].get<std::string>().c_str()) << index++;
        }
    }
    void wholeLotsFollowTheReference() {
        QFETCH(int, index);
        const json& scenario = m_golden["scenarios"][static_cast<std::size_t>(index)];
        const PerturbationParams params = paramsFrom(scenario);
        const FeedLawParams law = feedLawParams(EstimatorKind::Perturbation, kTableTargetDeflection_mm, scenario["S0"]);
        const TruthPlan truth = TruthPlan::paper();
        EstimatorState state = PerturbationState{};
        for (const auto& part : scenario["parts"]) {
            const auto number = part["part"].get<std::uint32_t>();
            const auto schedule = adviseFeed(state, law).schedule;
            PartVisit visit;
            visit.part = number;
            for (std::size_t i = 0; i < kOverhangs_mm.size(); ++i) {
                const double feed_mmPerRev = schedule.feed_mmPerRev(kOverhangs_mm[i]);
                KERF_CLOSE(feed_mmPerRev, part["S"][i].get<double>(), kTolerance);
                const double true_mm = deflection_mm(truth.at(number), feed_mmPerRev, kOverhangs_mm[i]);
                KERF_CLOSE(true_mm, part["d_true"][i].get<double>(), kTolerance);
                const double z = scenario["z"][number - 1][i];
                const Measurement measured =
                    measurementAt(schedule, kOverhangs_mm[i], measured_mm(true_mm, params.sigma_mm, z));
                KERF_CLOSE(measured.deflection_mm, part["d_meas"][i].get<double>(), kTolerance);
                visit.rows[visit.count++] = measured;
            }
            std::array<RowOutcome, 2> rows{};
            state = update(std::get<PerturbationState>(state), params, visit, rows);
            json fires = json::array();
            for (std::size_t i = 0; i < rows.size(); ++i) {
                if (rows[i].perturbed) {
                    fires.push_back(i + 1);
                }
            }
            QCOMPARE(QString::fromStdString(fires.dump()),
                     QString::fromStdString(part["fire_after_measurement"].dump()));
            const Estimate estimate = estimateOf(state);
            KERF_CLOSE(estimate.law.lnC, part["lnC"].get<double>(), kTolerance);
            KERF_CLOSE(estimate.law.alpha, part["alpha"].get<double>(), kTolerance);
            KERF_CLOSE(estimate.law.beta, part["beta"].get<double>(), kTolerance);
            for (std::size_t i = 0; i < estimate.covariance.size(); ++i) {
                KERF_CLOSE(estimate.covariance[i], part["P"][i].get<double>(), kTolerance);
            }
        }
    }
};
QTEST_APPLESS_MAIN(TestBoringGolden)
#include "tst_boring_golden.moc"
