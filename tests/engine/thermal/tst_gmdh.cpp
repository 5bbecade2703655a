// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/QR>
#include <QTest>
#include <numeric>

#include "engine/core/random.h"
#include "engine/process/thermal/gmdh.h"
#include "tests/support/golden.h"

using namespace kerf::thermal;
using nlohmann::json;

namespace {

Eigen::MatrixXd matrixOf(const json& rows) {
    Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            out(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = rows[r][c].get<double>();
        }
    }
    return out;
}
Eigen::VectorXd vectorOf(const json& values) {
    Eigen::VectorXd out(static_cast<Eigen::Index>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k) {
        out[static_cast<Eigen::Index>(k)] = values[k].get<double>();
    }
    return out;
}
GmdhRows thirds(Eigen::Index rows) {
    GmdhRows out;
    for (Eigen::Index row = 0; row < rows; ++row) {
        (row < rows / 3 ? out.a : row < 2 * rows / 3 ? out.b : out.check).push_back(row);
    }
    return out;
}
std::vector<double> rowOf(const Eigen::MatrixXd& x, Eigen::Index row) {
    const Eigen::RowVectorXd r = x.row(row);
    return {r.begin(), r.end()};
}
/// As the reference was computed: nothing scaled, nothing guarded.
GmdhOptions raw(int width) {
    GmdhOptions options = GmdhOptions::asPrinted();
    options.standardise = false;
    options.width = width;
    options.maxLayers = 5;  // where the reference stopped
    return options;
}

}  // namespace

class TestGmdh : public QObject {
    Q_OBJECT
 private slots:
    void findsAnExactPolynomialInOneLayer();
    void everyFirstLayerCandidateMatchesTheReference();
    void growsLikeTheReference_data();
    void growsLikeTheReference();
    void standardisedRidgeMatchesTheReference();
    void pairMomentsGiveThePlainLeastSquares();
    void severalOutputsGiveTheSameModelsAsOneByOne();
    void guardedNetworkStaysBoundedFarOutside();
    void tooFewRowsAreRefused();
};

void TestGmdh::findsAnExactPolynomialInOneLayer() {
    const json golden = kerf::test::loadGolden("golden_gmdh.json")["G1_exact_single_layer"];
    const Eigen::MatrixXd x = matrixOf(golden["X"]);
    const Eigen::VectorXd y = vectorOf(golden["y"]);
    const auto models = trainGmdh(x, y, thirds(60), raw(4));
    QVERIFY(models.has_value());
    const GmdhModel& model = models->front();
    QCOMPARE(model.layers.size(), std::size_t{1});
    QCOMPARE(model.layers[0].size(), std::size_t{1});
    const GmdhNeuron& neuron = model.layers[0][0];
    QCOMPARE(neuron.i, golden["pair"][0].get<int>());
    QCOMPARE(neuron.j, golden["pair"][1].get<int>());
    QVERIFY(neuron.c < 1e-13);
    for (std::size_t k = 0; k < 6; ++k) {
        KERF_CLOSE(neuron.coef[k], golden["coef"][k].get<double>(), golden["coef_tol"].get<double>());
    }
    for (Eigen::Index row = 0; row < x.rows(); ++row) {
        KERF_CLOSE(model.predict(rowOf(x, row)), y[row], golden["pred_tol"].get<double>());
    }
}

