// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>

#include "engine/core/random.h"
#include "engine/process/thermal/replay.h"
#include "engine/process/thermal/training.h"
#include "tests/engine/thermal/thermal_days.h"

using namespace kerf::thermal;
using kerf::test::coldDays;
using kerf::test::defaultModel;
using kerf::test::kWarmDay;
using kerf::test::thermalDay;
using kerf::test::trainingDays;

namespace {

/// Predicted minus true, minutes × axes.
Eigen::MatrixXd errorsOn(const ThermalModel& model, const ThermalHistory& day, double* insideShare = nullptr) {
    const Replay replayed = replay(model, day);
    Eigen::MatrixXd errors(day.workRows(), 3);
    double inside = 0.0;
    for (Eigen::Index row = 0; row < errors.rows(); ++row) {
        const ThermalPrediction& p = replayed.minutes[static_cast<std::size_t>(row)].prediction;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            errors(row, axis) = p.drift_um[k] - day.trueDrift_um(row + day.baselineRows(), axis);
            inside += std::abs(errors(row, axis)) <= p.half_um[k] ? 1.0 : 0.0;
        }
    }
    if (insideShare != nullptr) {
        *insideShare = inside / static_cast<double>(errors.size());
    }
    return errors;
}

ErrorSummary summaryOnColdDays(const ThermalModel& model) {
    Eigen::MatrixXd all(0, 3);
    for (const std::string& name : coldDays()) {
        const Eigen::MatrixXd errors = errorsOn(model, thermalDay(name));
        all.conservativeResize(all.rows() + errors.rows(), 3);
        all.bottomRows(errors.rows()) = errors;
    }
    return summaryOf(all);
}

bool within(const PerAxis& values, const PerAxis& limits) {
    return values[0] <= limits[0] && values[1] <= limits[1] && values[2] <= limits[2];
}
QByteArray shown(const PerAxis& v) {
    return QStringLiteral("%1 %2 %3 um").arg(v[0]).arg(v[1]).arg(v[2]).toUtf8();
}

/// The day with these sensors open from a minute on.
ThermalHistory without(ThermalHistory day, const std::vector<std::string>& names, double from_min) {
    for (const std::string& name : names) {
        for (Eigen::Index row = 0; row < day.rows(); ++row) {
            if (day.time_min[static_cast<std::size_t>(row)] >= from_min) {
                day.present(row, *day.sensorIndex(name)) = false;
            }
        }
    }
    return day;
}

const ThermalModel& networkOfOneDay() {
    static const ThermalModel model = *trainNetwork(ModelKind::Gmdh, {thermalDay("H0_train")}, {});
    return model;
}
const ThermalModel& printedNetworkOfOneDay() {
    static const ThermalModel model = *trainNetwork(ModelKind::GmdhPaper, {thermalDay("H0_train")}, {});
    return model;
}

}  // namespace

class TestThermalModels : public QObject {
    Q_OBJECT
 private slots:
    void guardedNetworkOfOneDayHoldsOnUnseenDays();
    void defaultHoldsOnUnseenDays();
    void defaultHoldsAfterAWarmStart();
    void defaultUsesAtMostFourteenSensors();
    void intervalsCoverUnseenMinutes();
    void eachTrainingDayIsPredictedFromTheOthers();
    void anyTwoLostSensorsAtMostDoubleTheError();
    void lostSensorsWidenTheInterval();
    void boundedUnderInputFuzz_data();
    void boundedUnderInputFuzz();
    void unknownSpeedFallsBackToTemperatures();
    void compensationHoldsAtOneMinute();
    void compensationHoldsAtFiveMinutes();
    void compensationHoldsWhenFarOutside();
    void autoKeepsTheHierarchicalModel();
    void sameDaysGiveTheSameModel();
    void otherDaysGiveAnotherFingerprint();
    void oneDayTrainsButIsNotHeldOut();
    void trainingCanBeCancelled();
    void formulaNamesEverySensor();
    void subsetSolutionsAreThoseOfTheSmallerProblem();
};

