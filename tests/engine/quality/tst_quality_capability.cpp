// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/core/random.h"
#include "engine/quality/capability.h"
#include "engine/quality/steadiness.h"
#include "engine/quality/verdict.h"

namespace {

using namespace kerf::quality;

QString printed(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

/// n values with mean 0 and s with n − 1 of exactly 1.
std::vector<double> standardised(std::size_t n) {
    std::vector<double> values(n);
    double squares = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        values[i] = static_cast<double>(i) - static_cast<double>(n - 1) / 2.0;
        squares += values[i] * values[i];
    }
    for (double& value : values) {
        value /= std::sqrt(squares / static_cast<double>(n - 1));
    }
    return values;
}

}  // namespace

class TestQualityCapability : public QObject {
    Q_OBJECT
 private slots:
    void indicesAndTheirIntervals() {
        const auto values = standardised(50);
        const Capability result = capability(values, {-4.0, 5.0}, true);
        QCOMPARE(result.count, std::size_t{50});
        QVERIFY(std::abs(result.mean) < 1e-12 && std::abs(result.deviation - 1.0) < 1e-12);
        QCOMPARE(printed(result.pp->value, 9), QString("1.500000000"));
        QCOMPARE(printed(result.ppk->value, 9), QString("1.333333333"));
        // 1.333333 ± 1.959964·√(1/450 + 1.777778/98)
        QCOMPARE(printed(result.ppk->low, 6), QString("1.053650"));
        QCOMPARE(printed(result.ppk->high, 6), QString("1.613017"));
        // χ²₄₉: 31.5549 and 70.2224
        QCOMPARE(printed(result.pp->low, 4), printed(1.5 * std::sqrt(31.554916 / 49.0), 4));
        QCOMPARE(printed(result.pp->high, 4), printed(1.5 * std::sqrt(70.222414 / 49.0), 4));
        QVERIFY(!result.preliminary);
        QVERIFY(result.reason.empty());
        QCOMPARE(result.cp->value, result.pp->value);
        QCOMPARE(result.cpk->value, result.ppk->value);
    }
    void aSignalTakesTheCapabilityAndLeavesThePerformance() {
        const Capability result = capability(standardised(50), {-4.0, 5.0}, false);
        QVERIFY(result.pp && result.ppk && !result.cp && !result.cpk);
        QVERIFY(!result.reason.empty());
    }
    void oneSidedTolerancesHaveOneSidedIndices() {
        const Capability upper = capability(standardised(60), {std::nullopt, 3.0}, true);
        QVERIFY(!upper.pp && !upper.cp);
        QCOMPARE(printed(upper.ppk->value, 9), QString("1.000000000"));
        const Capability lower = capability(standardised(60), {-6.0, std::nullopt}, true);
        QCOMPARE(printed(lower.ppk->value, 9), QString("2.000000000"));
    }
    void fewPartsSaySo() {
        const Capability nine = capability(standardised(9), {-4.0, 5.0}, true);
        QVERIFY(!nine.pp && !nine.ppk && !nine.cp && !nine.cpk);
        QCOMPARE(nine.count, std::size_t{9});
        QVERIFY(!nine.reason.empty());
        QVERIFY(capability(standardised(10), {-4.0, 5.0}, true).preliminary);
        QVERIFY(capability(standardised(49), {-4.0, 5.0}, true).preliminary);
        QVERIFY(!capability(std::vector<double>{}, {-4.0, 5.0}, true).ppk);
    }
    void alikeValuesAndNoToleranceGiveNoIndex() {
        QVERIFY(!capability(std::vector<double>(30, 1.0), {0.0, 2.0}, true).ppk);
        QVERIFY(!capability(standardised(30), {}, true).ppk);
    }
    void aMeanOutsideIsNegative() { QVERIFY(capability(standardised(30), {1.0, 2.0}, true).ppk->value < 0.0); }
    void aSmallSpreadOnALargeValueKeepsItsDigits() {
        Moments near;
        Moments far;
        constexpr double kStep = 1.0 / 16384.0;  // distances from 2^20 without rounding
        for (int i = 0; i < 1000; ++i) {
            const double value = kStep * ((i * 37) % 101);
            near.add(value);
            far.add(1048576.0 + value);
        }
        QCOMPARE(far.mean(), 1048576.0 + near.mean());
        QVERIFY(std::abs(far.deviation() / near.deviation() - 1.0) < 1e-14);
    }
    void verdicts() {
        const Tolerance bore{49.985, 50.015, ReworkSide::Below};
        QVERIFY(judge(50.0, bore) == Verdict::Good);
        QVERIFY(judge(49.985, bore) == Verdict::Good);
        QVERIFY(judge(50.015, bore) == Verdict::Good);
        QVERIFY(judge(49.9849, bore) == Verdict::Rework);
        QVERIFY(judge(50.0151, bore) == Verdict::Scrap);
        QVERIFY(judge(std::nullopt, bore) == Verdict::NotJudged);
        QVERIFY(judge(std::numeric_limits<double>::quiet_NaN(), bore) == Verdict::NotJudged);
        QVERIFY(judge(50.0, {}) == Verdict::NotJudged);
        const Tolerance surface{std::nullopt, 0.8, ReworkSide::None};
        QVERIFY(judge(0.81, surface) == Verdict::Scrap);
        QVERIFY(judge(0.1, surface) == Verdict::Good);
        const Tolerance wall{9.9, 10.1, ReworkSide::Above};
        QVERIFY(judge(10.2, wall) == Verdict::Rework && judge(9.8, wall) == Verdict::Scrap);
    }
    void theWorstVerdictIsThePartsAndNotJudgedIsNotGood() {
        QVERIFY(worse(Verdict::Good, Verdict::NotJudged) == Verdict::NotJudged);
        QVERIFY(worse(Verdict::Rework, Verdict::NotJudged) == Verdict::Rework);
        QVERIFY(worse(Verdict::Rework, Verdict::Scrap) == Verdict::Scrap);
        for (const Verdict verdict : {Verdict::Good, Verdict::NotJudged, Verdict::Rework, Verdict::Scrap}) {
            QVERIFY(verdictOf(verdictKey(verdict)) == verdict);
        }
    }
    void steadySeriesAreSeldomCalledUnsteady_data() {
        QTest::addColumn<int>("n");
        QTest::newRow("10") << 10;
        QTest::newRow("50") << 50;
        QTest::newRow("1000") << 1000;
    }
    void steadySeriesAreSeldomCalledUnsteady() {
        QFETCH(int, n);
        constexpr int kSeries = 2000;
        int ofValues = 0;
        int ofErrors = 0;
        for (int series = 0; series < kSeries; ++series) {
            kerf::Random random = kerf::Random(7).stream(static_cast<std::uint32_t>(series));
            std::vector<double> values(static_cast<std::size_t>(n));
            for (double& value : values) {
                value = random.gauss();
            }
            ofValues += isSteadySeries(values) ? 0 : 1;
            ofErrors += isSteady(values) ? 0 : 1;
        }
        // The three tests together are made for 1 in 100; σ from few moving ranges adds to it.
        QVERIFY2(ofErrors <= kSeries / 66, qPrintable(QString::number(ofErrors)));
        QVERIFY2(ofValues <= kSeries / (n < 50 ? 25 : 66), qPrintable(QString::number(ofValues)));
    }
    void shiftsDriftsAndOutliersAreUnsteady() {
        kerf::Random random(3);
        std::vector<double> plain(100);
        for (double& value : plain) {
            value = random.gauss();
        }
        QVERIFY(isSteadySeries(plain) && isSteady(plain));
        std::vector<double> shifted = plain;
        std::vector<double> drifting = plain;
        std::vector<double> outlier = plain;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            shifted[i] += i < 50 ? 0.0 : 2.0;
            drifting[i] += 0.03 * static_cast<double>(i);
        }
        outlier[40] = 7.0;
        for (const auto& series : {shifted, drifting, outlier}) {
            QVERIFY(!isSteadySeries(series) && !isSteady(series));
        }
        std::vector<double> biased = plain;
        for (double& value : biased) {
            value += 2.0;
        }
        QVERIFY(isSteadySeries(biased));  // a series is its own centre …
        QVERIFY(!isSteady(biased));       // … but a law has promised 0
        QVERIFY(isSteadySeries(std::vector<double>(40, 5.0)) && isSteady({}) && isSteadySeries({}));
    }
};

QTEST_GUILESS_MAIN(TestQualityCapability)
#include "tst_quality_capability.moc"
