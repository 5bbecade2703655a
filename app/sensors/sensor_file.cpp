// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/sensor_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <tuple>

#include "app/sensors/gauge_frames.h"
#include "app/sensors/json_keys.h"
#include "engine/core/sentence.h"

namespace kerf::sensors {
namespace {

constexpr int kHighestAddress = 65535;
constexpr double kLargest = 1e9;
constexpr std::size_t kLargestFile = 4'000'000;  // bytes; a pipe or device never ends

Parity parityFrom(const JsonKeys& keys) {
    return keys.choice<Parity>("parity", {{"none", Parity::None}, {"even", Parity::Even}, {"odd", Parity::Odd}},
                               Parity::None);
}

Module moduleFrom(const Json& json, const std::string& where) {
    const JsonKeys keys(json, where);
    Module module;
    module.transport = keys.choice<Transport>(
        "transport", {{"tcp", Transport::Tcp}, {"rtu", Transport::Rtu}, {"hal", Transport::Hal}});
    module.name = keys.name("name");
    const bool rtu = module.transport == Transport::Rtu;
    switch (module.transport) {
        case Transport::Tcp:
            keys.only({"name", "transport", "host", "port", "unit", "period_ms", "timeout_ms"}, "of transport tcp");
            module.host = keys.text("host");
            module.port = keys.integer("port", 1, 65535, 502);
            break;
        case Transport::Rtu:
            keys.only({"name", "transport", "device", "baud", "parity", "stop_bits", "unit", "period_ms", "timeout_ms"},
                      "of transport rtu");
            module.device = keys.text("device");
            module.baud = keys.integer("baud", 300, 4'000'000, module.baud);
            module.parity = parityFrom(keys);
            module.stopBits = keys.integer("stop_bits", 1, 2, 1);
            break;
        case Transport::Hal:
            keys.only({"name", "transport"}, "of transport hal");
            return module;
    }
    module.unit = keys.integer("unit", rtu ? 1 : 0, rtu ? 247 : 255, 1);
    module.period_ms = keys.integer("period_ms", 20, 3'600'000, module.period_ms);
    module.timeout_ms = keys.integer("timeout_ms", 10, 60'000, module.timeout_ms);
    return module;
}

std::pair<double, double> rangeOf(RegisterType type) {
    switch (type) {
        case RegisterType::Int16:
            return {-32768.0, 32767.0};
        case RegisterType::Uint16:
            return {0.0, 65535.0};
        case RegisterType::Int32:
            return {-2147483648.0, 2147483647.0};
        case RegisterType::Uint32:
            return {0.0, 4294967295.0};
        case RegisterType::Float32:
            break;
    }
    return {-3.4e38, 3.4e38};
}

StatusRegister statusFrom(const Json& json, const std::string& where, int function) {
    const JsonKeys keys(json, where);
    keys.only({"address", "bad", "function"}, "of a status register");
    StatusRegister status;
    status.function = keys.integer("function", 1, 4, function);
    status.address = keys.integer("address", 0, kHighestAddress);
    // What the register can never hold would leave its fault unseen.
    const bool bit = status.function <= 2;
    for (const double value : keys.numbers("bad", bit ? 0.0 : -32768.0, bit ? 1.0 : 65535.0, true)) {
        status.bad.push_back(static_cast<std::int64_t>(value));
    }
    if (status.bad.empty()) {
        throw SensorFileFault(where + ".bad", KERF_TEXT("no value in it; expected at least one that means a fault."));
    }
    return status;
}

/// "kerf.temperature-63" → 63
int pinFrom(const JsonKeys& keys, Quantity quantity) {
    static const std::string kTemperature = "kerf.temperature-";
    const std::string pin = keys.text("pin");
    if (quantity == Quantity::Temperature && pin.starts_with(kTemperature)) {
        const std::string digits = pin.substr(kTemperature.size());
        const bool number = !digits.empty() && digits.size() <= 2 &&
                            std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
        const int index = number ? std::stoi(digits) : kMostHalTemperatures;
        if (index < kMostHalTemperatures && std::to_string(index) == digits) {
            return index;
        }
    }
    throw SensorFileFault(keys.path("pin"),
                          KERF_TEXT("'%1' is no pin of kerf-hal for this quantity; expected kerf.temperature-0 to "
                                    "kerf.temperature-%2 for a temperature."),
                          {brief(pin), std::to_string(kMostHalTemperatures - 1)});
}

void requireUnit(const JsonKeys& keys, Quantity quantity) {
    static const std::map<Quantity, std::pair<const char*, const char*>> kUnits{
        {Quantity::Temperature, {"temperature", "degC"}},
        {Quantity::Speed, {"speed", "rpm"}},
        {Quantity::Force, {"force", "N"}}};
    const auto& [name, unit] = kUnits.at(quantity);
    if (keys.has("unit") && keys.text("unit") != unit) {
        throw SensorFileFault(keys.path("unit"),
                              KERF_TEXT("'%1' is not the unit of a %2; expected %3, which scale and offset bring the "
                                        "register to."),
                              {brief(keys.text("unit")), name, unit});
    }
}

Channel channelFrom(const Json& json, const std::string& where, const std::vector<Module>& modules) {
    const JsonKeys keys(json, where);
    Channel channel;
    channel.name = keys.name("name");
    const std::string module = keys.text("module");
    const auto found = std::ranges::find(modules, module, &Module::name);
    if (found == modules.end()) {
        throw SensorFileFault(keys.path("module"),
                              KERF_TEXT("there is no module '%1'; expected the name of one in modules."),
                              {brief(module)});
    }
    channel.module = static_cast<std::size_t>(found - modules.begin());
    channel.quantity = keys.choice<Quantity>(
        "quantity", {{"temperature", Quantity::Temperature}, {"speed", Quantity::Speed}, {"force", Quantity::Force}},
        Quantity::Temperature);
    if (channel.quantity == Quantity::Force) {
        throw SensorFileFault(keys.path("quantity"),
                              KERF_TEXT("a force is too fast for a polled module; it comes over the HAL pin kerf.force "
                                        "(docs/sensors.md). Expected temperature or speed."));
    }
    requireUnit(keys, channel.quantity);
    channel.place = keys.text("place", "");
    if (found->transport == Transport::Hal) {
        keys.only({"name", "quantity", "unit", "module", "pin", "place", "scale", "offset"},
                  "of a channel of transport hal");
        channel.pin = pinFrom(keys, channel.quantity);
    } else {
        keys.only({"name", "quantity", "unit", "module", "function", "address", "type", "words", "scale", "offset",
                   "invalid", "status", "place"},
                  "of a Modbus channel");
        channel.function = keys.integer("function", 3, 4, 4);
        channel.type = keys.choice<RegisterType>("type",
                                                 {{"int16", RegisterType::Int16},
                                                  {"uint16", RegisterType::Uint16},
                                                  {"int32", RegisterType::Int32},
                                                  {"uint32", RegisterType::Uint32},
                                                  {"float32", RegisterType::Float32}},
                                                 RegisterType::Int16);
        channel.address = keys.integer("address", 0, kHighestAddress + 1 - registersOf(channel.type));
        channel.words =
            keys.choice<WordOrder>("words", {{"big", WordOrder::Big}, {"little", WordOrder::Little}}, WordOrder::Big);
        const auto [low, high] = rangeOf(channel.type);
        if (keys.has("invalid")) {
            channel.invalid = keys.numbers("invalid", low, high, channel.type != RegisterType::Float32);
        }
        if (keys.has("status")) {
            channel.status = statusFrom(keys.value("status"), keys.path("status"), channel.function);
        }
    }
    channel.scale = keys.number("scale", -kLargest, kLargest, 1.0);
    if (channel.scale == 0.0) {
        throw SensorFileFault(keys.path("scale"),
                              KERF_TEXT("0 makes every reading the same; expected a factor other than 0."));
    }
    channel.offset = keys.number("offset", -kLargest, kLargest, 0.0);
    return channel;
}

Gauge gaugeFrom(const Json& json, const std::string& where) {
    const JsonKeys keys(json, where);
    keys.only({"name", "device", "baud", "parity", "protocol", "pattern", "unit", "ask", "depths"}, "of a gauge");
    Gauge gauge;
    gauge.name = keys.name("name");
    gauge.device = keys.text("device");
    gauge.protocol = keys.choice<GaugeProtocol>("protocol", {{"digimatic", GaugeProtocol::Digimatic},
                                                             {"mahr", GaugeProtocol::Mahr},
                                                             {"sylvac", GaugeProtocol::Sylvac},
                                                             {"pattern", GaugeProtocol::Pattern}});
    gauge.baud = keys.integer("baud", 300, 4'000'000, gauge.protocol == GaugeProtocol::Sylvac ? 4800 : 9600);
    gauge.parity = keys.choice<Parity>("parity", {{"none", Parity::None}, {"even", Parity::Even}, {"odd", Parity::Odd}},
                                       gauge.protocol == GaugeProtocol::Sylvac ? Parity::Even : Parity::None);
    gauge.inch = keys.choice<bool>("unit", {{"mm", false}, {"in", true}}, false);
    gauge.ask = keys.text("ask", gauge.protocol == GaugeProtocol::Sylvac ? "?" : "");
    const bool pattern = gauge.protocol == GaugeProtocol::Pattern;
    if (pattern != keys.has("pattern")) {
        throw SensorFileFault(keys.path("pattern"),
                              pattern
                                  ? KERF_TEXT("missing; expected a regular expression whose first group is the value.")
                                  : KERF_TEXT("only for the protocol pattern; expected no such key here."));
    }
    gauge.pattern = keys.text("pattern", "");
    if (const char* fault = pattern ? whyNotAPattern(gauge.pattern) : nullptr; fault != nullptr) {
        throw SensorFileFault(keys.path("pattern"), fault, {brief(gauge.pattern)});
    }
    if (keys.has("depths")) {
        const Json& depths = keys.value("depths");
        if (!depths.is_object()) {
            throw SensorFileFault(keys.path("depths"), KERF_TEXT("not an object; expected {\"channel\": depth, …}."));
        }
        const JsonKeys inside(depths, keys.path("depths"));
        for (const auto& [channel, depth] : depths.items()) {
            gauge.depths.emplace_back(channel, inside.integer(channel, 1, 99));
        }
    }
    return gauge;
}

template <class T>
void requireDifferentNames(const std::vector<T>& list, const char* what) {
    std::map<std::string, std::size_t> seen;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (const auto [first, fresh] = seen.emplace(list[i].name, i); !fresh) {
            throw SensorFileFault(fmt::format("{}[{}].name", what, i),
                                  KERF_TEXT("'%1' is the name of %2 too; expected another one."),
                                  {list[i].name, fmt::format("{}[{}]", what, first->second)});
        }
    }
}

void requireSameLine(const std::vector<Module>& modules) {
    for (std::size_t i = 0; i < modules.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Module& a = modules[k];
            const Module& b = modules[i];
            if (a.transport == Transport::Rtu && b.transport == Transport::Rtu && a.device == b.device) {
                if (a.baud != b.baud || a.parity != b.parity || a.stopBits != b.stopBits) {
                    throw SensorFileFault(fmt::format("modules[{}].baud", i),
                                          KERF_TEXT("modules[%1] is on the same line %2 with other settings; expected "
                                                    "the same baud, parity and stop_bits."),
                                          {std::to_string(k), brief(b.device)});
                }
                if (a.unit == b.unit) {
                    throw SensorFileFault(
                        fmt::format("modules[{}].unit", i),
                        KERF_TEXT("%1 is the unit of modules[%2] on the same line; expected another one."),
                        {std::to_string(b.unit), std::to_string(k)});
                }
            }
        }
    }
}

/// A serial device is opened by one reader: a gauge that shares it would never be plugged in.
void requireOwnDevice(const SensorFile& file) {
    for (std::size_t i = 0; i < file.gauges.size(); ++i) {
        const std::string& device = file.gauges[i].device;
        const auto other = std::ranges::find(file.gauges, device, &Gauge::device);
        const auto module = std::ranges::find_if(file.modules, [&device](const Module& one) {
            return one.transport == Transport::Rtu && one.device == device;
        });
        const auto k = static_cast<std::size_t>(other - file.gauges.begin());
        if (k < i || module != file.modules.end()) {
            const std::string whose =
                k < i ? fmt::format("gauges[{}]", k) : fmt::format("modules[{}]", module - file.modules.begin());
            throw SensorFileFault(fmt::format("gauges[{}].device", i),
                                  KERF_TEXT("%1 is the device of %2 too; expected one of its own (the channels of a "
                                            "multiplexer belong to one gauge)."),
                                  {brief(device), whose});
        }
    }
}

void requireRoom(const SensorFile& file) {
    if (file.channels.empty() && file.gauges.empty()) {
        throw SensorFileFault("channels", KERF_TEXT("none; expected at least one channel or gauge."));
    }
    if (file.channels.size() > kMostChannels) {
        throw SensorFileFault("channels", KERF_TEXT("%1 of them; expected %2 at the most."),
                              {std::to_string(file.channels.size()), std::to_string(kMostChannels)});
    }
    if (const auto count = channelsOf(file, Quantity::Temperature).size(); count > kMostTemperatures) {
        throw SensorFileFault("channels", KERF_TEXT("%1 temperatures; expected %2 at the most."),
                              {std::to_string(count), std::to_string(kMostTemperatures)});
    }
    if (const auto speeds = channelsOf(file, Quantity::Speed); speeds.size() > 1) {
        throw SensorFileFault(fmt::format("channels[{}].quantity", speeds[1]),
                              KERF_TEXT("a second speed; expected one at the most."));
    }
}

void lookForSlips(SensorFile& file) {
    std::map<std::tuple<std::size_t, int, int>, std::size_t> taken;
    for (std::size_t i = 0; i < file.channels.size(); ++i) {
        const Channel& channel = file.channels[i];
        const bool hal = file.modules[channel.module].transport == Transport::Hal;
        const auto key = std::tuple(channel.module, hal ? 0 : channel.function, hal ? channel.pin : channel.address);
        if (const auto [first, fresh] = taken.emplace(key, i); !fresh) {
            file.warnings.push_back(fmt::format("channels[{}]: reads the same {} as channels[{}].", i,
                                                hal ? "pin" : "register", first->second));
        }
        const int low = channel.function == 4 ? 30001 : 40001;
        if (!hal && channel.address >= low && channel.address < low + 9999) {
            file.warnings.push_back(
                fmt::format("channels[{}].address: {} looks like a register's number in a manual; on the wire that "
                            "register is {}.",
                            i, channel.address, channel.address - low));
        }
    }
    for (std::size_t m = 0; m < file.modules.size(); ++m) {
        if (std::ranges::none_of(file.channels, [m](const Channel& channel) { return channel.module == m; })) {
            file.warnings.push_back(fmt::format("modules[{}]: no channel is read from it.", m));
        }
    }
}

std::uint64_t fingerprintOf(const std::string& text) {
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char c : text) {
        hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3ULL;
    }
    return hash;
}

