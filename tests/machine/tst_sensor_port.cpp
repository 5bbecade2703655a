// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <QTest>
#include <chrono>
#include <new>

#include "engine/machine/replay/replay_machine.h"
#include "engine/machine/sensors/sensor_port.h"
#include "tests/support/cycle_guard.h"
#include "tests/support/sensor_process.h"

using namespace kerf;

namespace {

ReplayRow row(double time_min, float temp_degC) {
    ReplayRow one;
    one.time_min = time_min;
    one.speed_rpm = 1000.0 * time_min;
    one.temp_degC[0] = temp_degC;
    one.present = 1;
    return one;
}

}  // namespace

class TestSensorPort : public QObject {
    Q_OBJECT
 private slots:
    void readingsJoinAMachineThatHasNone() {
        const std::string name = QString::asprintf("/kerf-test-%d", getpid()).toStdString();
        test::SensorProcess writer(name);
        ReplayMachine machine({row(0.0, 20.0F), row(1.0, 21.0F)}, 1);
        SensorPort port(machine, {name, {2, 0}, 1});
        QVERIFY(port.connect().has_value());
        QCOMPARE(port.capabilities().temperatureCount, std::uint16_t{2});
        QVERIFY(port.capabilities().process[static_cast<std::size_t>(ProcessId::Thermal)].fitted);
        MachineInputs inputs;
        port.read(5'000'000'000, inputs);
        QVERIFY(inputs.temperatures == nullptr);  // nobody has written yet
        writer.write({30.0, 1500.0, 40.0});
        {
            const test::CycleGuard guard;
            port.read(6'000'000'000, inputs);
            QVERIFY(!test::CycleGuard::available() || guard.allocations() + guard.locks() + guard.throws() == 0);
        }
        QVERIFY(inputs.temperatures != nullptr);
        QCOMPARE(inputs.temperatures->temp_degC[0].value, 40.0);
        QCOMPARE(inputs.temperatures->temp_degC[1].value, 30.0);
        QCOMPARE(inputs.temperatures->temp_degC[0].stamp_ns, std::int64_t{5'600'000'000});
        QVERIFY(inputs.temperatures->temp_degC[0].good());
        QCOMPARE(inputs.spindleSpeed_rpm.value, 1500.0);
        writer.write({30.0, 1500.0, 40.0}, Quality::Stale);
        port.read(7'000'000'000, inputs);
        QVERIFY(inputs.temperatures == nullptr);  // not one that is good
        writer.write({30.0, 1500.0, 40.0}, Quality::Good, 2.0);
        port.read(8'000'000'000, inputs);
        QVERIFY(inputs.temperatures == nullptr && inputs.spindleSpeed_rpm.quality == Quality::Stale);  // it hangs
        writer.write({31.0, 1500.0, 41.0});
        port.read(9'000'000'000, inputs);
        QVERIFY(inputs.temperatures != nullptr && inputs.temperatures->temp_degC[0].value == 41.0);
    }
    void aRecordedDayComesAgain() {
        ReplayMachine machine({row(-1.0, 20.0F), row(0.0, 21.0F), row(1.0, 22.0F)}, 1);
        MachineInputs inputs;
        const auto at = [&](double time_min) {
            machine.read(static_cast<std::int64_t>((time_min + 11.0) * 60e9), inputs);
            return inputs.temperatures == nullptr ? -1.0 : inputs.temperatures->temp_degC[0].value;
        };
        QCOMPARE(at(-1.0), 20.0);
        QCOMPARE(at(-0.01), 20.0);
        QCOMPARE(at(0.0), 21.0);
        QCOMPARE(inputs.temperatures->revision, std::uint64_t{2});
        QCOMPARE(at(1.5), 22.0);
        QCOMPARE(inputs.spindleSpeed_rpm.value, 1000.0);
        QCOMPARE(at(3.5), -1.0);  // yesterday is over
        QVERIFY(machine.ended());
        MachineOutputs outputs;
        outputs.workOffset_um[1] = -7.2;
        machine.write(outputs);
        (void)at(4.0);
        QCOMPARE(inputs.workOffset_um[1].value, -7.0);
        outputs.request = {5, AbortProgram{}};
        machine.write(outputs);
        (void)at(4.1);
        QVERIFY(inputs.reply.state == RequestState::Refused && !inputs.reply.reason.empty());
    }
};

QTEST_APPLESS_MAIN(TestSensorPort)
#include "tst_sensor_port.moc"
