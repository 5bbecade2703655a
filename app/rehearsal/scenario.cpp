// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/rehearsal/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "app/files/json_document.h"
#include "app/files/table.h"
#include "app/rehearsal/faults.h"
#include "engine/port/machine_port.h"
#include "engine/process/milling/milling_fields.h"
#include "engine/process/milling/milling_setup.h"
#include "engine/process/turning/turning_setup.h"

namespace kerf::rehearsal {
namespace {

using Json = nlohmann::json;
using headless::BadInput;

constexpr double kLongest_s = 86'400.0;
constexpr double kMostSeed = 9'007'199'254'740'991.0;  // that a JSON number carries exactly
constexpr std::size_t kMostEvents = 10'000;
constexpr std::size_t kMostText = 4'000'000;
constexpr std::size_t kMostCouples = std::tuple_size_v<decltype(InjectedFaults::couples)>;

constexpr std::array<std::pair<const char*, Deed>, 7> kDeeds{{{"start", Deed::Start},
                                                              {"hold_all", Deed::HoldAll},
                                                              {"release_hold", Deed::ReleaseHold},
                                                              {"set_mode", Deed::SetMode},
                                                              {"release_stop", Deed::ReleaseStop},
                                                              {"abort_tap", Deed::AbortTap},
                                                              {"recover_tap", Deed::RecoverTap}}};
constexpr std::array<std::pair<const char*, LoopMode>, 3> kModes{
    {{"off", LoopMode::Off}, {"advise", LoopMode::Advise}, {"control", LoopMode::Control}}};
constexpr std::array<std::pair<const char*, MachineKind>, 3> kMachines{{{"simulator", MachineKind::Simulator},
                                                                        {"diamond-lathe", MachineKind::DiamondLathe},
                                                                        {"linuxcnc", MachineKind::LinuxCnc}}};

template <class Table>
std::string namesOf(const Table& table) {
    std::string names;
    for (const auto& row : table) {
        names += (names.empty() ? "" : ", ") + std::string(row.first);
    }
    return names;
}

std::string shown(const Json& value) {
    constexpr std::size_t kMost = 60;
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() > kMost ? text.substr(0, kMost) + "…" : text;
}

/// One object of the file, read key by key; what has not been read at the end is unknown.
class Keys {
 public:
    Keys(const Json& object, std::string where, std::string path)
        : m_object(object), m_where(std::move(where)), m_path(std::move(path)) {
        if (!object.is_object()) {
            fail(m_path.empty() ? "the scenario" : m_path, shown(object) + " is not an object {…}");
        }
    }
    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw BadInput(fmt::format("{}: {}: {}.", m_where, key, what));
    }
    [[nodiscard]] std::string path(const std::string& key) const { return m_path.empty() ? key : m_path + "." + key; }
    const Json* find(const std::string& key) {
        m_read.insert(key);
        const auto found = m_object.find(key);
        return found == m_object.end() ? nullptr : &*found;
    }
    const Json& need(const std::string& key, const std::string& what) {
        const Json* value = find(key);
        if (value == nullptr) {
            fail(path(key), "is missing; expected " + what);
        }
        return *value;
    }
    double number(const std::string& key, double low, double high) {
        return asNumber(need(key, fmt::format("a number from {} to {}", low, high)), key, low, high);
    }
    double asNumber(const Json& value, const std::string& key, double low, double high) const {
        if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) {
            fail(path(key), fmt::format("{} is not usable; expected a number from {} to {}", shown(value), low, high));
        }
        return value.get<double>();
    }
    template <class Table>
    auto choice(const Json& value, const std::string& key, const Table& table) const {
        if (value.is_string()) {
            for (const auto& row : table) {
                if (value.get_ref<const std::string&>() == row.first) {
                    return row.second;
                }
            }
        }
        fail(path(key), fmt::format("{} is unknown; expected one of {}", shown(value), namesOf(table)));
    }
    void end() const {
        for (const auto& [key, value] : m_object.items()) {
            if (!m_read.contains(key)) {
                fail(path(key), "is unknown here");
            }
        }
    }
    [[nodiscard]] const Json& object() const noexcept { return m_object; }
    void markRead(const std::string& key) { m_read.insert(key); }

