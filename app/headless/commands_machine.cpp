// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/machines/machine_file.h"
#include "app/machines/machine_module_loader.h"
#include "engine/cycle/engine.h"
#include "engine/machine/linuxcnc/port_exposure.h"
#include "engine/machine/linuxcnc/shared_link.h"
#include "engine/port/state_keys.h"

namespace kerf::headless {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct MachineOptions {
    std::string machine{"linuxcnc"};
    std::string file{};  ///< machine file; empty: nothing is described
    double seconds{10.0};
    double period_s{0.5};
};

constexpr auto kLook = std::chrono::milliseconds(1);
constexpr double kAppear_s = 1.0;  ///< how long a link may take to come up
constexpr const char* kNotReached =
    "the machine is not reached: it does not run, or its HAL file does not load kerf-hal.";

std::int64_t now_ns() {
    return Clock::now().time_since_epoch().count();
}

MachineDescription describedBy(const MachineOptions& options) {
    if (options.file.empty()) {
        return {};
    }
    try {
        return readMachineFile(options.file, options.machine).description;
    } catch (const MachineFileFault& fault) {
        throw BadInput(fault.what());
    }
}

/// Whoever reaches the port may move the machine; said by every command that looks.
std::string warnOfOpenPort(std::uint16_t port) {
    const std::string address = linuxcnc::openAddress(port);
    if (!address.empty()) {
        std::fprintf(stderr,
                     "kerf: linuxcncrsh answers on %s, port %u: whoever reaches this computer may move the machine. "
                     "Close the port in the firewall (docs/linuxcnc.md).\n",
                     address.c_str(), unsigned{port});
    }
    return address;
}

std::unique_ptr<MachinePort> open(const MachineOptions& options, bool onlyRead) {
    auto machine = loadMachine(options.machine, describedBy(options));
    if (!machine) {
        throw BadInput(machine.error().english());
    }
    if (onlyRead) {
        (*machine)->onlyRead();
    }
    if (const auto connected = (*machine)->connect(); !connected) {
        throw BadInput(connected.error().english());
    }
    return std::move(*machine);
}

/// Reads only: a console that runs beside keeps the machine.
void readFor(MachinePort& machine, double seconds, MachineInputs& inputs) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    do {
        machine.read(now_ns(), inputs);
        std::this_thread::sleep_for(kLook);
    } while (Clock::now() < end);
}

Json readingJson(const Reading& reading) {
    return reading.good() ? Json(reading.value) : Json(nullptr);
}

Json signalsJson(const MachineInputs& in) {
    Json json;
    json["link"] = in.link == LinkState::Up ? "up" : "down";
    json["machine_on"] = in.machineOn;
    json["emergency_stop"] = in.emergencyStop;
    json["feed_hold"] = in.feedHold;
    json["operator_override"] = in.operatorOverride;
    json["program"] = stateKey(in.program);
    json["actual_feed_mm_per_s"] = readingJson(in.actualFeed_mmPerS);
    json["applied_feed_scale"] = readingJson(in.appliedFeedScale);
    json["spindle_speed_rpm"] = readingJson(in.spindleSpeed_rpm);
    json["spindle_angle_rev"] = readingJson(in.spindleAngle_rev);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        json["position_mm"].push_back(readingJson(in.position_mm[axis]));
        json["work_offset_um"].push_back(readingJson(in.workOffset_um[axis]));
    }
    return json;
}

Json capabilityJson(const Capability& capability) {
    Json json;
    json["fitted"] = capability.fitted;
    if (!capability.fitted) {
        json["why"] = capability.why.english();
    }
    return json;
}

Json capabilitiesJson(const Capabilities& c) {
    Json json;
    json["machine"] = c.machineName.data();
    json["max_feed_scale"] = c.maxFeedScale;
    json["feed_scale"] = capabilityJson(c.feedScale);
    json["work_offset"] = capabilityJson(c.workOffset);
    json["force_sensor"] = capabilityJson(c.forceSensor);
    if (c.forceSensor.fitted) {
        json["force_sensor"]["rate_hz"] = c.force.rate_Hz;
        json["force_sensor"]["bandwidth_hz"] = c.force.bandwidth_Hz;
        json["force_sensor"]["zero_in_air"] = c.force.zeroInAir;
        json["force_sensor"]["drift_n_per_s"] = c.force.drift_NPerS;
    }
    json["force_reset"] = capabilityJson(c.forceReset);
    json["servo_gains"] = capabilityJson(c.servoGains);
    json["z_trim"] = capabilityJson(c.zTrim);
    json["temperatures"] = capabilityJson(c.temperatures);
    json["cycle_start"] = capabilityJson(c.cycleStart);
    for (const ProcessId id : allProcesses()) {
        json["loops"][processKey(id)] = capabilityJson(c.process[static_cast<std::size_t>(id)]);
    }
    return json;
}

void status(const MachineOptions& options) {
    const auto machine = open(options, true);
    MachineInputs inputs;
    readFor(*machine, kAppear_s, inputs);
    (void)warnOfOpenPort(describedBy(options).commandPort);
    Json json;
    json["capabilities"] = capabilitiesJson(machine->capabilities());
    json["signals"] = signalsJson(inputs);
    printJson(json);
    if (inputs.link != LinkState::Up) {
        throw BadInput(kNotReached);
    }
}

/// The machine file as it is understood, and what stands open; the machine need not run.
void check(const MachineOptions& options) {
    MachineFile file;
    file.machine = options.machine;
    if (!options.file.empty()) {
        try {
            file = readMachineFile(options.file);
        } catch (const MachineFileFault& fault) {
            throw BadInput(fault.what());
        }
    }
    Json json;
    json["description"] = machineFileJson(file);
    json["open_address"] = nullptr;
    if (file.machine == "linuxcnc") {
        if (const std::string address = warnOfOpenPort(file.description.commandPort); !address.empty()) {
            json["open_address"] = address;
        }
    }
    printJson(json);
}

