// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/api/status.h"
#include "engine/core/latest_value.h"
#include "engine/core/spsc_ring.h"
#include "engine/cycle/event_sink.h"
#include "engine/cycle/process_loop.h"
#include "engine/cycle/supervisor.h"
#include "engine/limits/output_limiter.h"

namespace kerf {

/// Carriers between the engine thread and the others. Made once, before the thread starts.
struct EngineRings {
    SpscRing<Command> commands{64};
    SpscRing<Sample> samples{8192};
    SpscRing<AlarmEvent> alarms{256};
    SpscRing<PartRecord> parts{64};
    std::atomic<bool> partsRefused{false};  ///< set by the store while it takes none: no part of Kerf's begins
    LatestValue<Status> status{};
    std::atomic<std::uint32_t> holdsAsked{0};  ///< counts presses of hold-all
};

/// One step of the engine: read the machine, take commands, run the loops, limit, write. Has no clock and no thread;
/// whoever calls step() decides what time is, so the console and the headless program run the same code.
///
/// step() neither allocates, locks, throws, logs nor blocks (tests/engine/cycle/tst_cycle_guard).
class Cycle {
 public:
    Cycle(MachinePort& port, std::vector<std::unique_ptr<ProcessLoop>> loops, EngineRings& rings);

    void step(std::int64_t now_ns) noexcept;
    /// Copy the state to LatestValue; the engine thread does this once per wake-up.
    void publish(const CycleStats& stats) noexcept;
    /// Push one chart sample; a full ring drops and counts it.
    void emitSample(std::int64_t wallTime_ns) noexcept;
    /// The engine missed many deadlines lately (or no longer does).
    void reportOverruns(bool many) noexcept { m_events.set(4, many); }

    [[nodiscard]] double simulationSpeed() const noexcept { return m_simulationSpeed; }
    [[nodiscard]] const MachineInputs& inputs() const noexcept { return m_inputs; }
    [[nodiscard]] const MachineOutputs& outputs() const noexcept { return m_outputs; }
    [[nodiscard]] const StopLatch& stops() const noexcept { return m_limiter.stops(); }
    [[nodiscard]] LoopStatus describe(ProcessId id) const noexcept;
    [[nodiscard]] const std::array<CommandResult, 8>& recentCommands() const noexcept { return m_recentCommands; }
    [[nodiscard]] const std::vector<std::unique_ptr<ProcessLoop>>& loops() const noexcept { return m_loops; }

 private:
    void takeCommands() noexcept;
    [[nodiscard]] CommandResult execute(const Command& command) noexcept;
    [[nodiscard]] CommandResult startPart(const Command& command, const StartPart& start) noexcept;
    [[nodiscard]] ProcessLoop* find(ProcessId id) const noexcept { return m_byProcess[static_cast<std::size_t>(id)]; }
    void watchMachine() noexcept;
    [[nodiscard]] bool partsBlocked() const noexcept {
        return m_events.partsBlocked() || m_rings.partsRefused.load(std::memory_order_relaxed);
    }
    void showStops() noexcept;
    void runLoop(ProcessLoop& loop) noexcept;
    void tellRefused() noexcept;
    void sayRefused() noexcept;

    MachinePort& m_port;
    std::vector<std::unique_ptr<ProcessLoop>> m_loops;
    std::array<ProcessLoop*, kProcessPlaces> m_byProcess{};
    EngineRings& m_rings;
    EventSink m_events;
    Supervisor m_supervisor;
    OutputLimiter m_limiter;
    MachineInputs m_inputs{};
    MachineOutputs m_outputs{};
    LimitReport m_limitReport{};
    std::array<LoopOutputs, kProcessPlaces> m_wishes{};
    std::array<LoopVerdict, kProcessPlaces> m_verdicts{};
    std::array<LoopMode, kProcessPlaces> m_modes{};
    std::array<CommandResult, 8> m_recentCommands{};
    std::int64_t m_lastTime_ns{0};
    std::uint64_t m_cycles{0};
    std::uint32_t m_holdsTaken{0};
    bool m_linkWasUp{false};
    std::array<RequestReply, LimitReport::kMaxRefused> m_refused{};  ///< of the limiter, told one per cycle
    std::size_t m_refusedCount{0};
    RequestReply m_portReply{};        ///< the last one
    RequestReply m_saidReply{};        ///< the last one that an alarm has told, or need not tell
    std::uint32_t m_refusedNumber{0};  ///< of the newest request that was not carried out
    double m_simulationSpeed{1.0};
};

}  // namespace kerf
