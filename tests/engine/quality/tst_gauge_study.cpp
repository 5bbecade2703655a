// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <vector>

#include "engine/quality/gauge_study.h"

namespace {

using namespace kerf::quality;

QString printed(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

/// The crossed example of AIAG's manual: 10 parts, persons A-C, 3 trials; rows are person and trial.
constexpr std::array<std::array<double, 10>, 9> kAiag{{
    {0.29, -0.56, 1.34, 0.47, -0.80, 0.02, 0.59, -0.31, 2.26, -1.36},
    {0.41, -0.68, 1.17, 0.50, -0.92, -0.11, 0.75, -0.20, 1.99, -1.25},
    {0.64, -0.58, 1.27, 0.64, -0.84, -0.21, 0.66, -0.17, 2.01, -1.31},
    {0.08, -0.47, 1.19, 0.01, -0.56, -0.20, 0.47, -0.63, 1.80, -1.68},
    {0.25, -1.22, 0.94, 1.03, -1.20, 0.22, 0.55, 0.08, 2.12, -1.62},
    {0.07, -0.68, 1.34, 0.20, -1.28, 0.06, 0.83, -0.34, 2.19, -1.50},
    {0.04, -1.38, 0.88, 0.14, -1.46, -0.29, 0.02, -0.46, 1.77, -1.49},
    {-0.11, -1.13, 1.09, 0.20, -1.07, -0.67, 0.01, -0.56, 1.45, -1.77},
    {-0.15, -0.96, 0.67, 0.11, -1.45, -0.49, 0.21, -0.49, 1.87, -2.16},
}};

std::vector<StudyReading> aiag() {
    std::vector<StudyReading> readings;
    for (std::uint32_t row = 0; row < kAiag.size(); ++row) {
        for (std::uint32_t part = 0; part < kAiag[row].size(); ++part) {
            readings.push_back({part, row / 3, row % 3, kAiag[row][part]});
        }
    }
    return readings;
}

}  // namespace

class TestGaugeStudy : public QObject {
    Q_OBJECT
 private slots:
    void typeOneOfTheExample() {
        const auto study = typeOneStudy(50, 6.0009, 0.00099488, 0.06, 6.002);
        QVERIFY(study.has_value());
        QCOMPARE(printed(study->cg, 3), QString("2.010"));
        QCOMPARE(printed(*study->cgk, 3), QString("1.642"));
        QVERIFY(study->pass);
        QCOMPARE(printed(*study->bias, 4), QString("-0.0011"));
    }
    void averageAndRangeOfTheExample() {
        const auto study = crossedStudy(aiag(), StudyMethod::AverageRange, std::nullopt);
        QVERIFY(study.has_value());
        QCOMPARE(printed(study->meanRange, 5), QString("0.34167"));
        QCOMPARE(printed(study->personDiff, 5), QString("0.44467"));
        QCOMPARE(printed(study->ev, 5), QString("0.20186"));
        QCOMPARE(printed(study->av, 5), QString("0.22967"));
        QCOMPARE(printed(study->grr, 5), QString("0.30577"));
        QCOMPARE(printed(study->pv, 5), QString("1.10460"));
        QCOMPARE(printed(study->tv, 5), QString("1.14613"));
        QCOMPARE(printed(study->grrPercent, 2), QString("26.68"));
        QCOMPARE(study->ndc, 5U);
    }
    void anovaOfTheExample() {
        const auto study = crossedStudy(aiag(), StudyMethod::Anova, std::nullopt);
        QVERIFY(study.has_value());
        QCOMPARE(printed(study->ssPerson, 4), QString("3.1673"));
        QCOMPARE(printed(study->ssPart, 4), QString("88.3619"));
        QCOMPARE(printed(study->ssInteraction, 4), QString("0.3590"));
        QCOMPARE(printed(study->ssRepeatability, 4), QString("2.7589"));
        QCOMPARE(printed(study->ssTotal, 4), QString("94.6471"));
        QCOMPARE(printed(*study->fInteraction, 3), QString("0.434"));
        QVERIFY(study->pooled);
        QCOMPARE(printed(study->ev, 6), QString("0.199933"));
        QCOMPARE(printed(study->av, 6), QString("0.226838"));
        // The example prints .302373; its own EV and AV (checked above) make .3023715, and so does exact arithmetic.
        QCOMPARE(printed(study->grr, 6), QString("0.302372"));
        QCOMPARE(printed(study->pv, 6), QString("1.042327"));
        QCOMPARE(printed(study->tv, 3), QString("1.085"));
        QCOMPARE(printed(study->grrPercent, 1), QString("27.9"));
        QCOMPARE(study->ndc, 4U);
        QVERIFY(study->evLow < study->ev && study->ev < study->evHigh);
    }
    void theOrderOfTheReadingsDoesNotMatter() {
        auto readings = aiag();
        std::ranges::reverse(readings);
        QCOMPARE(printed(crossedStudy(readings, StudyMethod::Anova, std::nullopt)->grr, 12),
                 printed(crossedStudy(aiag(), StudyMethod::Anova, std::nullopt)->grr, 12));
    }
    void toleranceGivesItsOwnPercentage() {
        const auto study = crossedStudy(aiag(), StudyMethod::AverageRange, 6.0);
        QCOMPARE(printed(*study->grrPercentOfTolerance, 3), QString("30.577"));
    }
    void interactionThatMattersIsNotPooled() {
        // Person 1 reads odd parts high, person 2 even ones; hardly any repetition error.
        std::vector<StudyReading> readings;
        for (std::uint32_t part = 0; part < 6; ++part) {
            for (std::uint32_t person = 0; person < 2; ++person) {
                for (std::uint32_t trial = 0; trial < 2; ++trial) {
                    const double off = (part + person) % 2 == 0 ? 0.5 : -0.5;
                    readings.push_back({part, person, trial, part + off + 0.01 * trial});
                }
            }
        }
        const auto study = crossedStudy(readings, StudyMethod::Anova, std::nullopt);
        QVERIFY(study.has_value());
        QVERIFY(!study->pooled && study->interaction > 0.5);
        QVERIFY(study->avNegative && study->av == 0.0);  // persons differ less than the interaction makes them
    }
    void negativeComponentsAreZeroAndSaidSo() {
        std::vector<StudyReading> readings;
        for (std::uint32_t part = 0; part < 3; ++part) {
            for (std::uint32_t person = 0; person < 2; ++person) {
                readings.push_back({part, person, 0, 1.0 * part});
                readings.push_back({part, person, 1, 1.0 * part + 0.4});
            }
        }
        const auto study = crossedStudy(readings, StudyMethod::AverageRange, std::nullopt);
        QVERIFY(study->avNegative);
        QCOMPARE(study->av, 0.0);
        QCOMPARE(study->grr, study->ev);
    }
    void whatIsNotCrossedIsRefused() {
        auto missing = aiag();
        missing.erase(missing.begin() + 17);
        QVERIFY(!crossedStudy(missing, StudyMethod::Anova, std::nullopt));
        auto twice = aiag();
        twice.push_back(twice.front());
        QVERIFY(!crossedStudy(twice, StudyMethod::Anova, std::nullopt));
        QVERIFY(!crossedStudy({}, StudyMethod::Anova, std::nullopt));
        QVERIFY(!crossedStudy(aiag(), StudyMethod::Anova, 0.0));
        auto far = aiag();
        far.front().part = 4'000'000'000U;
        QVERIFY(!crossedStudy(far, StudyMethod::AverageRange, std::nullopt));
        auto alike = aiag();
        for (auto& reading : alike) {
            reading.value = 3.0;
        }
        QVERIFY(!crossedStudy(alike, StudyMethod::Anova, std::nullopt));
        QVERIFY(!crossedStudy(alike, StudyMethod::AverageRange, std::nullopt));
    }
    void typeOneRefusesWhatItCannotJudge() {
        QVERIFY(!typeOneStudy(24, 6.0, 0.001, 0.06, 6.0));
        QVERIFY(!typeOneStudy(25, 6.0, 0.001, 0.0, 6.0));
        QVERIFY(!typeOneStudy(25, 6.0, 0.0, 0.06, 6.0));
        QVERIFY(!typeOneStudy(std::vector<double>(25, 6.0), 0.06, 6.0));
        QVERIFY(!typeOneStudy(50, 6.0, 0.002, 0.06, 6.002)->pass);
        QVERIFY(!typeOneStudy(50, 6.0, 0.001, 0.06, std::nullopt)->cgk);
    }
};

QTEST_GUILESS_MAIN(TestGaugeStudy)
#include "tst_gauge_study.moc"
