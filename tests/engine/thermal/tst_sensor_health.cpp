// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <functional>

#include "engine/core/random.h"
#include "engine/process/thermal/replay.h"
#include "tests/engine/thermal/thermal_days.h"

using namespace kerf::thermal;
using kerf::test::coldDays;
using kerf::test::defaultModel;
using kerf::test::kWarmDay;
using kerf::test::thermalDay;

namespace {

/// The day with one sensor's readings changed from a minute on: (minute, reading) → reading.
ThermalHistory tampered(const std::string& name, const std::string& sensor,
                        const std::function<double(double, double)>& change, double from_min = 120.0) {
    ThermalHistory day = thermalDay(name);
    const Eigen::Index column = *day.sensorIndex(sensor);
    for (Eigen::Index row = 0; row < day.rows(); ++row) {
        const double t_min = day.time_min[static_cast<std::size_t>(row)];
        if (t_min >= from_min) {
            day.temp_degC(row, column) = change(t_min, day.temp_degC(row, column));
        }
    }
    return day;
}

/// Twice the limits of a healthy machine.
constexpr std::array<double, 3> kTwiceTheLimit_um{2.0, 5.0, 9.0};

double worst_um(const ThermalHistory& day, std::size_t axis) {
    const Replay replayed = replay(defaultModel(), day);
    double worst = 0.0;
    for (std::size_t k = 0; k < replayed.minutes.size(); ++k) {
        const double truth =
            day.trueDrift_um(static_cast<Eigen::Index>(k) + day.baselineRows(), static_cast<Eigen::Index>(axis));
        worst = std::max(worst, std::abs(replayed.minutes[k].prediction.drift_um[axis] - truth));
    }
    return worst;
}

}  // namespace

class TestSensorHealth : public QObject {
    Q_OBJECT
 private slots:
    void healthySensorsStayHealthyOnEveryDay();
    void openIsFound();
    void shortToTheTerminalIsFound();
    void stuckIsFound();
    void offsetIsFoundAndNamed();
    void noiseIsFound();
    void slowDriftIsFound();
    void twoAtOnceAreFound();
    void faultsDoNotDisturbThePrediction();
    void aSensorDeadFromTheStartIsLeftOut();
    void coarseReadingsAreNotStuck();
    void aLinkThatWasCutComesBack();
};

void TestSensorHealth::healthySensorsStayHealthyOnEveryDay() {
    std::vector<std::string> names = coldDays();
    names.emplace_back(kWarmDay);
    for (const std::string& name : names) {
        const Replay replayed = replay(defaultModel(), thermalDay(name));
        for (std::size_t i = 0; i < replayed.sensors.size(); ++i) {
            QVERIFY2(replayed.sensors[i] == SensorState::Healthy,
                     (name + " " + defaultModel().sensors[i].name).c_str());
        }
        for (const ReplayedMinute& minute : replayed.minutes) {
            QCOMPARE(minute.prediction.lostSensors, 0);
        }
    }
}

void TestSensorHealth::openIsFound() {
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        const auto day = tampered("T1_rand", defaultModel().sensors[i].name, [](double, double) { return 800.0; });
        QCOMPARE(replay(defaultModel(), day).sensors[i], SensorState::Open);
    }
}

void TestSensorHealth::shortToTheTerminalIsFound() {
    // On a hot day, a warm sensor that suddenly reads like the cabinet.
    std::size_t found = 0;
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        const auto day = tampered(
            "T0_same", defaultModel().sensors[i].name, [](double, double) { return 19.0; }, 300.0);
        const SensorState state = replay(defaultModel(), day).sensors[i];
        QVERIFY(isSick(state));
        found += state == SensorState::Short ? 1U : 0U;
    }
    QVERIFY(found > 0);
}

void TestSensorHealth::stuckIsFound() {
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        double held = 0.0;
        const auto day = tampered("T1_rand", defaultModel().sensors[i].name, [&held](double, double value) {
            held = held == 0.0 ? value : held;
            return held;
        });
        QVERIFY(isSick(replay(defaultModel(), day).sensors[i]));
    }
}

void TestSensorHealth::offsetIsFoundAndNamed() {
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        const auto day =
            tampered("T1_rand", defaultModel().sensors[i].name, [](double, double value) { return value + 6.0; });
        const Replay replayed = replay(defaultModel(), day);
        QVERIFY2(replayed.sensors[i] == SensorState::Offset, defaultModel().sensors[i].name.c_str());
        for (std::size_t other = 0; other < replayed.sensors.size(); ++other) {
            QVERIFY(other == i || replayed.sensors[other] == SensorState::Healthy);
        }
    }
}

void TestSensorHealth::noiseIsFound() {
    kerf::Random random(5);
    const auto day = tampered("T1_rand", defaultModel().sensors[0].name,
                              [&random](double, double value) { return value + 1.2 * random.gauss(); });
    QVERIFY(isSick(replay(defaultModel(), day).sensors[0]));
}

