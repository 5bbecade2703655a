// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/files/thermal_files.h"
#include "app/sensors/sensor_session.h"
#include "engine/cycle/engine.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "engine/machine/sensors/sensor_port.h"
#include "engine/process/thermal/thermal_loop.h"
#include "engine/process/thermal/training.h"
#include "tests/support/golden.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

namespace {

constexpr double kPeriod_min = 0.1;
constexpr int kTemperatures = 64;

bool setSignal(const QString& name, bool value) {
    QProcess halcmd;
    halcmd.start(QStringLiteral("halcmd"),
                 {QStringLiteral("sets"), name, value ? QStringLiteral("1") : QStringLiteral("0")});
    return halcmd.waitForFinished() && halcmd.exitCode() == 0;
}

}  // namespace

/// Temperatures on HAL pins of LinuxCNC's simulator → reading process → thermal loop → external offsets of the control.
class TestLinuxCncThermal : public QObject {
    Q_OBJECT

    bool setRow(Eigen::Index row) {
        QProcess halcmd;  // all of them in one go
        halcmd.start(QStringLiteral("halcmd"), {QStringLiteral("-f"), QStringLiteral("-k")});
        if (!halcmd.waitForStarted()) {
            return false;
        }
        for (int k = 0; k < kTemperatures; ++k) {
            halcmd.write(
                QStringLiteral("sets kerf-temp-%1 %2\n").arg(k).arg(m_day.temp_degC(row, k), 0, 'f', 3).toLatin1());
        }
        halcmd.closeWriteChannel();
        return halcmd.waitForFinished() && halcmd.exitCode() == 0;
    }
    template <class Action>
    bool send(const Action& action) {
        Command command;
        command.action = action;
        const auto number = m_engine->send(command);
        return number && QTest::qWaitFor([&] {
                   const auto& recent = m_engine->status().recentCommands;
                   return std::ranges::any_of(recent,
                                              [&](const CommandResult& r) { return r.number == *number && r.done; });
               });
    }
    [[nodiscard]] ThermalStatus thermal() { return m_engine->status().thermal; }
    [[nodiscard]] double largestShift_um() {
        double largest = 0.0;
        for (const Reading& shift : thermal().shifted_um) {
            largest = std::max(largest, shift.good() ? std::abs(shift.value) : 0.0);
        }
        return largest;
    }

 private slots:
    void theOriginFollowsTemperaturesOfHalPins() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        const auto read = [](const char* name, headless::HistoryUse use) {
            return headless::readThermalHistory(test::fixture(std::string("thermal/") + name + ".csv"), use);
        };
        m_day = read("T2_consthigh", headless::HistoryUse::Prediction);
        const std::vector days{read("H0_train", headless::HistoryUse::Training),
                               read("H1_train", headless::HistoryUse::Training)};
        const auto model = thermal::trainRegression(days, {});
        QVERIFY(model.has_value());
        test::LinuxCncControl control;
        QVERIFY2(control.start(), control.log());

        nlohmann::json file{{"modules", {{{"name", "H"}, {"transport", "hal"}}}}};
        for (int k = 0; k < kTemperatures; ++k) {
            file["channels"].push_back({{"name", m_day.sensors[static_cast<std::size_t>(k)]},
                                        {"module", "H"},
                                        {"pin", QStringLiteral("kerf.temperature-%1").arg(k).toStdString()}});
        }
        std::ofstream("sensors.json") << file;
        sensors::SensorSession session("sensors.json");
        QVERIFY(session.start().has_value());
        QVERIFY(setRow(0));

