// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/process/turning/identifier.h"

using namespace kerf::turning;
using kerf::Random;

namespace {

double worstError(const Eigen::Vector3d& theta, const ProcessParams& truth) {
    return std::max({std::abs(theta[0] - truth.a1), std::abs(theta[1] - truth.b0), std::abs(theta[2] - truth.b1)});
}
bool insideFivePercent(const Eigen::Vector3d& theta, const ProcessParams& truth) {
    return std::abs(theta[0] / truth.a1 - 1.0) < 0.05 && std::abs(theta[1] / truth.b0 - 1.0) < 0.05 &&
           std::abs(theta[2] / truth.b1 - 1.0) < 0.05;
}

}  // namespace

/// The default identification: what must hold, item 4, on other seeds and chips than it was made with.
class TestProcessIdentifier : public QObject {
    Q_OBJECT
 private slots:
    void staysInsideFivePercent_data() {
        QTest::addColumn<double>("spread_um");
        QTest::addColumn<double>("noise_N");
        QTest::addColumn<double>("share");
        QTest::newRow("5 mN") << 0.5 << 0.005 << 0.99;
        QTest::newRow("5 mN, small chip variation") << 0.1 << 0.005 << 0.99;
        QTest::newRow("20 mN") << 0.5 << 0.02 << 0.99;
    }
    void staysInsideFivePercent() {
        QFETCH(double, spread_um);
        QFETCH(double, noise_N);
        QFETCH(double, share);
        for (const double forgetting : {0.9, 0.98}) {
            int inside = 0;
            int all = 0;
            for (std::uint64_t seed = 301; seed < 321; ++seed) {
                Random chip(seed);
                Random sensor(seed + 5000);
                CuttingProcess process{ProcessParams{}};
                ProcessIdentifier identifier({forgetting, Forgetting::Robust, 1e4, 0.0});
                for (int k = 0; k < 1000; ++k) {
                    const double chip_um = 6.0 + spread_um * chip.gauss();
                    identifier.update(process.step(chip_um) + noise_N * sensor.gauss(), chip_um);
                    inside += insideFivePercent(identifier.theta(), ProcessParams{}) ? 1 : 0;
                    ++all;
                }
            }
            QVERIFY2(inside >= share * all, qPrintable(QString::number(inside)));
        }
    }
    void unexcitedItStandsStill() {
        for (std::uint64_t seed = 401; seed < 431; ++seed) {
            Random chip(seed);
            Random sensor(seed + 5000);
            CuttingProcess process{ProcessParams{}};
            ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
            double worst = 0.0;
            for (int k = 0; k < 2600; ++k) {
                const double chip_um = k < 1000 ? 6.0 + 0.5 * chip.gauss() : 6.0;
                identifier.update(process.step(chip_um) + 0.005 * sensor.gauss(), chip_um);
                worst = k < 1000 ? 0.0 : std::max(worst, worstError(identifier.theta(), ProcessParams{}));
            }
            QVERIFY2(worst <= 0.008, qPrintable(QString::number(worst)));
        }
    }
    void finiteAndSymmetricAfterAMillionSamples_data() {
        QTest::addColumn<int>("excitedSamples");
        QTest::addColumn<double>("noise_N");
        QTest::newRow("excited") << 1'000'000 << 0.005;
        QTest::newRow("excited for .2 s, then at rest") << 1000 << 0.005;
        QTest::newRow("never excited") << 0 << 0.005;
        QTest::newRow("no noise at all") << 1000 << 0.0;
    }
    void finiteAndSymmetricAfterAMillionSamples() {
        QFETCH(int, excitedSamples);
        QFETCH(double, noise_N);
        Random chip(77);
        Random sensor(78);
        CuttingProcess process{ProcessParams{}};
        ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
        for (int k = 0; k < 1'000'000; ++k) {
            const double chip_um = k < excitedSamples ? 6.0 + 0.5 * chip.gauss() : 6.0;
            identifier.update(process.step(chip_um) + noise_N * sensor.gauss(), chip_um);
            if (k % 1000 == 0) {
                QVERIFY(identifier.theta().allFinite() && identifier.covariance().allFinite());
                QCOMPARE(identifier.covariance(), Eigen::Matrix3d(identifier.covariance().transpose()));
                QVERIFY(identifier.trace() <= 3.1e4);
            }
        }
        if (excitedSamples > 0) {
            QVERIFY(worstError(identifier.theta(), ProcessParams{}) < 0.02);
        }
    }
    void followsAChippedToolInFiftyMilliseconds() {
        for (std::uint64_t seed = 501; seed < 511; ++seed) {
            Random chip(seed);
            Random sensor(seed + 5000);
            ProcessParams truth;
            CuttingProcess process{truth};
            ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
            int lastOutside = 0;
            for (int k = 0; k < 4000; ++k) {
                if (k == 2000) {
                    truth.b0 *= 1.5;
                    truth.b1 *= 1.5;
                    process.setParams(truth);
                }
                const double chip_um = 6.0 + 0.5 * chip.gauss();
                identifier.update(process.step(chip_um) + 0.005 * sensor.gauss(), chip_um);
                lastOutside = insideFivePercent(identifier.theta(), truth) ? lastOutside : k;
            }
            QVERIFY2(lastOutside < 2250, qPrintable(QString::number(lastOutside)));
        }
    }
    void intervalsHoldTheTruthMostOfTheTime() {
        int inside = 0;
        int all = 0;
        for (std::uint64_t seed = 601; seed < 641; ++seed) {
            Random chip(seed);
            Random sensor(seed + 5000);
            CuttingProcess process{ProcessParams{}};
            ProcessIdentifier identifier({0.98, Forgetting::Robust, 1e4, 0.0});
            for (int k = 0; k < 600; ++k) {
                const double chip_um = 6.0 + 0.5 * chip.gauss();
                identifier.update(process.step(chip_um) + 0.005 * sensor.gauss(), chip_um);
            }
            const auto estimate = identifier.estimate();
            inside += std::abs(estimate.process.a1 - ProcessParams{}.a1) <= estimate.half95[0] ? 1 : 0;
            inside += std::abs(estimate.process.b0 - ProcessParams{}.b0) <= estimate.half95[1] ? 1 : 0;
            inside += std::abs(estimate.process.b1 - ProcessParams{}.b1) <= estimate.half95[2] ? 1 : 0;
            all += 3;
        }
        QVERIFY2(inside >= all * 85 / 100, qPrintable(QStringLiteral("%1 of %2").arg(inside).arg(all)));
    }
    void excitationTellsRestFromMotion() {
        ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
        CuttingProcess process{ProcessParams{}};
        Random random(9);
        for (int k = 0; k < 2000; ++k) {
            const double chip_um = 6.0 + 0.5 * random.gauss();
            identifier.update(process.step(chip_um) + 0.005 * random.gauss(), chip_um);
        }
        QVERIFY(identifier.excitation() > 20.0);
        for (int k = 0; k < 2000; ++k) {
            identifier.update(process.step(6.0) + 0.005 * random.gauss(), 6.0);
        }
        QVERIFY(identifier.excitation() < 0.5);
    }
    void badSamplesChangeNothing() {
        ProcessIdentifier identifier({0.9, Forgetting::Robust, 1e4, 0.0});
        for (int k = 0; k < 100; ++k) {
            identifier.update(1.44 + 0.01 * (k % 7), 6.0 + 0.1 * (k % 5));
        }
        const Eigen::Vector3d before = identifier.theta();
        identifier.update(std::numeric_limits<double>::quiet_NaN(), 6.0);
        identifier.update(1.44, std::numeric_limits<double>::infinity());
        QCOMPARE(identifier.theta(), before);
    }
    void refusesUnusableSettings() {
        QVERIFY(ProcessIdentifier::whyInvalid({0.4, Forgetting::Robust, 1e4, 0.0}).has_value());
        QVERIFY(ProcessIdentifier::whyInvalid({std::nan(""), Forgetting::Robust, 1e4, 0.0}).has_value());
        QVERIFY(ProcessIdentifier::whyInvalid({0.9, Forgetting::Robust, 0.0, 0.0}).has_value());
        QVERIFY(!ProcessIdentifier::whyInvalid({1.0, Forgetting::Robust, 1e4, 0.0}).has_value());
    }
};
QTEST_APPLESS_MAIN(TestProcessIdentifier)
#include "tst_process_identifier.moc"
