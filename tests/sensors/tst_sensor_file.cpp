// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/sensors/gauge_frames.h"
#include "app/sensors/reading_plan.h"
#include "app/sensors/sensor_file.h"

using namespace kerf::sensors;
using Json = nlohmann::json;

namespace {

/// The file of the contract, whole.
Json contract() {
    return Json::parse(R"({
        "modules": [
            {"name": "A", "transport": "tcp", "host": "127.0.0.1", "port": 502, "unit": 1, "period_ms": 1000, "timeout_ms": 300},
            {"name": "B", "transport": "rtu", "device": "/dev/ttyUSB0", "baud": 19200, "parity": "none", "unit": 2},
            {"name": "H", "transport": "hal"}],
        "channels": [
            {"name": "T00", "quantity": "temperature", "unit": "degC", "module": "A", "function": 4, "address": 0,
             "type": "int16", "words": "big", "scale": 0.1, "offset": 0, "invalid": [32767],
             "status": {"address": 100, "bad": [1, 2]}, "place": "front bearing"},
            {"name": "T63", "module": "H", "pin": "kerf.temperature-63"}]})");
}

std::string complaint(const Json& json) {
    try {
        (void)parseSensorFile(json.dump());
        return {};
    } catch (const SensorFileFault& fault) {
        return fault.what();
    }
}

}  // namespace