        linuxcnc::LinuxCncMachine machine{linuxcnc::LinuxCncMachine::Params{}};
        SensorPort::Params params;
        params.memoryName = session.memoryName();
        for (std::uint16_t k = 0; k < kTemperatures; ++k) {
            params.temperatures.push_back(k);
        }
        SensorPort port(machine, params);
        QVERIFY(port.connect().has_value());
        std::vector<std::unique_ptr<ProcessLoop>> loops;
        loops.push_back(std::make_unique<ThermalLoop>(*m_exchange));
        m_engine = std::make_unique<Engine>(port, std::move(loops));
        const auto end = qScopeGuard([this] { m_engine.reset(); });  // before the port, also when a check fails
        m_exchange->offer(std::move(*LiveModel::make(*model, m_day.sensors, 1)));
        m_engine->start();
        QTRY_VERIFY(m_engine->status().link == LinkState::Up);
        QVERIFY(m_engine->capabilities().temperatures.fitted);
        ThermalSetup setup;
        setup.revision = 1;
        setup.period_min = kPeriod_min;
        setup.maxStep_umPerMin = 60.0;
        QVERIFY(send(LoadThermalSetup{setup}));
        QVERIFY(send(SetLoopMode{ProcessId::Thermal, LoopMode::Control}));
        // At rest, with the noise of that day: six readings alike in a row are a thermocouple that is stuck.
        for (Eigen::Index k = 0; k < 60 && thermal().stage != ThermalStage::Following; ++k) {
            QVERIFY(setRow(k % m_day.baselineRows()));
            (void)QTest::qWaitFor([this] { return thermal().stage == ThermalStage::Following; }, 1000);
        }
        QVERIFY2(thermal().stage == ThermalStage::Following,
                 qPrintable(QStringLiteral("stage %1").arg(static_cast<int>(thermal().stage))));
        QCOMPARE(largestShift_um(), 0.0);

        // The machine warms: an hour of that day with every prediction.
        Eigen::Index row = m_day.baselineRows();
        const auto warm = [&] {
            const std::uint32_t before = thermal().updates;
            row = std::min(row + 60, m_day.rows() - 1);
            return setRow(row) && QTest::qWaitFor([&] { return thermal().updates > before; }, 20'000);
        };
        for (int k = 0; k < 10 && largestShift_um() < 3.0; ++k) {
            QVERIFY(warm());
            (void)QTest::qWaitFor([this] { return largestShift_um() >= 3.0; }, 4000);  // a micrometre a second
        }
        QVERIFY2(largestShift_um() >= 3.0,
                 qPrintable(QStringLiteral("%1 µm; Z: drift %2, target %3, read back %4 (%5); stage %6, machine on %7")
                                .arg(largestShift_um())
                                .arg(thermal().drift_um[2])
                                .arg(thermal().target_um[2])
                                .arg(thermal().shifted_um[2].value)
                                .arg(static_cast<int>(thermal().shifted_um[2].quality))
                                .arg(static_cast<int>(thermal().stage))
                                .arg(m_engine->status().machineOn)));
        // The control really has it: what it reads back is what was asked for.
        QTRY_VERIFY_WITH_TIMEOUT(
            std::ranges::all_of(std::array<std::size_t, 3>{0, 1, 2},
                                [&](std::size_t axis) {
                                    return std::abs(thermal().shifted_um[axis].value - thermal().target_um[axis]) < 0.6;
                                }),
            30'000);

        // The reading process hangs: stale, nothing moves, and it goes on by itself.
        const std::int64_t hung_ns = test::monotonic_ns();
        QVERIFY(kill(session.process(), SIGSTOP) == 0);
        QTRY_VERIFY(thermal().stage == ThermalStage::NoTemperatures);
        const double noticed_ms = static_cast<double>(test::monotonic_ns() - hung_ns) / 1e6;
        QTest::qWait(300);  // until the control has followed what was asked of it before
        const double held_um = largestShift_um();
        QTest::qWait(1000);
        QCOMPARE(largestShift_um(), held_um);
        QVERIFY(QTest::qWaitFor(
            [&] {
                session.keep();  // ends it and starts another
                return session.restarts() > 0 && thermal().stage == ThermalStage::Following;
            },
            20'000));
        qInfo("reading process hung: noticed after %.0f ms, controlling again after %.0f ms", noticed_ms,
              static_cast<double>(test::monotonic_ns() - hung_ns) / 1e6);
        QVERIFY(std::abs(largestShift_um() - held_um) < 2.0);
        QVERIFY(warm());

        // A driver reports a fault of one channel, and takes it back.
        QVERIFY(setSignal(QStringLiteral("kerf-temp-fault-0"), true));
        QTRY_VERIFY_WITH_TIMEOUT(thermal().couple[0] == CoupleState::Unread || thermal().couple[0] == CoupleState::Open,
                                 20'000);
        QVERIFY(setSignal(QStringLiteral("kerf-temp-fault-0"), false));
        QTRY_VERIFY_WITH_TIMEOUT(thermal().couple[0] == CoupleState::Healthy, 60'000);
    }

 private:
    thermal::ThermalHistory m_day{};
    std::unique_ptr<ThermalExchange> m_exchange{std::make_unique<ThermalExchange>()};
    std::unique_ptr<Engine> m_engine;
};

KERF_TEST_IN_TIME(TestLinuxCncThermal)
#include "tst_linuxcnc_thermal.moc"
