// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QLoggingCategory>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/files/output.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/sensor_reading.h"
#include "app/sensors/cause_text.h"
#include "app/sensors/day_recorder.h"
#include "app/sensors/modbus_scan.h"
#include "app/sensors/sensor_file.h"

namespace kerf::headless {
namespace {

using Json = nlohmann::ordered_json;

const char* transportName(sensors::Transport transport) {
    switch (transport) {
        case sensors::Transport::Rtu:
            return "rtu";
        case sensors::Transport::Hal:
            return "hal";
        case sensors::Transport::Tcp:
            break;
    }
    return "tcp";
}

void check(const std::string& path) {
    const sensors::SensorFile file = sensorFile(path);
    Json modules = Json::array();
    for (std::size_t m = 0; m < file.modules.size(); ++m) {
        const auto channels =
            std::ranges::count_if(file.channels, [m](const sensors::Channel& channel) { return channel.module == m; });
        modules.push_back({{"name", file.modules[m].name},
                           {"transport", transportName(file.modules[m].transport)},
                           {"channels", channels}});
    }
    printJson({{"modules", std::move(modules)},
               {"channels", file.channels.size()},
               {"temperatures", sensors::channelsOf(file, sensors::Quantity::Temperature).size()},
               {"gauges", file.gauges.size()},
               {"warnings", file.warnings}});
}

const char* qualityName(Quality quality) {
    switch (quality) {
        case Quality::Good:
            return "good";
        case Quality::Saturated:
            return "saturated";
        case Quality::Bad:
            return "bad";
        case Quality::Stale:
            return "stale";
        case Quality::Missing:
            break;
    }
    return "missing";
}

volatile std::sig_atomic_t g_stop = 0;
void onSignal(int /*signal*/) {
    g_stop = 1;
}

/// Tells on stderr when a channel changes between good and not.
class Teller {
 public:
    explicit Teller(const sensors::SensorFile& file)
        : m_file(file), m_told(file.channels.size(), sensors::Cause::None) {}
    void look(const sensors::SensorFrame& frame) {
        for (std::size_t i = 0; i < m_told.size() && i < frame.count; ++i) {
            const sensors::Cause cause = frame.channel[i].cause;
            if (cause == m_told[i] || cause == sensors::Cause::NotYetRead) {
                continue;
            }
            m_told[i] = cause;
            const std::string& name = m_file.channels[i].name;
            std::fprintf(stderr, "kerf: %s: %s\n", name.c_str(),
                         cause == sensors::Cause::None ? "reads again." : sensors::causeText(cause));
        }
    }

 private:
    const sensors::SensorFile& m_file;
    std::vector<sensors::Cause> m_told;
};

void printFrame(const sensors::SensorFile& file, const sensors::SensorFrame& frame, double time_s, bool alive) {
    for (std::size_t i = 0; i < file.channels.size(); ++i) {
        const sensors::ChannelValue value = i < frame.count ? frame.channel[i] : sensors::ChannelValue{};
        const Quality quality = alive || value.stamp_ns == 0 ? value.quality : Quality::Stale;
        Json line;
        line["t_s"] = std::round(time_s * 1000.0) / 1000.0;
        line["name"] = file.channels[i].name;
        line["value"] = quality == Quality::Good ? Json(value.value) : Json(nullptr);
        line["quality"] = qualityName(quality);
        const double age_s = static_cast<double>(steady_ns() - value.stamp_ns) * 1e-9;
        line["age_s"] = value.stamp_ns == 0 ? Json(nullptr) : Json(std::round(age_s * 1000.0) / 1000.0);
        std::printf("%s\n", line.dump().c_str());
    }
    std::fflush(stdout);
}

constexpr double kFirstRow_s = 1.0;  ///< every module has been asked by then

struct WatchArguments {
    std::string file{};
    double seconds{0.0};  ///< 0: until interrupted
    double period_s{1.0};
    std::string record{};  ///< day file; empty: none
};

void watch(const WatchArguments& arguments) {
    const sensors::SensorFile file = sensorFile(arguments.file);
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    const auto session = sensorSession(arguments.file);
    const std::int64_t start_ns = steady_ns();
    Teller teller(file);
    std::optional<sensors::DayRecorder> recorder;
    if (!arguments.record.empty()) {
        recorder.emplace(arguments.record, file);
        if (!recorder->good()) {
            throw BadInput(arguments.record + ": cannot be written; expected a path of a day file.");
        }
    }
    sensors::SensorFrame frame;
    const auto now_s = [start_ns] { return static_cast<double>(steady_ns() - start_ns) * 1e-9; };
    const bool endless = arguments.seconds == 0.0;
    for (double next_s = arguments.period_s; g_stop == 0; next_s += arguments.period_s) {
        const double until_s = endless ? next_s : std::min(next_s, arguments.seconds);
        bool alive = false;
        do {
            pause_ms(50);
            session->keep();
            alive = session->latest(frame);
            if (alive) {
                teller.look(frame);
            }
            if (recorder && now_s() > kFirstRow_s) {
                recorder->look(now_s() - kFirstRow_s, alive ? &frame : nullptr);
            }
        } while (now_s() < until_s && g_stop == 0);
        printFrame(file, frame, now_s(), alive);
        if (!endless && next_s >= arguments.seconds) {
            break;
        }
    }
}

/// "192.168.0.5", "host:1502", "[::1]:502"
void takeAddress(const std::string& text, sensors::ScanOptions& options) {
    const auto colon = text.rfind(':');
    const bool bracket = text.starts_with('[');
    const bool hasPort = colon != std::string::npos && (bracket ? text[colon - 1] == ']' : text.find(':') == colon);
    options.host = hasPort ? text.substr(0, colon) : text;
    if (bracket && options.host.ends_with(']')) {
        options.host = options.host.substr(1, options.host.size() - 2);
    }
    const std::string port = hasPort ? text.substr(colon + 1) : "502";
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), options.port);
    if (error != std::errc{} || end != port.data() + port.size() || options.port < 1 || options.port > 65535 ||
        options.host.empty()) {
        throw BadInput("--modbus " + text + ": " + sensors::kNoAddress);
    }
}

