// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/engine.h"

#include "engine/api/quality_alarms.h"
#include "engine/cycle/machine_alarms.h"

namespace kerf {

Engine::Engine(MachinePort& port, std::vector<std::unique_ptr<ProcessLoop>> loops)
    : m_port(port),
      m_cycle(port, std::move(loops), m_rings),
      m_thread(m_cycle, port.capabilities().cycle_ns, port.capabilities().simulated) {}

void Engine::start() {
    m_thread.start();
}

void Engine::stop() noexcept {
    m_thread.stop();
}

void Engine::runCycles(std::uint64_t count) noexcept {
    for (std::uint64_t i = 0; i < count; ++i) {
        m_inlineTime_ns += m_port.capabilities().cycle_ns;
        m_cycle.step(m_inlineTime_ns);
        ++m_inlineStats.cycles;
    }
    m_cycle.publish(m_inlineStats);
}

std::optional<std::uint32_t> Engine::send(const Command& command) noexcept {
    Command numbered = command;
    numbered.number = m_commandNumber + 1;
    if (auto* release = std::get_if<ReleaseHold>(&numbered.action)) {
        release->holdsSeen = m_rings.holdsAsked.load(std::memory_order_acquire);
    }
    if (!m_rings.commands.tryPush(numbered)) {
        return std::nullopt;
    }
    return ++m_commandNumber;
}

void Engine::holdAll() noexcept {
    m_rings.holdsAsked.fetch_add(1, std::memory_order_acq_rel);
}

Status Engine::status() noexcept {
    (void)m_rings.status.refresh();
    return m_rings.status.value();
}

std::size_t Engine::drainSamples(std::span<Sample> samples) noexcept {
    std::size_t count = 0;
    while (count < samples.size() && m_rings.samples.tryPop(samples[count])) {
        ++count;
    }
    return count;
}

const AlarmSpec* Engine::alarmSpec(AlarmCode code) const noexcept {
    const auto search = [code](std::span<const AlarmSpec> specs) -> const AlarmSpec* {
        for (const AlarmSpec& spec : specs) {
            if (spec.code == code) {
                return &spec;
            }
        }
        return nullptr;
    };
    if (const AlarmSpec* found = search(machine_alarm::kSpecs)) {
        return found;
    }
    if (const AlarmSpec* found = search(quality_alarm::kSpecs)) {
        return found;
    }
    for (const auto& loop : m_cycle.loops()) {
        if (const AlarmSpec* found = search(loop->alarms())) {
            return found;
        }
    }
    return nullptr;
}

}  // namespace kerf
