// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/loop_modes.h"

#include <utility>

namespace kerf::console {
namespace {

std::string modeKeyOf(ProcessId process) {
    return std::string("loop.mode.") + processKey(process);
}

const char* nameOf(LoopMode mode) {
    switch (mode) {
        case LoopMode::Advise:
            return "advise";
        case LoopMode::Control:
            return "control";
        case LoopMode::Off:
            break;
    }
    return "off";
}

LoopMode modeOf(const std::string& name) {
    return name == "control" ? LoopMode::Control : name == "advise" ? LoopMode::Advise : LoopMode::Off;
}

}  // namespace

LoopModes::LoopModes(EngineApi& engine, SettingsReader& settings, Save save)
    : m_engine(engine), m_save(std::move(save)) {
    for (const ProcessId process : allProcesses()) {
        const auto stored = settings.setting(modeKeyOf(process));
        LoopMode& kept = m_kept[static_cast<std::size_t>(process)];
        kept = m_engine.capabilities().simulated ? LoopMode::Control : LoopMode::Advise;
        if (stored && *stored) {
            kept = modeOf(**stored);
        }
    }
}

void LoopModes::restore() {
    for (const ProcessId process : allProcesses()) {
        const auto index = static_cast<std::size_t>(process);
        if (m_engine.capabilities().process[index].fitted) {
            Command command;
            command.action = SetLoopMode{process, m_kept[index]};
            (void)m_engine.send(command);
        }
    }
}

void LoopModes::poll() {
    const Status& status = m_engine.status();
    for (const ProcessId process : allProcesses()) {
        const auto index = static_cast<std::size_t>(process);
        const LoopStatus& loop = status.loops[index];
        if (!loop.fitted) {
            continue;
        }
        if (!m_inForce[index]) {
            m_inForce[index] = loop.mode == m_kept[index];
        } else if (loop.mode != m_kept[index]) {
            m_kept[index] = loop.mode;
            m_save(modeKeyOf(process), nameOf(loop.mode));
        }
    }
}

}  // namespace kerf::console