void takeUnits(const std::string& text, sensors::ScanOptions& options) {
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, options.firstUnit);
    auto last = first;
    options.lastUnit = options.firstUnit;
    if (first.ec == std::errc{} && first.ptr != end && *first.ptr == '-') {
        last = std::from_chars(first.ptr + 1, end, options.lastUnit);
    }
    if (last.ec != std::errc{} || last.ptr != end || options.firstUnit < 0 || options.lastUnit > 255 ||
        options.lastUnit < options.firstUnit) {
        throw BadInput("--units: '" + text + "' is no range; expected FROM-TO, 0 <= FROM <= TO <= 255.");
    }
}

void scan(const std::string& address, const std::string& units, int timeout_ms) {
    sensors::ScanOptions options;
    takeAddress(address, options);
    takeUnits(units, options);
    options.timeout_ms = timeout_ms;
    QLoggingCategory::setFilterRules(QStringLiteral("qt.modbus*=false"));
    int argc = 1;
    char name[] = "kerf";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    const auto found = sensors::scanModbus(options);
    if (!found) {
        throw BadInput(address + ": " + found.error().english());
    }
    Json list = Json::array();
    for (const sensors::ScannedUnit& unit : *found) {
        Json blocks = Json::array();
        for (const sensors::ScannedBlock& block : unit.blocks) {
            blocks.push_back(
                {{"function", block.function}, {"address", block.address}, {"registers", block.registers}});
        }
        list.push_back({{"unit", unit.unit},
                        {"identity", unit.identity.empty() ? Json(nullptr) : Json(unit.identity)},
                        {"answers", std::move(blocks)}});
    }
    printJson({{"host", options.host}, {"port", options.port}, {"units", std::move(list)}});
}

void addCheck(CLI::App& group) {
    auto* command = group.add_subcommand("check", "Check a sensor file; what is in it as JSON.");
    auto path = std::make_shared<std::string>();
    command->add_option("file", *path, "Sensor file")->required();
    command->callback([path] { check(*path); });
}

void addWatch(CLI::App& group) {
    auto* command = group.add_subcommand(
        "watch", "Read the sensors: one line of JSON per channel and second. A value that is not good is null.");
    auto arguments = std::make_shared<WatchArguments>();
    command->add_option("file", arguments->file, "Sensor file")->required();
    command->add_option("--seconds", arguments->seconds, "How long (default: until interrupted)")
        ->check(CLI::Range(0.1, 864'000.0));
    command->add_option("--period", arguments->period_s, "Seconds from line to line")
        ->check(CLI::Range(0.1, 3600.0))
        ->capture_default_str();
    command->add_option("--record", arguments->record,
                        "Day file (CSV) to write too: a row a minute, for train and replay");
    command->callback([arguments] { watch(*arguments); });
}

void addScan(CLI::App& group) {
    auto* command = group.add_subcommand(
        "scan", "What answers at an address: units, their first registers and their identity as JSON. Reads only.");
    auto address = std::make_shared<std::string>();
    auto units = std::make_shared<std::string>("1-32");
    auto timeout_ms = std::make_shared<int>(300);
    command->add_option("--modbus", *address, "HOST[:PORT] of a Modbus TCP module or gateway")->required();
    command->add_option("--units", *units, "Units to ask, FROM-TO")->capture_default_str();
    command->add_option("--timeout-ms", *timeout_ms, "How long to wait for an answer, ms")
        ->check(CLI::Range(10, 60'000))
        ->capture_default_str();
    command->callback([=] { scan(*address, *units, *timeout_ms); });
}

}  // namespace

void addSensorCommands(CLI::App& kerf) {
    auto* group = kerf.add_subcommand("sensors", "Temperatures and gauges of a real machine: check, watch, scan.");
    group->require_subcommand(1);
    addCheck(*group);
    addWatch(*group);
    addScan(*group);
}

}  // namespace kerf::headless
