// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/files/thermal_files.h"
#include "app/sensors/sensor_poller.h"
#include "engine/process/thermal/replay.h"
#include "engine/process/thermal/training.h"
#include "tests/support/golden.h"
#include "tests/support/modbus_modules.h"

using namespace kerf;
using namespace kerf::sensors;
using namespace kerf::thermal;
using Json = nlohmann::json;

namespace {

constexpr std::size_t kModules = 8;
constexpr std::size_t kPerModule = 8;
constexpr double kResolution_K = 0.01;

/// Modules 0 … 3 hold hundredths of a degree, 4 and 5 float32, 6 and 7 float32 with swapped words.
struct Registers {
    Registers(const Json& channelFile, std::size_t channel) : kind(channel / kPerModule), json(channelFile) {}
    [[nodiscard]] std::vector<int> of(double temp_degC) const {
        if (kind < 4) {
            return {static_cast<int>(std::lround(temp_degC / kResolution_K))};
        }
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(temp_degC));
        const int high = static_cast<int>(bits >> 16U);
        const int low = static_cast<int>(bits & 0xFFFFU);
        return kind < 6 ? std::vector{high, low} : std::vector{low, high};
    }
    [[nodiscard]] double read(double temp_degC) const {
        return kind < 4 ? kResolution_K * static_cast<double>(of(temp_degC)[0])
                        : static_cast<double>(static_cast<float>(temp_degC));
    }
    std::size_t kind;
    Json json;
};

}  // namespace

/// A recorded day, written minute by minute into the registers of 64 channels in 8 modules of pymodbus.
class TestSensorDay : public QObject {
    Q_OBJECT
 private slots:
    void aDayThroughTheRegistersPredictsAsTheFile() {
        if (const QString why = test::ModbusModules::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        const auto read = [](const char* name, headless::HistoryUse use) {
            return headless::readThermalHistory(test::fixture(std::string("thermal/") + name + ".csv"), use);
        };
        std::vector<ThermalHistory> days;
        for (const char* name : {"H0_train", "H1_train", "H2_train"}) {
            days.push_back(read(name, headless::HistoryUse::Training));
        }
        const auto model = trainRegression(days, {});
        QVERIFY(model.has_value());
        const ThermalHistory day = read("T1_rand", headless::HistoryUse::Prediction);
        QCOMPARE(day.sensors.size(), kModules * kPerModule);

        test::ModbusModules modules;
        QVERIFY(modules.start());
        Json file;
        std::vector<int> ids(kModules);
        for (std::size_t m = 0; m < kModules; ++m) {
            const int port = modules.addTcp(ids[m]);
            const std::string name = QString::asprintf("M%d", static_cast<int>(m)).toStdString();
            file["modules"].push_back({{"name", name},
                                       {"transport", "tcp"},
                                       {"host", "127.0.0.1"},
                                       {"port", port},
                                       {"period_ms", 20},
                                       {"timeout_ms", 2000}});
            for (std::size_t k = 0; k < kPerModule; ++k) {
                Json channel{{"name", day.sensors[m * kPerModule + k]}, {"module", name}};
                channel["address"] = m < 4 ? k : 2 * k;
                if (m < 4) {
                    channel["scale"] = kResolution_K;
                } else {
                    channel["type"] = "float32";
                    channel["words"] = m < 6 ? "big" : "little";
                }
                file["channels"].push_back(channel);
            }
        }
        file["channels"].push_back({{"name", "spindle"}, {"quantity", "speed"}, {"module", "M0"}, {"address", 20}});
        const auto memory = std::make_unique<SensorMemory>();
        SensorPoller poller(parseSensorFile(file.dump()), *memory);
        poller.start();

        const std::size_t count = day.sensors.size();
        ThermalEstimator estimator(*model);
        std::vector<std::size_t> channel;
        for (const ModelSensor& sensor : model->sensors) {
            channel.push_back(static_cast<std::size_t>(*day.sensorIndex(sensor.name)));
        }
        ThermalHistory quantised = day;
        std::vector<ThermalPrediction> live;
        std::vector<Reading> readings(channel.size());
        for (Eigen::Index row = 0; row < day.rows(); ++row) {
            for (std::size_t m = 0; m < kModules; ++m) {
                std::vector<int> registers;
                for (std::size_t k = 0; k < kPerModule; ++k) {
                    const std::size_t i = m * kPerModule + k;
                    const Registers module(file, i);
                    const double temp_degC = day.temp_degC(row, static_cast<Eigen::Index>(i));
                    quantised.temp_degC(row, static_cast<Eigen::Index>(i)) = module.read(temp_degC);
                    for (const int value : module.of(temp_degC)) {
                        registers.push_back(value);
                    }
                }
                QVERIFY(modules.set(ids[m], "input", 0, registers));
            }
            const double speed_rpm = day.speed_rpm[static_cast<std::size_t>(row)];
            quantised.speed_rpm[static_cast<std::size_t>(row)] = std::round(speed_rpm);
            QVERIFY(modules.set(ids[0], "input", 20, {static_cast<int>(std::lround(speed_rpm))}));
            // A question under way was perhaps answered before: two more readings of every channel.
            std::vector<std::uint32_t> before;
            for (std::size_t i = 0; i <= count; ++i) {
                before.push_back(poller.value(i).changes);
            }
            QVERIFY(QTest::qWaitFor(
                [&] {
                    for (std::size_t i = 0; i <= count; ++i) {
                        if (poller.value(i).changes < before[i] + 2) {
                            return false;
                        }
                    }
                    return true;
                },
                10'000));
            for (std::size_t i = 0; i < channel.size(); ++i) {
                const ChannelValue& value = poller.value(channel[i]);
                readings[i] = {value.value, value.stamp_ns, value.quality};
            }
            const double t_min = day.time_min[static_cast<std::size_t>(row)];
            if (t_min < 0.0) {
                estimator.baseline(t_min, readings);
            } else {
                live.push_back(estimator.update(t_min, poller.value(count).value, readings));
            }
        }
        const Replay exact = replay(*model, quantised);
        const Replay recorded = replay(*model, day);
        QCOMPARE(live.size(), exact.minutes.size());
        double worst_um = 0.0;
        for (std::size_t k = 0; k < live.size(); ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                QVERIFY(std::abs(live[k].drift_um[axis] - exact.minutes[k].prediction.drift_um[axis]) < 1e-9);
                worst_um = std::max(worst_um,
                                    std::abs(live[k].drift_um[axis] - recorded.minutes[k].prediction.drift_um[axis]));
            }
        }
        qInfo("%zu minutes: the same as the file's prediction to %.3f um, with registers of %.2f K", live.size(),
              worst_um, kResolution_K);
        QVERIFY2(worst_um < 0.1, qPrintable(QString::number(worst_um)));
    }
};

QTEST_GUILESS_MAIN(TestSensorDay)
#include "tst_sensor_day.moc"
