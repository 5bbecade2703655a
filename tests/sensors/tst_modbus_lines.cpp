// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QLoggingCategory>
#include <QTest>
#include <nlohmann/json.hpp>

#include "app/sensors/monotonic.h"
#include "app/sensors/sensor_poller.h"
#include "tests/support/modbus_modules.h"

using namespace kerf;
using namespace kerf::sensors;
using Json = nlohmann::json;
using test::ModbusModules;

namespace {

constexpr int kPeriod_ms = 100;
constexpr int kTimeout_ms = 80;
constexpr int kSerialTimeout_ms = 400;  // through two ptys and two other programs, on a busy computer

Json tcp(const std::string& name, int port, int unit = 1) {
    return {{"name", name}, {"transport", "tcp"},      {"host", "127.0.0.1"},      {"port", port},
            {"unit", unit}, {"period_ms", kPeriod_ms}, {"timeout_ms", kTimeout_ms}};
}
Json rtu(const std::string& name, const QString& device, int unit) {
    return {{"name", name}, {"transport", "rtu"},      {"device", device.toStdString()},
            {"unit", unit}, {"period_ms", kPeriod_ms}, {"timeout_ms", kSerialTimeout_ms}};
}
Json channel(const std::string& name, const std::string& module, int address) {
    return {{"name", name}, {"module", module}, {"address", address}, {"scale", 0.1}};
}

/// A poller in this process, and what it publishes.
struct Bench {
    explicit Bench(const Json& file) : poller(parseSensorFile(file.dump()), *memory) { poller.start(); }
    [[nodiscard]] ChannelValue now(std::size_t i) const {
        SensorFrame frame;
        return memory->frames.latest(frame) ? frame.channel[i] : ChannelValue{};
    }
    [[nodiscard]] bool becomes(std::size_t i, Quality quality, int within_ms = 20'000) const {
        return QTest::qWaitFor([&] { return now(i).quality == quality; }, within_ms);
    }
    [[nodiscard]] bool reads(std::size_t i, double value, int within_ms = 20'000) const {
        return QTest::qWaitFor([&] { return now(i).quality == Quality::Good && std::abs(now(i).value - value) < 1e-9; },
                               within_ms);
    }
    std::unique_ptr<SensorMemory> memory{std::make_unique<SensorMemory>()};
    SensorPoller poller;
};

}  // namespace

/// Faults on the way to a module, against modules of pymodbus.
class TestModbusLines : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() {
        if (const QString why = ModbusModules::whyNot(true); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QLoggingCategory::setFilterRules(QStringLiteral("qt.modbus*=false"));
    }
    void init() {
        m_modules = std::make_unique<ModbusModules>();
        QVERIFY(m_modules->start());
    }
    void cleanup() { m_modules.reset(); }

