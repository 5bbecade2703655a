// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/stop_keeper.h"

#include <array>
#include <charconv>
#include <utility>

namespace kerf::console {
namespace {

std::string stopKeyOf(ProcessId process) {
    return std::string("stop.") + processKey(process);
}

constexpr StopSlot kUnreadable{1, 0, StopKind::NoStart, 0};  // what cannot be read may have been a stop

/// "number released kind cause"
std::string textOf(const StopSlot& slot) {
    return std::to_string(slot.number) + ' ' + std::to_string(slot.released) + ' ' +
           std::to_string(static_cast<unsigned>(slot.kind)) + ' ' + std::to_string(slot.cause);
}

StopSlot slotOf(const std::string& text) {
    std::array<std::uint32_t, 4> values{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::uint32_t& value : values) {
        while (at != end && *at == ' ') {
            ++at;
        }
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc()) {
            return kUnreadable;
        }
        at = next;
    }
    if (values[2] > static_cast<std::uint32_t>(StopKind::InWork)) {
        return kUnreadable;
    }
    return {values[0], values[1], static_cast<StopKind>(values[2]), static_cast<AlarmCode>(values[3])};
}

}  // namespace

StopKeeper::StopKeeper(EngineApi& engine, SettingsReader& settings, Save save)
    : m_engine(engine), m_save(std::move(save)) {
    for (const ProcessId process : allProcesses()) {
        if (const auto stored = settings.setting(stopKeyOf(process)); stored && *stored) {
            m_kept[static_cast<std::size_t>(process)] = slotOf(**stored);
        }
    }
}

void StopKeeper::restore() {
    Command command;
    command.action = RestoreStops{m_kept};
    (void)m_engine.send(command);
}

void StopKeeper::poll() {
    const Status& status = m_engine.status();
    for (const ProcessId process : allProcesses()) {
        const auto index = static_cast<std::size_t>(process);
        const StopSlot now = joined(m_kept[index], status.stops[index].slot);
        if (now != m_kept[index]) {
            const bool stopped = now.number != m_kept[index].number;
            m_kept[index] = now;
            m_save(stopKeyOf(process), textOf(now), stopped ? status.stops[index].reason.english() : "released");
        }
    }
}

}  // namespace kerf::console