void TestThermalModels::guardedNetworkOfOneDayHoldsOnUnseenDays() {
    const ErrorSummary s = summaryOnColdDays(networkOfOneDay());
    QVERIFY2(within(s.worst_um, {4.0, 6.0, 4.5}), shown(s.worst_um));
}

void TestThermalModels::defaultHoldsOnUnseenDays() {
    const ErrorSummary s = summaryOnColdDays(defaultModel());
    QVERIFY2(within(s.rms_um, {0.3, 0.8, 1.2}), shown(s.rms_um));
    QVERIFY2(within(s.worst_um, {1.0, 2.5, 4.5}), shown(s.worst_um));
}

void TestThermalModels::defaultHoldsAfterAWarmStart() {
    const ErrorSummary s = summaryOf(errorsOn(defaultModel(), thermalDay(kWarmDay)));
    QVERIFY2(within(s.worst_um, {1.5, 3.0, 4.0}), shown(s.worst_um));
}

void TestThermalModels::defaultUsesAtMostFourteenSensors() {
    QVERIFY(defaultModel().sensors.size() <= kMaxRegressionSensors);
}

void TestThermalModels::intervalsCoverUnseenMinutes() {
    double sum = 0.0;
    double days = 0.0;
    for (const std::string& name : coldDays()) {
        double share = 0.0;
        (void)errorsOn(defaultModel(), thermalDay(name), &share);
        QVERIFY2(share >= 0.8, name.c_str());
        sum += share;
        days += 1.0;
    }
    const double mean = sum / days;
    QVERIFY2(mean >= 0.90 && mean <= 0.99, qPrintable(QString::number(mean)));
}

void TestThermalModels::eachTrainingDayIsPredictedFromTheOthers() {
    for (std::size_t left = 0; left < 3; ++left) {
        std::vector<ThermalHistory> others = trainingDays();
        const ThermalHistory judge = others[left];
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(left));
        const auto model = trainHierarchical(others, {});
        QVERIFY(model.has_value());
        const ErrorSummary s = summaryOf(errorsOn(*model, judge));
        QVERIFY2(within(s.worst_um, {1.5, 3.0, 5.0}), shown(s.worst_um));
    }
}

void TestThermalModels::anyTwoLostSensorsAtMostDoubleTheError() {
    const auto& sensors = defaultModel().sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        for (std::size_t j = i + 1; j < sensors.size(); ++j) {
            for (const std::string& name : coldDays()) {
                const ThermalHistory day = without(thermalDay(name), {sensors[i].name, sensors[j].name}, 90.0);
                const ErrorSummary s = summaryOf(errorsOn(defaultModel(), day));
                QVERIFY2(within(s.worst_um, {2.0, 5.0, 9.0}), shown(s.worst_um));
            }
        }
    }
}

void TestThermalModels::lostSensorsWidenTheInterval() {
    const auto& sensors = defaultModel().sensors;
    const ThermalHistory& day = thermalDay("T1_rand");
    const Replay whole = replay(defaultModel(), day);
    const Replay lost = replay(defaultModel(), without(day, {sensors[0].name, sensors[1].name}, 100.0));
    QCOMPARE(lost.minutes[200].prediction.lostSensors, 2);
    QVERIFY(lost.minutes[200].prediction.usable);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        QVERIFY(lost.minutes[200].prediction.half_um[axis] >= whole.minutes[200].prediction.half_um[axis]);
    }
    const Replay three =
        replay(defaultModel(), without(day, {sensors[0].name, sensors[1].name, sensors[2].name}, 100.0));
    QVERIFY(!three.minutes[200].prediction.usable);
}

void TestThermalModels::boundedUnderInputFuzz_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("printed") << 0;
    QTest::newRow("guarded") << 1;
    QTest::newRow("default") << 2;
}