    void everyTypeComesAsTheFileSays() {
        int id = 0;
        const int port = m_modules->addTcp(id, 64, 7);
        QVERIFY(port > 0);
        QVERIFY(m_modules->set(id, "input", 0, {215, 0xFFFE, 0x41AC, 0x0000, 0x0000, 0x41AC, 1, 2}, 7));
        QVERIFY(m_modules->set(id, "holding", 3, {-45}, 7));
        Json channels = Json::array();
        channels.push_back(channel("int16", "A", 0));
        channels.push_back(channel("minus", "A", 1));
        channels.push_back({{"name", "float"}, {"module", "A"}, {"address", 2}, {"type", "float32"}});
        channels.push_back(
            {{"name", "little"}, {"module", "A"}, {"address", 4}, {"type", "float32"}, {"words", "little"}});
        channels.push_back(
            {{"name", "speed"}, {"quantity", "speed"}, {"module", "A"}, {"address", 6}, {"type", "uint32"}});
        channels.push_back({{"name", "holding"}, {"module", "A"}, {"function", 3}, {"address", 3}, {"scale", 0.5}});
        const Bench bench({{"modules", {tcp("A", port, 7)}}, {"channels", channels}});
        QVERIFY(bench.reads(0, 21.5));
        QVERIFY(bench.reads(1, -0.2));
        QVERIFY(bench.reads(2, 21.5));
        QVERIFY(bench.reads(3, 21.5));
        QVERIFY(bench.reads(4, 65538.0));
        QVERIFY(bench.reads(5, -22.5));
    }
    void anotherClientSeesTheSameRegisters() {
        // mbpoll counts registers from 1, the sensor file as the wire does, from 0.
        if (QStandardPaths::findExecutable(QStringLiteral("mbpoll")).isEmpty()) {
            QSKIP("mbpoll is not installed here (package mbpoll)");
        }
        int id = 0;
        const int port = m_modules->addTcp(id, 64, 1);
        QVERIFY(m_modules->set(id, "input", 7, {-215}));
        QProcess mbpoll;
        mbpoll.start(QStringLiteral("mbpoll"), {"-m", "tcp", "-a", "1", "-t", "3", "-r", "8", "-c", "1", "-1", "-p",
                                                QString::number(port), "127.0.0.1"});
        QVERIFY(mbpoll.waitForFinished(10'000));
        QVERIFY(mbpoll.readAllStandardOutput().contains("[8]: \t65321 (-215)"));
        const Bench bench({{"modules", {tcp("A", port)}}, {"channels", {channel("T7", "A", 7)}}});
        QVERIFY(bench.reads(0, -21.5));
    }
    void statusRegistersAndCodesAreHeeded() {
        int id = 0;
        const int port = m_modules->addTcp(id);
        QVERIFY(m_modules->set(id, "input", 0, {215, 216, 217}));
        Json channels = {channel("T0", "A", 0), channel("T1", "A", 1), channel("T2", "A", 2)};
        channels[0]["invalid"] = {9999};
        channels[1]["status"] = {{"address", 32}, {"bad", {1, 2}}};
        channels[2]["status"] = {{"function", 2}, {"address", 8}, {"bad", {1}}};
        const Bench bench({{"modules", {tcp("A", port)}}, {"channels", channels}});
        QVERIFY(bench.reads(0, 21.5) && bench.reads(1, 21.6) && bench.reads(2, 21.7));
        QVERIFY(m_modules->set(id, "input", 0, {9999}) && m_modules->set(id, "input", 32, {2}) &&
                m_modules->set(id, "discrete", 8, {1}));
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(bench.becomes(i, Quality::Bad));
        }
        QVERIFY(bench.now(0).cause == Cause::InvalidCode && bench.now(1).cause == Cause::BadStatus &&
                bench.now(2).cause == Cause::BadStatus);
        QVERIFY(m_modules->set(id, "input", 0, {220}) && m_modules->set(id, "input", 32, {0}) &&
                m_modules->set(id, "discrete", 8, {0}));
        QVERIFY(bench.reads(0, 22.0) && bench.reads(1, 21.6) && bench.reads(2, 21.7));
    }
    void aModuleWithAnotherMapIsSaidNotRead() {
        int id = 0;
        const int port = m_modules->addTcp(id, 8);  // 8 registers, and the file wants the ninth
        const Bench bench(
            {{"modules", {tcp("A", port)}}, {"channels", {channel("T0", "A", 7), channel("T1", "A", 8)}}});
        QVERIFY(bench.becomes(1, Quality::Bad));
        QVERIFY(bench.now(1).cause == Cause::Refused);
        QVERIFY(bench.becomes(0, Quality::Good));  // the rest goes on, though both were asked for together
    }
    void oneBadModuleDelaysNoOther_data() {
        QTest::addColumn<QString>("mode");
        QTest::newRow("hang") << "hang";
        QTest::newRow("cut") << "cut";
        QTest::newRow("late") << "late";
    }
    void oneBadModuleDelaysNoOther() {
        QFETCH(QString, mode);
        int good = 0;
        int bad = 0;
        const int goodPort = m_modules->addTcp(good);
        const int badPort = m_modules->addTcp(bad);
        QVERIFY(m_modules->set(good, "input", 0, {215}) && m_modules->set(bad, "input", 0, {300}));
        const Bench bench({{"modules", {tcp("bad", badPort), tcp("good", goodPort)}},
                           {"channels", {channel("T0", "bad", 0), channel("T1", "good", 0)}}});
        QVERIFY(bench.reads(0, 30.0) && bench.reads(1, 21.5));
        const std::int64_t broken_ns = monotonic_ns();
        QVERIFY(m_modules->line(bad, mode.toLatin1(), 0.5));
        QVERIFY(bench.becomes(0, Quality::Stale));
        const double stale_ms = static_cast<double>(monotonic_ns() - broken_ns) / 1e6;
        qInfo("%s: stale after %.0f ms (period %d, time-out %d)", qPrintable(mode), stale_ms, kPeriod_ms, kTimeout_ms);
        const std::uint32_t before = bench.now(1).changes;
        const std::int64_t start_ns = monotonic_ns();
        QTest::qWait(1500);
        const double passed_ms = static_cast<double>(monotonic_ns() - start_ns) / 1e6;
        const double share = (bench.now(1).changes - before) * kPeriod_ms / passed_ms;
        QVERIFY2(share > 0.7, qPrintable(QString::number(share)));  // of its rounds, on a busy computer too
        QVERIFY(bench.now(0).quality == Quality::Stale);
        QVERIFY(m_modules->set(bad, "input", 0, {310}));
        const std::int64_t healed_ns = monotonic_ns();
        QVERIFY(m_modules->line(bad, "pass"));
        QVERIFY(bench.reads(0, 31.0));  // by itself
        qInfo("%s: reads again after %.0f ms", qPrintable(mode), static_cast<double>(monotonic_ns() - healed_ns) / 1e6);
    }
    void answersToTheQuestionBeforeNeverCount() {
        // Two blocks of the same shape, answers later than the time-out: whoever took a late one would show T0's value
        // as T1's.
        int id = 0;
        const int port = m_modules->addTcp(id);
        QVERIFY(m_modules->set(id, "input", 0, {215}) && m_modules->set(id, "input", 40, {415}));
        const Bench bench(
            {{"modules", {tcp("A", port)}}, {"channels", {channel("T0", "A", 0), channel("T1", "A", 40)}}});
        QVERIFY(bench.reads(0, 21.5) && bench.reads(1, 41.5));
        for (const double late_s : {0.09, 0.1, 0.12, 0.2, 0.35}) {
            QVERIFY(m_modules->line(id, "late", late_s));
            QElapsedTimer passed;
            passed.start();
            while (passed.elapsed() < 1200) {
                QTest::qWait(5);
                QVERIFY(std::abs(bench.now(0).value - 21.5) < 1e-9 && std::abs(bench.now(1).value - 41.5) < 1e-9);
            }
        }
        QVERIFY(bench.becomes(0, Quality::Stale));
        QVERIFY(m_modules->line(id, "pass"));
        QVERIFY(bench.becomes(0, Quality::Good) && bench.becomes(1, Quality::Good));
    }
    void aModuleThatComesLaterIsFound() {
        int id = 0;
        const int port = m_modules->addTcp(id);
        QVERIFY(m_modules->set(id, "input", 0, {215}));
        QVERIFY(m_modules->line(id, "cut"));
        const Bench bench({{"modules", {tcp("A", port)}}, {"channels", {channel("T0", "A", 0)}}});
        QVERIFY(QTest::qWaitFor([&] { return bench.now(0).cause == Cause::NoAnswer; }, 5000));
        QVERIFY(bench.now(0).quality == Quality::Missing);
        QVERIFY(m_modules->line(id, "pass"));
        QVERIFY(bench.reads(0, 21.5));
    }

    void serialModulesShareALine() {
        int id = 0;
        const QString device = m_modules->addRtu(id, {1, 2});
        QVERIFY(!device.isEmpty());
        QVERIFY(m_modules->set(id, "input", 0, {215}, 1) && m_modules->set(id, "input", 0, {315}, 2));
        const Bench bench({{"modules", {rtu("A", device, 1), rtu("B", device, 2), rtu("dead", device, 3)}},
                           {"channels", {channel("T0", "A", 0), channel("T1", "B", 0), channel("T2", "dead", 0)}}});
        QVERIFY(bench.reads(0, 21.5) && bench.reads(1, 31.5));
        QVERIFY(QTest::qWaitFor([&] { return bench.now(2).cause == Cause::NoAnswer; }, 5000));
        const std::uint32_t before = bench.now(0).changes;
        QTRY_VERIFY_WITH_TIMEOUT(bench.now(0).changes > before + 5,
                                 20'000);  // the dead one costs one time-out every two seconds
        QVERIFY(bench.now(0).quality == Quality::Good && bench.now(1).quality == Quality::Good);
    }
    void noiseOnTheLineIsNoNumberAndGoesByItself() {
        int id = 0;
        const QString device = m_modules->addRtu(id, {1});
        QVERIFY(m_modules->set(id, "input", 0, {215}, 1));
        const Bench bench({{"modules", {rtu("A", device, 1)}}, {"channels", {channel("T0", "A", 0)}}});
        QVERIFY(bench.reads(0, 21.5));
        QVERIFY(m_modules->line(id, "noise"));
        QVERIFY(bench.becomes(0, Quality::Stale));
        QCOMPARE(bench.now(0).value, 21.5);
        QVERIFY(m_modules->set(id, "input", 0, {216}, 1) && m_modules->line(id, "pass"));
        QVERIFY(bench.reads(0, 21.6));
    }
    void lateAnswersOnASerialLineNeverCount() {
        int id = 0;
        const QString device = m_modules->addRtu(id, {1, 2});
        QVERIFY(m_modules->set(id, "input", 0, {215}, 1) && m_modules->set(id, "input", 40, {415}, 1) &&
                m_modules->set(id, "input", 0, {615}, 2));
        const Bench bench({{"modules", {rtu("A", device, 1), rtu("B", device, 2)}},
                           {"channels", {channel("T0", "A", 0), channel("T1", "A", 40), channel("T2", "B", 0)}}});
        QVERIFY(bench.reads(0, 21.5) && bench.reads(1, 41.5) && bench.reads(2, 61.5));
        for (const double late_s : {0.41, 0.5, 0.9}) {
            QVERIFY(m_modules->line(id, "late", late_s));
            QElapsedTimer passed;
            passed.start();
            while (passed.elapsed() < 2500) {
                QTest::qWait(5);
                QVERIFY(std::abs(bench.now(0).value - 21.5) < 1e-9 && std::abs(bench.now(1).value - 41.5) < 1e-9 &&
                        std::abs(bench.now(2).value - 61.5) < 1e-9);
            }
        }
        QVERIFY(m_modules->line(id, "pass"));
        QVERIFY(bench.becomes(0, Quality::Good) && bench.becomes(1, Quality::Good) && bench.becomes(2, Quality::Good));
    }
    void anAdapterPulledOutAndInIsFoundAgain() {
        int id = 0;
        const QString device = m_modules->addRtu(id, {1});
        QVERIFY(m_modules->set(id, "input", 0, {215}, 1));
        const Bench bench({{"modules", {rtu("A", device, 1)}}, {"channels", {channel("T0", "A", 0)}}});
        QVERIFY(bench.reads(0, 21.5));
        m_modules->dropPair();
        QVERIFY(bench.becomes(0, Quality::Stale));
        QCOMPARE(m_modules->addRtu(id, {1}), device);
        QVERIFY(m_modules->set(id, "input", 0, {216}, 1));
        QVERIFY(bench.reads(0, 21.6));
    }

    void gaugesOnSerialLinesAreHeard() {
        const QString far = m_modules->file("gauge-far");
        const QString near = m_modules->file("gauge-near");
        const Json file = {
            {"gauges",
             {{{"name", "G1"}, {"device", near.toStdString()}, {"protocol", "digimatic"}, {"depths", {{"01", 1}}}},
              {{"name", "G2"}, {"device", "/nowhere"}, {"protocol", "mahr"}}}}};
        const Bench bench(file);
        QVERIFY(m_modules->makePair(far, near));  // plugged in while it runs
        QVERIFY(QTest::qWaitFor([&] { return bench.memory->gaugeConnected[0].load(); }, 5000));
        QVERIFY(!bench.memory->gaugeConnected[1].load());
        QFile port(far);
        QVERIFY(port.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        port.write("01A+00050.012\r02A-00000.003\r911\r");  // a foot switch: all channels at once
        GaugeEvent event;
        std::vector<GaugeEvent> events;
        std::uint64_t next = 0;
        QVERIFY(QTest::qWaitFor(
            [&] {
                while (bench.memory->gauges.read(next, event)) {
                    events.push_back(event);
                }
                return events.size() == 3;
            },
            5000));
        QVERIFY(events[0].understood && events[1].understood && !events[2].understood);
        QCOMPARE(events[0].value, 50.012);
        QCOMPARE(QString::fromLatin1(events[0].channel.data()), QStringLiteral("01"));
        QCOMPARE(events[1].value, -0.003);
        m_modules->dropPair();
        QVERIFY(QTest::qWaitFor([&] { return !bench.memory->gaugeConnected[0].load(); }, 5000));
    }

 private:
    std::unique_ptr<ModbusModules> m_modules;
};

QTEST_GUILESS_MAIN(TestModbusLines)
#include "tst_modbus_lines.moc"