class TestSensorFile : public QObject {
    Q_OBJECT
 private slots:
    void theContractsFileIsTaken() {
        const SensorFile file = parseSensorFile(contract().dump());
        QCOMPARE(file.modules.size(), 3U);
        QCOMPARE(file.channels.size(), 2U);
        const Channel& first = file.channels[0];
        QCOMPARE(first.name, std::string("T00"));
        QCOMPARE(first.scale, 0.1);
        QCOMPARE(first.invalid, std::vector<double>{32767.0});
        QCOMPARE(first.status->address, 100);
        QCOMPARE(first.place, std::string("front bearing"));
        QCOMPARE(file.modules[1].baud, 19200);
        QCOMPARE(file.modules[1].timeout_ms, 300);
        QCOMPARE(file.channels[1].pin, 63);
        QVERIFY(file.modules[file.channels[1].module].transport == Transport::Hal);
    }
    void whatIsWrongIsSaidWithItsKey_data() {
        QTest::addColumn<QString>("pointer");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("begins");
        const auto row = [](const char* pointer, const char* value, const char* begins) {
            QTest::addRow("%s = %s", pointer, value) << pointer << value << begins;
        };
        row("/colour", "1", "colour: unknown key");
        row("/modules/0/prot", "502", "modules[0].prot: unknown key");
        row("/modules/0/device", R"("x")", "modules[0].device: unknown key");
        row("/modules/1/host", R"("x")", "modules[1].host: unknown key");
        row("/modules/2/unit", "1", "modules[2].unit: unknown key");
        row("/channels/0/adress", "1", "channels[0].adress: unknown key");
        row("/channels/0/pin", R"("kerf.temperature-1")", "channels[0].pin: unknown key");
        row("/channels/1/address", "1", "channels[1].address: unknown key");
        row("/channels/0/status/good", "[0]", "channels[0].status.good: unknown key");
        row("/modules/0/transport", R"("usb")", "modules[0].transport: 'usb' is not known");
        row("/modules/0/port", "70000", "modules[0].port: 70000 is out of range");
        row("/modules/0/port", "502.5", "modules[0].port: 502.5 is out of range");
        row("/modules/0/unit", "256", "modules[0].unit: 256 is out of range");
        row("/modules/1/unit", "0", "modules[1].unit: 0 is out of range");
        row("/modules/0/period_ms", "1", "modules[0].period_ms: 1 is out of range");
        row("/modules/0/timeout_ms", R"("300")", "modules[0].timeout_ms: \"300\" is out of range");
        row("/modules/0/host", R"("")", "modules[0].host: \"\" is no text");
        row("/modules/0/name", R"("B")", "modules[1].name: 'B' is the name of modules[0] too");
        row("/modules/1/parity", R"("mark")", "modules[1].parity: 'mark' is not known");
        row("/channels/0/module", R"("Z")", "channels[0].module: there is no module 'Z'");
        row("/channels/0/name", R"("T63")", "channels[1].name: 'T63' is the name of channels[0] too");
        row("/channels/0/function", "6", "channels[0].function: 6 is out of range");
        row("/channels/0/address", "65536", "channels[0].address: 65536 is out of range");
        row("/channels/0/address", "-1", "channels[0].address: -1 is out of range");
        row("/channels/0/type", R"("int8")", "channels[0].type: 'int8' is not known");
        row("/channels/0/words", R"("middle")", "channels[0].words: 'middle' is not known");
        row("/channels/0/name", R"("a\nb")", "channels[0].name: 'a?b' is no name");
        row("/channels/0/module", R"("A\r\n")", "channels[0].module: there is no module 'A");
        row("/a key whose name goes on for longer than any line", "1",
            "a key whose name goes on for longer t...: unknown key");
        row("/channels/0/scale", "0", "channels[0].scale: 0 makes every reading the same");
        row("/channels/0/scale", R"("x")", "channels[0].scale: \"x\" is out of range");
        row("/channels/0/invalid", "[40000]", "channels[0].invalid[0]: 40000 is out of range");
        row("/channels/0/status/bad", "[]", "channels[0].status.bad: no value in it");
        // What a register of 16 bits or a bit can never hold would leave the fault unseen.
        row("/channels/0/status/bad", "[1, 65536]", "channels[0].status.bad[1]: 65536 is out of range");
        row("/channels/0/status", R"({"address": 7, "function": 2, "bad": [2]})",
            "channels[0].status.bad[0]: 2 is out of range");
        row("/channels/0/quantity", R"("pressure")", "channels[0].quantity: 'pressure' is not known");
        row("/channels/0/quantity", R"("force")", "channels[0].quantity: a force is too fast");
        row("/channels/0/unit", R"("degF")", "channels[0].unit: 'degF' is not the unit of a temperature");
        row("/channels/1/pin", R"("kerf.temperature-64")", "channels[1].pin: 'kerf.temperature-64' is no pin");
        row("/channels/1/pin", R"("kerf.temperature-07")", "channels[1].pin: 'kerf.temperature-07' is no pin");
        row("/channels", "[]", "channels: none");
        row("/channels", "{}", "channels: {} is no list");
        row("/modules/0", "7", "modules[0]: 7 is no object");
    }
    void whatIsWrongIsSaidWithItsKey() {
        QFETCH(QString, pointer);
        QFETCH(QString, value);
        QFETCH(QString, begins);
        Json json = contract();
        json[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
        const QString said = QString::fromStdString(complaint(json));
        QVERIFY2(said.startsWith(begins), qPrintable(said));
        QVERIFY2(said.endsWith(u'.') && said.contains(QStringLiteral("expected"), Qt::CaseInsensitive),
                 qPrintable(said));
    }
    void aMissingKeyIsNamed_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<QString>("key");
        for (const auto& [object, key] :
             std::vector<std::pair<const char*, const char*>>{{"", "modules"},
                                                              {"", "channels"},
                                                              {"/modules/0", "name"},
                                                              {"/modules/0", "transport"},
                                                              {"/modules/0", "host"},
                                                              {"/modules/1", "device"},
                                                              {"/channels/0", "name"},
                                                              {"/channels/0", "module"},
                                                              {"/channels/0", "address"},
                                                              {"/channels/1", "pin"},
                                                              {"/channels/0/status", "bad"}}) {
            QTest::addRow("%s.%s", object, key) << object << key;
        }
    }
    void aMissingKeyIsNamed() {
        QFETCH(QString, object);
        QFETCH(QString, key);
        Json json = contract();
        json[Json::json_pointer(object.toStdString())].erase(key.toStdString());
        const QString said = QString::fromStdString(complaint(json));
        QVERIFY2(said.contains(key + QStringLiteral(": missing")), qPrintable(said));
    }
    void brokenJsonIsToldByLineAndColumn() {
        try {
            (void)parseSensorFile("{\n  \"modules\": [,]\n}");
            QFAIL("taken");
        } catch (const SensorFileFault& fault) {
            QVERIFY2(QString::fromLatin1(fault.what()).startsWith(QStringLiteral("line 2, column 15:")), fault.what());
        }
    }
    void aKeyThatStandsTwiceIsRefused() {
        try {
            (void)parseSensorFile(R"({"modules": [], "channels": [], "modules": []})");
            QFAIL("taken");
        } catch (const SensorFileFault& fault) {
            QVERIFY2(QString::fromLatin1(fault.what()).startsWith(QStringLiteral("modules: the key stands twice")),
                     fault.what());
        }
    }
    /// A page says the sentence in its own language: key, sentence and values come apart, with the file's name too.
    void aRefusalComesInItsParts() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath(QStringLiteral("old.json")).toStdString();
        Json json = contract();
        json["channels"][1]["adress"] = 4;
        std::ofstream(path) << json.dump();
        try {
            (void)readSensorFile(path);
            QFAIL("taken");
        } catch (const SensorFileFault& fault) {
            QCOMPARE(fault.where(), std::string("channels[1].adress"));
            QCOMPARE(std::string(fault.text()), std::string("unknown key %2; expected one of %1."));
            QCOMPARE(fault.values().size(), std::size_t{2});
            QVERIFY(fault.values()[0].starts_with("name, quantity, unit"));
            QCOMPARE(std::string(fault.what()), path + ": channels[1].adress: unknown key " + fault.values()[1] +
                                                    "; expected one of " + fault.values()[0] + '.');
        }
    }
    void endlessKeysCostNoTime() {
        std::string text = "{";
        for (int i = 0; i < 200'000; ++i) {
            text += "\"k" + std::to_string(i) + "\":1,";
        }
        try {
            (void)parseSensorFile(text + "\"end\":1}");
            QFAIL("taken");
        } catch (const SensorFileFault& fault) {
            QVERIFY2(QString::fromLatin1(fault.what()).startsWith(QStringLiteral("the file: more than 1000 keys")),
                     fault.what());
        }
    }
    void aLineHasOneSettingAndDifferentUnits() {
        Json json = contract();
        json["modules"].push_back({{"name", "C"}, {"transport", "rtu"}, {"device", "/dev/ttyUSB0"}, {"unit", 2}});
        QVERIFY(complaint(json).starts_with("modules[3].unit: 2 is the unit of modules[1]"));
        json["modules"][3]["unit"] = 3;
        QCOMPARE(complaint(json), std::string());
        json["modules"][3]["baud"] = 9600;
        QVERIFY(complaint(json).starts_with("modules[3].baud: modules[1] is on the same line"));
    }
    void aGaugeHasADeviceOfItsOwnAndAPatternThatIsOne() {
        Json json = contract();
        json["gauges"] = {{{"name", "G1"}, {"device", "/dev/ttyUSB1"}, {"protocol", "mahr"}}};
        QCOMPARE(complaint(json), std::string());
        json["gauges"].push_back({{"name", "G2"}, {"device", "/dev/ttyUSB1"}, {"protocol", "digimatic"}});
        QVERIFY(complaint(json).starts_with("gauges[1].device: /dev/ttyUSB1 is the device of gauges[0] too"));
        json["gauges"][1]["device"] = "/dev/ttyUSB0";
        QVERIFY(complaint(json).starts_with("gauges[1].device: /dev/ttyUSB0 is the device of modules[1] too"));
        json["gauges"][1] = {{"name", "G2"}, {"device", "/dev/ttyUSB2"}, {"protocol", "pattern"}, {"pattern", "(["}};
        QVERIFY(complaint(json).starts_with("gauges[1].pattern: '([': it is no regular expression"));
        json["gauges"][1]["pattern"] = ".*";
        QVERIFY(complaint(json).starts_with("gauges[1].pattern: '.*': it has no group"));
        json["gauges"][1]["pattern"] = "^.*?([+-][0-9.]+).*$";
        QCOMPARE(complaint(json), std::string());
    }
    void aFileWithoutAnEndIsRefused() {
        try {
            (void)readSensorFile("/dev/zero");
            QFAIL("taken");
        } catch (const SensorFileFault& fault) {
            QCOMPARE(fault.what(), "/dev/zero: larger than 4 MB; expected a sensor file.");
        }
    }
    void moreTemperaturesThanThereIsRoomForAreRefused() {
        Json json = contract();
        for (int i = 0; i < 64; ++i) {
            json["channels"].push_back(
                {{"name", QString::asprintf("X%d", i).toStdString()}, {"module", "A"}, {"address", 200 + i}});
        }
        QVERIFY(complaint(json).starts_with("channels: 66 temperatures"));
    }
    void slipsAreWarnedOf() {
        Json json = contract();
        json["channels"][0]["address"] = 30001;
        json["channels"].push_back({{"name", "again"}, {"module", "A"}, {"address", 30001}});
        const SensorFile file = parseSensorFile(json.dump());
        QCOMPARE(file.warnings.size(), 4U);  // two addresses, one register twice, module B unused
    }
    void registersThatTouchAreAskedForTogether() {
        Json json = contract();
        json["channels"] = Json::array();
        for (int i = 0; i < 8; ++i) {
            json["channels"].push_back({{"name", QString::asprintf("T%d", i).toStdString()},
                                        {"module", "A"},
                                        {"address", 10 + 2 * i},
                                        {"type", "float32"},
                                        {"status", {{"function", 2}, {"address", 128 + i}, {"bad", {1}}}}});
        }
        json["channels"].push_back({{"name", "far"}, {"module", "A"}, {"address", 500}});
        const ReadingPlan plan = planFor(parseSensorFile(json.dump()), 0);
        QCOMPARE(plan.blocks.size(), 3U);
        QCOMPARE(plan.blocks[0].function, 2);
        QCOMPARE(plan.blocks[0].count, 8);
        QCOMPARE(plan.blocks[1].address, 10);
        QCOMPARE(plan.blocks[1].count, 16);
        QCOMPARE(plan.blocks[2].address, 500);
        QCOMPARE(plan.channels[3].value.offset, 6U);
        QCOMPARE(plan.channels[3].status.offset, 3U);
    }
    void aChannelWithADepthIsSentUnderTheDepthsNumber() {
        Gauge gauge;
        gauge.depths = {{"07", 1}, {"B", 2}};
        QCOMPARE(depthOf(gauge, "07").value_or(0), 1);
        QCOMPARE(depthOf(gauge, "B").value_or(0), 2);
        QVERIFY(!depthOf(gauge, "03"));
        QCOMPARE(QString::fromStdString(wedgeFrame(gauge, "07", 50.012, false)), QStringLiteral("+50.01200mm"));
        QCOMPARE(QString::fromStdString(wedgeFrame(gauge, "B", -0.003, false)), QStringLiteral("-0.00300mm"));
        QCOMPARE(QString::fromStdString(wedgeFrame(gauge, "03", 1.969, true)), QStringLiteral("03A+1.96900in"));
        QCOMPARE(QString::fromStdString(wedgeFrame(gauge, "", 50.0, false)), QStringLiteral("+50.00000mm"));
        QCOMPARE(QString::fromStdString(wedgeFrame(gauge, "top", 50.0, false)), QStringLiteral("+50.00000mm"));
    }
    void framesOfGauges_data() {
        QTest::addColumn<int>("protocol");
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("value");  // empty: no reading
        QTest::addColumn<QString>("channel");
        const auto row = [](GaugeProtocol protocol, const char* line, const char* value, const char* channel = "") {
            QTest::addRow("%d %s", static_cast<int>(protocol), line)
                << static_cast<int>(protocol) << line << value << channel;
        };
        row(GaugeProtocol::Digimatic, "01A+00012.345", "12.345", "01");
        row(GaugeProtocol::Digimatic, "12A-00000.001", "-0.001", "12");
        row(GaugeProtocol::Digimatic, "911", "");
        row(GaugeProtocol::Digimatic, "912", "");
        row(GaugeProtocol::Digimatic, "01A+00012.3", "12.3", "01");
        row(GaugeProtocol::Digimatic, "01A+000", "");
        row(GaugeProtocol::Mahr, "+12.3456mm", "12.3456");
        row(GaugeProtocol::Mahr, "   +  12.3456 mm", "12.3456");
        row(GaugeProtocol::Mahr, "-0,0123", "-0.0123");
        row(GaugeProtocol::Mahr, "ERR", "");
        row(GaugeProtocol::Sylvac, "+12.345", "12.345");
        row(GaugeProtocol::Sylvac, "ERR0", "");
        row(GaugeProtocol::Sylvac, "12", "");
        row(GaugeProtocol::Pattern, "CH2 ;  3.25 ; OK", "3.25", "2");
        row(GaugeProtocol::Pattern, "CH2 ; ---- ; NG", "");
    }
    void framesOfGauges() {
        QFETCH(int, protocol);
        QFETCH(QString, line);
        QFETCH(QString, value);
        QFETCH(QString, channel);
        Gauge gauge;
        gauge.protocol = static_cast<GaugeProtocol>(protocol);
        // Group 2 stands in front of the value here: it is looked ahead for.
        gauge.pattern = "(?=.*; +([-+0-9.]+) ; OK)CH([0-9]).*";
        const auto frame = parseGaugeFrame(gauge, line.toStdString());
        QCOMPARE(frame.has_value(), !value.isEmpty());
        if (frame) {
            QCOMPARE(frame->value, value.toDouble());
            QCOMPARE(QString::fromStdString(frame->channel), channel);
        }
    }
};

QTEST_APPLESS_MAIN(TestSensorFile)
#include "tst_sensor_file.moc"