void TestGmdh::everyFirstLayerCandidateMatchesTheReference() {
    const json golden = kerf::test::loadGolden("golden_gmdh.json")["G2_two_layer_noisy"];
    const auto candidates = firstLayerCandidates(matrixOf(golden["X"]), vectorOf(golden["y"]), thirds(90), raw(10));
    QCOMPARE(candidates.size(), golden["layer1"].size());
    const auto tolerance = golden["layer1_tol"].get<double>();
    for (std::size_t n = 0; n < candidates.size(); ++n) {
        const json& expected = golden["layer1"][n];
        QCOMPARE(candidates[n].i, expected["i"].get<int>());
        QCOMPARE(candidates[n].j, expected["j"].get<int>());
        for (std::size_t k = 0; k < 6; ++k) {
            KERF_CLOSE(candidates[n].coef[k], expected["coef"][k].get<double>(), tolerance);
            KERF_CLOSE(candidates[n].coefA[k], expected["coefA"][k].get<double>(), tolerance);
            KERF_CLOSE(candidates[n].coefB[k], expected["coefB"][k].get<double>(), tolerance);
        }
        KERF_CLOSE(candidates[n].r, expected["r"].get<double>(), tolerance);
        KERF_CLOSE(candidates[n].u, expected["u"].get<double>(), tolerance);
        KERF_CLOSE(candidates[n].c, expected["c"].get<double>(), tolerance);
    }
}

void TestGmdh::growsLikeTheReference_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("criterion");
    const json results = kerf::test::loadGolden("golden_gmdh.json")["G2_two_layer_noisy"]["results"];
    for (const auto& [name, value] : results.items()) {
        const auto criterion = name == "regularity" ? GmdhCriterion::Regularity
                               : name == "unbiased" ? GmdhCriterion::Unbiased
                                                    : GmdhCriterion::Combined;
        QTest::newRow(name.c_str()) << QString::fromStdString(name) << static_cast<int>(criterion);
    }
}

void TestGmdh::growsLikeTheReference() {
    QFETCH(QString, name);
    QFETCH(int, criterion);
    const json golden = kerf::test::loadGolden("golden_gmdh.json")["G2_two_layer_noisy"];
    const json& expected = golden["results"][name.toStdString()];
    GmdhOptions options = raw(10);
    options.criterion = static_cast<GmdhCriterion>(criterion);
    const Eigen::MatrixXd x = matrixOf(golden["X"]);
    const auto models = trainGmdh(x, vectorOf(golden["y"]), thirds(90), options);
    QVERIFY(models.has_value());
    const GmdhModel& model = models->front();
    const json& history = expected["model"]["history"];
    QCOMPARE(model.growth.size(), history.size());
    for (std::size_t layer = 0; layer < history.size(); ++layer) {
        QCOMPARE(model.growth[layer].candidates, history[layer]["candidates"].get<int>());
        KERF_CLOSE(model.growth[layer].bestCriterion, history[layer]["best_c"].get<double>(), 1e-8);
    }
    QVERIFY(json(model.usedInputs()) == expected["inputs"]);
    for (Eigen::Index row = 0; row < x.rows(); ++row) {
        KERF_CLOSE(model.predict(rowOf(x, row)), expected["pred"][static_cast<std::size_t>(row)].get<double>(),
                   golden["pred_tol"].get<double>());
    }
}

void TestGmdh::standardisedRidgeMatchesTheReference() {
    const json all = kerf::test::loadGolden("golden_gmdh.json");
    const json& golden = all["G3_standardised_ridge"];
    const Eigen::MatrixXd x = matrixOf(all["G2_two_layer_noisy"]["X"]);
    GmdhOptions options = raw(10);
    options.standardise = true;
    options.ridge = 1e-4;
    const auto models = trainGmdh(x, vectorOf(all["G2_two_layer_noisy"]["y"]), thirds(90), options);
    QVERIFY(models.has_value());
    const GmdhModel& model = models->front();
    KERF_CLOSE(model.outputMean, golden["model"]["y_mean"].get<double>(), 1e-12);
    KERF_CLOSE(model.outputScale, golden["model"]["y_scale"].get<double>(), 1e-12);
    QCOMPARE(model.layers.size(), golden["model"]["layers"].size());
    for (Eigen::Index row = 0; row < x.rows(); ++row) {
        KERF_CLOSE(model.predict(rowOf(x, row)), golden["pred"][static_cast<std::size_t>(row)].get<double>(),
                   golden["pred_tol"].get<double>());
    }
}

