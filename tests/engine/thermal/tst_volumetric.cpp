// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <QTest>

#include "engine/process/thermal/volumetric.h"
#include "tests/support/golden.h"

using kerf::thermal::exactError_mm;
using kerf::thermal::firstOrderError_mm;
using kerf::thermal::VolumetricChain;
using nlohmann::json;

namespace {

Eigen::Vector3d vectorOf(const json& value) {
    return Eigen::Vector3d(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

VolumetricChain chainOf(const json& input) {
    VolumetricChain chain;
    chain.position_mm = vectorOf(input["xyz"]);
    for (std::size_t link = 0; link < 4; ++link) {
        chain.shape_mm[link] = vectorOf(input["shape"][link]["d"]);
        chain.shapeError[link] = {vectorOf(input["shape"][link]["e"]), vectorOf(input["shape"][link]["w"])};
    }
    for (std::size_t link = 0; link < 3; ++link) {
        chain.jointError[link] = {vectorOf(input["joint"][link]["e"]), vectorOf(input["joint"][link]["w"])};
    }
    return chain;
}

VolumetricChain scaled(VolumetricChain chain, double factor) {
    for (auto& link : chain.shapeError) {
        link.delta_mm *= factor;
        link.omega_rad *= factor;
    }
    for (auto& link : chain.jointError) {
        link.delta_mm *= factor;
        link.omega_rad *= factor;
    }
    return chain;
}

double difference_mm(const VolumetricChain& chain) {
    return (exactError_mm(chain) - firstOrderError_mm(chain)).norm();
}

}  // namespace

class TestVolumetric : public QObject {
    Q_OBJECT
 private slots:
    void bothModesMatchTheReference();
    void everySingleElementMatchesTheReference();
    void transformMatchesTheReference();
    void exactErrorIsTheInverseOfTheTransform();
    void secondOrderPartShrinksFourfoldPerHalving();
    void elementsLinearInPositionAddUpAtAPosition();

 private:
    json m_golden = kerf::test::loadGolden("golden_htm.json");
};

void TestVolumetric::bothModesMatchTheReference() {
    QVERIFY(!m_golden["random_cases"].empty());
    for (const json& one : m_golden["random_cases"]) {
        const VolumetricChain chain = chainOf(one["input"]);
        QVERIFY((exactError_mm(chain) - vectorOf(one["e_lin"])).cwiseAbs().maxCoeff() <= 1e-12);
        QVERIFY((firstOrderError_mm(chain) - vectorOf(one["e_eq8"])).cwiseAbs().maxCoeff() <= 1e-12);
    }
}

void TestVolumetric::everySingleElementMatchesTheReference() {
    QCOMPARE(m_golden["unit_cases"].size(), std::size_t{42});
    for (const json& one : m_golden["unit_cases"]) {
        json input = m_golden["base_for_unit"];
        const std::size_t index = one["index"].get<std::size_t>() - 1U;
        json& link = input[one["group"].get<std::string>()][index];
        link[one["field"].get<std::string>()][one["axis"].get<std::size_t>()] = one["value"];
        const VolumetricChain chain = chainOf(input);
        QVERIFY((exactError_mm(chain) - vectorOf(one["e_lin"])).cwiseAbs().maxCoeff() <= 1e-12);
        QVERIFY((firstOrderError_mm(chain) - vectorOf(one["e_eq8"])).cwiseAbs().maxCoeff() <= 1e-12);
    }
}

void TestVolumetric::transformMatchesTheReference() {
    const json& one = m_golden["random_cases"][0];
    const Eigen::Matrix4d h = kerf::thermal::actualTransform(chainOf(one["input"]));
    for (Eigen::Index row = 0; row < 4; ++row) {
        for (Eigen::Index col = 0; col < 4; ++col) {
            KERF_CLOSE(h(row, col),
                       one["H_lin"][static_cast<std::size_t>(row)][static_cast<std::size_t>(col)].get<double>(), 1e-12);
        }
    }
}

void TestVolumetric::exactErrorIsTheInverseOfTheTransform() {
    for (const json& one : m_golden["random_cases"]) {
        const VolumetricChain chain = chainOf(one["input"]);
        const Eigen::Vector4d origin(0.0, 0.0, 0.0, 1.0);
        const Eigen::Vector3d actual = kerf::thermal::actualTransform(chain).inverse().eval().col(3).head<3>();
        const Eigen::Vector3d ideal =
            kerf::thermal::actualTransform(scaled(chain, 0.0)).inverse().eval().col(3).head<3>();
        QVERIFY((actual - ideal - exactError_mm(chain)).norm() < 1e-9);  // subtraction of two 700 mm positions
    }
}

void TestVolumetric::secondOrderPartShrinksFourfoldPerHalving() {
    for (const json& one : m_golden["random_cases"]) {
        VolumetricChain chain = chainOf(one["input"]);
        for (int halving = 0; halving < 4; ++halving) {
            const double before_mm = difference_mm(chain);
            chain = scaled(chain, 0.5);
            const double ratio = before_mm / difference_mm(chain);
            QVERIFY2(std::abs(ratio - 4.0) <= 0.05, qPrintable(QString::number(ratio, 'g', 12)));
        }
    }
}

void TestVolumetric::elementsLinearInPositionAddUpAtAPosition() {
    kerf::thermal::ErrorElements elements;
    elements.jointErrorPer_mm[0].delta_mm = {0.0, 0.0, 20e-6};  // Z screw grows 20 µm/m
    elements.jointError[2].delta_mm = {5e-3, 0.0, 0.0};
    const Eigen::Vector3d error = firstOrderError_mm(elements.at({100.0, 0.0, 500.0}));
    KERF_CLOSE(error.x(), -5e-3, 1e-15);
    KERF_CLOSE(error.z(), -10e-3, 1e-15);
}

QTEST_APPLESS_MAIN(TestVolumetric)
#include "tst_volumetric.moc"
