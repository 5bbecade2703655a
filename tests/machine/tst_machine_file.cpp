// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/machines/machine_file.h"
#include "engine/machine/described_machine.h"

using namespace kerf;
using Json = nlohmann::json;

namespace {

Json whole() {
    return Json::parse(R"({"machine": "linuxcnc", "name": "Mill 1", "units": "mm",
        "spindle": {"overhang_at_z0_mm": 55.5, "highest_speed_rpm": 6000},
        "axes": {"x": {"low_mm": -200, "high_mm": 400}, "z": {"low_mm": -100, "high_mm": 20}},
        "outputs": {"feed_scale_min": 0.1, "work_offset_max_um": 50},
        "force": {"bandwidth_hz": 300, "scale_n_per_unit": -200, "range_n": 1900, "drift_n_per_s": 0.02, "reset_ms": 150},
        "hosts": ["boring", "tapping"],
        "commands": {"host": "127.0.0.1", "port": 5008, "password_file": "/etc/kerf/words"}})");
}

std::string complaint(const Json& json) {
    try {
        (void)parseMachineFile(json.dump());
        return {};
    } catch (const MachineFileFault& fault) {
        return fault.what();
    }
}

StartProgram boring(double from_mm, double to_mm) {
    StartProgram start;
    start.process = ProcessId::Boring;
    start.from_mm = from_mm;
    start.to_mm = to_mm;
    start.spindleSpeed_rpm = 1500.0;
    return start;
}

/// Answers every request, and remembers what reached it.
class Counter final : public MachinePort {
 public:
    Result<void> connect() override { return {}; }
    void disconnect() noexcept override {}
    const Capabilities& capabilities() const noexcept override { return caps; }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override {
        inputs.time_ns = now_ns;
        inputs.reply = reply;
    }
    void write(const MachineOutputs& outputs) noexcept override {
        if (outputs.request.number != 0) {
            reply = {outputs.request.number, RequestState::Done, {}};
        }
    }
    Capabilities caps{};
    RequestReply reply{};
};

}  // namespace