void TestGmdh::pairMomentsGiveThePlainLeastSquares() {
    kerf::Random random(7);
    Eigen::MatrixXd x(90, 5);
    for (double& value : x.reshaped()) {
        value = random.gauss();
    }
    Eigen::VectorXd y(90);
    for (double& value : y) {
        value = random.gauss();
    }
    for (const GmdhBasis basis : {GmdhBasis::Quadratic, GmdhBasis::Bilinear}) {
        GmdhOptions options = raw(3);
        options.basis = basis;
        for (const GmdhCandidate& c : firstLayerCandidates(x, y, thirds(90), options)) {
            const int terms = basis == GmdhBasis::Quadratic ? 6 : 4;
            Eigen::MatrixXd design(60, terms);
            for (Eigen::Index row = 0; row < 60; ++row) {
                const double a = x(row, c.i);
                const double b = x(row, c.j);
                if (terms == 6) {
                    design.row(row) << 1.0, a, b, a * a, b * b, a * b;
                } else {
                    design.row(row) << 1.0, a, b, a * b;
                }
            }
            const Eigen::VectorXd w = design.colPivHouseholderQr().solve(y.head(60));
            KERF_CLOSE(c.coef[0], w[0], 1e-10);
            KERF_CLOSE(c.coef[1], w[1], 1e-10);
            KERF_CLOSE(c.coef[5], w[terms - 1], 1e-10);
        }
    }
}

void TestGmdh::severalOutputsGiveTheSameModelsAsOneByOne() {
    kerf::Random random(11);
    Eigen::MatrixXd x(120, 8);
    for (double& value : x.reshaped()) {
        value = random.gauss();
    }
    Eigen::MatrixXd y(120, 2);
    y.col(0) = x.col(1) + 0.5 * x.col(3).cwiseProduct(x.col(4));
    y.col(1) = x.col(2) - x.col(6).cwiseProduct(x.col(6));
    const auto together = trainGmdh(x, y, thirds(120), GmdhOptions::guarded());
    QVERIFY(together.has_value());
    for (Eigen::Index output = 0; output < 2; ++output) {
        const auto alone = trainGmdh(x, y.col(output), thirds(120), GmdhOptions::guarded());
        QVERIFY(alone.has_value());
        for (Eigen::Index row = 0; row < x.rows(); ++row) {
            QCOMPARE(together->at(static_cast<std::size_t>(output)).predict(rowOf(x, row)),
                     alone->front().predict(rowOf(x, row)));
        }
    }
}

void TestGmdh::guardedNetworkStaysBoundedFarOutside() {
    kerf::Random random(3);
    Eigen::MatrixXd x(150, 6);
    for (double& value : x.reshaped()) {
        value = random.uniform(0.0, 5.0);
    }
    const Eigen::VectorXd y = x.col(0) + 0.3 * x.col(1).cwiseProduct(x.col(2));
    const auto models = trainGmdh(x, y, thirds(150), GmdhOptions::guarded());
    QVERIFY(models.has_value());
    const double span = y.maxCoeff() - y.minCoeff();
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> far(6);
        for (double& value : far) {
            value = random.uniform(-1e6, 1e6);
        }
        const double z = models->front().predict(far);
        QVERIFY(z >= y.minCoeff() - 2.0 * span && z <= y.maxCoeff() + 2.0 * span);
    }
}

void TestGmdh::tooFewRowsAreRefused() {
    const Eigen::MatrixXd x = Eigen::MatrixXd::Random(12, 4);
    const auto models = trainGmdh(x, x.col(0), thirds(12), GmdhOptions::guarded());
    QVERIFY(!models.has_value());
    QVERIFY(!models.error().english().empty());
    QVERIFY(!trainGmdh(x.leftCols(1), x.col(0), thirds(12), GmdhOptions::guarded()).has_value());
}

QTEST_APPLESS_MAIN(TestGmdh)
#include "tst_gmdh.moc"
