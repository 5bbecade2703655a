// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machines/machine_file.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/machines/machine_module_loader.h"
#include "app/sensors/json_keys.h"
#include "app/sensors/sensor_file.h"

namespace kerf {
namespace {

using sensors::Json;
using sensors::JsonKeys;

constexpr const char* kAxes[] = {"x", "y", "z"};
constexpr double kFarthest_mm = 100'000.0;
constexpr double kLargestForce_N = 1e6;
constexpr std::size_t kLargest_B = 1 << 20;

/// One limit of the outputs: key, place, lowest, highest.
struct LimitField {
    const char* key;
    double OutputLimits::*place;
    double low;
    double high;
};
constexpr LimitField kLimits[] = {
    {"feed_scale_min", &OutputLimits::feedScaleMin, 0.01, 1.0},
    {"feed_scale_max", &OutputLimits::feedScaleMax, 1.0, 2.0},
    {"feed_scale_rise_per_s", &OutputLimits::feedScaleRise_perS, 0.01, 100.0},
    {"feed_scale_fall_per_s", &OutputLimits::feedScaleFall_perS, 0.01, 1000.0},
    {"work_offset_max_um", &OutputLimits::workOffsetMax_um, 0.0, 2000.0},
    {"work_offset_rate_um_per_s", &OutputLimits::workOffsetRate_umPerS, 0.001, 1000.0},
    {"tool_trim_max_um", &OutputLimits::toolTrimMax_um, 0.0, 100.0},
    {"tool_trim_rate_um_per_s", &OutputLimits::toolTrimRate_umPerS, 0.1, 1e6},
    {"z_trim_max_um", &OutputLimits::zTrimMax_um, 0.0, 5000.0},
    {"z_trim_rate_um_per_s", &OutputLimits::zTrimRate_umPerS, 1.0, 1e7},
    {"z_trim_return_um_per_s", &OutputLimits::zTrimReturn_umPerS, 1.0, 1e6},
    {"servo_gain_min_per_s", &OutputLimits::servoGainMin_perS, 0.1, 1000.0},
    {"servo_gain_max_per_s", &OutputLimits::servoGainMax_perS, 0.1, 1000.0},
};

OutputLimits outputsFrom(const Json& json) {
    const JsonKeys keys(json, "outputs");
    keys.only(
        {"feed_scale_min", "feed_scale_max", "feed_scale_rise_per_s", "feed_scale_fall_per_s", "work_offset_max_um",
         "work_offset_rate_um_per_s", "tool_trim_max_um", "tool_trim_rate_um_per_s", "z_trim_max_um",
         "z_trim_rate_um_per_s", "z_trim_return_um_per_s", "servo_gain_min_per_s", "servo_gain_max_per_s"},
        "of outputs");
    OutputLimits limits;
    for (const LimitField& field : kLimits) {
        limits.*field.place = keys.number(field.key, field.low, field.high, limits.*field.place);
    }
    if (limits.servoGainMin_perS > limits.servoGainMax_perS) {
        throw MachineFileFault(
            fmt::format("outputs.servo_gain_min_per_s: {:g} is above servo_gain_max_per_s, {:g}; "
                        "expected at most as much.",
                        limits.servoGainMin_perS, limits.servoGainMax_perS));
    }
    return limits;
}

AxisTravel travelFrom(const Json& json, const std::string& where) {
    const JsonKeys keys(json, where);
    keys.only({"low_mm", "high_mm"}, "of an axis");
    (void)keys.value("low_mm");  // both or none
    (void)keys.value("high_mm");
    const AxisTravel travel{keys.number("low_mm", -kFarthest_mm, kFarthest_mm, 0.0),
                            keys.number("high_mm", -kFarthest_mm, kFarthest_mm, 0.0)};
    if (!(travel.low_mm < travel.high_mm)) {
        throw MachineFileFault(fmt::format("{}.low_mm: {:g} is not below high_mm, {:g}; expected a travel.", where,
                                           travel.low_mm, travel.high_mm));
    }
    return travel;
}

std::array<bool, kProcessPlaces> hostsFrom(const JsonKeys& keys) {
    std::array<bool, kProcessPlaces> hosts{};
    for (std::size_t i = 0; const Json& one : keys.list("hosts")) {
        const std::string word = one.is_string() ? one.get<std::string>() : one.dump();
        if (const ProcessDescriptor* process = findProcess(std::string_view(word))) {
            hosts[static_cast<std::size_t>(process->id)] = true;
        } else {
            std::vector<std::string_view> names;
            for (const ProcessDescriptor* known : processes()) {
                names.emplace_back(known->key);
            }
            throw MachineFileFault(fmt::format("hosts[{}]: '{}' is no process; expected one of {}.", i,
                                               sensors::brief(word), fmt::join(names, ", ")));
        }
        ++i;
    }
    return hosts;
}

void commandsFrom(const Json& json, MachineDescription& machine) {
    const JsonKeys keys(json, "commands");
    keys.only({"host", "port", "password_file"}, "of commands");
    machine.commandHost = keys.text("host", machine.commandHost);
    if (machine.commandHost != "127.0.0.1") {
        throw MachineFileFault(
            fmt::format("commands.host: '{}' is another computer; expected 127.0.0.1, because the "
                        "commands travel in the clear.",
                        sensors::brief(machine.commandHost)));
    }
    machine.commandPort = static_cast<std::uint16_t>(keys.integer("port", 1, 65535, machine.commandPort));
    machine.passwordFile = keys.text("password_file", "");
}

void spindleFrom(const Json& json, MachineDescription& machine) {
    const JsonKeys keys(json, "spindle");
    keys.only({"overhang_at_z0_mm", "highest_speed_rpm"}, "of the spindle");
    if (keys.has("overhang_at_z0_mm")) {
        machine.overhangAtZ0_mm = keys.number("overhang_at_z0_mm", -kFarthest_mm, kFarthest_mm, 0.0);
    }
    if (keys.has("highest_speed_rpm")) {
        machine.highestSpeed_rpm = keys.number("highest_speed_rpm", 1.0, 500'000.0, 0.0);
    }
}

DescribedForce forceFrom(const Json& json) {
    const JsonKeys keys(json, "force");
    keys.only({"bandwidth_hz", "scale_n_per_unit", "range_n", "zero_in_air", "drift_n_per_s", "reset_ms"},
              "of the force");
    DescribedForce force;
    if (keys.has("bandwidth_hz")) {
        force.bandwidth_Hz = keys.number("bandwidth_hz", 0.1, 100'000.0, 0.0);
    }
    force.scale_NPerUnit = keys.number("scale_n_per_unit", -kLargestForce_N, kLargestForce_N, force.scale_NPerUnit);
    if (force.scale_NPerUnit == 0.0) {
        throw MachineFileFault("force.scale_n_per_unit: 0 makes every force 0; expected another number.");
    }
    if (keys.has("range_n")) {
        force.range_N = keys.number("range_n", 0.001, kLargestForce_N, 0.0);
    }
    force.zeroInAir = keys.flag("zero_in_air", force.zeroInAir);
    if (keys.has("drift_n_per_s")) {
        force.drift_NPerS = keys.number("drift_n_per_s", 0.0, 1000.0, 0.0);
    }
    force.reset_s = keys.number("reset_ms", 1.0, 5000.0, force.reset_s * 1000.0) / 1000.0;
    return force;
}

Json forceJson(const DescribedForce& force) {
    const auto orNull = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
    return {{"bandwidth_hz", orNull(force.bandwidth_Hz)}, {"scale_n_per_unit", force.scale_NPerUnit},
            {"range_n", orNull(force.range_N)},           {"zero_in_air", force.zeroInAir},
            {"drift_n_per_s", orNull(force.drift_NPerS)}, {"reset_ms", std::round(force.reset_s * 1e6) / 1e3}};
}

MachineFile machineFrom(const Json& json) {
    const JsonKeys keys(json, "");
    keys.only({"machine", "name", "units", "spindle", "axes", "outputs", "force", "hosts", "commands"},
              "of a machine file");
    MachineFile file;
    std::vector<std::string> machines = machineModules();
    machines.insert(machines.end(), {"simulator", "diamond-lathe"});
    file.machine = keys.oneOf("machine", machines);
    MachineDescription& machine = file.description;
    if (keys.has("name")) {
        machine.name = keys.name("name");
    }
    machine.units = keys.choice<DescribedUnits>(
        "units", {{"mm", DescribedUnits::Millimetre}, {"inch", DescribedUnits::Inch}}, DescribedUnits::Unsaid);
    if (keys.has("spindle")) {
        spindleFrom(keys.value("spindle"), machine);
    }
    if (keys.has("axes")) {
        const JsonKeys axes(keys.value("axes"), "axes");
        axes.only({"x", "y", "z"}, "of axes");
        for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
            if (axes.has(kAxes[axis])) {
                machine.axes[axis] = travelFrom(axes.value(kAxes[axis]), axes.path(kAxes[axis]));
            }
        }
    }
    if (keys.has("outputs")) {
        machine.limits = outputsFrom(keys.value("outputs"));
    }
    if (keys.has("force")) {
        machine.force = forceFrom(keys.value("force"));
    }
    if (keys.has("hosts")) {
        machine.hosts = hostsFrom(keys);
    }
    if (keys.has("commands")) {
        commandsFrom(keys.value("commands"), machine);
    }
    return file;
}

}  // namespace

MachineFile parseMachineFile(const std::string& text) {
    try {
        return machineFrom(sensors::parseStrictly(text));
    } catch (const sensors::SensorFileFault& fault) {
        throw MachineFileFault(fault.what());
    }
}

MachineFile readMachineFile(const std::string& path, const std::string& machine) {
    std::ifstream in(path, std::ios::binary | std::ios::ate);
    const auto size = in.is_open() ? in.tellg() : std::ifstream::pos_type(-1);
    if (size <= 0 || static_cast<std::size_t>(size) > kLargest_B) {
        throw MachineFileFault(
            fmt::format("{}: cannot be read, is empty or larger than 1 MiB; expected a machine file.", path));
    }
    in.seekg(0);
    std::ostringstream all;
    all << in.rdbuf();
    try {
        MachineFile file = parseMachineFile(all.str());
        if (!machine.empty() && machine != file.machine) {
            throw MachineFileFault(fmt::format("machine: the file is for {}, --machine says {}; expected the same.",
                                               file.machine, machine));
        }
        return file;
    } catch (const MachineFileFault& fault) {
        throw MachineFileFault(fmt::format("{}: {}", path, fault.what()));
    }
}

nlohmann::ordered_json machineFileJson(const MachineFile& file) {
    const MachineDescription& machine = file.description;
    nlohmann::ordered_json json;
    json["machine"] = file.machine;
    json["name"] = machine.name;
    json["units"] = machine.units == DescribedUnits::Inch         ? nlohmann::ordered_json("inch")
                    : machine.units == DescribedUnits::Millimetre ? nlohmann::ordered_json("mm")
                                                                  : nlohmann::ordered_json(nullptr);
    const auto orNull = [](const std::optional<double>& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
    };
    json["spindle"]["overhang_at_z0_mm"] = orNull(machine.overhangAtZ0_mm);
    json["spindle"]["highest_speed_rpm"] = orNull(machine.highestSpeed_rpm);
    for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
        nlohmann::ordered_json travel;
        if (machine.axes[axis]) {
            travel["low_mm"] = machine.axes[axis]->low_mm;
            travel["high_mm"] = machine.axes[axis]->high_mm;
        }
        json["axes"][kAxes[axis]] = travel;
    }
    for (const LimitField& field : kLimits) {
        json["outputs"][field.key] = machine.limits.*field.place;
    }
    json["force"] = forceJson(machine.force);
    json["hosts"] = nlohmann::ordered_json::array();
    for (const ProcessId id : allProcesses()) {
        if (machine.hosts[static_cast<std::size_t>(id)]) {
            json["hosts"].push_back(processKey(id));
        }
    }
    json["commands"]["host"] = machine.commandHost;
    json["commands"]["port"] = machine.commandPort;
    json["commands"]["password_file"] = machine.passwordFile;
    return json;
}

}  // namespace kerf
