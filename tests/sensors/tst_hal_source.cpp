// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <thread>

#include "app/sensors/hal_source.h"
#include "tests/support/scripted_control.h"

using namespace kerf;
using namespace kerf::sensors;

namespace {

constexpr const char* kFile = R"({"modules": [{"name": "H", "transport": "hal"}],
    "channels": [{"name": "T00", "module": "H", "pin": "kerf.temperature-0"}, {"name": "T01", "module": "H", "pin": "kerf.temperature-7"}]})";

}  // namespace

/// Temperatures on pins of the bridge, from a memory of this test's own.
class TestHalSource : public QObject {
    Q_OBJECT
    void show(double temp_degC) {
        linuxcnc::HalTemperatures now;
        now.beat = ++m_beat;
        now.linked = 1;
        now.temp_degC[0] = temp_degC;
        m_bridge->memory->temperatures.push(now);
    }
    /// Looked at until the first channel shows it; false: it never did.
    bool shows(HalSource& source, const std::vector<ChannelJudge>& judges, double temp_degC, bool again = false) {
        for (int i = 0; i < 20'000; ++i) {
            if (again) show(temp_degC);
            source.read();
            if (judges[0].value().quality == Quality::Good && judges[0].value().value == temp_degC) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the thread that looks for the memory
        }
        return false;
    }
    std::unique_ptr<test::ScriptedBridge> m_bridge{};
    std::uint64_t m_beat{0};

 private slots:
    void init() {
        m_bridge.reset();  // first: its end takes the name away
        m_bridge = std::make_unique<test::ScriptedBridge>();
    }
    void whatAKilledBridgeHasLeftBehindIsNoReading() {
        const SensorFile file = parseSensorFile(kFile);
        std::vector<ChannelJudge> judges{ChannelJudge(file.channels[0]), ChannelJudge(file.channels[1])};
        for (int i = 0; i < 30; ++i)
            show(31.5);
        m_bridge->ready();
        HalSource source(file, judges, test::ownMemory());
        for (int i = 0; i < 100; ++i)
            source.read();
        QCOMPARE(judges[0].value().cause, Cause::NotYetRead);
        QCOMPARE(judges[0].value().changes, 0U);
        show(24.25);  // it lives
        source.read();
        QCOMPARE(judges[0].value().quality, Quality::Good);
        QCOMPARE(judges[0].value().value, 24.25);
        QCOMPARE(judges[1].value().cause, Cause::NotLinked);
    }
    void aNewBridgeIsFound() {
        const SensorFile file = parseSensorFile(kFile);
        std::vector<ChannelJudge> judges{ChannelJudge(file.channels[0]), ChannelJudge(file.channels[1])};
        m_bridge->ready();
        HalSource source(file, judges, test::ownMemory());
        source.read();
        show(24.25);
        QVERIFY(shows(source, judges, 24.25));
        init();
        m_bridge->ready();
        QVERIFY(shows(source, judges, 24.5, true));
    }
};
QTEST_APPLESS_MAIN(TestHalSource)
#include "tst_hal_source.moc"
