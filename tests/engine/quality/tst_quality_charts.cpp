// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cmath>
#include <vector>

#include "engine/core/random.h"
#include "engine/quality/charts.h"
#include "engine/quality/distributions.h"

namespace {

using namespace kerf::quality;

/// Figures of the source, compared as printed there.
QString printed(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

/// Index (from 1) of the first point at which `rule` fires; 0: never.
std::size_t firstSignal(const std::vector<double>& errors, Rule rule) {
    ChartParams params;
    params.active = rules({rule});
    ChartState chart(params);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (has(chart.push(errors[i]).fired, rule)) {
            return i + 1;
        }
    }
    return 0;
}

}  // namespace

class TestQualityCharts : public QObject {
    Q_OBJECT
 private slots:
    void ewmaLimitsAreThoseOfNist() {
        const double half = ewmaLimit(2.0539, 0.3, 3.0);
        QCOMPARE(printed(50.0 + half, 4), QString("52.5884"));
        QCOMPARE(printed(50.0 - half, 4), QString("47.4116"));
    }
    void ewmaOfNistsDataStaysInside() {
        constexpr std::array kData{52.0, 47.0, 53.0, 49.3, 50.1, 47.0, 51.0, 50.1, 51.2, 50.5,
                                   49.6, 47.6, 49.9, 51.3, 47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
        // as printed; NIST's table rounds 49.52 and 49.21 up from 49.516 and 49.2148, the last ones carry that on
        constexpr std::array kPrinted{50.60, 49.52, 50.56, 50.18, 50.16, 49.21, 49.75, 49.85, 50.26, 50.33,
                                      50.11, 49.36, 49.52, 50.05, 49.38, 49.92, 50.73, 51.23, 51.94, 51.99};
        ChartParams params;
        params.active = rules({Rule::Ewma});
        params.ewmaLambda = 0.3;
        ChartState chart(params);
        for (std::size_t i = 0; i < kData.size(); ++i) {
            const ChartPoint point = chart.push((kData[i] - 50.0) / 2.0539);
            QVERIFY(point.fired.none());
            QVERIFY2(std::abs(50.0 + 2.0539 * point.ewma - kPrinted[i]) < 0.006, qPrintable(QString::number(i)));
        }
    }
    void exactEwmaLimitsBeginNarrowAndEndAtTheSteadyOnes() {
        ChartParams params;
        params.ewmaSteadyState = false;
        ChartState chart(params);
        const double first = chart.push(0.0).ewmaLimit;
        QVERIFY(std::abs(first - params.ewmaWidth * params.ewmaLambda) < 1e-12);  // z1 = λ e
        double last = first;
        for (int i = 0; i < 100; ++i) {
            const double next = chart.push(0.0).ewmaLimit;
            QVERIFY(next >= last);
            last = next;
        }
        QVERIFY(std::abs(last - ewmaLimit(1.0, params.ewmaLambda, params.ewmaWidth)) < 1e-12);
    }
    void cusumOfNistsDataSignalsAtPoint14() {
        constexpr std::array kData{324.925, 324.675, 324.725, 324.350, 325.350, 325.225, 324.125,
                                   324.525, 325.225, 324.600, 324.625, 325.150, 328.325, 327.250,
                                   327.825, 328.500, 326.675, 327.775, 326.875, 328.350};
        ChartParams params;
        params.active = rules({Rule::Cusum});
        params.cusumAllowance = 0.3175;
        params.cusumLimit = 4.1959;
        ChartState chart(params);
        std::size_t first = 0;
        double at14 = 0.0;
        for (std::size_t i = 0; i < kData.size(); ++i) {
            const ChartPoint point = chart.push(kData[i] - 325.0);
            first = first == 0 && has(point.fired, Rule::Cusum) ? i + 1 : first;
            at14 = i + 1 == 14 ? point.cusumHigh : at14;
        }
        QCOMPARE(first, std::size_t{14});
        QCOMPARE(printed(at14, 2), QString("4.94"));
    }
    void everyRuleFiresAtItsLastPointAndNotBefore_data() {
        QTest::addColumn<int>("rule");
        QTest::addColumn<std::vector<double>>("errors");
        const auto row = [](const char* name, Rule rule, std::vector<double> errors) {
            QTest::newRow(name) << static_cast<int>(rule) << errors;
        };
        row("one beyond 3", Rule::Nelson1, {0.0, 3.0, -3.01});
        row("nine on a side", Rule::Nelson2, {-0.1, .1, .2, .1, .2, .1, .2, .1, .2, .1});
        row("six falling", Rule::Nelson3, {1.0, 1.0, .8, .6, .4, .2, -.1});
        row("fourteen alternating", Rule::Nelson4,
            {-.5, -.4, .4, -.4, .4, -.4, .4, -.4, .4, -.4, .4, -.4, .4, -.4, .4});
        row("two of three beyond 2", Rule::Nelson5, {2.5, -2.5, 0.0, -2.1});
        row("four of five beyond 1", Rule::Nelson6, {1.1, -1.1, -1.2, 0.0, -1.1, -1.3});
        std::vector<double> quiet(16, 0.5);
        quiet.front() = 1.5;
        row("fifteen within 1", Rule::Nelson7, quiet);
        row("eight beyond 1", Rule::Nelson8, {0.5, 1.1, -1.1, 1.1, -1.2, 1.1, -1.1, 1.1, -1.1});
        row("western 1", Rule::Western1, {2.9, 3.1});
        row("western 2", Rule::Western2, {0.0, 2.1, 0.0, 2.2});
        row("western 3", Rule::Western3, {1.1, 1.1, 0.0, 1.1, 1.1});
        row("western 4", Rule::Western4, {0.1, -.1, -.1, -.1, -.1, -.1, -.1, -.1, -.1});
    }
    void everyRuleFiresAtItsLastPointAndNotBefore() {
        QFETCH(int, rule);
        QFETCH(std::vector<double>, errors);
        QCOMPARE(firstSignal(errors, static_cast<Rule>(rule)), errors.size());
        std::vector<double> mirrored = errors;
        for (double& error : mirrored) {
            error = -error;
        }
        QCOMPARE(firstSignal(mirrored, static_cast<Rule>(rule)), errors.size());
    }
    void onlyActiveRulesFire() {
        ChartState chart;  // also beyond 3σ of Western Electric and beyond the CUSUM's limit
        QCOMPARE(chart.push(10.0).fired, rules({Rule::Nelson1, Rule::Ewma}));
    }
    void tSquaredTakesThePlaceOfThreeSigma() {
        ChartState chart;
        QVERIFY(has(chart.push(0.0, true).fired, Rule::Nelson1));
        QVERIFY(!has(chart.push(3.5, false).fired, Rule::Nelson1));
        QCOMPARE(printed(tSquaredLimit(1), 10), printed(9.0, 10));
        QCOMPARE(printed(tSquaredLimit(2), 4), QString("11.8292"));
    }
    void resetForgets() {
        ChartState chart;
        for (int i = 0; i < 20; ++i) {
            (void)chart.push(1.0);
        }
        chart.reset();
        const ChartPoint point = chart.push(0.0);
        QCOMPARE(point.ewma, 0.0);
        QCOMPARE(point.cusumHigh, 0.0);
    }
    void keysNameEveryRuleOnce() {
        for (std::size_t i = 0; i < kRules; ++i) {
            const auto rule = static_cast<Rule>(i);
            QVERIFY(ruleOf(ruleKey(rule)) == rule);
        }
        QVERIFY(!ruleOf("nelson9"));
    }
    void centreLineByMovingRange() {
        constexpr std::array kValues{1.0, 3.0, 2.0, 4.0};
        const CentreLine line = centreLine(kValues);
        QCOMPARE(line.centre, 2.5);
        QCOMPARE(printed(line.sigma, 6), printed(5.0 / 3.0 / 1.1283791671, 6));
        QCOMPARE(centreLine({}).sigma, 0.0);
    }
    /// Independent errors: 370 points between false alarms of rule 1 (Markov chain, any text on run lengths).
    void runLengthOfRule1OnWhiteErrors() {
        kerf::Random random(7);
        ChartParams params;
        params.active = rules({Rule::Nelson1});
        ChartState chart(params);
        constexpr int kPoints = 400'000;
        int alarms = 0;
        for (int i = 0; i < kPoints; ++i) {
            alarms += chart.push(random.gauss()).fired.any() ? 1 : 0;
        }
        const double arl = static_cast<double>(kPoints) / alarms;
        QVERIFY2(arl > 340.0 && arl < 402.0, qPrintable(QString::number(arl)));
    }
    /// Second opinion: R's package spc, xewma.arl(.2, 3, shift, sided = "two") and xcusum.arl(.5, 5, shift, sided =
    /// "two").
    void runLengthsAreThoseOfSpc_data() {
        QTest::addColumn<int>("rule");
        QTest::addColumn<double>("shift");
        QTest::addColumn<double>("expected");
        QTest::newRow("ewma, in control") << static_cast<int>(Rule::Ewma) << 0.0 << 559.8741;
        QTest::newRow("ewma, 1.5 sigma") << static_cast<int>(Rule::Ewma) << 1.5 << 5.604721;
        QTest::newRow("cusum, in control") << static_cast<int>(Rule::Cusum) << 0.0 << 465.4435;
        QTest::newRow("cusum, 1.5 sigma") << static_cast<int>(Rule::Cusum) << 1.5 << 5.747218;
    }
    void runLengthsAreThoseOfSpc() {
        QFETCH(int, rule);
        QFETCH(double, shift);
        QFETCH(double, expected);
        kerf::Random random(11);
        ChartParams params;
        params.active = rules({static_cast<Rule>(rule)});
        ChartState chart(params);
        constexpr int kPoints = 1'000'000;
        int alarms = 0;
        for (int i = 0; i < kPoints; ++i) {
            if (chart.push(random.gauss() + shift).fired.any()) {
                ++alarms;
                chart.reset();
            }
        }
        const double arl = static_cast<double>(kPoints) / alarms;
        // Run lengths spread by as much as their mean: three standard errors.
        const double tolerance = 3.0 * expected * std::sqrt(expected / kPoints);
        QVERIFY2(std::abs(arl - expected) < tolerance, qPrintable(QString::number(arl)));
    }
    void quantilesAreTheTables() {
        QCOMPARE(printed(normalQuantile(0.975), 9), QString("1.959963985"));
        QCOMPARE(printed(chiSquareQuantile(10.0, 0.95), 4), QString("18.3070"));
        QCOMPARE(printed(chiSquareUpperTail(2.0, 13.815510558), 9), QString("0.001000000"));
        QCOMPARE(printed(fUpperTail(2.0, 10.0, 4.1028), 4), QString("0.0500"));
    }
};

QTEST_GUILESS_MAIN(TestQualityCharts)
#include "tst_quality_charts.moc"