void watch(const MachineOptions& options) {
    const auto machine = open(options, true);
    MachineInputs inputs;
    const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
    while (Clock::now() < end) {
        readFor(*machine, options.period_s, inputs);
        std::printf("%s\n", signalsJson(inputs).dump().c_str());
        std::fflush(stdout);
    }
}

struct Spread {
    std::size_t count{0};
    std::size_t missed{0};
    double p50_us{0.0};
    double p999_us{0.0};
    double max_us{0.0};
};

/// Lateness against the period's deadline; more than a period is a missed cycle.
Spread spreadOf(std::vector<double> late_us) {
    Spread spread;
    if (late_us.empty()) {
        return spread;
    }
    std::ranges::sort(late_us);
    const auto at = [&](double share) {
        return late_us[std::min(late_us.size() - 1,
                                static_cast<std::size_t>(share * static_cast<double>(late_us.size())))];
    };
    spread.count = late_us.size();
    spread.missed = static_cast<std::size_t>(std::ranges::count_if(late_us, [](double late) { return late > 1000.0; }));
    spread.p50_us = at(0.5);
    spread.p999_us = at(0.999);
    spread.max_us = late_us.back();
    return spread;
}

void takeOver(const MachineOptions& options) {
    const auto machine = open(options, true);
    if (const auto ended = machine->endOtherClaim(); !ended) {
        throw BadInput(ended.error().english());
    }
    Json json;
    json["taken_over"] = true;
    printJson(json);
}

void jitter(const MachineOptions& options) {
    const auto machine = open(options, false);
    if (!machine->capabilities().cycleStart.fitted) {
        throw BadInput(machine->capabilities().cycleStart.why.english());
    }
    linuxcnc::SharedLink link;
    linuxcnc::LinkMemory* memory = link.take();
    MachineInputs inputs;
    readFor(*machine, kAppear_s, inputs);
    if (memory == nullptr || inputs.link != LinkState::Up) {  // a bridge that was killed leaves its memory behind
        throw BadInput(kNotReached);
    }
    std::uint64_t nextPeriod = memory->servo.written();
    Engine engine(*machine, {});
    engine.start();
    std::vector<double> servo_us;
    const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
    linuxcnc::ServoPeriod period;
    std::uint32_t first = 0;
    while (Clock::now() < end) {
        while (memory->servo.read(nextPeriod, period)) {
            if (servo_us.empty()) {
                first = period.number;
            }
            servo_us.push_back(std::abs(static_cast<double>(period.late_ns)) / 1000.0);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const Status status = engine.status();
    engine.stop();
    const Spread servo = spreadOf(servo_us);
    CsvOutput csv("thread,cycles,missed,p50_us,p999_us,max_us,unread");
    csv.row("kerf engine (start after the deadline)", status.stats.cycles, status.stats.overruns,
            static_cast<double>(status.stats.lateness.percentile_ns(0.5)) / 1000.0,
            static_cast<double>(status.stats.lateness.percentile_ns(0.999)) / 1000.0,
            static_cast<double>(status.stats.lateness.max_ns()) / 1000.0, 0);
    csv.row("LinuxCNC servo thread (period against 1 ms)", servo.count, servo.missed, servo.p50_us, servo.p999_us,
            servo.max_us, period.number - first + 1 - servo.count);
    csv.row("kerf engine (work in one cycle)", status.stats.cycles, 0,
            static_cast<double>(status.stats.cost.percentile_ns(0.5)) / 1000.0,
            static_cast<double>(status.stats.cost.percentile_ns(0.999)) / 1000.0,
            static_cast<double>(status.stats.cost.max_ns()) / 1000.0, 0);
    csv.flush();
}

}  // namespace

void addMachineCommands(CLI::App& kerf) {
    auto* machine =
        kerf.add_subcommand("machine", "A real machine: what it can do, what it reports, how evenly it runs");
    machine->require_subcommand(1);
    auto options = std::make_shared<MachineOptions>();
    const auto add = [&](const char* name, const char* what, void (*run)(const MachineOptions&)) {
        auto* command = machine->add_subcommand(name, what);
        command->add_option("--machine", options->machine, "Which machine")
            ->check(CLI::IsMember(machineModules()))
            ->capture_default_str();
        command->add_option("--machine-file", options->file,
                            "Machine file (JSON, docs/linuxcnc.md): units, geometry, travel, limits, hosts");
        command->callback([options, run] { run(*options); });
        return command;
    };
    add("status", "Capabilities, with the reason for what is missing, and signals as JSON. Reads only.", status);
    add("check",
        "The machine file as it is understood, defaults included, and whether the control's command port answers on an "
        "address that others reach, as JSON. The machine need not run.",
        check);
    auto* watching = add("watch", "The signals as one line of JSON per period. Reads only.", watch);
    watching->add_option("--seconds", options->seconds, "How long")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    watching->add_option("--period", options->period_s, "Seconds from line to line")
        ->check(CLI::Range(0.01, 60.0))
        ->capture_default_str();
    add("take-over",
        "Ends the claim of the program that commands the machine: the next one that is started commands it. For a "
        "person "
        "who has looked; a program that has died is taken over from by starting another.",
        takeOver);
    auto* timing =
        add("jitter",
            "Runs an empty engine on the machine and compares the punctuality of its cycle with the control's "
            "servo thread, as CSV. The machine is commanded by nobody else meanwhile.",
            jitter);
    timing->add_option("--seconds", options->seconds, "How long")
        ->check(CLI::Range(1.0, 3600.0))
        ->capture_default_str();
}

}  // namespace kerf::headless