void TestThermalModels::boundedUnderInputFuzz() {
    QFETCH(int, kind);
    const ThermalModel& model = kind == 0 ? printedNetworkOfOneDay() : kind == 1 ? networkOfOneDay() : defaultModel();
    kerf::Random random(20);
    for (const char* name : {"T0_same", "T3_constlow", "T7_warmstart"}) {
        for (int trial = 0; trial < 8; ++trial) {
            ThermalHistory day = thermalDay(name);
            for (double& value : day.temp_degC.reshaped()) {
                value += random.uniform(-20.0, 20.0);
            }
            for (const ReplayedMinute& minute : replay(model, day).minutes) {
                for (std::size_t axis = 0; axis < kAxes; ++axis) {
                    const Range& range = model.drift_um[axis];
                    QVERIFY(minute.prediction.drift_um[axis] >= range.low - range.span());
                    QVERIFY(minute.prediction.drift_um[axis] <= range.high + range.span());
                    QVERIFY(std::isfinite(minute.prediction.half_um[axis]));
                }
            }
        }
    }
}

void TestThermalModels::unknownSpeedFallsBackToTemperatures() {
    ThermalHistory day = thermalDay("T1_rand");
    day.speed_rpm.clear();
    const ErrorSummary s = summaryOf(errorsOn(defaultModel(), day));
    QVERIFY2(within(s.worst_um, {2.0, 5.0, 9.0}), shown(s.worst_um));
    QCOMPARE(replay(defaultModel(), day).minutes.back().prediction.speedShare, 0.0);
}

namespace {
ErrorSummary residuals(double period_min) {
    CompensationOptions options;
    options.period_min = period_min;
    const ThermalHistory& day = thermalDay("T0_same");
    const auto minutes = compensate(replay(defaultModel(), day), day, options);
    Eigen::MatrixXd out(static_cast<Eigen::Index>(minutes.size()), 3);
    for (std::size_t k = 0; k < minutes.size(); ++k) {
        out.row(static_cast<Eigen::Index>(k)) = Eigen::RowVector3d::Map(minutes[k].residual_um.data());
    }
    return summaryOf(out);
}
}  // namespace

void TestThermalModels::compensationHoldsAtOneMinute() {
    const ErrorSummary s = residuals(1.0);
    QVERIFY2(within(s.worst_um, {4.0, 4.0, 4.0}), shown(s.worst_um));
    QVERIFY2(within(s.p95_um, {3.0, 3.0, 3.0}), shown(s.p95_um));
}

void TestThermalModels::compensationHoldsAtFiveMinutes() {
    const ErrorSummary s = residuals(5.0);
    QVERIFY2(within(s.p95_um, {4.0, 3.0, 4.0}), shown(s.p95_um));
}

void TestThermalModels::compensationHoldsWhenFarOutside() {
    // Three times the warming ever seen, in the usual pattern: nothing accuses a single sensor, but the model knows it
    // not.
    ThermalHistory day = thermalDay("T2_consthigh");
    const Eigen::RowVectorXd start = baselineOf(day).transpose();
    for (Eigen::Index row = day.baselineRows(); row < day.rows(); ++row) {
        day.temp_degC.row(row) = start + 3.0 * (day.temp_degC.row(row) - start);
    }
    const Replay replayed = replay(defaultModel(), day);
    std::size_t k = 0;
    while (k + 1 < replayed.minutes.size() && replayed.minutes[k].prediction.outside < 1.0) {
        ++k;
    }
    QVERIFY(replayed.minutes[k].prediction.usable);
    QVERIFY(replayed.minutes[k].prediction.outside >= 1.0);
    QVERIFY(replayed.minutes[k].prediction.half_um[0] > 2.0 * replayed.minutes.front().prediction.half_um[0]);
    const auto minutes = compensate(replayed, day, {});
    for (std::size_t later = k; later < minutes.size() && replayed.minutes[later].prediction.outside >= 1.0; ++later) {
        QCOMPARE(minutes[later].shift_um[1], minutes[k].shift_um[1]);
    }
}