 private:
    const Json& m_object;
    std::string m_where;
    std::string m_path;
    std::set<std::string> m_read{};
};

std::vector<std::pair<const char*, ProcessId>> processTable() {
    std::vector<std::pair<const char*, ProcessId>> table;
    for (const ProcessDescriptor* process : processes()) {
        table.emplace_back(process->key, process->id);
    }
    return table;
}

/// "milling.planned_feed_mm_per_s", "planned_feed_mm_s" and "planned_feed_mm_S" are one key.
std::string plain(std::string_view key) {
    std::string text;
    for (const char letter : key.substr(key.find('.') == std::string_view::npos ? 0 : key.find('.') + 1)) {
        text += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    }
    for (std::size_t at = text.find("_per_"); at != std::string::npos; at = text.find("_per_")) {
        text.erase(at, 4);
    }
    return text;
}

struct SetupKey {
    const char* name;
    double* value;
    double low;
    double high;
};

std::vector<SetupKey> keysOf(BoringSchedule& s) {
    return {{"ln_c", &s.lnC, -50.0, 50.0},
            {"alpha", &s.alpha, 0.01, 5.0},
            {"beta", &s.beta, -5.0, 5.0},
            {"target_deflection_mm", &s.targetDeflection_mm, 1e-4, 5.0},
            {"constant_feed_mm_per_rev", &s.constantFeed_mmPerRev, 0.0, 5.0},
            {"min_feed_mm_per_rev", &s.minFeed_mmPerRev, 0.001, 5.0},
            {"max_feed_mm_per_rev", &s.maxFeed_mmPerRev, 0.001, 5.0},
            {"overhang_from_mm", &s.overhangFrom_mm, 1.0, 2000.0},
            {"overhang_to_mm", &s.overhangTo_mm, 1.0, 2000.0},
            {"spindle_speed_rpm", &s.spindleSpeed_rpm, 1.0, 20'000.0}};
}
std::vector<SetupKey> keysOf(TurningSetup& s) {
    return {{"depth_um", &s.depth_um, 0.1, 50.0},
            {"spindle_speed_rpm", &s.spindleSpeed_rpm, 150.0, 30'000.0},
            {"feed_um_per_rev", &s.feed_umPerRev, 0.1, 1000.0},
            {"tool_radius_um", &s.toolRadius_um, 1.0, 1e5},
            {"face_from_mm", &s.faceFrom_mm, -1000.0, 1000.0},
            {"face_to_mm", &s.faceTo_mm, -1000.0, 1000.0},
            {"trim_authority_um", &s.trimAuthority_um, 0.0, 2.0}};
}
std::vector<SetupKey> keysOf(ThermalSetup& s) {
    return {{"period_min", &s.period_min, 0.1, 60.0},
            {"allowed_um", &s.allowed_um, 0.1, 100.0},
            {"max_shift_um", &s.maxShift_um, 1.0, 200.0},
            {"max_step_um_per_min", &s.maxStep_umPerMin, 1.0, 60.0},
            {"warm_up_speed_rpm", &s.warmUpSpeed_rpm, 100.0, 30'000.0},
            {"warm_up_min", &s.warmUp_min, 1.0, 120.0}};
}
std::vector<SetupKey> keysOf(TappingJob& job, TapGains& gains) {
    return {{"pitch_mm", &job.pitch_mm, 0.1, 10.0},
            {"depth_rev", &job.depth_rev, 1.0, 200.0},
            {"speed_rpm", &job.speed_rpm, 10.0, 20'000.0},
            {"engage_rev", &job.engage_rev, 0.0, 100.0},
            {"abort_error_um", &job.abortError_um, 10.0, 5000.0},
            {"allowed_pp_um", &job.allowedPp_um, 1.0, 1000.0},
            {"spindle_kp_per_s", &gains.gains.spindleKp_perS, 5.0, 200.0},
            {"z_kp_per_s", &gains.gains.zKp_perS, 5.0, 200.0}};
}

void readSetup(Keys& setup, const std::vector<SetupKey>& keys) {
    for (const auto& [name, value] : setup.object().items()) {
        const auto found =
            std::ranges::find_if(keys, [&](const SetupKey& key) { return plain(key.name) == plain(name); });
        if (found != keys.end()) {
            setup.markRead(name);
            *found->value = setup.asNumber(value, name, found->low, found->high);
        }
    }
    setup.end();
}

void readMilling(Keys& setup, MillingSetup& milling) {
    constexpr std::array<std::pair<const char*, MillingLaw>, kMillingLawCount> kLaws{
        {{"constant", MillingLaw::Constant},
         {"pi", MillingLaw::Pi},
         {"model", MillingLaw::Model},
         {"preview", MillingLaw::Preview}}};
    for (const auto& [name, value] : setup.object().items()) {
        if (plain(name) == "law") {
            setup.markRead(name);
            milling.law = setup.choice(value, name, kLaws);
        }
        for (const MillingField& field : milling::setupFields()) {
            if (plain(field.spec.key) == plain(name)) {
                setup.markRead(name);
                field.set(milling, setup.asNumber(value, name, field.spec.min, field.spec.max));
            }
        }
    }
    setup.end();
    if (const auto why = milling::whyUnusable(milling)) {
        setup.fail("setup", why->english().substr(0, why->english().size() - 1));
    }
}

Setups defaults() {
    Setups setups;
    setups.boring.revision = 1;
    setups.boring.lnC = std::log(0.0871);  // the built-in machine's law
    setups.boring.alpha = 0.5025;
    setups.boring.beta = 0.2676;
    setups.boring.targetDeflection_mm = 0.1165;
    setups.boring.overhangTo_mm = 140.0;
    setups.milling.revision = 1;
    setups.turning.revision = 1;
    setups.turning.faceTo_mm = 2.0;
    setups.thermal.revision = 1;
    setups.tapping.revision = 1;
    setups.tapGains.revision = 1;
    setups.tapGains.gains.spindleKp_perS = 40.0;
    setups.tapGains.gains.zKp_perS = 48.0;
    return setups;
}

void readSetups(const Json& object, const std::string& where, Scenario& scenario) {
    Keys setup(object, where, "setup");
    Setups& all = scenario.setups;
    switch (scenario.process) {
        case ProcessId::Boring:
            readSetup(setup, keysOf(all.boring));
            if (!(all.boring.overhangTo_mm > all.boring.overhangFrom_mm)) {
                setup.fail("setup.overhang_to_mm",
                           fmt::format("{} is not usable; expected more than overhang_from_mm, {}",
                                       all.boring.overhangTo_mm, all.boring.overhangFrom_mm));
            }
            if (!(all.boring.maxFeed_mmPerRev >= all.boring.minFeed_mmPerRev)) {
                setup.fail("setup.max_feed_mm_per_rev",
                           fmt::format("{} is not usable; expected at least min_feed_mm_per_rev, {}",
                                       all.boring.maxFeed_mmPerRev, all.boring.minFeed_mmPerRev));
            }
            break;
        case ProcessId::Milling:
            readMilling(setup, all.milling);
            break;
        case ProcessId::Turning:
            readSetup(setup, keysOf(all.turning));
            if (const auto why = turning::whyUnusable(all.turning)) {
                setup.fail("setup", why->english().substr(0, why->english().size() - 1));
            }
            break;
        case ProcessId::Thermal:
            readSetup(setup, keysOf(all.thermal));
            break;
        case ProcessId::Tapping:
            readSetup(setup, keysOf(all.tapping, all.tapGains));
            break;
    }
}

void readDeed(Keys& keys, const Json& value, const Scenario& scenario, Event& event) {
    event.deed = keys.choice(value, "do", kDeeds);
    event.process = scenario.process;
    if (*event.deed == Deed::Start || *event.deed == Deed::SetMode || *event.deed == Deed::ReleaseStop) {
        if (const Json* process = keys.find("process")) {
            event.process = keys.choice(*process, "process", processTable());
        }
    }
    if (*event.deed == Deed::SetMode) {
        event.mode = keys.choice(keys.need("mode", "one of " + namesOf(kModes)), "mode", kModes);
    }
}

void readFault(Keys& keys, const Json& value, const Scenario& scenario, Event& event) {
    const FaultSpec* spec = value.is_string() ? findFault(value.get_ref<const std::string&>()) : nullptr;
    if (spec == nullptr) {
        std::string names;
        for (const FaultSpec& known : faultSpecs()) {
            names += (names.empty() ? "" : ", ") + std::string(known.name);
        }
        keys.fail(keys.path("fault"), fmt::format("{} is unknown; expected one of {}", shown(value), names));
    }
    event.fault = spec->name;
    if (spec->apply != nullptr && scenario.machine == MachineKind::LinuxCnc) {
        keys.fail(keys.path("fault"), fmt::format("{} cannot be made on linuxcnc, only {} and {}", spec->name,
                                                  kCycleStall, kConsoleRestart));
    }
    switch (spec->needs) {
        case FaultNeeds::Nothing:
            break;
        case FaultNeeds::Value:
            event.value = keys.number("value", 0.0, 2.0);
            break;
        case FaultNeeds::Channel: {
            const double channel = keys.number("channel", 0.0, static_cast<double>(kMaxTemperatures - 1));
            if (channel != std::floor(channel)) {
                keys.fail(keys.path("channel"), fmt::format("{} is not a whole number", channel));
            }
            event.channel = static_cast<std::uint16_t>(channel);
            break;
        }
        case FaultNeeds::Seconds:
            event.seconds = keys.number("seconds", 0.001, 3600.0);
            break;
    }
    if (event.fault == kConsoleRestart) {
        const Json* seconds = keys.find("seconds");
        event.seconds = seconds == nullptr ? 1.0 : keys.asNumber(*seconds, "seconds", 0.0, 3600.0);
    }
}

Event readEvent(const Json& object, const std::string& where, std::size_t index, const Scenario& scenario) {
    Keys keys(object, where, fmt::format("events[{}]", index));
    Event event;
    event.index = index;
    event.at_s = keys.number("at_s", 0.0, scenario.duration_s);
    const Json* deed = keys.find("do");
    const Json* fault = keys.find("fault");
    if ((deed == nullptr) == (fault == nullptr)) {
        keys.fail(keys.path(deed == nullptr ? "do" : "fault"),
                  deed == nullptr ? "is missing; expected do or fault" : "stands beside do; expected one of both");
    }
    deed != nullptr ? readDeed(keys, *deed, scenario, event) : readFault(keys, *fault, scenario, event);
    keys.end();
    return event;
}

void checkCouples(const std::vector<Event>& events, const std::string& where) {
    std::set<std::uint16_t> sick;
    for (const Event& event : events) {
        const FaultSpec* spec = findFault(event.fault);
        if (spec != nullptr && spec->needs == FaultNeeds::Channel) {
            event.fault == "thermocouple_ok" ? (void)sick.erase(event.channel) : (void)sick.insert(event.channel);
            if (sick.size() > kMostCouples) {
                throw BadInput(fmt::format("{}: events[{}].channel: {} thermocouples fail at once; at most {} can.",
                                           where, event.index, sick.size(), kMostCouples));
            }
        }
    }
}

/// A signal that nothing in this scenario looks at: the run can be made, but says nothing about it.
void remarkIdle(const std::string& where, Scenario& scenario) {
    const auto used = [&](const Event& fault) {
        return concerns(fault.fault, scenario.process) || std::ranges::any_of(scenario.events, [&](const Event& event) {
                   return event.deed == Deed::Start && concerns(fault.fault, event.process);
               });
    };
    for (const Event& event : scenario.events) {
        if (!event.deed && !used(event)) {
            scenario.remarks.push_back(
                fmt::format("{}: events[{}].fault: {} changes nothing: {} does not use that signal.", where,
                            event.index, event.fault, processKey(scenario.process)));
        }
    }
}

}  // namespace

const char* machineKey(MachineKind kind) noexcept {
    return kMachines[static_cast<std::size_t>(kind)].first;
}

const char* deedKey(Deed deed) noexcept {
    return kDeeds[static_cast<std::size_t>(deed)].first;
}

Scenario readScenario(const std::string& text, const std::string& where, const std::string& machine) {
    if (text.size() > kMostText) {
        throw BadInput(fmt::format("{}: {} bytes; a scenario has at most {}.", where, text.size(), kMostText));
    }
    constexpr int kDeepest = 8;
    Json document;
    try {
        document = Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
            if (depth > kDeepest) {
                throw BadInput("");
            }
            return true;
        });
    } catch (const BadInput&) {
        throw BadInput(fmt::format("{}: nested deeper than {} levels; a scenario is not.", where, kDeepest));
    } catch (const Json::parse_error& error) {  // its words hold the text as it stands there, whatever that is
        throw BadInput(fmt::format("{}: no JSON from byte {} on; expected a scenario.", where, error.byte));
    } catch (const Json::exception&) {
        throw BadInput(fmt::format("{}: a number is too large to be stored; expected a scenario.", where));
    }
    if (const auto twice = files::doubledKey(text)) {
        throw BadInput(
            fmt::format("{}: {}: the key stands twice in one object; expected it once.", where, shown(Json(*twice))));
    }
    Keys keys(document, where, "");
    Scenario scenario;
    scenario.setups = defaults();
    scenario.process =
        keys.choice(keys.need("process", "one of " + namesOf(processTable())), "process", processTable());
    const bool turns = scenario.process == ProcessId::Turning;
    if (machine.empty()) {
        scenario.machine = turns ? MachineKind::DiamondLathe : MachineKind::Simulator;
    } else {
        for (const auto& [name, kind] : kMachines) {
            scenario.machine = machine == name ? kind : scenario.machine;
        }
        const bool has =
            scenario.machine == MachineKind::DiamondLathe
                ? turns || scenario.process == ProcessId::Thermal
                : !turns && !(scenario.machine == MachineKind::LinuxCnc && scenario.process == ProcessId::Thermal);
        if (!has) {
            keys.fail("process", fmt::format("{} is not on the machine {}", processKey(scenario.process), machine));
        }
    }
    scenario.duration_s = keys.number("duration_s", 0.001, kLongest_s);
    if (const Json* mode = keys.find("mode")) {
        scenario.mode = keys.choice(*mode, "mode", kModes);
    }
    if (const Json* seed = keys.find("seed")) {
        const double value = keys.asNumber(*seed, "seed", 0.0, kMostSeed);
        if (value != std::floor(value)) {
            keys.fail("seed", fmt::format("{} is not a whole number", value));
        }
        scenario.seed = static_cast<std::uint64_t>(value);
    }
    if (const Json* setup = keys.find("setup")) {
        readSetups(*setup, where, scenario);
    }
    if (const Json* events = keys.find("events")) {
        if (!events->is_array() || events->size() > kMostEvents) {
            keys.fail("events", fmt::format("is no list […] of at most {} events", kMostEvents));
        }
        for (std::size_t i = 0; i < events->size(); ++i) {
            scenario.events.push_back(readEvent((*events)[i], where, i, scenario));
        }
    }
    keys.find("name");
    keys.find("about");
    keys.end();
    std::ranges::stable_sort(scenario.events, {}, &Event::at_s);
    checkCouples(scenario.events, where);
    remarkIdle(where, scenario);
    return scenario;
}

}  // namespace kerf::rehearsal
