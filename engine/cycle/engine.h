// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/api/engine_api.h"
#include "engine/cycle/cycle.h"
#include "engine/cycle/engine_thread.h"

namespace kerf {

/// The engine as a whole: rings, cycle and thread around one machine. What screens see of it is EngineApi.
class Engine final : public EngineApi {
 public:
    /// @pre port is connected and outlives the engine.
    Engine(MachinePort& port, std::vector<std::unique_ptr<ProcessLoop>> loops);

    /// Run in real time on a thread of its own.
    void start();
    void stop() noexcept;
    /// Run on the caller's thread instead, machine time only: `kerf simulate`, tests. @pre not started.
    void runCycles(std::uint64_t count) noexcept;

    /// For the database's writer thread, the only consumer.
    [[nodiscard]] SpscRing<PartRecord>& partRecords() noexcept { return m_rings.parts; }
    /// Set by the writer thread while it cannot store finished parts: the engine begins none of its own.
    [[nodiscard]] std::atomic<bool>& partsRefused() noexcept { return m_rings.partsRefused; }
    [[nodiscard]] Cycle& cycle() noexcept { return m_cycle; }

    [[nodiscard]] std::optional<std::uint32_t> send(const Command& command) noexcept override;
    void holdAll() noexcept override;
    [[nodiscard]] Status status() noexcept override;
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_port.capabilities(); }
    [[nodiscard]] std::size_t drainSamples(std::span<Sample> samples) noexcept override;
    [[nodiscard]] bool nextAlarm(AlarmEvent& event) noexcept override { return m_rings.alarms.tryPop(event); }
    [[nodiscard]] const AlarmSpec* alarmSpec(AlarmCode code) const noexcept override;

 private:
    MachinePort& m_port;
    EngineRings m_rings;
    Cycle m_cycle;
    EngineThread m_thread;
    CycleStats m_inlineStats{};
    std::int64_t m_inlineTime_ns{0};
    std::uint32_t m_commandNumber{0};
};

}  // namespace kerf
