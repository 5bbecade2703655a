// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/rehearsal/rehearsal_console.h"

#include <fmt/format.h>

#include "engine/cycle/machine_alarms.h"
#include "engine/process/boring/boring_loop.h"
#include "engine/process/milling/milling_loop.h"
#include "engine/process/tapping/tapping_loop.h"
#include "engine/process/thermal/thermal_loop.h"
#include "engine/process/turning/turning_loop.h"

namespace kerf::rehearsal {

Console::Console(MachinePort& machine, const Setups& setups, const std::array<LoopMode, kProcessPlaces>& modes,
                 const StopSlots& keptStops, const thermal::ThermalModel* thermal)
    : m_taps(std::make_unique<TapExchange>()), m_thermal(std::make_unique<ThermalExchange>()) {
    const Capabilities& capabilities = machine.capabilities();
    const auto has = [&](ProcessId id) { return capabilities.process[static_cast<std::size_t>(id)].fitted; };
    std::vector<std::unique_ptr<ProcessLoop>> loops;
    loops.push_back(std::make_unique<BoringLoop>());
    loops.push_back(std::make_unique<MillingLoop>());
    loops.push_back(std::make_unique<TurningLoop>(nullptr));
    loops.push_back(std::make_unique<ThermalLoop>(*m_thermal));
    loops.push_back(std::make_unique<TappingLoop>(*m_taps));
    if (capabilities.simulated) {
        std::erase_if(loops, [&](const auto& loop) { return !has(loop->id()); });
    }
    m_engine = std::make_unique<Engine>(machine, std::move(loops));
    if (thermal != nullptr) {
        std::vector<std::string> channels;
        for (int i = 0; i < capabilities.temperatureCount; ++i) {
            channels.push_back(fmt::format("T{:02}", i));
        }
        if (auto live = LiveModel::make(*thermal, channels, 1)) {
            m_thermal->offer(std::move(*live));
        }
    }
    (void)send(RestoreStops{keptStops});
    (void)send(LoadBoringSchedule{setups.boring});
    (void)send(LoadMillingSetup{setups.milling});
    (void)send(LoadTurningSetup{setups.turning});
    (void)send(LoadThermalSetup{setups.thermal});
    (void)send(LoadTappingJob{setups.tapping});
    LoadTapGains gains;
    gains.gains = setups.tapGains;
    gains.accept = true;
    gains.production = true;
    (void)send(gains);
    for (const ProcessId id : allProcesses()) {
        (void)send(SetLoopMode{id, modes[static_cast<std::size_t>(id)]});
    }
}

void Console::step(std::int64_t now_ns) {
    m_engine->cycle().step(now_ns);
}

void Console::ask(const Event& event, const char* person, std::size_t index) {
    std::uint32_t number = 0;
    switch (*event.deed) {
        case Deed::Start:
            number = send(StartPart{event.process});
            break;
        case Deed::HoldAll:
            m_engine->holdAll();
            m_asked[0] = index;  // done with the next cycle
            return;
        case Deed::ReleaseHold:
            number = send(ReleaseHold{});
            break;
        case Deed::SetMode:
            number = send(SetLoopMode{event.process, event.mode});
            break;
        case Deed::ReleaseStop: {
            ReleaseStop release;
            release.process = event.process;
            release.number = stops()[static_cast<std::size_t>(event.process)].number;
            release.person.set(person);
            number = send(release);
            break;
        }
        case Deed::AbortTap:
            number = send(AbortTap{});
            break;
        case Deed::RecoverTap:
            number = send(RecoverTap{});
            break;
    }
    m_asked[number] = index;
}

void Console::takeAnswers(std::vector<CommandSeen>& commands) {
    if (const auto hold = m_asked.find(0); hold != m_asked.end()) {
        commands[hold->second].done = true;
        m_asked.erase(hold);
    }
    if (m_asked.empty()) {
        return;
    }
    for (const CommandResult& result : m_engine->cycle().recentCommands()) {
        const auto asked = m_asked.find(result.number);
        if (result.number != 0 && asked != m_asked.end()) {
            commands[asked->second].done = result.done;
            commands[asked->second].reason = result.reason.english();
            m_asked.erase(asked);
        }
    }
}

void Console::drainAlarms(std::set<AlarmCode>& standing) {
    AlarmEvent event;
    while (m_engine->nextAlarm(event)) {
        event.raised ? (void)standing.insert(event.code) : (void)standing.erase(event.code);
    }
}

void Console::countParts(std::uint32_t& finished, std::uint32_t& aborted) {
    PartRecord part;
    while (m_engine->partRecords().tryPop(part)) {
        ++(part.complete ? finished : aborted);
    }
}

std::string Console::stopReason(ProcessId process) const {
    return m_engine->cycle().stops().status(process).reason.english();
}

std::map<AlarmCode, std::string> Console::alarmTitles() const {
    std::map<AlarmCode, std::string> titles;
    for (const AlarmSpec& spec : machine_alarm::kSpecs) {
        titles[spec.code] = spec.title;
    }
    for (const auto& loop : m_engine->cycle().loops()) {
        for (const AlarmSpec& spec : loop->alarms()) {
            titles[spec.code] = spec.title;
        }
    }
    return titles;
}

}  // namespace kerf::rehearsal