/// "%1" and on, each in the place of its number.
std::string filled(const char* text, const std::vector<std::string>& values) {
    std::string out;
    for (const char* at = text; *at != '\0'; ++at) {
        const auto place = static_cast<std::size_t>(at[1] - '1');
        if (*at == '%' && place < values.size()) {
            out += values[place];
            ++at;
        } else {
            out += *at;
        }
    }
    return out;
}

}  // namespace

SensorFileFault::SensorFileFault(std::string where, const char* text, std::vector<std::string> values)
    : std::runtime_error((where.empty() ? std::string() : where + ": ") + filled(text, values)),
      m_where(std::move(where)),
      m_text(text),
      m_values(std::move(values)) {}

SensorFileFault::SensorFileFault(const std::string& file, const SensorFileFault& fault)
    : std::runtime_error(file + ": " + fault.what()),
      m_where(fault.m_where),
      m_text(fault.m_text),
      m_values(fault.m_values) {}

std::vector<std::size_t> channelsOf(const SensorFile& file, Quantity quantity) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < file.channels.size(); ++i) {
        if (file.channels[i].quantity == quantity) {
            found.push_back(i);
        }
    }
    return found;
}

SensorFile parseSensorFile(const std::string& text) {
    const Json json = parseStrictly(text);
    const JsonKeys keys(json, "");
    keys.only({"modules", "channels", "gauges"}, "of a sensor file");
    SensorFile file;
    file.fingerprint = fingerprintOf(text);
    const bool gaugesOnly = keys.has("gauges") && !keys.has("modules") && !keys.has("channels");
    if (!gaugesOnly) {
        for (std::size_t i = 0; const Json& one : keys.list("modules")) {
            file.modules.push_back(moduleFrom(one, fmt::format("modules[{}]", i++)));
        }
        requireDifferentNames(file.modules, "modules");
        for (std::size_t i = 0; const Json& one : keys.list("channels")) {
            file.channels.push_back(channelFrom(one, fmt::format("channels[{}]", i++), file.modules));
        }
        requireDifferentNames(file.channels, "channels");
    }
    if (keys.has("gauges")) {
        for (std::size_t i = 0; const Json& one : keys.list("gauges")) {
            file.gauges.push_back(gaugeFrom(one, fmt::format("gauges[{}]", i++)));
        }
        requireDifferentNames(file.gauges, "gauges");
    }
    requireSameLine(file.modules);
    requireOwnDevice(file);
    requireRoom(file);
    lookForSlips(file);
    return file;
}

SensorFile readSensorFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text(kLargestFile + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    if (!in.is_open() || text.empty()) {
        throw SensorFileFault(path, KERF_TEXT("cannot be read, or is empty; expected a sensor file."));
    }
    if (text.size() > kLargestFile) {
        throw SensorFileFault(path, KERF_TEXT("larger than %1 MB; expected a sensor file."),
                              {std::to_string(kLargestFile / 1'000'000)});
    }
    try {
        return parseSensorFile(text);
    } catch (const SensorFileFault& fault) {
        throw SensorFileFault(path, fault);
    }
}

}  // namespace kerf::sensors