/// The machine file, and what a machine that is described may do.
class TestMachineFile : public QObject {
    Q_OBJECT
 private slots:
    void everyKeyIsTaken() {
        const MachineFile file = parseMachineFile(whole().dump());
        const MachineDescription& machine = file.description;
        QCOMPARE(file.machine, std::string("linuxcnc"));
        QCOMPARE(machine.name, std::string("Mill 1"));
        QVERIFY(machine.units == DescribedUnits::Millimetre);
        QCOMPARE(*machine.overhangAtZ0_mm, 55.5);
        QCOMPARE(*machine.highestSpeed_rpm, 6000.0);
        QCOMPARE(machine.axes[0]->high_mm, 400.0);
        QVERIFY(!machine.axes[1]);
        QCOMPARE(machine.limits.feedScaleMin, 0.1);
        QCOMPARE(machine.limits.workOffsetMax_um, 50.0);
        QCOMPARE(machine.limits.feedScaleRise_perS, OutputLimits{}.feedScaleRise_perS);
        QVERIFY(machine.hosts[static_cast<std::size_t>(ProcessId::Tapping)]);
        QVERIFY(!machine.hosts[static_cast<std::size_t>(ProcessId::Milling)]);
        QCOMPARE(machine.commandPort, std::uint16_t{5008});
        QCOMPARE(machine.passwordFile, std::string("/etc/kerf/words"));
        QCOMPARE(*machine.force.bandwidth_Hz, 300.0);
        QCOMPARE(machine.force.scale_NPerUnit, -200.0);
        QCOMPARE(*machine.force.range_N, 1900.0);
        QVERIFY(machine.force.zeroInAir);
        QCOMPARE(*machine.force.drift_NPerS, 0.02);
        QCOMPARE(machine.force.reset_s, 0.15);
        QCOMPARE(machineFileJson(file)["force"]["reset_ms"].get<double>(), 150.0);
        QCOMPARE(machineFileJson(file)["commands"]["port"].get<int>(), 5008);
        QCOMPARE(machineFileJson(file)["hosts"].dump(), std::string(R"(["boring","tapping"])"));
    }
    void nothingSaidIsNothingAssumed() {
        const MachineDescription machine = parseMachineFile(R"({"machine": "simulator"})").description;
        QVERIFY(!machine.overhangAtZ0_mm && !machine.axes[2] && !machine.highestSpeed_rpm);
        QVERIFY(machine.units == DescribedUnits::Unsaid);
        QVERIFY(machine.hosts == MachineDescription{}.hosts);
    }
    void whatIsWrongIsSaidWithItsKey_data() {
        QTest::addColumn<QString>("pointer");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("begins");
        const auto row = [](const char* name, const char* pointer, const char* value, const char* begins) {
            QTest::newRow(name) << QString::fromUtf8(pointer) << QString::fromUtf8(value) << QString::fromUtf8(begins);
        };
        row("unknown", "/overhang", "40", "overhang: unknown key of a machine file");
        row("unknown inside", "/spindle/overhang_mm", "40", "spindle.overhang_mm: unknown key of the spindle");
        row("unknown axis", "/axes/w", "{}", "axes.w: unknown key of axes");
        row("no such machine", "/machine", "\"heidenhain\"", "machine: 'heidenhain' is not known");
        row("units", "/units", "\"cm\"", "units: 'cm' is not known; expected one of mm, inch.");
        row("overhang", "/spindle/overhang_at_z0_mm", "\"long\"",
            "spindle.overhang_at_z0_mm: \"long\" is out of range");
        row("overflow", "/spindle/overhang_at_z0_mm", "1e308", "spindle.overhang_at_z0_mm: 1e+308 is out of range");
        row("speed", "/spindle/highest_speed_rpm", "0", "spindle.highest_speed_rpm: 0 is out of range");
        row("travel", "/axes/z", "{\"low_mm\": 20, \"high_mm\": -100}", "axes.z.low_mm: 20 is not below high_mm");
        row("half a travel", "/axes/z", "{\"low_mm\": 20}", "axes.z.high_mm: missing");
        row("no step", "/outputs/feed_scale_min", "0", "outputs.feed_scale_min: 0 is out of range");
        row("faster", "/outputs/feed_scale_max", "3", "outputs.feed_scale_max: 3 is out of range");
        row("negative", "/outputs/work_offset_max_um", "-1", "outputs.work_offset_max_um: -1 is out of range");
        row("gains", "/outputs/servo_gain_min_per_s", "300", "outputs.servo_gain_min_per_s: 300 is above");
        row("force, unknown", "/force/band", "300", "force.band: unknown key of the force");
        row("force, no bandwidth", "/force/bandwidth_hz", "0", "force.bandwidth_hz: 0 is out of range");
        row("force, no scale", "/force/scale_n_per_unit", "0", "force.scale_n_per_unit: 0 makes every force 0");
        row("force, zero", "/force/zero_in_air", "1", "force.zero_in_air: 1 is neither; expected true or false");
        row("force, drift", "/force/drift_n_per_s", "-0.1", "force.drift_n_per_s: -0.1 is out of range");
        row("force, reset", "/force/reset_ms", "0", "force.reset_ms: 0 is out of range");
        row("host", "/hosts", "[\"boring\", \"drilling\"]", "hosts[1]: 'drilling' is no process");
        row("far", "/commands/host", "\"192.168.0.7\"", "commands.host: '192.168.0.7' is another computer");
        row("port", "/commands/port", "70000", "commands.port: 70000 is out of range");
        row("long name", "/name", "\"the large milling machine in hall 3\"", "name: 'the large milling machine");
    }
    void whatIsWrongIsSaidWithItsKey() {
        QFETCH(QString, pointer);
        QFETCH(QString, value);
        QFETCH(QString, begins);
        Json json = whole();
        json[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
        const std::string said = complaint(json);
        QVERIFY2(said.starts_with(begins.toStdString()), said.c_str());
        QCOMPARE(std::count(said.begin(), said.end(), '\n'), 0);
    }
    void whatIsNoMachineFileIsRefusedInOneSentence() {
        for (const std::string text :
             {"", "[", "{}", "[]", "{\"machine\": \"simulator\", \"machine\": \"linuxcnc\"}"}) {
            QVERIFY_EXCEPTION_THROWN((void)parseMachineFile(text), MachineFileFault);
        }
        QVERIFY_EXCEPTION_THROWN((void)parseMachineFile(std::string(100'000, '[')), MachineFileFault);
        QVERIFY_EXCEPTION_THROWN((void)readMachineFile("nowhere.json"), MachineFileFault);
        std::ofstream("other.json") << R"({"machine": "simulator"})";
        QVERIFY_EXCEPTION_THROWN((void)readMachineFile("other.json", "linuxcnc"), MachineFileFault);
        QCOMPARE(readMachineFile("other.json").machine, std::string("simulator"));
    }
    void theShippedFilesAreTaken() {
        for (const char* name : {"linuxcnc", "simulator"}) {
            const MachineFile file =
                readMachineFile(std::string(KERF_SOURCE_DIR "/resources/machines/") + name + ".json");
            QCOMPARE(file.machine, std::string(name));
        }
    }
    void programsBeyondTheMachineAreRefused() {
        const MachineDescription machine = parseMachineFile(whole().dump()).description;
        QVERIFY(!whyOutside(boring(40.0, 80.0), machine));
        QVERIFY(whyOutside(boring(40.0, 161.0), machine));   // longer than Z travels
        QVERIFY(whyOutside(boring(100.0, 160.0), machine));  // Z would have to stand at −104.5
        QVERIFY(whyOutside(boring(30.0, 60.0), machine));    // … or at 25.5
        StartProgram fast = boring(40.0, 80.0);
        fast.spindleSpeed_rpm = 6001.0;
        QVERIFY(whyOutside(fast, machine));
        StartProgram mill;
        mill.process = ProcessId::Milling;
        mill.from_mm = 0.0;
        mill.to_mm = 601.0;
        QVERIFY(whyOutside(mill, machine));
        mill.to_mm = 599.0;
        QVERIFY(!whyOutside(mill, machine));
        QVERIFY(!whyOutside(boring(0.0, 9999.0), MachineDescription{}));
    }
    void theDescriptionStandsBeforeTheMachine() {
        Counter machine;
        machine.caps.process[0].fitted = machine.caps.process[1].fitted = true;
        DescribedMachine described(machine, parseMachineFile(whole().dump()).description);
        QVERIFY(described.connect().has_value());
        const Capabilities& seen = described.capabilities();
        QCOMPARE(std::string(seen.machineName.data()), std::string("Mill 1"));
        QCOMPARE(seen.limits.workOffsetMax_um, 50.0);
        QVERIFY(seen.process[0].fitted);
        QVERIFY(!seen.process[1].fitted && !seen.process[1].why.empty());
        QVERIFY(!seen.process[4].fitted);  // named, but the machine itself has none: nothing is added
        MachineInputs inputs;
        MachineOutputs outputs;
        outputs.request = {7, boring(40.0, 900.0)};
        described.write(outputs);
        described.read(1, inputs);
        QCOMPARE(machine.reply.number, 0U);
        QCOMPARE(inputs.reply.number, 7U);
        QVERIFY(inputs.reply.state == RequestState::Refused && !inputs.reply.reason.empty());
        outputs.request = {8, boring(40.0, 80.0)};
        described.write(outputs);
        described.read(2, inputs);
        QCOMPARE(inputs.reply.number, 8U);
        QVERIFY(inputs.reply.state == RequestState::Done);
    }
};
QTEST_APPLESS_MAIN(TestMachineFile)
#include "tst_machine_file.moc"