void TestThermalModels::autoKeepsTheHierarchicalModel() {
    const auto trained = trainAuto(trainingDays(), {});
    QVERIFY(trained.has_value());
    QCOMPARE(trained->compared.size(), std::size_t{4});
    QCOMPARE(trained->best.kind, ModelKind::Hierarchical);
    QVERIFY(trained->best.judgement.heldOut);
}

void TestThermalModels::sameDaysGiveTheSameModel() {
    const auto again = trainHierarchical(trainingDays(), {});
    QVERIFY(again.has_value());
    QCOMPARE(again->fingerprint, defaultModel().fingerprint);
    QVERIFY(again->regression->temperatures.gram == defaultModel().regression->temperatures.gram);
    const ThermalHistory& day = thermalDay("T4_stair");
    QVERIFY(errorsOn(*again, day) == errorsOn(defaultModel(), day));
}

void TestThermalModels::otherDaysGiveAnotherFingerprint() {
    std::vector<ThermalHistory> days = trainingDays();
    const auto before = fingerprintOf(days);
    days[1].temp_degC(100, 3) += 0.001;
    QVERIFY(fingerprintOf(days) != before);
}

void TestThermalModels::oneDayTrainsButIsNotHeldOut() {
    const auto model = trainRegression({thermalDay("H0_train")}, {});
    QVERIFY(model.has_value());
    QVERIFY(!model->judgement.heldOut);
    const ErrorSummary s = summaryOf(errorsOn(*model, thermalDay("T0_same")));
    QVERIFY2(within(s.worst_um, {1.5, 3.0, 5.0}), shown(s.worst_um));
    const auto chosen = trainAuto({thermalDay("H0_train")}, {});
    QVERIFY(chosen.has_value());
    QCOMPARE(chosen->best.kind, ModelKind::Gmdh);  // no day to leave out: the cautious one
}

void TestThermalModels::trainingCanBeCancelled() {
    int calls = 0;
    const auto model = trainRegression(trainingDays(), {}, [&calls](double) { return ++calls < 3; });
    QVERIFY(!model.has_value());
    QCOMPARE(calls, 3);
    QVERIFY(!model.error().empty());
}

void TestThermalModels::formulaNamesEverySensor() {
    const auto lines = formulaLines(defaultModel());
    QVERIFY(lines.size() >= 3);
    for (const ModelSensor& sensor : defaultModel().sensors) {
        QVERIFY(lines.front().find(sensor.name) != std::string::npos);
    }
    QVERIFY(formulaLines(networkOfOneDay()).size() >= 6);
}

void TestThermalModels::subsetSolutionsAreThoseOfTheSmallerProblem() {
    const NormalEquations& all = defaultModel().regression->temperatures;
    NormalEquations smaller = all;
    smaller.sensors = all.sensors - 1;
    const Eigen::Index terms = all.gram.rows() - kTermsPerSensor;
    smaller.gram = all.gram.bottomRightCorner(terms, terms);
    smaller.moment = all.moment.bottomRows(terms);
    const Eigen::MatrixXd without0 = solveWithout(all, {0});
    QVERIFY(without0.topRows(kTermsPerSensor).isZero(0.0));
    QVERIFY((without0.bottomRows(terms) - solveWithout(smaller, {})).cwiseAbs().maxCoeff() < 1e-9);
    // Every set has its own place.
    const std::size_t n = 10;
    std::vector<bool> seen(lostSetCount(n), false);
    seen[lostSetIndex(n)] = true;
    for (std::size_t i = 0; i < n; ++i) {
        seen[lostSetIndex(n, i)] = true;
        for (std::size_t j = i + 1; j < n; ++j) {
            seen[lostSetIndex(n, i, j)] = true;
        }
    }
    QVERIFY(std::ranges::all_of(seen, [](bool s) { return s; }));
}

QTEST_APPLESS_MAIN(TestThermalModels)
#include "tst_thermal_models.moc"