void TestSensorHealth::slowDriftIsFound() {
    std::size_t found = 0;
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        const auto day = tampered("T1_rand", defaultModel().sensors[i].name,
                                  [](double t_min, double value) { return value + 0.05 * (t_min - 120.0); });
        found += isSick(replay(defaultModel(), day).sensors[i]) ? 1U : 0U;
    }
    QCOMPARE(found, defaultModel().sensors.size());
}

void TestSensorHealth::twoAtOnceAreFound() {
    const auto& sensors = defaultModel().sensors;
    for (std::size_t i = 0; i + 1 < sensors.size(); ++i) {
        ThermalHistory day = tampered("T0_same", sensors[i].name, [](double, double value) { return value + 8.0; });
        const Eigen::Index column = *day.sensorIndex(sensors[i + 1].name);
        for (Eigen::Index row = 150; row < day.rows(); ++row) {
            day.temp_degC(row, column) -= 8.0;
        }
        const Replay replayed = replay(defaultModel(), day);
        QVERIFY(isSick(replayed.sensors[i]));
        QVERIFY(isSick(replayed.sensors[i + 1]));
        QVERIFY(replayed.minutes.back().prediction.usable);
    }
}

void TestSensorHealth::faultsDoNotDisturbThePrediction() {
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        const std::string& name = defaultModel().sensors[i].name;
        for (const auto& change : std::vector<std::function<double(double, double)>>{
                 [](double, double) { return 0.0; }, [](double, double) { return 999.0; },
                 [](double, double value) { return value + 5.0; }, [](double, double value) { return value - 15.0; }}) {
            const ThermalHistory day = tampered("T5_interm", name, change);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double worst = worst_um(day, axis);
                QVERIFY2(worst <= kTwiceTheLimit_um[axis],
                         qPrintable(QStringLiteral("%1 axis %2: %3").arg(name.c_str()).arg(axis).arg(worst)));
            }
        }
    }
}

void TestSensorHealth::aSensorDeadFromTheStartIsLeftOut() {
    for (std::size_t i = 0; i < defaultModel().sensors.size(); ++i) {
        const ThermalHistory day = tampered(
            "T2_consthigh", defaultModel().sensors[i].name, [](double, double) { return 0.0; }, -10.0);
        const Replay replayed = replay(defaultModel(), day);
        QVERIFY(isSick(replayed.sensors[i]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            QVERIFY(worst_um(day, axis) <= kTwiceTheLimit_um[axis]);
        }
    }
}

void TestSensorHealth::coarseReadingsAreNotStuck() {
    // A machine whose amplifiers resolve .1 K: trained so, its repeats are no fault.
    std::vector<ThermalHistory> days = kerf::test::trainingDays();
    ThermalHistory unseen = thermalDay("T6_ambient");
    for (ThermalHistory* day : {&days[0], &days[1], &days[2], &unseen}) {
        for (double& value : day->temp_degC.reshaped()) {
            value = std::round(value * 10.0) / 10.0;
        }
    }
    const auto model = trainRegression(days, {});
    QVERIFY(model.has_value());
    for (const SensorState state : replay(*model, unseen).sensors) {
        QCOMPARE(state, SensorState::Healthy);
    }
}

void TestSensorHealth::aLinkThatWasCutComesBack() {
    // Twenty minutes without any thermocouple, in the middle of the day.
    const ThermalHistory whole = thermalDay("T1_rand");
    ThermalHistory cut = whole;
    for (Eigen::Index row = 0; row < cut.rows(); ++row) {
        const double t_min = cut.time_min[static_cast<std::size_t>(row)];
        if (t_min >= 150.0 && t_min < 170.0) {
            cut.present.row(row).setConstant(false);
        }
    }
    const Replay undisturbed = replay(defaultModel(), whole);
    const Replay replayed = replay(defaultModel(), cut);
    for (const SensorState state : replayed.sensors) {
        QVERIFY(state == SensorState::Healthy);
    }
    for (std::size_t k = 0; k < replayed.minutes.size(); ++k) {
        const double t_min = replayed.minutes[k].time_min;
        const bool away = t_min >= 150.0 && t_min < 170.0 + SensorHealth::kReturning - 1;
        QCOMPARE(replayed.minutes[k].prediction.usable, !away);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double apart_um = std::abs(replayed.minutes[k].prediction.drift_um[axis] -
                                             undisturbed.minutes[k].prediction.drift_um[axis]);
            QVERIFY2(away || t_min < 150.0 || apart_um < 3.0, qPrintable(QString::number(apart_um)));
            QVERIFY2(t_min < 260.0 || apart_um < 0.5, qPrintable(QString::number(apart_um)));
        }
    }
}

QTEST_APPLESS_MAIN(TestSensorHealth)
#include "tst_sensor_health.moc"
