// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "engine/core/random.h"
#include "tests/support/golden.h"

class TestRandom : public QObject {
    Q_OBJECT
 private slots:
    void sameDigitsAsTheReference() {
        const auto reference = kerf::test::loadGolden("golden_diamond.json")["rng"];
        kerf::Random integers(42);
        for (const auto& hex : reference["u64"]) {
            QCOMPARE(integers.nextU64(), std::stoull(hex.get<std::string>(), nullptr, 16));
        }
        kerf::Random normals(42);
        for (const auto& value : reference["gauss"]) {
            KERF_CLOSE(normals.gauss(), value.get<double>(), 1e-12);
        }
    }
    void streamsOfOneSeedDifferAndRepeat() {
        const kerf::Random seed(7);
        QCOMPARE(seed.stream(1).nextU64(), seed.stream(1).nextU64());
        QVERIFY(seed.stream(1).nextU64() != seed.stream(2).nextU64());
    }
    void uniformStaysInItsRange() {
        kerf::Random random(3);
        double sum = 0.0;
        for (int i = 0; i < 100000; ++i) {
            const double value = random.uniform(-2.0, 4.0);
            QVERIFY(value >= -2.0 && value < 4.0);
            sum += value;
        }
        QVERIFY(std::abs(sum / 100000 - 1.0) < 0.02);
    }
};
QTEST_APPLESS_MAIN(TestRandom)
#include "tst_random.moc"
